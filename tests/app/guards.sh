# SPDX-License-Identifier: LGPL-2.1-or-later
# Guards beyond what tests/viscous/guards.prm shows: a resumed run warns of what is new and counts
# on, and a power that differs by round-off is seen.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

guards="$CAUDAL_SOURCE_DIR/tests/viscous/guards.prm"

# show: each warning about the run, without the values.
show() {
  grep "^Warning" printed | sed -n 's/at t = [0-9.]* s/at t = .../; s/ is [-0-9][-0-9.e]*/ is .../; / t = \|^Warnings/ s/^/    /p'
}

"$CAUDAL" "$guards" -D "Time/End time=0.1" >printed
echo "* resumed from the middle"
"$CAUDAL" --resume results -D "Time/End time=0.2" >printed
show
echo "* powers equal but for round-off"
# In which steps the powers agree to the last bit is chance.
"$CAUDAL" "$CAUDAL_SOURCE_DIR/tests/viscous/guards_none.prm" -D "Guards/Largest power identity=1e-30" >printed
show | sed 's/in [1-9][0-9]* steps/in some steps/'
