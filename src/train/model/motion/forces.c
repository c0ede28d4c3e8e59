/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The forces in a moving chain, computed from the tail to the head. Part of the torque on a follower
 * accelerates the follower. The rest of the torque acts on its leader, through their contact. When the
 * contact forces are known, Newton's law gives the force of the floor on each domino.
 */
#include "motion/motion.h"
#include <stdlib.h>

/* The force on a domino depends on all dominoes behind it. If n dominoes are wanted, forces_at lists n + 64
 * more dominoes behind them, but at most about FORCES_MORE. The dominoes behind the end of the list all move
 * alike, so forces_push replaces them by a geometric series. */
#define FORCES_MORE 4096

static real geometric(real first, real ratio)
{
    return fabs(ratio) < 1 ? first / (1 - ratio) : first;
}

/* Finds the forces and impulses of all contacts. */
static void forces_push(const struct geometry *geometry, const struct kinematics *motion, struct loaded *k,
                        size_t n)
{
    /* `rest` is the torque on domino j that the contact with its leader must balance. `push` is the angular
     * momentum that this contact must supply in the collision, by equation (54; e3). */
    real rest = 0, push = 0;
    const bool endless = geometry->n == CHAIN_ENDLESS && k[n - 1].link.leads;
    for (size_t j = n - 1; j > 0; j--) {
        const struct link *self = &k[j].link, *leader = &k[j - 1].link;
        const real theta_2 = self->slope * motion->acceleration + self->second_derivative * motion->omegasq,
                   gravity = -self->weight * geometry_lift(self->geometry, self->tilt) / 2,
                   torque_share = self->leads ? k[j].arms.ratio : 0,
                   inertia = self->inertia * geometry_inertia(self->geometry, self->tilt),
                   grows = self->inertia * geometry_inertia_slope(self->geometry, self->tilt),
                   omegasq = self->slope * self->slope * motion->omegasq;
        rest = gravity - inertia * theta_2 - (grows / 2 + self->inertia * self->geometry->drag) * omegasq +
               torque_share * rest;
        push = inertia * self->slope * motion->omega_lost + torque_share * push;
        if (j + 1 == n && endless) {
            rest = geometric(rest, geometry->weight * torque_share);
            push = geometric(push, geometry->inertia * self->contact.slope * torque_share);
        }
        /* At r s = 1, the tip hits the leader's hinge, and the force has no lever arm. */
        const bool at_hinge = j == 1 && leader->tilt.x == 0 && geometry->short_of <= REAL_EPSILON;
        const real arm_b = at_hinge ? 0 : k[j - 1].arms.b / leader->geometry->r * k[j - 1].size;
        k[j - 1].force = arm_b > 0 ? rest / arm_b : REAL_NAN;
        k[j - 1].impulse = motion->hit && arm_b > 0 ? push / arm_b : REAL_NAN;
    }
}

KERNEL_SHARED enum dom_status forces_at(const struct segment *st, real theta, size_t least,
                                        struct kinematics *motion, struct loaded **list, size_t *count)
{
    const struct geometry *geometry = &st->geometry;
    struct equation_of_motion at = {.n = 0};
    real omegasq = 0;
    *motion = (struct kinematics){.n = 0};
    enum dom_status status = geometry_tilt(geometry, theta, &motion->head);
    if (status == DOM_OK)
        status = dynamics_speed(geometry, &st->start, theta, &omegasq);
    if (status == DOM_OK)
        status = chain_equation(geometry, motion->head, &at);
    motion->omegasq = fmax(omegasq, 0);
    motion->acceleration = (at.C - at.B * motion->omegasq) / at.A;
    motion->n = at.n;
    motion->hit = theta == geometry->lean && st->inertia_ratio > 0;
    motion->omega = sqrt(st->start.omegasq);
    /* The collision multiplies all angular velocities by T / (1 + T). So the lost angular velocity is 1 / T
     * times the angular velocity that remains. */
    motion->omega_lost = motion->hit ? motion->omega / st->inertia_ratio : 0;
    const size_t wanted = motion->n > least ? motion->n : least,
                 more = wanted < FORCES_MORE ? wanted + 64 : FORCES_MORE,
                 room = geometry->n < wanted || geometry->n - wanted < more ? geometry->n : wanted + more;
    *list = status == DOM_OK ? malloc(room * sizeof **list) : NULL;
    *count = 0;
    if (!*list)
        return status == DOM_OK ? DOM_NO_MEMORY : status;
    struct link link = link_head(geometry, motion->head, geometry->rolls);
    real size = 1;
    for (size_t n = 0;; size /= link.geometry->r, link_on(&link)) {
        const bool last = !link.leads || n + 1 == room;
        (*list)[n++] =
            (struct loaded){.link = link,
                            .size = size,
                            .arms = link.leads ? link_arms(&link, geometry->rolls) : (struct arms){.a = 0},
                            .leaned = !last,
                            .force = REAL_NAN,
                            .impulse = REAL_NAN};
        if (last) {
            forces_push(geometry, motion, *list, n);
            *count = n < wanted ? n : wanted;
            return DOM_OK;
        }
    }
}

/* ---- The largest value over a motion ---- */

