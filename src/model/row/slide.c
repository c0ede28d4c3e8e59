/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "row/slide.h"

/* The margin must be so many times the estimated error, and more than this part of the energy. */
#define SLIDE_CLEAR 8
#define SLIDE_ROOM  ((real)1 / 64)

/* Places where the required energy is found, in search of its maximum. */
enum { SLIDE_PLACES = 12 };

struct slide_context {
    const struct geometry *head;
};

/* Finds the equation of motion as a function of p = tan(theta / 2), which needs no trigonometry. */
static bool slide_rate(real p, void *context, struct num_rate *rate)
{
    const struct slide_context *c = context;
    const real turn = 2 / (1 + p * p); /* dtheta / dp */
    struct equation_of_motion equation;
    if (c->head->flow->equation(c->head, tilt_half(p), &equation) != DOM_OK || equation.locks)
        return false;
    rate->p = -2 * equation.B / equation.A * turn;
    rate->c = 2 * equation.C / equation.A * turn;
    return true;
}

/* Returns the omegasq that the head needs to come over the hardest tilt: the maximum of -v, from samples and
 * a parabola through each three of them. */
static real slide_need(const struct num_rough *flow)
{
    real most = 0, last = 0, own = 0;
    for (int i = 1; i <= SLIDE_PLACES; i++) {
        const real next = -num_rough_v(flow, 2 * (real)i / SLIDE_PLACES - 1), bend = 2 * own - last - next;
        most = fmax(most, next);
        if (i > 1 && own >= last && own >= next && bend > 0)
            most = fmax(most, own + (next - last) * (next - last) / (8 * bend));
        last = own;
        own = next;
    }
    return most;
}

KERNEL real slide_error(const struct geometry *head)
{
    return SLIDE_CLEAR * head->tol;
}

KERNEL bool slide_goes(struct slide *s, const struct geometry *head, real omegasq, real *after,
                       real *after_off)
{
    struct slide_context context = {head};
    struct num_rough *flow = &s->flow;
    if (!num_rough_solve(slide_rate, &context, half_of_tilt(head->c), flow))
        return false;
    const real off = s->off + flow->v_error, G = num_rough_G(flow, 1);
    *after = G * (omegasq + num_rough_v(flow, 1));
    *after_off = G * off + *after * (flow->ln_G_error + slide_error(head));
    return omegasq - slide_need(flow) > SLIDE_CLEAR * off + SLIDE_ROOM * omegasq &&
           *after > SLIDE_CLEAR * *after_off;
}

KERNEL bool slide_sure(const struct slide *s, real omegasq, real margin, real kinetic)
{
    return fabs(margin) > kinetic * SLIDE_CLEAR * (s->off / omegasq + SLIDE_CLEAR * SLIDE_TOL);
}
