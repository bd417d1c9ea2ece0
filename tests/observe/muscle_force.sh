# SPDX-License-Identifier: LGPL-2.1-or-later
# The field muscle_force is that of the time of the other fields: a surface load that grows in the
# step has reached at its end the value of one that has always been there.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >disc.prm <<'END'
set Bodies = disc
subsection Time
  set End time = 0.1
  set Step     = 0.1
end
subsection Domain
  set Cells  = 4, 4
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 0.1
end
subsection Body disc
  subsection Shape
    set Type     = disc
    set Elements = 6, 8
    set Position = 0.5, 0.5
  end
  subsection Region body
    set Young's modulus = 3
  end
end
subsection Output
  set Folder = results
end
END

# The largest force [N/m^2] at the start and at the end.
largest() {
  for file in results/fields/disc-0000[01].vtu; do
    /usr/bin/python3 - $file <<'END'
import sys
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
reader.Update()
data = reader.GetOutput().GetPointData().GetArray("muscle_force")
print(f"{data.GetMaxNorm():.5f}")
END
  done
}

for traction in "0.01; 0" "0.1*t; 0"; do
  caudal disc.prm -D "Body disc/Traction=$traction"
  echo "$traction:" $(largest)
done
