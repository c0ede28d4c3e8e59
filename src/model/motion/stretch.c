/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/stretch.h"

/* Behind the first that has left by the end another may have left earlier, and so on. */
KERNEL enum dom_status stretch_cut(struct stretch *st, size_t *stay)
{
    const struct lean *g = &st->g;
    *stay = g->n;
    for (;;) {
        struct tilt head;
        enum dom_status status = lean_tilt(g, st->hi, &head);
        if (status != DOM_OK)
            return status;
        struct link k = link_head(g, head);
        /* What moves less than rounding does not fall off now; behind one that does, nothing moves just then.
         */
        bool last = false, all = *stay < g->n;
        while (!last && ((*stay < g->n && k.i < *stay) || k.tilt.v < k.lean->leave.v)) {
            last = k.i + 1 >= g->n || (!all && k.slope < REAL_EPSILON * REAL_EPSILON);
            if (!last)
                link_next(&k);
        }
        if (last || k.i + 1 >= g->n)
            return DOM_OK;
        struct tilt leave = k.lean->leave;
        *stay = k.i + 1;
        for (const struct lean *leader = k.lean + 1; k.i > 0; k.i--, leader++)
            leave = lean_leader(leader, leave);
        st->hi = fmin(fmax(tilt_angle(leave), st->lo), st->hi);
    }
}

KERNEL real stretch_climbed(struct stretch *st, real theta, real *J)
{
    struct tilt head;
    struct sums at = {.dH = REAL_NAN, .J = REAL_NAN};
    st->status = lean_tilt(&st->g, theta, &head);
    if (st->status == DOM_OK)
        st->status = chain_rise_from(&st->g, st->from, head, &at);
    *J = at.J;
    return at.dH;
}

KERNEL real stretch_speed(struct stretch *st, real theta)
{
    real J;
    if (st->g.mu > 0)
        return friction_omegasq(&st->g, st->omegasq, theta);
    real climbed = stretch_climbed(st, theta, &J);
    return (st->J * st->omegasq - climbed) / J;
}

KERNEL enum dom_status stretch_begin(struct stretch *st)
{
    struct sums at = {.J = 0};
    enum dom_status status = chain_sum(&st->g, st->from, &at);
    /* Whoever falls off takes no energy along; where that is at once (r s = 1), J falls with him. */
    real kept = at.J > 0 && st->J > 0 ? st->J / at.J : 1;
    st->omegasq *= kept;
    st->gain *= kept;
    st->J = at.J;
    if (st->g.n == 1) /* nothing rubs on it */
        st->g.mu = 0;
    if (status == DOM_OK && st->g.mu > 0 && st->lo < st->hi)
        status = friction_flow_piece(&st->g, st->J, st->lo, &st->hi);
    st->locks = status == DOM_LOCKS;
    status = st->locks ? DOM_OK : status;
    if (status == DOM_OK && st->lo < st->hi)
        status = barrier_piece(&st->g, st->from, st->lo, st->hi, &st->barrier);
    return status;
}

KERNEL enum dom_status stretch_next(struct stretch *st, struct stretch *next)
{
    real J, gain, u;
    stretch_climbed(st, st->hi, &J);
    gain = st->gain * st->J / J;
    *next = (struct stretch){
        .g = st->g, .from = st->g.c, .lo = st->hi, .J = J, .omegasq = stretch_speed(st, st->hi)};
    if (st->g.mu > 0) {
        friction_at(&st->g, st->hi, &gain, &u);
        gain = st->gain * exp(gain);
    }
    next->gain = gain;
    return st->status == DOM_OK ? lean_tilt(&st->g, st->hi, &next->from) : st->status;
}

/* With A -> 0 it is the sign of C that is left: w' = 2 (C - B w) / A. */
KERNEL enum dom_status stretch_braked(const struct stretch *st, bool *braked)
{
    struct tilt head;
    struct law law = {.C = 0};
    enum dom_status status = lean_tilt(&st->g, st->hi, &head);
    if (status == DOM_OK)
        status = friction_law(&st->g, head, &law);
    *braked = law.C < 0;
    return status;
}

KERNEL real stretch_kinetic(const struct stretch *st)
{
    return st->J * st->omegasq;
}

static real stretch_short(real theta, void *context)
{
    struct stretch *st = context;
    struct barrier b = {.height = REAL_NAN};
    st->status = barrier_piece(&st->g, st->from, st->lo, theta, &b);
    return b.height - stretch_kinetic(st);
}

KERNEL enum dom_status stretch_rest(struct stretch *st, real *theta)
{
    real hi = st->barrier.theta_m;
    enum dom_status status =
        st->g.mu > 0 ? friction_flow_spent(&st->g, st->from, st->lo, st->omegasq, &hi) : DOM_OK;
    if (status != DOM_OK)
        return status;
    enum num_status solver = num_root(stretch_short, st, st->lo, hi, st->g.tol / 8, theta);
    return model_status(st->status, solver);
}

static real stretch_slowness(real theta, void *context)
{
    struct stretch *st = context;
    real omegasq = stretch_speed(st, theta);
    return omegasq > 0 ? 1 / sqrt(omegasq) : REAL_NAN;
}

KERNEL enum dom_status stretch_time(struct stretch *st, real *time)
{
    real margin = stretch_kinetic(st) - st->barrier.height;
    real noise = 16 * REAL_EPSILON * stretch_kinetic(st) / margin;
    *time = REAL_NAN;
    if (!(noise < (real)0.125))
        return DOM_OK;
    enum num_status solver = num_peak_integral(stretch_slowness, st, st->lo, st->hi, st->barrier.theta_m,
                                               barrier_width(&st->g, st->from, &st->barrier, margin),
                                               fmax(st->g.tol / 8, noise), time, NULL);
    return model_status(st->status, solver);
}

/* ---- Forces: does contact hold, what must the floor hold? ---- */

KERNEL enum dom_status stretch_pace(real theta, struct tilt *head, struct pace *pace, void *context)
{
    struct stretch *st = context;
    pace->omegasq = fmax(stretch_speed(st, theta), 0);
    pace->hit = theta == 0 && st->T > 0;
    pace->omega = sqrt(st->omegasq);
    pace->omega_lost = pace->hit ? pace->omega / st->T : 0;
    enum dom_status status = lean_tilt(&st->g, theta, head);
    return status == DOM_OK ? motion_acceleration(&st->g, *head, pace->omegasq, &pace->acceleration, &pace->n)
                            : status;
}

enum { CONTACT_SAMPLES = 3 };

static bool contact_seen(const struct held *held, void *context)
{
    real *least = context;
    if (held->leaned)
        *least = fmin(*least, held->force / held->link->weight * held->size);
    return true;
}

KERNEL enum dom_status stretch_contact(struct stretch *st, real to, real *least)
{
    for (int k = 0; k <= CONTACT_SAMPLES && st->g.n > 1; k++) {
        real u = (1 - cos(PI * (real)k / CONTACT_SAMPLES)) / 2, theta = st->lo + u * (to - st->lo);
        struct tilt head;
        struct pace pace = {0};
        enum dom_status status = stretch_pace(theta, &head, &pace, st);
        if (status == DOM_OK)
            status = forces_walk(&st->g, head, &pace, pace.n, contact_seen, least);
        if (status != DOM_OK)
            return status;
    }
    return DOM_OK;
}
