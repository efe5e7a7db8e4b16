// sun.lua for POV-Ray 3.7, with the same shading model. What is said in shapes.pov of hands, and in
// spot.pov of the hundredfold size, holds here. A parallel light shines from the plane in which it
// stands: that is beyond all shapes.
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

light_source {
    100000 * <1, 1.5, 1.2>
    rgb 0.8 * <1, 0.95, 0.85>
    parallel
    point_at <0, 0, 0>
}

// From the horizon up by the sine of the height; below the horizon as at the horizon.
sky_sphere {
    pigment {
        function { max(0, y) }
        color_map {
            [0 rgb <0.45, 0.55, 0.70>]
            [1 rgb <0.10, 0.20, 0.45>]
        }
    }
}

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
