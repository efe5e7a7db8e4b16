// pictures.lua for POV-Ray 3.7, with the same shading model: the same light in each pixel. What is
// said in glass.pov and in shapes.pov holds here.
#version 3.7;

global_settings {
    assumed_gamma 1.0
    max_trace_level 6
    adc_bailout 0.000001
    ambient_light rgb 1
}

camera {
    perspective
    location 100 * <0.4, 0.9, 5.2>
    right -x * 4/3
    up y
    look_at 100 * <0.1, 0.1, 0>
    angle 46
}

light_source { 100 * <-4, 6, 5> rgb 0.9 }

// The panorama's middle is at +x until it is turned, and it is a mirror image.
sky_sphere {
    pigment {
        image_map { jpeg "stars.jpg" gamma srgb map_type 1 interpolate 2 }
        rotate <0, -90, 0>
    }
}

sphere {
    0, 1
    pigment {
        image_map { jpeg "earth.jpg" gamma srgb map_type 1 interpolate 2 }
        scale <-1, 1, 1>
        rotate <0, -90, 0>
    }
    finish { ambient 0.15 diffuse 1 phong 0.4 phong_size 60 specular 0 reflection { 0 } }
    scale 1.05
    translate <-1.1, 0, 0>
    scale 100
}

sphere {
    <1.3, 0, 0>, 1
    scale 100
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 phong 0 specular 0 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior 1.5 }
}
