// Two curves whose ends are one place and two points, 3 and 7 m long, and a third that nobody takes.
Point(1) = {0, 0, 0};
Point(2) = {3, 0, 0};
Point(3) = {3, 0, 0};
Point(4) = {6, 0, 0};
Point(5) = {6, 4, 0};
Point(6) = {3, -2, 0};
Line(1) = {1, 2};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {2, 6};
Transfinite Curve {1, 2, 3, 4} = 2;
Physical Curve("m1") = {1};
Physical Curve("m2") = {2, 3};
Physical Curve("m3") = {4};
Physical Point("A") = {1};
Physical Point("P") = {2};
Physical Point("B") = {5};
