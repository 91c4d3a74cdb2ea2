// Two rectangles of 1 m side by side, whose cells at the bottom are of different lengths.
Point(1)={0,0,0};Point(2)={1,0,0};Point(3)={2,0,0};Point(4)={2,1,0};Point(5)={1,1,0};Point(6)={0,1,0};
Line(1)={1,2};Line(2)={2,3};Line(3)={3,4};Line(4)={4,5};Line(5)={5,6};Line(6)={6,1};Line(7)={2,5};
Curve Loop(1)={1,7,5,6};Plane Surface(1)={1};Curve Loop(2)={2,3,4,-7};Plane Surface(2)={2};
Transfinite Curve{1,5}=2;Transfinite Curve{2,4}=11;Transfinite Curve{3,6,7}=3;Transfinite Surface{1};Transfinite Surface{2};Recombine Surface{1};Recombine Surface{2};
Physical Curve("b1")={1};Physical Curve("b2")={2};Physical Curve("top")={4,5};Physical Curve("left")={6};Physical Curve("right")={3};Physical Surface("body")={1,2};Physical Point("TR")={4};
