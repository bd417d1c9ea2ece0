# SPDX-License-Identifier: LGPL-2.1-or-later
# What the elastic model can't do is said in a sentence.

. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

csm1=$CAUDAL_SOURCE_DIR/prm/benchmarks/csm1.prm
refuse "no density" "$csm1" -D "Output/Folder=results" -D "Body flag/Density=0"
refuse "a run to verify" --verify-restart "$csm1"
refuse "feedback" "$csm1" -D "Output/Folder=results" -D "Body flag/Region flag/Feedback damping=1"
refuse "a thin direction" "$csm1" -D "Output/Folder=results" -D "Body flag/Region flag/Thin direction=y"
refuse "a traction" "$csm1" -D "Output/Folder=results" -D "Body flag/Traction=1; 0"

"$CAUDAL" "$csm1" -D "Output/Folder=csm1" -D "Time/End time=0.2" -D "Body flag/Shape/Elements=12,2" >printed
refuse "a finished run to resume" --resume csm1
