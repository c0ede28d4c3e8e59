/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the friction that the floor needs so that no foot slips, from the forces on the hinges (forces.c). */
#include "motion/forces.h"

enum { FLOOR_SAMPLES = 24, FLOOR_HALVINGS = 24 };

/* A search ends when no peak can exceed the largest known value by more than this fraction. */
#define FLOOR_TOL fmax((real)1e-7, 16 * REAL_EPSILON)

/* The walk from the head backwards ends at the first domino that is slower than this fraction of the head's
 * speed. Nobody would see the dominoes behind it slip. */
#define FLOOR_SHARE ((real)1e-3)

/* The walk looks at no more dominoes than this. */
enum { FLOOR_SHOWN = 4096 };

struct required_walk {
    struct required_friction required_friction;
    size_t seen; /* the number of dominoes that the walk has looked at */
};

static bool required_seen(const struct hinge_load *hinge_load, void *context)
{
    struct required_walk *walk = context;
    struct required_friction *required_friction = &walk->required_friction;
    walk->seen++;
    real motion = friction_needed(hinge_load->x, hinge_load->z),
         hit = friction_needed(hinge_load->impulse_x, hinge_load->impulse_z);
    if (motion > required_friction->motion) {
        required_friction->motion = motion;
        required_friction->domino = hinge_load->link->i;
    }
    if (hit > required_friction->hit) {
        required_friction->hit = hit;
        required_friction->hit_domino = hinge_load->link->i;
    }
    return hinge_load->link->slope > FLOOR_SHARE;
}

/* Sets *motion to the friction coefficient that the floor needs during the motion, at the tilt theta. Also
 * updates the maxima in *required_friction. */
static enum dom_status required_at(const struct segment *st, real theta,
                                   struct required_friction *required_friction, real *motion)
{
    struct tilt head;
    struct kinematics kinematics = {.floor = true};
    struct required_walk walk;
    const struct required_friction *here = &walk.required_friction;
    enum dom_status status = segment_kinematics(st, theta, &head, &kinematics);
    /* More dominoes may move than count for the energy, because light ones do not count. */
    size_t shown = kinematics.n > required_friction->shown ? kinematics.n : required_friction->shown;
    for (; status == DOM_OK; shown *= 2) {
        walk = (struct required_walk){.required_friction = {.motion = -1,
                                                            .theta = theta,
                                                            .hit = required_friction->hit,
                                                            .hit_domino = required_friction->hit_domino}};
        status = forces_walk(&st->geometry, head, &kinematics, shown, required_seen, &walk);
        if (walk.seen < shown || shown >= FLOOR_SHOWN)
            break;
    }
    if (status != DOM_OK)
        return status;
    required_friction->shown = shown;
    *motion = here->motion;
    required_friction->hit = here->hit;
    required_friction->hit_domino = here->hit_domino;
    if (here->motion > required_friction->motion) {
        required_friction->motion = here->motion;
        required_friction->theta = theta;
        required_friction->domino = here->domino;
    }
    return status;
}

/*
 * Searches [lo, hi] for values of the required friction that are larger than the largest so far. A piece is
 * bisected only if it may contain such a value. If the values form a parabola, the parabola exceeds three
 * equally spaced values by at most 1/8 of their second difference. To be safe, the test allows for the whole
 * second difference.
 */
static enum dom_status required_between(const struct segment *st, real lo, real hi, const real at[2],
                                        int halvings, struct required_friction *required_friction)
{
    real middle = lo + (hi - lo) / 2, motion;
    if (!(lo < middle && middle < hi))
        return DOM_OK;
    enum dom_status status = required_at(st, middle, required_friction, &motion);
    real second_difference = fabs(at[0] - 2 * motion + at[1]),
         most = fmax(fmax(at[0], at[1]), motion) + second_difference;
    if (status != DOM_OK || halvings == 0 || !(most > required_friction->motion * (1 + FLOOR_TOL)))
        return status;
    status = required_between(st, lo, middle, (real[]){at[0], motion}, halvings - 1, required_friction);
    return status == DOM_OK
               ? required_between(st, middle, hi, (real[]){motion, at[1]}, halvings - 1, required_friction)
               : status;
}

KERNEL enum dom_status floor_over(const struct segment *st, real lo, real hi,
                                  struct required_friction *required_friction)
{
    real step = (hi - lo) / FLOOR_SAMPLES, motion[FLOOR_SAMPLES + 1];
    enum dom_status status = DOM_OK;
    for (int k = 0; k <= FLOOR_SAMPLES && status == DOM_OK; k++)
        status = required_at(st, k < FLOOR_SAMPLES ? lo + (real)k * step : hi, required_friction, &motion[k]);
    for (int k = 0; k < FLOOR_SAMPLES && status == DOM_OK; k++) {
        real from = lo + (real)k * step, to = k + 1 < FLOOR_SAMPLES ? from + step : hi;
        status = required_between(st, from, to, &motion[k], FLOOR_HALVINGS, required_friction);
    }
    return status;
}

/* ---- The floor below a train ---- */

KERNEL enum dom_status cycle_floor(const struct request *train, struct dom_floor *floor)
{
    struct motion m;
    struct segment *st = &m.cycle.segment;
    struct required_friction required_friction = {0};
    enum dom_status status = motion_begin(train, false, &m);
    st->geometry.tol = fmax(st->geometry.tol, FORCES_TOL);
    for (int i = 1; status == DOM_OK && i < st->barrier.edges; i++) {
        real lo, hi;
        if (motion_part(&m, i, &lo, &hi))
            status = floor_over(st, lo, hi, &required_friction);
    }
    motion_end(&m);
    if (status != DOM_OK)
        return status;
    if (train->work)
        train->work->entered[DOM_EFFECT_floor]++;
    *floor = (struct dom_floor){required_friction.motion, required_friction.theta, required_friction.domino,
                                required_friction.hit, required_friction.hit_domino};
    return DOM_OK;
}
