Point(1) = {0, 0, 0};
Point(2) = {5, 0, 0};
Line(1) = {1, 2};
Line(2) = {1, 2};
Transfinite Curve {1, 2} = 2;
Physical Curve("main") = {1, 2};
Physical Point("A") = {1};
