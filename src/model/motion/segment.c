/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/segment.h"

/* Behind the first that has left by the end another may have left earlier, and so on. */
KERNEL enum dom_status segment_cut(struct segment *st, size_t *stay)
{
    const struct geometry *geometry = &st->geometry;
    *stay = geometry->n;
    for (;;) {
        struct tilt head;
        enum dom_status status = geometry_tilt(geometry, st->hi, &head);
        if (status != DOM_OK)
            return status;
        struct link k = link_head(geometry, head);
        /* What moves less than rounding does not fall off now; behind one that does, nothing moves just then.
         */
        bool last = false, all = *stay < geometry->n;
        while (!last && ((*stay < geometry->n && k.i < *stay) || k.tilt.v < k.geometry->leave.v)) {
            last = k.i + 1 >= geometry->n || (!all && k.slope < REAL_EPSILON * REAL_EPSILON);
            if (!last)
                link_next(&k);
        }
        if (last || k.i + 1 >= geometry->n)
            return DOM_OK;
        struct tilt leave = k.geometry->leave;
        *stay = k.i + 1;
        for (const struct geometry *leader = k.geometry + 1; k.i > 0; k.i--, leader++)
            leave = geometry_leader(leader, leave);
        st->hi = fmin(fmax(tilt_angle(leave), st->lo), st->hi);
    }
}

KERNEL real segment_climbed(struct segment *st, real theta, real *J)
{
    struct tilt head;
    struct sums at = {.dH = REAL_NAN, .J = REAL_NAN};
    st->status = geometry_tilt(&st->geometry, theta, &head);
    if (st->status == DOM_OK)
        st->status = chain_energy_change_from(&st->geometry, st->from, head, &at);
    *J = at.J;
    return at.dH;
}

KERNEL real segment_speed(struct segment *st, real theta)
{
    real J;
    if (st->geometry.mu > 0)
        return friction_omegasq(&st->geometry, st->omegasq, theta);
    real climbed = segment_climbed(st, theta, &J);
    return (st->J * st->omegasq - climbed) / J;
}

KERNEL enum dom_status segment_begin(struct segment *st)
{
    struct sums at = {.J = 0};
    enum dom_status status = chain_sum(&st->geometry, st->from, &at);
    /* Whoever falls off takes no energy along; where that is at once (r s = 1), J falls with him. */
    real kept = at.J > 0 && st->J > 0 ? st->J / at.J : 1;
    st->omegasq *= kept;
    st->gain *= kept;
    st->J = at.J;
    if (st->geometry.n == 1) /* nothing rubs on it */
        st->geometry.mu = 0;
    if (status == DOM_OK && st->geometry.mu > 0 && st->lo < st->hi)
        status = friction_flow_piece(&st->geometry, st->J, st->lo, &st->hi);
    st->locks = status == DOM_LOCKS;
    status = st->locks ? DOM_OK : status;
    if (status == DOM_OK && st->lo < st->hi)
        status = barrier_piece(&st->geometry, st->from, st->lo, st->hi, &st->barrier);
    return status;
}

KERNEL enum dom_status segment_next(struct segment *st, struct segment *next)
{
    real J, gain, u;
    segment_climbed(st, st->hi, &J);
    gain = st->gain * st->J / J;
    *next = (struct segment){.geometry = st->geometry,
                             .from = st->geometry.c,
                             .lo = st->hi,
                             .J = J,
                             .omegasq = segment_speed(st, st->hi)};
    if (st->geometry.mu > 0) {
        friction_at(&st->geometry, st->hi, &gain, &u);
        gain = st->gain * exp(gain);
    }
    next->gain = gain;
    return st->status == DOM_OK ? geometry_tilt(&st->geometry, st->hi, &next->from) : st->status;
}

