/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/floor.h"

enum { FLOOR_SAMPLES = 24, FLOOR_ZOOMS = 3 };

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

static enum dom_status need_at(const struct floor_path *path, real theta, struct need *need)
{
    struct tilt head;
    struct pace pace = {.floor = true};
    enum dom_status status = path->pace(theta, &head, &pace, path->context);
    need->theta = theta;
    return status == DOM_OK ? forces_walk(path->lean, head, &pace, pace.n, need_seen, need) : status;
}

KERNEL enum dom_status floor_over(const struct floor_path *path, struct need *need)
{
    real lo = path->lo, hi = path->hi;
    for (int zoom = 0; zoom < FLOOR_ZOOMS; zoom++) {
        real step = (hi - lo) / FLOOR_SAMPLES, top = lo;
        struct need most = {.motion = -1};
        for (int k = 0; k <= FLOOR_SAMPLES; k++) {
            struct need here = {.motion = -1, .hit = need->hit, .hit_domino = need->hit_domino};
            enum dom_status status = need_at(path, k < FLOOR_SAMPLES ? lo + (real)k * step : hi, &here);
            if (status != DOM_OK)
                return status;
            if (here.motion > most.motion) {
                most = here;
                top = here.theta;
            }
            need->hit = here.hit;
            need->hit_domino = here.hit_domino;
        }
        if (most.motion > need->motion) {
            need->motion = most.motion;
            need->theta = most.theta;
            need->domino = most.domino;
        }
        lo = fmax(top - step, lo);
        hi = fmin(top + step, hi);
    }
    return DOM_OK;
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
    struct flow flow;
    struct need need = {0};
    enum dom_status status = motion_begin(train, &flow, &m);
    for (int i = 1; status == DOM_OK && i < m.cycle.barrier.edges; i++) {
        const real *edge = m.cycle.barrier.edge, inside = 16 * REAL_EPSILON;
        real lo = i == 1 ? 0 : edge[i - 1] * (1 + inside), hi = fmin(edge[i] * (1 - inside), m.end);
        struct floor_path path = {&m.cycle.lean, lo, hi, train_pace, &m};
        if (lo < hi)
            status = floor_over(&path, &need);
    }
    if (status != DOM_OK)
        return status;
    if (train->work)
        train->work->entered[DOM_EFFECT_floor]++;
    *floor = (struct dom_floor){need.motion, need.theta, need.domino, need.hit, need.hit_domino};
    return DOM_OK;
}
