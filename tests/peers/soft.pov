// soft.lua for POV-Ray 3.7, with the same shading model. What is said in shapes.pov of hands, and in
// spot.pov of the hundredfold size, holds here.
//
// Our ball of light looks alike bright all over. A point r from its middle, of radius 1, stands for
// its share of a density of 1 / sqrt(1 - r^2): along any line through the ball, b from the middle,
//
//     integral of dz / sqrt(1 - b^2 - z^2) = pi,    whatever b is,
//
// so that many lamps spread so are an even disc from wherever one looks. A lamp's share u of those
// nearer to the middle is (asin r - r sqrt(1 - r^2)) / (pi / 2), which is solved for r by halving.
// POV-Ray's own area lights are flat, and their circles not even.
#version 3.7;

#declare Lamps = 4096;
#declare Radius = 0.5;

global_settings {
    assumed_gamma 1.0
    max_trace_level 1
    ambient_light rgb 1
}

camera {
    perspective
    location 100 * <0, 3, 0.6>
    right -x * 4/3
    up y
    look_at 100 * <0, 0, 0>
    angle 46
}

#macro Distance(U)
    #local Low = 0;
    #local High = 1;
    #for (I, 1, 40)
        #local R = (Low + High) / 2;
        #if ((asin(R) - R * sqrt(1 - R * R)) / (pi / 2) < U)
            #local Low = R;
        #else
            #local High = R;
        #end
    #end
    R
#end

// Evenly spread by multiples of powers of one number (Roberts): of x^4 = x + 1.
#declare Step = 1 / 1.2207440846057596;
#for (I, 1, Lamps)
    #local R = Distance(mod(0.5 + I * Step, 1));
    #local Height = 2 * mod(0.5 + I * Step * Step, 1) - 1;
    #local Turn = 2 * pi * mod(0.5 + I * Step * Step * Step, 1);
    #local Across = sqrt(1 - Height * Height);
    light_source {
        100 * (<-4, 6, 5> + Radius * R * <Across * cos(Turn), Height, Across * sin(Turn)>)
        rgb 0.8 / Lamps
    }
#end

#macro Matt(C, Specular)
    pigment { rgb C }
    finish { ambient rgb 0.15 diffuse 1 phong Specular phong_size 60 specular 0 reflection { 0 } }
#end

plane { y, 0 Matt(<0.8, 0.75, 0.65>, 0.4) }
sphere { 100 * <-1.9, 2, 1.3>, 35 }
box { 100 * <-1.3, 1.8, 1.9>, 100 * <-0.8, 2.2, 2.4> }
cylinder { 100 * <-1.5, 1.9, 0.8>, 100 * <-0.9, 1.1, 0.9>, 15 }
cylinder { 100 * <-1.1, 0.7, 1.6>, 100 * <-0.7, 0.9, 1.9>, 8 }
