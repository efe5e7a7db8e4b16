/**
 * @file
 * @brief What is noted of the rays of pixels.
 */
#include "trace/survey.h"

#include "trace/grid.h"

/** @return Place of a shape, or -1: a lamp that is seen is none. @param hit Hits. @param lane Which
 *          of them. */
static int shape_met(const Hit *hit, int lane) {
    int shape = integer_lane(hit->shape, lane);
    return shape >= 0 ? shape : -1;
}

/** Notes what the camera's rays have met. @param packet The rays. @param hits What they met.
 *  @param[in,out] points What is known of them. */
static void hits_note(const Packet *packet, const Hit *hits, SurveyPoint *points) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        const Hit *hit = &hits[i / LANES];
        int lane = i % LANES;
        bool is_met = mask_lane(packet->active[i / LANES], lane) && shape_met(hit, lane) >= 0;
        points[i].shape = is_met ? shape_met(hit, lane) : -1;
        points[i].distance = (double)real_lane(hit->distance, lane);
        points[i].normal[0] = is_met ? (double)real_lane(hit->normal.x, lane) : 0;
        points[i].normal[1] = is_met ? (double)real_lane(hit->normal.y, lane) : 0;
        points[i].normal[2] = is_met ? (double)real_lane(hit->normal.z, lane) : 0;
    }
}

/** Notes where on a picture rays have met a shape. @param place The places. @param lanes Those that
 *  count. @param[in,out] points What is known of the rays. */
static void place_note(const TexturePlace *place, mask lanes, SurveyPoint *points) {
    for (unsigned left = mask_bits(lanes); left; left &= left - 1) {
        int lane = __builtin_ctz(left);
        points[lane].place[0] = (double)real_lane(place->u, lane);
        points[lane].place[1] = (double)real_lane(place->v, lane);
    }
}

/** Notes where on pictures the camera's rays have met shapes. @param list All shapes. @param packet
 *  The rays. @param hits What they met. @param[in,out] points What is known of them. */
static void places_note(const ShapeList *list, const Packet *packet, const Hit *hits,
                        SurveyPoint *points) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask left = packet->active[v] & (hits[v].shape >= integer_of(0));
        while (any(left)) {
            int shape = integer_lane(hits[v].shape, mask_first(left));
            mask same = left & (hits[v].shape == integer_of(shape));
            TexturePlace place = shape_texture_place(list->shapes[shape], &hits[v], same);
            place_note(&place, same, points + v * LANES);
            left &= mask_not(same);
        }
    }
}

/** Notes what a ray that goes on has met. @param shape The shape, or -1. @param[in,out] point What
 *  is known of its pixel. */
static void next_note(int shape, SurveyPoint *point) {
    if (point->next_count < SURVEY_NEXT) {
        point->next[point->next_count++] = shape;
    }
}

void survey_surfaces(const Encounter *met) {
    const Lineage *lineage = &met->packet->lineage;
    if (lineage->bounce == 0) {
        hits_note(met->packet, met->hits, lineage->notes->survey);
    }
    for (int i = 0; i < PACKET_RAYS; i++) {
        if (mask_lane(met->packet->active[i / LANES], i % LANES)) {
            lineage->notes->survey[i].rays++;
            if (lineage->bounce == 1) {
                next_note(shape_met(&met->hits[i / LANES], i % LANES), &lineage->notes->survey[i]);
            }
        }
    }
}

void survey_shadows(const Encounter *met, size_t lamp, const Packet *shadow, const mask *blocked) {
    const Lineage *lineage = &met->packet->lineage;
    bool is_noted = lineage->bounce == 0 && lamp < SURVEY_LAMPS;
    uint64_t bit = is_noted ? UINT64_C(1) << lamp : 0;
    for (int i = 0; i < PACKET_RAYS; i++) {
        if (mask_lane(shadow->active[i / LANES], i % LANES)) {
            SurveyPoint *point = &lineage->notes->survey[i];
            point->rays++;
            point->asked |= bit;
            point->dark |= mask_lane(blocked[i / LANES], i % LANES) ? bit : 0;
        }
    }
}

/* --- marching steps --------------------------------------------------------------------------- */

/** Marches to where rays have met anything, and their steps. */
typedef struct Pacing {
    const Hit *hits;            /**< What they have met. */
    real steps[PACKET_VECTORS]; /**< The steps so far. */
} Pacing;

