// A billion cells by the size at the points.
Point(1) = {0, 0, 0, 1e-8};
Point(2) = {10, 0, 0, 1e-8};
Line(1) = {1, 2};
Physical Curve("main") = {1};
Physical Point("A") = {1};
