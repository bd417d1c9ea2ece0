# SPDX-License-Identifier: LGPL-2.1-or-later
# Mutated parameter files and damaged checkpoints: no crash, no hang, a sentence for each error.
cat >tank.prm <<'EOF'
set Bodies = fish
subsection Time
  set End time = 0.02
  set Step     = 0.01
end
subsection Domain
  set Size   = 2, 1
  set Cells  = 4, 2
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 0.01
  set Initial velocity    = y*(1-y); 0
  set Probes              = 0.2, 0.2
end
subsection Body fish
  set Regions          = head, tail
  set Monitored points = 0.2, 0
  subsection Shape
    set Type              = naca
    set Length            = 0.6
    set Elements          = 12, 4
    set Position          = 0.7, 0.5
    set Region boundaries = 0.5
    subsection Naca
      set Digits = 0024
    end
  end
  subsection Region head
    set Young's modulus    = 10
    set Feedback stiffness = 10
  end
  subsection Muscle
    set Type               = bang-bang
    set Regions            = tail
    set Monitored point    = 0.9
    set Force distribution = s^2
    subsection Bang-bang
      set Maximum force density = 5
    end
  end
end
subsection Coupling
  set Kernel = dirac
end
subsection Refinement
  set Body margin         = 1
  set Vorticity threshold = 0.5
end
subsection Output
  set Interval of fields = 0.01
end
EOF
"$CAUDAL_SOURCE_DIR/tests/fuzz" "$CAUDAL" tank.prm 2>counts
