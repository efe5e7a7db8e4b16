/**
 * @file
 * @brief Aiming at lamps and suns.
 *
 * A ball that glows alike all over lights a point outside as its centre would, if nothing hides a
 * part of it: pi L (r / d)^2 cos, L being how bright it looks. So the light of a lamp is the same
 * whatever its radius, and L = I / (pi r^2). A soft lamp's rays are spread evenly over the cone
 * that the ball fills, of half-angle a with sin a = r / d. The cone's solid angle is 2 pi (1 - cos
 * a), and L times it, divided by what the centre gives, I / d^2, is the weight of one ray:
 *
 *     2 (1 - cos a) / sin^2 a = 2 / (1 + cos a)
 *
 * (Shirley, Wang, Zimmerman, *Monte Carlo Techniques for Direct Lighting Calculations*, 1996).
 */
#include "trace/lamp.h"

#include "trace/sequence.h"

/** Squares of distances below this, of the smallest length that a scene may hold, count as this. */
#define NEAREST_SQUARED ((scalar)(LENGTH_MINIMUM * LENGTH_MINIMUM))

/** No lamp gives more light than this at any point, so that sums stay finite in float. */
#define BRIGHTEST ((scalar)1e30)

/** @return The square of the distance from which on a lamp weakens. Within its ball it is as bright
 *          as at the ball, and nowhere brighter than a number can hold. @param radius The ball's.
 *  @param light Its light. */
static scalar nearest_squared_of(scalar radius, Scalar3 light) {
    scalar nearest = radius * radius, strongest = 1;
    strongest = light.red > strongest ? light.red : strongest;
    strongest = light.green > strongest ? light.green : strongest;
    strongest = light.blue > strongest ? light.blue : strongest;
    scalar bearable = strongest / BRIGHTEST;
    nearest = nearest > NEAREST_SQUARED ? nearest : NEAREST_SQUARED;
    return nearest > bearable ? nearest : bearable;
}

Scalar3 light_strength(const Light *light) {
    scalar intensity = (scalar)light->intensity;
    Scalar3 color = scalar3_of(light->color);
    return (Scalar3){color.red * intensity, color.green * intensity, color.blue * intensity};
}

Lamp lamp_of(const Light *light, int samples) {
    bool is_sun = light->kind == LIGHT_SUN, is_ball = light_is_ball(light);
    scalar radius = is_ball ? (scalar)light->radius : 0;
    Scalar3 bright = light_strength(light);
    Vector3 place = light->position;
    if (is_sun) {
        place = vector3_scale(vector3_normalize(vector3_scaled(light->direction)), -1);
    }
    return (Lamp){.place = vector_of(place),
                  .light = light3_of(bright),
                  .is_sun = is_sun,
                  .radius = radius,
                  .nearest_squared = nearest_squared_of(radius, bright),
                  .is_inverse_square = !is_sun && light->falloff == FALLOFF_INVERSE_SQUARE,
                  .is_soft = is_ball && samples > 1};
}

/** Notes what points could get from a lamp along one ray each. @param met The points. @param v
 * Which vector of them. @param way From them to the lamp. @param[in,out] shine What it would give.
 */
INLINE void shine_from(const Encounter *met, int v, Vector way, Shine *shine) {
    real distance_squared = real_max(vector_dot(way, way), real_of(NEAREST_SQUARED));
    real cosine = vector_dot(met->facing[v], way) / real_sqrt(distance_squared);
    shine->shadow.active[v] = met->lit[v] & (cosine > 0);
    shine->cosine[v] = cosine;
    shine->distance_squared[v] = distance_squared;
}

/** Aims at a sun. See #lamp_aim. @param lamp The sun. @param departure Where the rays start.
 *  @param met The points. @param[out] shine What it would give. */
static void aim_at_sun(const Lamp *lamp, const Departure *departure, const Encounter *met,
                       Shine *shine) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Vector way = lamp->place, origin = departure_origin(departure, &met->hits[v], way);
        shine_from(met, v, way, shine);
        shine->shadow.rays[v] = ray_of(origin, way);
        shine->shadow.limit[v] = real_of(INFINITE);
    }
}

/** Aims at a point. See #lamp_aim. @param lamp The lamp. @param departure Where the rays start.
 *  @param met The points. @param[out] shine What it would give. */
static void aim_at_point(const Lamp *lamp, const Departure *departure, const Encounter *met,
                         Shine *shine) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit *hit = &met->hits[v];
        Vector way = vector_subtract(lamp->place, hit->point);
        Vector origin = departure_origin(departure, hit, way);
        shine_from(met, v, way, shine);
        // The ray ends at the lamp itself: its parameter runs from 0 to 1.
        shine->shadow.rays[v] = ray_of(origin, vector_subtract(lamp->place, origin));
        shine->shadow.limit[v] = real_of(1);
    }
}

/** Lets the rays to a ball's centre end at the ball: what stands in it is not in the way.
 *  @param lamp The lamp. @param[in,out] shine The rays. */
static void end_at_ball(const Lamp *lamp, Shine *shine) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real rest = 1 - lamp->radius / real_sqrt(shine->distance_squared[v]);
        shine->shadow.limit[v] = real_max(rest, real_of(0));
    }
}

/** LANES points of the unit disc. */
typedef struct DiscPoint {
    real x; /**< Across. */
    real y; /**< Up. */
} DiscPoint;

