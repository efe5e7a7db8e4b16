/**
 * @file
 * @brief What the picture of the window shows, for those who do not see it.
 */
#ifndef DIOPTRE_WEB_DESCRIPTION_H
#define DIOPTRE_WEB_DESCRIPTION_H

#include "view/app.h"

/** @return Shapes, lights, camera, layer and what is in the middle, as JSON; to be freed. NULL
 * without memory. */
char *description_write(App *app);

#endif