/* With A -> 0 it is the sign of C that is left: w' = 2 (C - B w) / A. */
KERNEL enum dom_status segment_braked(const struct segment *st, bool *braked)
{
    struct tilt head;
    struct equation_of_motion equation_of_motion = {.C = 0};
    enum dom_status status = geometry_tilt(&st->geometry, st->hi, &head);
    if (status == DOM_OK)
        status = friction_equation_of_motion(&st->geometry, head, &equation_of_motion);
    *braked = equation_of_motion.C < 0;
    return status;
}

KERNEL real segment_kinetic(const struct segment *st)
{
    return st->J * st->omegasq;
}

static real segment_short(real theta, void *context)
{
    struct segment *st = context;
    struct barrier b = {.height = REAL_NAN};
    st->status = barrier_piece(&st->geometry, st->from, st->lo, theta, &b);
    return b.height - segment_kinetic(st);
}

KERNEL enum dom_status segment_rest(struct segment *st, real *theta)
{
    real hi = st->barrier.theta_m;
    enum dom_status status =
        st->geometry.mu > 0 ? friction_flow_spent(&st->geometry, st->from, st->lo, st->omegasq, &hi) : DOM_OK;
    if (status != DOM_OK)
        return status;
    enum num_status solver = num_root(segment_short, st, st->lo, hi, st->geometry.tol / 8, theta);
    return model_status(st->status, solver);
}

static real segment_slowness(real theta, void *context)
{
    struct segment *st = context;
    real omegasq = segment_speed(st, theta);
    return omegasq > 0 ? 1 / sqrt(omegasq) : REAL_NAN;
}

KERNEL enum dom_status segment_time(struct segment *st, real *time)
{
    real margin = segment_kinetic(st) - st->barrier.height;
    real noise = 16 * REAL_EPSILON * segment_kinetic(st) / margin;
    *time = REAL_NAN;
    if (!(noise < (real)0.125))
        return DOM_OK;
    enum num_status solver = num_peak_integral(segment_slowness, st, st->lo, st->hi, st->barrier.theta_m,
                                               barrier_width(&st->geometry, st->from, &st->barrier, margin),
                                               fmax(st->geometry.tol / 8, noise), time, NULL);
    return model_status(st->status, solver);
}

/* ---- Forces: does contact hold, what must the floor hold? ---- */

KERNEL enum dom_status segment_kinematics(real theta, struct tilt *head, struct kinematics *kinematics,
                                          void *context)
{
    struct segment *st = context;
    kinematics->omegasq = fmax(segment_speed(st, theta), 0);
    kinematics->hit = theta == 0 && st->inertia_ratio > 0;
    kinematics->omega = sqrt(st->omegasq);
    kinematics->omega_lost = kinematics->hit ? kinematics->omega / st->inertia_ratio : 0;
    enum dom_status status = geometry_tilt(&st->geometry, theta, head);
    return status == DOM_OK ? motion_acceleration(&st->geometry, *head, kinematics->omegasq,
                                                  &kinematics->acceleration, &kinematics->n)
                            : status;
}

enum { CONTACT_SAMPLES = 3 };

static bool contact_seen(const struct hinge_load *hinge_load, void *context)
{
    real *least = context;
    if (hinge_load->leaned)
        *least = fmin(*least, hinge_load->force / hinge_load->link->weight * hinge_load->size);
    return true;
}

KERNEL enum dom_status segment_contact(struct segment *st, real to, real *least)
{
    for (int k = 0; k <= CONTACT_SAMPLES && st->geometry.n > 1; k++) {
        real u = (1 - cos(PI * (real)k / CONTACT_SAMPLES)) / 2, theta = st->lo + u * (to - st->lo);
        struct tilt head;
        struct kinematics kinematics = {0};
        enum dom_status status = segment_kinematics(theta, &head, &kinematics, st);
        if (status == DOM_OK)
            status = forces_walk(&st->geometry, head, &kinematics, kinematics.n, contact_seen, least);
        if (status != DOM_OK)
            return status;
    }
    return DOM_OK;
}
