/**
 * @file
 * @brief Size and quality of a scene's image.
 */
#include "dioptre/scene.h"

/** Words of `encoding`, in the order of #Encoding. */
static const char *const encoding_words[] = {"srgb", "linear", NULL};

/** Fields of `image`. */
static const Parameter scene_image_parameters[] = {
    {.name = "width",
     .type = PARAMETER_INTEGER,
     .offset = offsetof(SceneImage, width),
     .minimum = 1,
     .maximum = IMAGE_SIZE_MAXIMUM,
     .unit = "pixels",
     .help = "width of the picture"},
    {.name = "height",
     .type = PARAMETER_INTEGER,
     .offset = offsetof(SceneImage, height),
     .minimum = 1,
     .maximum = IMAGE_SIZE_MAXIMUM,
     .unit = "pixels",
     .help = "height of the picture"},
    {.name = "encoding",
     .type = PARAMETER_CHOICE,
     .offset = offsetof(SceneImage, encoding),
     .choices = encoding_words,
     .unit = "word",
     .help = "curve from light to numbers"},
    {.name = "samples",
     .type = PARAMETER_INTEGER,
     .offset = offsetof(SceneImage, samples),
     .minimum = 1,
     .maximum = SAMPLES_MAXIMUM,
     .unit = "rays per pixel",
     .help = "more make edges smooth"},
    {.name = "depth",
     .type = PARAMETER_INTEGER,
     .offset = offsetof(SceneImage, depth),
     .minimum = 0,
     .maximum = DEPTH_MAXIMUM,
     .unit = "times",
     .help = "how often a ray may be mirrored or refracted"},
    {.name = "cutoff",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(SceneImage, cutoff),
     .minimum = 0,
     .maximum = CUTOFF_MAXIMUM,
     .unit = "8-bit steps",
     .help = "how much all light may be worth that a pixel lacks; 0: no ray ends early"},
    {0}};

/** 800 by 600 pixels, one sample per pixel, automatic depth, a quarter of a step. */
static const SceneImage scene_image_defaults = {.width = 800,
                                                .height = 600,
                                                .encoding = ENCODING_SRGB,
                                                .samples = 1,
                                                .depth = IMAGE_DEPTH_AUTO,
                                                .cutoff = CUTOFF_DEFAULT};

const Keyword scene_image_keyword = {.name = "image",
                                     .help = "size and quality of the picture",
                                     .parameters = scene_image_parameters,
                                     .size = sizeof(SceneImage),
                                     .defaults = &scene_image_defaults};
