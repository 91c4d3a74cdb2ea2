// A block of 8 m by 2 m that stands on the 2 m in its middle, in squares of 0.5 m.
Point(1)={-4,0,0};Point(2)={-1,0,0};Point(3)={1,0,0};Point(4)={4,0,0};Point(5)={4,2,0};Point(6)={1,2,0};Point(7)={-1,2,0};Point(8)={-4,2,0};
Line(1)={1,2};Line(2)={2,3};Line(3)={3,4};Line(4)={4,5};Line(5)={5,6};Line(6)={6,7};Line(7)={7,8};Line(8)={8,1};Line(9)={2,7};Line(10)={3,6};
Curve Loop(1)={1,9,7,8};Plane Surface(1)={1};Curve Loop(2)={2,10,6,-9};Plane Surface(2)={2};Curve Loop(3)={3,4,5,-10};Plane Surface(3)={3};
Transfinite Curve{1,7,3,5}=4;Transfinite Curve{2,6}=3;Transfinite Curve{4,8,9,10}=3; // halved by gmsh for quadrangles
Transfinite Surface{1};Transfinite Surface{2};Transfinite Surface{3};Recombine Surface{1,2,3};
Physical Curve("ground")={2};Physical Curve("top")={5,6,7};Physical Surface("body")={1,2,3};Physical Point("TR")={5};
