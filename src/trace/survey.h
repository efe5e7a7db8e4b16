/**
 * @file
 * @brief What is noted of the rays of pixels. See dioptre/survey.h.
 *
 * Nobody but the layers of the window asks; where nobody does, a packet costs one look at a
 * pointer.
 */
#ifndef DIOPTRE_TRACE_SURVEY_H
#define DIOPTRE_TRACE_SURVEY_H

#include "trace/tracer.h"

/** Notes what rays have met. @param met The surfaces; somebody asks for a survey of its packet. */
void survey_surfaces(const Encounter *met);

/**
 * Notes which points a lamp does not reach.
 * @param met      The points; somebody asks for a survey of their packet.
 * @param lamp     Place of the lamp.
 * @param shadow   The rays to it.
 * @param blocked  Those with something in their way.
 */
void survey_shadows(const Encounter *met, size_t lamp, const Packet *shadow, const mask *blocked);

/** Surveys a grid of pixels. See #Engine.survey. @param tracer The tracer. @param grid The pixels.
 *  @param wanted What of them. @param[out] points What is known of them.
 *  @param[in,out] counts The rays traced. */
void survey_grid(const Tracer *tracer, const PixelGrid *grid, unsigned wanted, SurveyPoint *points,
                 RayCounts *counts);

#endif
