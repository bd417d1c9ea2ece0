# SPDX-License-Identifier: LGPL-2.1-or-later
# Mutated parameter files, meshes and tables, and damaged checkpoints: no crash, no hang, a sentence for each error.
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
cat >body.msh <<'EOF'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 2 "head"
2 1 "tail"
$EndPhysicalNames
$Nodes
15
1 0 -0.1 0
2 0 0 0
3 0 0.1 0
4 0.15 -0.1 0
5 0.15 0 0
6 0.15 0.1 0
7 0.3 -0.1 0
8 0.3 0 0
9 0.3 0.1 0
10 0.45 -0.1 0
11 0.45 0 0
12 0.45 0.1 0
13 0.6 -0.1 0
14 0.6 0 0
15 0.6 0.1 0
$EndNodes
$Elements
9
1 1 2 3 7 2 5
2 3 2 2 1 1 4 5 2
3 3 2 2 1 2 5 6 3
4 3 2 2 1 4 7 8 5
5 3 2 2 1 5 8 9 6
6 3 2 1 1 7 10 11 8
7 3 2 1 1 8 11 12 9
8 3 2 1 1 10 13 14 11
9 3 2 1 1 11 14 15 12
$EndElements
EOF
cat >force.csv <<'EOF'
time, 0, 0.5, 1
0, 0, 1, 2
0.01, 1, 2, 3
0.1, 0, -1, -2
EOF
"$CAUDAL_SOURCE_DIR/tests/fuzz" "$CAUDAL" tank.prm 2>counts
