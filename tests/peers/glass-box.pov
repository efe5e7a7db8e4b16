// glass-box.lua for POV-Ray 3.7, with the same shading model: the same light in each pixel. What is
// said in glass.pov of glass and mirrors, and in shapes.pov of hands, holds here; 6 are the 5
// mirrorings and refractions of --depth 5.
#version 3.7;

global_settings {
    assumed_gamma 1.0
    max_trace_level 6
    adc_bailout 0.000001
    ambient_light rgb 1
}

camera {
    perspective
    location 100 * <0, 0, 6.5>
    right -x * 4/3
    up y
    look_at <0, 0, 0>
    angle 46
}

light_source { 100 * <0, 1.75, 0.6> rgb 1.2 }

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
        scale 100
        pigment { rgb C }
        finish { ambient 0.15 diffuse 1 phong 0 specular 0 reflection { 0 } }
    }
#end

#macro Mirror(C, R, Specular, Shininess)
    scale 100
    pigment { rgb C }
    finish {
        ambient 0.15 * (1 - R)
        diffuse 1 - R
        phong Specular * (1 - R)
        phong_size Shininess
        specular 0
        reflection { R }
    }
#end

#macro Clear(Index)
    scale 100
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 phong 0 specular 0 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior Index }
#end

Quad(<0.10, 0.36, 0.11>, <-2, -2, -2>, <4, 0, 0>, <0, 0, 4>) // floor
Quad(<0.14, 0.44, 0.16>, <-2,  2, -2>, <4, 0, 0>, <0, 0, 4>) // ceiling
Quad(<0.13, 0.46, 0.16>, <-2, -2, -2>, <4, 0, 0>, <0, 4, 0>) // back
Quad(<0.07, 0.36, 0.13>, <-2, -2, -2>, <0, 0, 4>, <0, 4, 0>) // left
Quad(<0.15, 0.40, 0.08>, < 2, -2, -2>, <0, 0, 4>, <0, 4, 0>) // right

sphere { <-0.8, -1.15, -0.9>, 0.85 Mirror(<0.95, 0.05, 0.04>, 0.3, 0.9, 150) }
box { <0.40, -2.0, -1.2>, <1.60, -0.8, 0.0> Mirror(<0.05, 0.14, 0.80>, 0.4, 0.6, 60) }
difference {
    sphere { <0.45, -1.35, 0.9>, 0.55 }
    sphere { <0.55, -1.25, 1.0>, 0.18 }
    Clear(1.5)
}
box {
    <-1.7, -1.99, 0.3>, <-1.0, -1.0, 0.35>
    scale 100
    pigment { rgbf <0.9, 0.6, 0.3, 1> }
    finish { ambient 0 diffuse 0 phong 0 specular 0 reflection { 0 } }
    interior { ior 1 }
}