static enum dom_status peak_at(struct peak *p, real theta, real *value)
{
    const enum dom_status status = p->at(theta, p->context, value);
    if (status == DOM_OK && *value > p->most)
        p->most = *value;
    return status;
}

/*
 * Searches [lo, hi] for larger values. A piece is bisected only if it may contain such a value. If the values
 * form a parabola, the parabola exceeds three equally spaced values by at most 1/8 of their second
 * difference. To be safe, the test allows for the whole second difference.
 */
static enum dom_status peak_between(struct peak *p, real lo, real hi, const real at[2], int halvings)
{
    real middle = lo + (hi - lo) / 2, value;
    if (!(lo < middle && middle < hi))
        return DOM_OK;
    enum dom_status status = peak_at(p, middle, &value);
    if (status != DOM_OK)
        return status;
    const real most = fmax(fmax(at[0], at[1]), value) + fabs(at[0] - 2 * value + at[1]);
    if (halvings == 0 || !(most > p->most + p->tol * fabs(p->most) + p->off))
        return DOM_OK;
    status = peak_between(p, lo, middle, (real[]){at[0], value}, halvings - 1);
    return status == DOM_OK ? peak_between(p, middle, hi, (real[]){value, at[1]}, halvings - 1) : status;
}

KERNEL_SHARED enum dom_status peak_over(struct peak *p, real lo, real hi)
{
    const real step = (hi - lo) / (real)p->samples;
    real value[PEAK_MOST + 1];
    enum dom_status status = DOM_OK;
    for (int k = 0; k <= p->samples && status == DOM_OK; k++)
        status = peak_at(p, k < p->samples ? lo + (real)k * step : hi, &value[k]);
    for (int k = 0; k < p->samples && status == DOM_OK; k++) {
        const real from = lo + (real)k * step, to = k + 1 < p->samples ? from + step : hi;
        status = peak_between(p, from, to, &value[k], PEAK_HALVINGS);
    }
    return status;
}

KERNEL_SHARED enum dom_status peak_of_cycle(struct peak *p, const struct dom_train *train,
                                            const struct dom_compute *compute, struct motion *m)
{
    enum dom_status status = motion_prepare(train, compute, false, m);
    m->segment.geometry.tol = fmax(m->segment.geometry.tol, FORCES_TOL);
    const real *edge = m->segment.barrier.edge, inside = 16 * REAL_EPSILON;
    for (int i = 1; status == DOM_OK && i < m->segment.barrier.edges; i++) {
        const real lo = i == 1 ? 0 : edge[i - 1] * (1 + inside), hi = fmin(edge[i] * (1 - inside), m->end);
        if (lo < hi)
            status = peak_over(p, lo, hi);
    }
    motion_end(m);
    return status;
}

/* ---- The forces of contacts ---- */

/* The smallest force on a domino, divided by the weight of the domino that it pushes, so that forces on
 * dominoes of different sizes can be compared. */
struct least {
    const struct segment *segment;
    struct dom_least_force found; /* so far */
};

/* Sets *value to minus the smallest force at a tilt. */
static enum dom_status least_at(real theta, void *context, real *value)
{
    struct least *l = context;
    struct dom_least_force *least = &l->found;
    struct kinematics motion;
    struct loaded *list;
    size_t n;
    const enum dom_status status = forces_at(l->segment, theta, 0, &motion, &list, &n);
    *value = -(real)INFINITY;
    for (size_t i = 0; i < n && list[i].leaned; i++) {
        const real force = list[i].force * list[i].size / list[i].link.weight;
        *value = fmax(-force, *value);
        if (force < least->force) {
            least->force = force;
            least->theta = theta;
            least->domino = i;
        }
        if (isfinite(list[i].impulse))
            least->impulse = fmin(list[i].impulse, (real)least->impulse);
    }
    free(list);
    return status;
}

enum { CONTACT_SAMPLES = 3 };

KERNEL_SHARED enum dom_status segment_contact(const struct segment *st, real to, real *force)
{
    struct least least = {.segment = st, .found.force = *force};
    enum dom_status status = DOM_OK;
    for (int k = 0; k <= CONTACT_SAMPLES && status == DOM_OK; k++) {
        real part = (1 - cos(PI * (real)k / CONTACT_SAMPLES)) / 2, value;
        /* The last tilt is `to` itself, because rounding can put lo + (to - lo) beyond it. */
        status = least_at(k < CONTACT_SAMPLES ? st->lo + part * (to - st->lo) : to, &least, &value);
    }
    *force = least.found.force;
    return status;
}

/* The absolute error of the smallest force is at most an eighth of this. */
#define LEAST_OFF ((real)1e-6)

enum dom_status dom_cycle_least_force(const struct dom_train *train, const struct dom_compute *compute,
                                      struct dom_least_force *found)
{
    struct motion m;
    struct least least = {&m.segment, {.force = (real)INFINITY, .impulse = (real)INFINITY}};
    struct peak peak = {PEAK_MOST / 3, least_at, &least, -(real)INFINITY, FORCES_TOL, LEAST_OFF};
    const enum dom_status status = peak_of_cycle(&peak, train, compute, &m);
    if (status == DOM_OK)
        *found = least.found;
    return status;
}
