// scenes/box.lua for POV-Ray 3.7, with the same shading model: the same light in each pixel.
//
// - POV-Ray is left-handed; `right -x * 4/3` turns it round, so that all numbers are box.lua's.
// - Where our body mirrors R of the light, only 1 - R of it makes colour and highlight, in each of
//   the three colours. POV-Ray knows no such thing, so a mirror here has a lamp of its own, of the
//   colour 1 - R, at the same place: a light group. All shapes throw shadows in it.
// - `max_trace_level` counts the camera's ray too: 6 are the 5 mirrorings of --depth 5.
// - Picture files: sRGB, 8 bits, no dithering: see run.sh.
#version 3.7;

#declare Lamp_Position = <0, 1.75, 0.6>;
#declare Lamp_Color = <1.2, 1.2, 1.2>;
#declare Ambient = <0.15, 0.15, 0.15>;

global_settings {
    assumed_gamma 1.0
    max_trace_level 6
    adc_bailout 0.000001
    ambient_light rgb 1
}

camera {
    perspective
    location <0, 0, 6.5>
    right -x * 4/3
    up y
    look_at <0, 0, 0>
    angle 46
}

light_source { Lamp_Position rgb Lamp_Color }

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

#macro Quad(C, Corner, U, V)
    polygon {
        5, Corner, Corner + U, Corner + U + V, Corner + V, Corner
        pigment { rgb C }
        finish { ambient rgb Ambient diffuse 1 phong 0 specular 0 reflection { 0 } }
    }
#end

#macro Mirror(C, R, Specular, Shininess)
    pigment { rgb C }
    finish {
        ambient rgb Ambient * (<1, 1, 1> - R)
        diffuse 1
        phong Specular
        phong_size Shininess
        specular 0
        reflection { rgb R }
    }
#end

#macro Own_Lamp(R)
    light_source { Lamp_Position rgb Lamp_Color * (<1, 1, 1> - R) }
    global_lights off
#end

Quad(<0.10, 0.36, 0.11>, <-2, -2, -2>, <4, 0, 0>, <0, 0, 4>) // floor
Quad(<0.14, 0.44, 0.16>, <-2,  2, -2>, <4, 0, 0>, <0, 0, 4>) // ceiling
Quad(<0.13, 0.46, 0.16>, <-2, -2, -2>, <4, 0, 0>, <0, 4, 0>) // back
Quad(<0.07, 0.36, 0.13>, <-2, -2, -2>, <0, 0, 4>, <0, 4, 0>) // left
Quad(<0.15, 0.40, 0.08>, < 2, -2, -2>, <0, 0, 4>, <0, 4, 0>) // right

#declare Red_R = <0.42, 0.20, 0.20>;
light_group {
    sphere { <-0.8, -1.15, -0.9>, 0.85 Mirror(<0.95, 0.05, 0.04>, Red_R, 0.9, 150) }
    Own_Lamp(Red_R)
}

#declare Blue_R = <0.30, 0.36, 0.60>;
light_group {
    box { <0.40, -2.0, -1.2>, <1.60, -0.8, 0.0> Mirror(<0.05, 0.14, 0.80>, Blue_R, 0.6, 60) }
    Own_Lamp(Blue_R)
}

Quad(<0.90, 0.62, 0.03>, <0.05, -1.2, -1.65>, <1.7, 0, 0.1>, <-0.1, 1.6, -0.3>) // panel
