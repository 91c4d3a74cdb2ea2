// The line of straight.geo, its curves drawn from P outwards.
Point(1) = {0, 0, 0};
Point(2) = {6, 0, 0};
Point(3) = {10, 0, 0};
Line(2) = {2, 1};
Line(3) = {2, 3};
Transfinite Curve {2} = 4;
Transfinite Curve {3} = 3;
Physical Curve("main") = {2, 3};
Physical Point("A") = {1};
Physical Point("P") = {2};
Physical Point("B") = {3};
