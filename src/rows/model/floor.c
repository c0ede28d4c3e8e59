/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The friction that the floor needs so that no foot slips: the largest |R_x| / R_z over all feet. During the
 * motion, R is the force of the floor on a foot, and in the collision its impulse. x points forward and z
 * up. */
#include "numerics/api.h"
#include "row/row.h"
#include <stdlib.h>

/* The relative tolerance of the friction. */
#define FLOOR_TOL 1e-7

/* The search from the head backwards ends at the first domino that is slower than this fraction of the head's
 * speed. Nobody would see the dominoes behind it slip. */
#define FLOOR_SHARE 1e-3

/* The search looks at no more dominoes than this. */
enum { FLOOR_SHOWN = 4096 };

struct search {
    const struct segment *segment;
    struct dom_floor most;   /* the largest values for the current head, which has the number 0 */
    size_t shown;            /* the number of dominoes at which the last search looked */
    struct dom_floor *floor; /* for a row: the result for each head */
};

/* A push on the back face of a domino, including the friction that pulls the face down. */
struct push {
    real x, z;
};

static struct push push_on(const struct loaded *k, real normal)
{
    const real mu = k->link.geometry->mu;
    const struct tilt t = k->link.tilt;
    return (struct push){normal * (t.y - mu * t.x), normal * (-t.x - mu * t.y)};
}

/*
 * Returns the friction that the foot of a domino needs, during the motion or, if `hit` is true, in the
 * collision. `leader` is the domino on which it leans, or NULL for the head. The force R follows from
 * Newton's law for the centre of the domino. Relative to the hinge, the centre is at (x - d y, y + d x) / 2.
 * A domino with rounded edges has no hinge. In its place, the function uses the centre of the rounded lower
 * edge, which moves parallel to the floor at the height rho.
 */
static real foot_needs(const struct loaded *k, const struct loaded *leader, const struct geometry *head,
                       const struct kinematics *motion, bool hit)
{
    const struct link *self = &k->link;
    const struct rounded *shape = &self->geometry->rounded;
    const real tausq = head->inertia_factor * (1 + head->d * head->d) / 3, /* of the head, in units of h/g */
        mass = self->weight / k->size, momentum = mass * k->size / tausq, by = self->inertia / k->size,
               across = (shape->tall * self->tilt.x - shape->wide * self->tilt.y) / 2,
               up = (shape->tall * self->tilt.y + shape->wide * self->tilt.x) / 2, high = up + shape->rho;
    /* the angular acceleration and the square of the angular velocity, or the change of the angular velocity
     */
    const real turn = !hit ? self->slope * motion->acceleration + self->second_derivative * motion->omegasq
                      : leader ? -self->slope * motion->omega_lost
                               : motion->omega,
               omegasq = hit ? 0 : self->slope * self->slope * motion->omegasq, gravity = hit ? 0 : mass;
    const struct push none = {0, 0},
                      from = push_on(k, !k->leaned ? 0
                                        : hit      ? k->impulse
                                                   : k->force),
                      onto = leader ? push_on(leader, hit ? leader->impulse : leader->force) : none;
    /* The torque of the drag acts like a force at 3/4 of the height, and the air that moves along like a
     * force at 2/3 of it. Both forces are normal to the face. */
    const real back = self->geometry->drag * omegasq * by * 4 / 3 +
                      self->geometry->entrained * by * 3 / 2 * turn,
               x = momentum * (high * turn - across * omegasq) - gravity * self->geometry->g.along - from.x +
                   onto.x + back * self->tilt.y,
               z = momentum * (-across * turn - up * omegasq) + gravity * self->geometry->g.down - from.z +
                   onto.z - back * self->tilt.x;
    /* at r s = 1, no finite impulse turns the struck domino */
    if (hit && isnan(x))
        return (real)INFINITY;
    return z > 0 ? fabs(x) / z : isnan(x) || isnan(z) ? REAL_NAN : (real)INFINITY;
}

/* Finds the friction that the floor needs during the motion, at the tilt theta, and in the collision if the
 * motion begins there. */
static enum dom_status floor_at(real theta, void *context, real *value)
{
    struct search *s = context;
    const struct geometry *head = &s->segment->geometry;
    struct kinematics kinematics;
    struct loaded *list = NULL;
    size_t n, listed, most = 0;
    enum dom_status status;
    bool more;
    /* More dominoes may move than count for the energy, because light ones do not count. */
    do {
        free(list);
        status = forces_at(s->segment, theta, s->shown, &kinematics, &list, &listed);
        for (n = 0; n < listed && (n == 0 || list[n - 1].link.slope > FLOOR_SHARE);)
            n++;
        s->shown = kinematics.n > s->shown ? kinematics.n : s->shown;
        more = n == s->shown && n < FLOOR_SHOWN && status == DOM_OK;
        s->shown *= more ? 2 : 1;
    } while (more);
    *value = -1;
    for (size_t i = 0; i < n; i++) {
        const struct loaded *leader = i > 0 ? &list[i - 1] : NULL;
        const real motion = foot_needs(&list[i], leader, head, &kinematics, false),
                   hit = kinematics.hit ? foot_needs(&list[i], leader, head, &kinematics, true) : 0;
        if (motion > *value) {
            *value = motion;
            most = i;
        }
        if (hit > s->most.hit) {
            s->most.hit = hit;
            s->most.hit_domino = i;
        }
    }
    free(list);
    if (*value > s->most.motion) {
        s->most.motion = *value;
        s->most.theta = theta;
        s->most.domino = most;
    }
    return status;
}

static struct peak peak_of(struct search *s)
{
    return (struct peak){PEAK_MOST, floor_at, s, s->most.motion, FLOOR_TOL, 0};
}

enum dom_status dom_cycle_floor(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_floor *floor)
{
    struct motion m;
    struct search s = {.segment = &m.segment};
    struct peak peak = peak_of(&s);
    const enum dom_status status = peak_of_cycle(&peak, train, compute, &m);
    if (status == DOM_OK)
        *floor = s.most;
    return status;
}

/* ---- Rows ---- */

static void floor_begins(struct run *run, size_t k)
{
    struct search *s = run->options->context;
    (void)k;
    s->most = (struct dom_floor){0};
    s->shown = 0;
}

static enum dom_status floor_moves(struct run *run, const struct descent *d)
{
    struct search *s = run->options->context;
    s->segment = &d->st;
    struct peak peak = peak_of(s);
    return d->st.lo < d->to ? peak_over(&peak, d->st.lo, d->to) : DOM_OK;
}

/* Keeps the result for a head. If the head repeats the motion of the one before, so does its floor. */
static bool floor_keep(const struct dom_fall *fall, void *context)
{
    struct search *s = context;
    struct dom_floor *floor = &s->floor[fall->domino - 1];
    *floor = s->most;
    floor->domino = fall->domino - s->most.domino;
    floor->hit_domino = fall->domino - s->most.hit_domino;
    return true;
}

enum dom_status dom_row_floor(const struct dom_row *row, const struct dom_compute *compute,
                              struct dom_floor *floor)
{
    struct search s = {.floor = floor};
    const struct run_options options = {.begins = floor_begins, .moves = floor_moves, .context = &s};
    struct dom_verdict verdict;
    if (row->engine)
        return DOM_NO_METHOD;
    for (size_t k = 0; k < row->count; k++)
        floor[k] = (struct dom_floor){DOM_NAN, DOM_NAN, 0, DOM_NAN, 0};
    return row_run(row, compute, &options, floor_keep, &s, &verdict);
}
