// 10 m along x, cells of 2 m, a point P at 6 m.
Point(1) = {0, 0, 0};
Point(2) = {6, 0, 0};
Point(3) = {10, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Transfinite Curve {1} = 4;
Transfinite Curve {2} = 3;
Physical Curve("main") = {1, 2};
Physical Point("A") = {1};
Physical Point("P") = {2};
Physical Point("B") = {3};
