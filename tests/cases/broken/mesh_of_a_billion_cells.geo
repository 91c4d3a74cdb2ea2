// A billion cells by a number on the curve.
Point(1) = {0, 0, 0};
Point(2) = {10, 0, 0};
Line(1) = {1, 2};
Transfinite Curve {1} = 1000000001;
Physical Curve("main") = {1};
Physical Point("A") = {1};
