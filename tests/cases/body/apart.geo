// Two blocks 1 x 1 side by side, whose common side has the nodes of both.
Point(1) = {0, 0, 0, 1}; Point(2) = {1, 0, 0, 1}; Point(5) = {1, 1, 0, 1}; Point(6) = {0, 1, 0, 1};
Point(12) = {1, 0, 0, 1}; Point(3) = {2, 0, 0, 1}; Point(4) = {2, 1, 0, 1}; Point(15) = {1, 1, 0, 1};
Line(1) = {1, 2}; Line(7) = {2, 5}; Line(5) = {5, 6}; Line(6) = {6, 1};
Line(2) = {12, 3}; Line(3) = {3, 4}; Line(4) = {4, 15}; Line(8) = {15, 12};
Curve Loop(1) = {1, 7, 5, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, 8}; Plane Surface(2) = {2};
Transfinite Curve{1, 2, 3, 4, 5, 6, 7, 8} = 3;
Transfinite Surface{1, 2}; Recombine Surface{1, 2};
Physical Curve("bottom") = {1, 2}; Physical Curve("top") = {4, 5}; Physical Curve("right") = {3};
Physical Surface("body") = {1, 2};
