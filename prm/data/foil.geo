// A foil of 0.1 m for doc/cookbook/gmsh.md, the first 85 % of a NACA 0014, with a head and a tail:
//   gmsh -2 -format msh2 foil.geo -o foil.msh
// Frame: x from the nose to the tail, metres.
L = 0.1; t = 0.14; kept = 0.85; joint = 0.3; n = 24; size = 0.012;
Mesh.RecombineAll = 1; Mesh.SubdivisionAlgorithm = 1; // quadrilaterals, half as wide as size

For i In {0 : n}
  s = kept * (i / n)^2; // close together at the nose
  y = 5 * t * L / kept * (0.2969 * Sqrt(s) - 0.126 * s - 0.3516 * s^2 + 0.2843 * s^3 - 0.1015 * s^4);
  Point(100 + i) = {s * L / kept, y, 0, size};
  Point(200 + i) = {s * L / kept, -y, 0, size};
EndFor

k = Floor(n * Sqrt(joint)); // where the two parts meet
upper_head = newl; Spline(upper_head) = {100 : 100 + k};
upper_tail = newl; Spline(upper_tail) = {100 + k : 100 + n};
lower_head = newl; Spline(lower_head) = {100, 201 : 200 + k};
lower_tail = newl; Spline(lower_tail) = {200 + k : 200 + n};
between = newl; Line(between) = {200 + k, 100 + k};
end = newl; Line(end) = {200 + n, 100 + n};
Line Loop(1) = {lower_head, between, -upper_head};
Line Loop(2) = {lower_tail, end, -upper_tail, -between};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Physical Surface("head") = {1}; // the regions of the body, that of the head first
Physical Surface("tail") = {2};
