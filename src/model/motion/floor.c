/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/floor.h"

enum { FLOOR_SAMPLES = 24, FLOOR_HALVINGS = 24 };

/* What more a smooth maximum may need is not looked for. */
#define FLOOR_TOL fmax((real)1e-7, 16 * REAL_EPSILON)

/* Dominoes that move less than this share of the head may need much, and nobody would see them slip. */
#define FLOOR_SHARE ((real)1e-3)

static bool required_seen(const struct hinge_load *hinge_load, void *context)
{
    struct required_friction *required_friction = context;
    real motion = forces_needed(hinge_load->x, hinge_load->z),
         hit = forces_needed(hinge_load->impulse_x, hinge_load->impulse_z);
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

/* Raises need to what this tilt needs; *motion is that of the tilt alone. */
static enum dom_status required_at(const struct floor_path *path, real theta,
                                   struct required_friction *required_friction, real *motion)
{
    struct tilt head;
    struct kinematics kinematics = {.floor = true};
    struct required_friction here = {.motion = -1,
                                     .theta = theta,
                                     .hit = required_friction->hit,
                                     .hit_domino = required_friction->hit_domino};
    enum dom_status status = path->kinematics(theta, &head, &kinematics, path->context);
    if (status == DOM_OK)
        status = forces_walk(path->geometry, head, &kinematics, kinematics.n, required_seen, &here);
    *motion = here.motion;
    required_friction->hit = here.hit;
    required_friction->hit_domino = here.hit_domino;
    if (here.motion > required_friction->motion) {
        required_friction->motion = here.motion;
        required_friction->theta = theta;
        required_friction->domino = here.domino;
    }
    return status;
}

/*
 * Halves an interval for as long as a top inside may be higher than what is known: a parabola through its
 * ends and its middle is higher than these by an eighth of their second difference at most, so the whole of
 * that leaves room for the rest.  Of several tops none is given up because another one is seen first.
 */
static enum dom_status required_between(const struct floor_path *path, real lo, real hi, const real at[2],
                                        int halvings, struct required_friction *required_friction)
{
    real middle = lo + (hi - lo) / 2, motion;
    if (!(lo < middle && middle < hi))
        return DOM_OK;
    enum dom_status status = required_at(path, middle, required_friction, &motion);
    real second_derivative = fabs(at[0] - 2 * motion + at[1]),
         most = fmax(fmax(at[0], at[1]), motion) + second_derivative;
    if (status != DOM_OK || halvings == 0 || !(most > required_friction->motion * (1 + FLOOR_TOL)))
        return status;
    status = required_between(path, lo, middle, (real[]){at[0], motion}, halvings - 1, required_friction);
    return status == DOM_OK
               ? required_between(path, middle, hi, (real[]){motion, at[1]}, halvings - 1, required_friction)
               : status;
}

KERNEL enum dom_status floor_over(const struct floor_path *path, struct required_friction *required_friction)
{
    real step = (path->hi - path->lo) / FLOOR_SAMPLES, motion[FLOOR_SAMPLES + 1];
    enum dom_status status = DOM_OK;
    for (int k = 0; k <= FLOOR_SAMPLES && status == DOM_OK; k++)
        status = required_at(path, k < FLOOR_SAMPLES ? path->lo + (real)k * step : path->hi,
                             required_friction, &motion[k]);
    for (int k = 0; k < FLOOR_SAMPLES && status == DOM_OK; k++) {
        real lo = path->lo + (real)k * step, hi = k + 1 < FLOOR_SAMPLES ? lo + step : path->hi;
        status = required_between(path, lo, hi, &motion[k], FLOOR_HALVINGS, required_friction);
    }
    return status;
}

/* ---- Of a train ---- */

static enum dom_status train_kinematics(real theta, struct tilt *head, struct kinematics *kinematics,
                                        void *context)
{
    struct motion *m = context;
    enum dom_status status = geometry_tilt(&m->cycle.geometry, theta, head);
    return status == DOM_OK ? motion_kinematics(m, theta, *head, kinematics) : status;
}

KERNEL enum dom_status cycle_floor(const struct request *train, struct dom_floor *floor)
{
    struct motion m;
    FLOW(flow);
    struct required_friction required_friction = {0};
    enum dom_status status = motion_begin(train, &flow, &m, false);
    m.cycle.geometry.tol = fmax(m.cycle.geometry.tol, FORCES_TOL);
    for (int i = 1; status == DOM_OK && i < m.cycle.barrier.edges; i++) {
        const real *edge = m.cycle.barrier.edge, inside = 16 * REAL_EPSILON;
        real lo = i == 1 ? 0 : edge[i - 1] * (1 + inside), hi = fmin(edge[i] * (1 - inside), m.end);
        struct floor_path path = {&m.cycle.geometry, lo, hi, train_kinematics, &m};
        if (lo < hi)
            status = floor_over(&path, &required_friction);
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
