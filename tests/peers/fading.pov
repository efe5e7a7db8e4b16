// fading.lua for POV-Ray 3.7, with the same shading model. What is said in shapes.pov of hands, and in
// spot.pov of the hundredfold size, holds here.
//
// POV-Ray multiplies a lamp by 2 / (1 + (d / f)^p), f being its fade_distance and p its fade_power.
// With p = 2 that is 2 f^2 / (f^2 + d^2), and so a lamp of light I / (2 f^2) gives
//
//     I / (f^2 + d^2),
//
// which is I / d^2 but for a share of f^2 / d^2: a millionth, where f is a thousandth of d.
#version 3.7;

global_settings {
    assumed_gamma 1.0
    max_trace_level 6
    adc_bailout 0.000001
    ambient_light rgb 1
}

camera {
    perspective
    location 100 * <0.5, 2.6, 7.5>
    right -x * 4/3
    up y
    look_at 100 * <0, 0.8, 0>
    angle 46
}

// Lengths are a hundred times ours, so that light is 100^2 times as strong.
#declare F = 0.1;
#macro Lamp(Place, C, I)
    light_source {
        100 * Place
        rgb I * 100 * 100 / (2 * F * F) * C
        fade_distance F
        fade_power 2
    }
#end
Lamp(<-0.5, 2.4, 2.5>, <1, 0.9, 0.7>, 3)
Lamp(<3.4, 0.7, 0.4>, <0.5, 0.6, 1>, 1.5)

#macro Matt(C, Specular)
    pigment { rgb C }
    finish { ambient rgb 0.15 diffuse 1 phong Specular phong_size 60 specular 0 reflection { 0 } }
#end

plane { y, 0 Matt(<0.55, 0.52, 0.45>, 0) }
sphere { 100 * <-1.2, 0.9, 0.2>, 60 Matt(<0.9, 0.3, 0.2>, 0.4) }
box { 100 * <0.4, 0, -0.8>, 100 * <1.2, 1.6, 0.0> Matt(<0.2, 0.5, 0.8>, 0.4) }
cylinder { 100 * <1.9, 0.3, 1.4>, 100 * <0.2, 0.9, 1.6>, 15 Matt(<0.8, 0.7, 0.2>, 0.4) }
mesh {
    triangle { 100 * <-3, 0, -3>, 100 * <3, 0, -3>, 100 * <3, 2.5, -3> }
    triangle { 100 * <-3, 0, -3>, 100 * <3, 2.5, -3>, 100 * <-3, 2.5, -3> }
    Matt(<0.5, 0.5, 0.5>, 0.4)
}
