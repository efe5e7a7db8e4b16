/**
 * @file
 * @brief Does the steps of a lesson: each does what a viewer would do with keys and mouse.
 */
#ifndef DIOPTRE_VIEW_LESSON_LESSON_STEP_H
#define DIOPTRE_VIEW_LESSON_LESSON_STEP_H

#include "view/app.h"

/** Does a step, at the present time of the lesson's clock. */
void lesson_step_do(App *app, const LessonStep *step);

#endif
