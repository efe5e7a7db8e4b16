// spot.lua for POV-Ray 3.7, with the same shading model: the same light in each pixel. What is
// said in shapes.pov of hands holds here. The two meshes are made from the model by mesh2.awk, in
// a folder that +L names. All is a hundred times as large, for POV-Ray's shadow rays overlook what
// is nearer than 0.001: in creases there would be specks of light.
#version 3.7;

global_settings {
    assumed_gamma 1.0
    max_trace_level 6
    adc_bailout 0.000001
    ambient_light rgb 1
}

camera {
    perspective
    location 100 * <0.3, 1.4, 4.2>
    right -x * 4/3
    up y
    look_at 100 * <0, 0.75, 0>
    angle 46
}

light_source { 100 * <-4, 6, 5> rgb 0.9 }

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
#include "flat.inc"
    rotate <0, 150, 0>
    translate <-0.9, 0.74, 0>
    scale 100
    Matt(<0.2, 0.5, 0.8>, 0.4)
}
#include "smooth.inc"
    rotate <0, 220, 0>
    translate <0.9, 0.74, 0>
    scale 100
    Matt(<0.8, 0.5, 0.3>, 0.4)
}
