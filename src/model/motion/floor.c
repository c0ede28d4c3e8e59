/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/floor.h"

enum { FLOOR_SAMPLES = 24, FLOOR_HALVINGS = 24 };

/* What more a smooth maximum may need is not looked for. */
#define FLOOR_TOL fmax((real)1e-7, 16 * REAL_EPSILON)

/* Dominoes that move less than this share of the head may need much, and nobody would see them slip. */
#define FLOOR_SHARE ((real)1e-3)

static bool need_seen(const struct held *held, void *context)
{
    struct need *need = context;
    real motion = forces_needed(held->x, held->z), hit = forces_needed(held->blow_x, held->blow_z);
    if (motion > need->motion) {
        need->motion = motion;
        need->domino = held->link->i;
    }
    if (hit > need->hit) {
        need->hit = hit;
        need->hit_domino = held->link->i;
    }
    return held->link->slope > FLOOR_SHARE;
}

/* Raises need to what this tilt needs; *motion is that of the tilt alone. */
static enum dom_status need_at(const struct floor_path *path, real theta, struct need *need, real *motion)
{
    struct tilt head;
    struct pace pace = {.floor = true};
    struct need here = {.motion = -1, .theta = theta, .hit = need->hit, .hit_domino = need->hit_domino};
    enum dom_status status = path->pace(theta, &head, &pace, path->context);
    if (status == DOM_OK)
        status = forces_walk(path->lean, head, &pace, pace.n, need_seen, &here);
    *motion = here.motion;
    need->hit = here.hit;
    need->hit_domino = here.hit_domino;
    if (here.motion > need->motion) {
        need->motion = here.motion;
        need->theta = theta;
        need->domino = here.domino;
    }
    return status;
}

/*
 * Halves an interval for as long as a top inside may be higher than what is known: a parabola through its
 * ends and its middle is higher than these by an eighth of their second difference at most, so the whole of
 * that leaves room for the rest.  Of several tops none is given up because another one is seen first.
 */
static enum dom_status need_between(const struct floor_path *path, real lo, real hi, const real at[2],
                                    int halvings, struct need *need)
{
    real middle = lo + (hi - lo) / 2, motion;
    if (!(lo < middle && middle < hi))
        return DOM_OK;
    enum dom_status status = need_at(path, middle, need, &motion);
    real bend = fabs(at[0] - 2 * motion + at[1]), most = fmax(fmax(at[0], at[1]), motion) + bend;
    if (status != DOM_OK || halvings == 0 || !(most > need->motion * (1 + FLOOR_TOL)))
        return status;
    status = need_between(path, lo, middle, (real[]){at[0], motion}, halvings - 1, need);
    return status == DOM_OK ? need_between(path, middle, hi, (real[]){motion, at[1]}, halvings - 1, need)
                            : status;
}

KERNEL enum dom_status floor_over(const struct floor_path *path, struct need *need)
{
    real step = (path->hi - path->lo) / FLOOR_SAMPLES, motion[FLOOR_SAMPLES + 1];
    enum dom_status status = DOM_OK;
    for (int k = 0; k <= FLOOR_SAMPLES && status == DOM_OK; k++)
        status = need_at(path, k < FLOOR_SAMPLES ? path->lo + (real)k * step : path->hi, need, &motion[k]);
    for (int k = 0; k < FLOOR_SAMPLES && status == DOM_OK; k++) {
        real lo = path->lo + (real)k * step, hi = k + 1 < FLOOR_SAMPLES ? lo + step : path->hi;
        status = need_between(path, lo, hi, &motion[k], FLOOR_HALVINGS, need);
    }
    return status;
}

/* ---- Of a train ---- */

static enum dom_status train_pace(real theta, struct tilt *head, struct pace *pace, void *context)
{
    struct motion *m = context;
    enum dom_status status = lean_tilt(&m->cycle.lean, theta, head);
    return status == DOM_OK ? motion_pace(m, theta, *head, pace) : status;
}

KERNEL enum dom_status cycle_floor(const struct dom_train *train, struct dom_floor *floor)
{
    struct motion m;
    FLOW(flow);
    struct need need = {0};
    enum dom_status status = motion_begin(train, &flow, &m, false);
    m.cycle.lean.tol = fmax(m.cycle.lean.tol, FORCES_TOL);
    for (int i = 1; status == DOM_OK && i < m.cycle.barrier.edges; i++) {
        const real *edge = m.cycle.barrier.edge, inside = 16 * REAL_EPSILON;
        real lo = i == 1 ? 0 : edge[i - 1] * (1 + inside), hi = fmin(edge[i] * (1 - inside), m.end);
        struct floor_path path = {&m.cycle.lean, lo, hi, train_pace, &m};
        if (lo < hi)
            status = floor_over(&path, &need);
    }
    motion_end(&m);
    if (status != DOM_OK)
        return status;
    if (train->work)
        train->work->entered[DOM_EFFECT_floor]++;
    *floor = (struct dom_floor){need.motion, need.theta, need.domino, need.hit, need.hit_domino};
    return DOM_OK;
}
