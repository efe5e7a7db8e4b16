// glass.lua for POV-Ray 3.7, with the same shading model: the same light in each pixel.
//
// - What is said in shapes.pov of hands, and in spot.pov of the hundredfold size, holds here.
// - Glass mirrors by Fresnel's formulas, and `conserve_energy` lets through what it does not
//   mirror. Where POV-Ray reflects totally, it forgets the share let through, and where glass is
//   tinted it tints only what goes through: so the glass is clear, and what is tinted (the pane)
//   has air's index, which neither bends nor mirrors.
// - The bubble is cut out of its ball. As an object of its own it would mirror nothing where rays
//   leave it: there POV-Ray 3.7 divides the bubble's index by itself (Trace::ComputeRelativeIOR
//   asks for the innermost object when the bubble is still in its list).
// - A mirror of grey share R leaves 1 - R for colour and highlights.
// - `max_trace_level` counts the camera's ray too: 9 are the 8 mirrorings and refractions of
//   --depth 8.
#version 3.7;

global_settings {
    assumed_gamma 1.0
    max_trace_level 9
    adc_bailout 0.000001
    ambient_light rgb 1
}

camera {
    perspective
    location 100 * <0.4, 2.4, 7.6>
    right -x * 4/3
    up y
    look_at 100 * <0, 0.85, 0>
    angle 46
}

light_source { 100 * <-4, 6, 5> rgb 0.6 }
light_source { 100 * <5, 7, 2> rgb 0.35 * <1, 0.9, 0.75> }

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

#macro Body(C, R, Specular, Shininess)
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
#macro Matt(C) Body(C, 0, 0.4, 60) #end
#macro Mirror(C, R) Body(C, R, 0.5, 120) #end

#macro Clear(Index)
    scale 100
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 phong 0 specular 0 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior Index }
#end

plane { y, 0 Mirror(<0.50, 0.48, 0.42>, 0.2) }
sphere { <-2.3, 0.9, -1.6>, 0.9 Mirror(<0.9, 0.2, 0.1>, 0.6) }
sphere { <2.2, 0.8, -1.9>, 0.8 Mirror(<0.2, 0.3, 0.9>, 0.75) }
polygon {
    5, <-1.2, 0.05, -3.6>, <1.4, 0.05, -3.3>, <1.4, 2.25, -3.7>, <-1.2, 2.25, -4.0>,
    <-1.2, 0.05, -3.6>
    Mirror(<0.1, 0.1, 0.1>, 0.85)
}
cylinder { <0.1, 0, -1.4>, <0.1, 1.5, -1.4>, 0.3 Matt(<0.95, 0.75, 0.10>) }
box { <-3.2, 0, 0.4>, <-2.4, 0.8, 1.2> Matt(<0.15, 0.60, 0.25>) }
sphere { <3.0, 0.45, 0.6>, 0.45 Matt(<0.85, 0.15, 0.55>) }

difference {
    sphere { <-0.9, 0.801, 0.6>, 0.8 }
    sphere { <-0.75, 0.9, 0.7>, 0.25 }
    Clear(1.5)
}
sphere { <0.85, 0.551, 1.6>, 0.55 Clear(1.33) }
sphere { <-0.2, 0.301, 2.6>, 0.3 Clear(2.42) }
box {
    <-0.45, -0.45, -0.45>, <0.45, 0.45, 0.45>
    rotate <0, 35, 0>
    translate <1.75, 0.451, 0.1>
    Clear(1.5)
}
