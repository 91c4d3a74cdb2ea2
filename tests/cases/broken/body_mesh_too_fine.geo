// Some 2e8 quadrilaterals.
h = 2e-4;
Point(1) = {0, 0, 0, h};
Point(2) = {8, 0, 0, h};
Point(3) = {8, 1, 0, h};
Point(4) = {0, 1, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Curve("rollers") = {1};
Physical Curve("surface") = {3};
Physical Curve("pushed") = {4};
Physical Point("corner") = {4};
Physical Surface("slab") = {1};