/** Adds the steps of a shape. See #ShapeVisitor. @param shape The shape. @param packet The rays.
 *  @param v Which vector. @param active Which lanes. @param[in,out] found The #Pacing. */
static void shape_pace(const Shape *shape, const Packet *packet, int v, mask active, void *found) {
    Pacing *pacing = found;
    const Hit *hit = &pacing->hits[v];
    if (!shape->class->steps) {
        return;
    }
    // The shape that was met is marched to its surface, wherever roundings put the limit.
    mask is_met = hit->shape == integer_of(shape->place);
    real limit = real_select(is_met, real_of(INFINITE), hit->distance);
    real steps = shape->class->steps(shape, &packet->rays[v], active, limit);
    pacing->steps[v] += real_select(active, steps, real_of(0));
}

/** Counts the steps of the camera's rays to what they met. @param list All shapes. @param packet
 *  The rays. @param hits What they met. @param[in,out] points What is known of them. */
static void steps_note(const ShapeList *list, const Packet *packet, const Hit *hits,
                       SurveyPoint *points) {
    Packet limited = *packet;
    Pacing pacing = {.hits = hits};
    for (int v = 0; v < PACKET_VECTORS; v++) {
        limited.limit[v] = hits[v].distance;
        pacing.steps[v] = real_of(0);
    }
    shape_list_visit(list, &limited, shape_pace, &pacing);
    for (int i = 0; i < PACKET_RAYS; i++) {
        points[i].steps = (uint32_t)real_lane(pacing.steps[i / LANES], i % LANES);
    }
}

/* --- pixels ----------------------------------------------------------------------------------- */

/** Surveys a packet by its camera's rays alone. @param tracer The tracer. @param packet The rays.
 *  @param wanted What is wanted. @param[in,out] points What is known of them. */
static void packet_survey(const Tracer *tracer, const Packet *packet, unsigned wanted,
                          SurveyPoint *points) {
    Hit hits[PACKET_VECTORS];
    shape_list_nearest(&tracer->list, packet, hits);
    if (tracer->glow.count > 0) {
        glow_nearest(&tracer->glow, packet, hits);
    }
    hits_note(packet, hits, points);
    if (wanted & SURVEY_PLACE) {
        places_note(&tracer->list, packet, hits, points);
    }
    if (wanted & SURVEY_STEPS) {
        steps_note(&tracer->list, packet, hits, points);
    }
}

/** Puts what is known of a packet where it belongs. @param colors Its colours; NULL: nobody asked.
 *  @param grid The grid. @param column The packet's first column. @param row Its first row.
 *  @param points What is known of it. @param[out] all What is known of the grid. */
static void points_write(const Light3 *colors, const PixelGrid *grid, int column, int row,
                         SurveyPoint *points, SurveyPoint *all) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        int c = column + i % PACKET_COLUMNS, r = row + i / PACKET_COLUMNS;
        if (colors) {
            points[i].color[0] = (double)real_lane(colors[i / LANES].red, i % LANES);
            points[i].color[1] = (double)real_lane(colors[i / LANES].green, i % LANES);
            points[i].color[2] = (double)real_lane(colors[i / LANES].blue, i % LANES);
        }
        if (c < grid->columns && r < grid->rows) {
            all[(size_t)r * (size_t)grid->columns + (size_t)c] = points[i];
        }
    }
}

void survey_grid(const Tracer *tracer, const PixelGrid *grid, unsigned wanted, SurveyPoint *points,
                 RayCounts *counts) {
    bool follows = wanted & SURVEY_LIGHT;
    GridTrace trace = {tracer, grid, eye_sample(grid->sample), NULL, counts};
    for (int row = 0; row < grid->rows; row += PACKET_ROWS) {
        for (int column = 0; column < grid->columns; column += PACKET_COLUMNS) {
            SurveyPoint noted[PACKET_RAYS] = {0};
            Packet packet;
            Light3 colors[PACKET_VECTORS];
            if (follows) {
                grid_follow(&trace, column, row, &(Notes){.survey = noted}, colors);
            }
            if (!follows || (wanted & ~(unsigned)SURVEY_LIGHT)) {
                eye_aim(&tracer->eye, grid, trace.place, column, row, &packet);
                packet_survey(tracer, &packet, wanted, noted);
            }
            points_write(follows ? colors : NULL, grid, column, row, noted, points);
        }
    }
    counts->camera += (uint64_t)grid->columns * (uint64_t)grid->rows;
}
