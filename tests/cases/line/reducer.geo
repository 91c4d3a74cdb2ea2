// A reducer of 4 m and a pipe of 2 m behind it.
Point(1) = {0, 0, 0};
Point(2) = {4, 0, 0};
Point(3) = {6, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Physical Curve("reducer") = {1};
Physical Curve("pipe") = {2};
Physical Point("A") = {1};
Physical Point("B") = {2};
Physical Point("C") = {3};
