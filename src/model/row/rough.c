/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "row/rough.h"

/* A rough verdict counts as certain if the margin exceeds ROUGH_CLEAR times the estimated error.
 * rough_reaches also demands ROUGH_ROOM times the energy on top of that. */
#define ROUGH_CLEAR 8
#define ROUGH_ROOM  ((real)1 / 64)

/* Number of tilts at which the required energy is sampled to find its maximum. */
enum { ROUGH_PLACES = 12 };

/* The sums A, B and C of the equation of motion (friction.c), without compensation of rounding errors. */
struct rough_sums {
    real A, B, C;
    real S, curve; /* S_i and theta_i'' of the current domino i */
};

/* Adds one domino. Returns false if the contributions of all further dominoes are negligible. */
static bool rough_add(struct rough_sums *s, const struct link *k, real ratio, real tol)
{
    const struct geometry *self = k->geometry;
    const real m = k->inertia * s->S, w = k->weight * s->S;
    s->A += m * k->slope;
    s->B += m * s->curve;
    s->C -= w * geometry_height_slope(self, k->tilt) / 2;
    const real rate = fmax(fmax(self->weight, self->inertia) * ratio, fmax(self->decay, self->decay_J)),
               share = TAIL_SHARE * tol * (1 - rate);
    return rate * w * self->steepest > share * fabs(s->C) ||
           rate * m * (k->slope * (1 + self->rL * k->slope) + fabs(s->curve)) > share * s->A;
}

struct rough_context {
    const struct geometry *head;
};

/* Finds the sums for a chain with sharp edges. Returns false if friction locks the chain. */
static bool rough_sharp(const struct geometry *head, struct tilt tilt, struct rough_sums *sums)
{
    struct rough_sums s = {.S = 1};
    struct link k = link_head(head, tilt);
    for (;;) {
        const real a = contact_arm_a(&k), b = contact_arm_b(&k), ratio = a / b;
        const bool last = k.i + 1 == head->n;
        if (!last && !(a >= 0 && b > 0))
            return false;
        if (!rough_add(&s, &k, last ? 0 : ratio, head->tol) || last)
            break;
        s.S *= ratio;
        s.curve = link_second_derivative(&k, s.curve);
        link_next(&k);
    }
    *sums = s;
    return true;
}

/* Finds the coefficients of the equation of motion at p = tan(theta / 2). Unlike theta itself, p needs no
 * trigonometric functions. */
static bool rough_rate(real p, void *context, struct num_rate *rate)
{
    const struct geometry *head = ((const struct rough_context *)context)->head;
    const real turn = 2 / (1 + p * p); /* dtheta / dp */
    struct rough_sums s = {.S = 1};
    struct equation_of_motion e = {.A = 0};
    bool found;
    if (head->law->closed_form)
        found = rough_sharp(head, tilt_half(p), &s);
    else {
        found = head->law->equation(head, tilt_half(p), &e) == DOM_OK && !e.locks;
        s = (struct rough_sums){.A = e.A, .B = e.B, .C = e.C};
    }
    rate->p = -2 * s.B / s.A * turn;
    rate->c = 2 * s.C / s.A * turn;
    return found;
}

/* Returns the omegasq that the head needs: the maximum of -num_rough_v, from samples and parabolas through
 * them. */
static real rough_need(const struct num_rough *flow)
{
    real most = 0, last = 0, self = 0;
    for (int i = 1; i <= ROUGH_PLACES; i++) {
        const real next = -num_rough_v(flow, 2 * (real)i / ROUGH_PLACES - 1), bend = 2 * self - last - next;
        most = fmax(most, next);
        if (i > 1 && self >= last && self >= next && bend > 0)
            most = fmax(most, self + (next - last) * (next - last) / (8 * bend));
        last = self;
        self = next;
    }
    return most;
}

KERNEL real rough_error(const struct geometry *head)
{
    return ROUGH_CLEAR * head->tol;
}

KERNEL bool rough_reaches(struct rough_motion *s, const struct geometry *head, real hi, real omegasq)
{
    struct rough_context context = {head};
    struct num_rough *flow = &s->flow;
    return num_rough_solve(rough_rate, &context, hi, flow) &&
           omegasq - rough_need(flow) > ROUGH_CLEAR * (s->off + flow->v_error) + ROUGH_ROOM * omegasq;
}

KERNEL bool rough_descend(struct rough_motion *s, const struct geometry *head, real omegasq, real *after,
                          real *after_off)
{
    const struct num_rough *flow = &s->flow;
    if (!rough_reaches(s, head, half_of_tilt(head->c), omegasq))
        return false;
    const real off = s->off + flow->v_error, G = num_rough_G(flow, 1);
    *after = G * (omegasq + num_rough_v(flow, 1));
    *after_off = G * off + *after * (flow->ln_G_error + rough_error(head));
    return *after > ROUGH_CLEAR * *after_off;
}

KERNEL bool rough_sure(const struct rough_motion *s, real omegasq, real margin, real kinetic)
{
    return fabs(margin) > kinetic * ROUGH_CLEAR * (s->off / omegasq + ROUGH_CLEAR * ROUGH_TOL);
}