/** @return The sine of an eighth of a turn times s. @param s -1 to 1. */
INLINE real sine_of_eighth(real s) {
    // Taylor's series to the ninth power: off by less than 2e-9.
    real x = s * (scalar)0.78539816339744830961, square = x * x;
    real sum = 1 - square / 72;
    sum = 1 - square / 42 * sum;
    sum = 1 - square / 20 * sum;
    return x * (1 - square / 6 * sum);
}

/**
 * @return Points of the unit disc, as evenly spread as those of the square are: squares around the
 *         middle become circles (Shirley, Chiu, *A Low Distortion Map Between Disk and Square*,
 *         1997).
 * @param a  Across, -1 to 1.
 * @param b  Up, -1 to 1.
 */
INLINE DiscPoint disc_point(real a, real b) {
    mask is_wide = real_abs(a) > real_abs(b);
    real radius = real_select(is_wide, a, b), other = real_select(is_wide, b, a);
    real turn = real_select(radius == 0, real_of(0), other / radius);
    real sine = sine_of_eighth(turn), along = radius * real_sqrt(1 - sine * sine);
    real across = radius * sine;
    return (DiscPoint){real_select(is_wide, along, across), real_select(is_wide, across, along)};
}

/** @return -1 to 1, exact in every number type. @param bits Shares of 2^32. */
INLINE scalar signed_share(uint32_t bits) {
    return (scalar)((int32_t)(bits >> 8) - (1 << 23)) * (scalar)0x1p-23;
}

/**
 * @return The points of a ball's disc that the rays of a packet ask for: for all pixels the same
 *         point of the sequence, moved in each by its own number (exclusive or keeps the evenness
 * of Sobol's points).
 * @param lineage  Whose rays.
 * @param number   Which lamp.
 * @param v        Which vector of rays.
 */
static DiscPoint disc_choose(const Lineage *lineage, size_t number, int v) {
    uint32_t occasion = sequence_combine((uint32_t)number, lineage->bounce);
    SequencePoint point = sequence_point(lineage->sample, occasion);
    real a = {0}, b = {0};
    for (int i = 0; i < LANES; i++) {
        uint32_t pixel = sequence_hash(lineage->pixels[v * LANES + i] ^ occasion);
        real_set_lane(&a, i, signed_share(point.x ^ pixel));
        real_set_lane(&b, i, signed_share(point.y ^ sequence_hash(pixel)));
    }
    return disc_point(a, b);
}

/**
 * @return Directions within the cone that a ball fills.
 * @param axis    Unit vectors to the ball's centre.
 * @param spread  1 - cos a of the cone.
 * @param disc    Where in the cone.
 */
INLINE Vector cone_direction(Vector axis, real spread, DiscPoint disc) {
    // Two vectors at right angles (Duff and others, *Building an Orthonormal Basis, Revisited*,
    // 2017).
    real sign = real_select(axis.z < 0, real_of(-1), real_of(1));
    real a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
    Vector across = {1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
    Vector up = {b, sign + axis.y * axis.y * a, -axis.y};
    // The share of the disc within a point is the share of the cone within its direction.
    real share = disc.x * disc.x + disc.y * disc.y;
    real aside = real_sqrt(spread * (2 - share * spread));
    Vector out = vector_add(vector_scale(across, disc.x * aside), vector_scale(up, disc.y * aside));
    return vector_normalize(vector_add(out, vector_scale(axis, 1 - share * spread)));
}

/** Aims at a ball, each ray at another point of it. See #lamp_aim. @param lamp The lamp.
 *  @param number Which it is. @param departure Where the rays start. @param met The points.
 *  @param[out] shine What the lamp would give. */
static void aim_at_ball(const Lamp *lamp, size_t number, const Departure *departure,
                        const Encounter *met, Shine *shine) {
    real radius_squared = real_of(lamp->radius * lamp->radius);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit *hit = &met->hits[v];
        shine->shadow.active[v] = met->lit[v];
        if (!any(met->lit[v])) {
            continue;
        }
        Vector way = vector_subtract(lamp->place, hit->point);
        real distance_squared = real_max(vector_dot(way, way), real_of(NEAREST_SQUARED));
        real distance = real_sqrt(distance_squared);
        real sine_squared = real_min(radius_squared / distance_squared, real_of(1));
        real cosine = real_sqrt(1 - sine_squared), spread = sine_squared / (1 + cosine);
        DiscPoint disc = disc_choose(&met->packet->lineage, number, v);
        Vector direction = cone_direction(vector_scale(way, 1 / distance), spread, disc);
        // The ray ends where it meets the ball: half a chord before its point nearest the centre.
        real along = vector_dot(way, direction);
        real half_squared = radius_squared - (distance_squared - along * along);
        real end = along - real_sqrt(real_max(half_squared, real_of(0)));
        shine->shadow.rays[v] = ray_of(departure_origin(departure, hit, direction), direction);
        shine->shadow.limit[v] = real_max(end, real_of(0));
        shine->cosine[v] = vector_dot(met->facing[v], direction);
        shine->shadow.active[v] &= shine->cosine[v] > 0;
        shine->distance_squared[v] = distance_squared;
        shine->weight[v] = 2 / (1 + cosine);
    }
}

void lamp_aim(const Lamp *lamp, size_t number, const Departure *departure, const Encounter *met,
              Shine *shine) {
    shine->shadow.wants_points = false;
    if (lamp->is_soft) {
        aim_at_ball(lamp, number, departure, met, shine);
        return;
    }
    if (lamp->is_sun) {
        aim_at_sun(lamp, departure, met, shine);
        return;
    }
    aim_at_point(lamp, departure, met, shine);
    if (lamp->radius > 0) {
        end_at_ball(lamp, shine);
    }
}
