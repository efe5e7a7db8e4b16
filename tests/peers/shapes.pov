// shapes.lua for POV-Ray 3.7, with the same shading model: the same light in each pixel.
//
// POV-Ray is left-handed; `right -x * 4/3` turns the picture round, so that all numbers are
// shapes.lua's, the angles too: what is a turn by the left hand becomes one by the right.
#version 3.7;

global_settings {
    assumed_gamma 1.0
    max_trace_level 6
    adc_bailout 0.000001
    ambient_light rgb 1
}

camera {
    perspective
    location <0.5, 2.6, 7.5>
    right -x * 4/3
    up y
    look_at <0, 0.8, 0>
    angle 46
}

light_source { <-4, 6, 5> rgb 0.9 }

// From the horizon up by the sine of the height; below the horizon as at the horizon.
sky_sphere {
    pigment {
        function { max(0, y) }
        color_map {
            [0 rgb <0.12, 0.17, 0.30>]
            [1 rgb <0.02, 0.04, 0.12>]
        }
    }
}

#macro Matt(C, Specular)
    pigment { rgb C }
    finish { ambient rgb 0.15 diffuse 1 phong Specular phong_size 60 specular 0 reflection { 0 } }
#end

plane { y, 0 Matt(<0.55, 0.52, 0.45>, 0) }
cylinder { <-2.2, 0, -0.5>, <-2.0, 1.8, -0.8>, 0.6 Matt(<0.1, 0.2, 0.8>, 0.4) }
cylinder { <1.2, 0.45, 1.6>, <2.3, 0.5, 0.3>, 0.42 open Matt(<0.8, 0.45, 0.2>, 0.4) }
disc { <-0.5, 1.0, -1.6>, <0.3, 0.4, 1>, 0.9 Matt(<0.1, 0.6, 0.2>, 0.4) }
triangle { <1.1, 0.1, -1.2>, <2.6, 0.6, -1.6>, <1.5, 2.1, -1.9> Matt(<0.8, 0.1, 0.1>, 0.4) }
box {
    <-0.5, -0.5, -0.5>, <0.5, 0.5, 0.5>
    scale <1, 0.7, 1.4>
    rotate <20, 35, -10>
    translate <0.6, 0.9, 0.2>
    Matt(<0.6, 0.3, 0.7>, 0.4)
}
sphere {
    <0, 0, 0>, 1
    scale <0.4, 0.75, 0.4>
    rotate <0, 0, 30>
    translate <-0.9, 0.7, 1.4>
    Matt(<0.9, 0.8, 0.6>, 0.4)
}
