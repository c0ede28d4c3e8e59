/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dynamics/energy_balance.h"
#include "geometry/far.h"
#include "geometry/rounded.h"

#ifdef KERNEL_TEXTS
const struct dom_effect dom_energy_balance = {
    .name = "energy balance",
    .adds = "no effect: contacts without friction take no energy",
    .help = "Kinetic energy and height are kept through a cycle (21; c3), and the collision keeps "
            "angular momentum (22; c4), so a train that repeats itself has its kinetic energy in closed form "
            "(24; c6).",
    .source = "J. M. J. van Leeuwen, Domino Magnification",
    .plan = "energy balance (21; c3) (22; c4) (24; c6), not integrated",
};
#endif

/* ---- Fuel ---- */

KERNEL real energy_fuel_paper(const struct geometry *geometry)
{
    if (geometry->rounded.on)
        return rounded_fall(geometry, geometry->f);
    real s = geometry->s, d = geometry->d, x = geometry->h.x, y = geometry->h.y;
    /* h(0) - h(theta_f) = sin theta_f (h.y tan(theta_f / 2) - h.x). */
    if (geometry->detaches)
        return geometry->f.x * (y * geometry->f.x / (1 + geometry->f.y) - x);
    /* h(0) - h(theta_inf), rationalized, so that no digits cancel near P = 0; on a level floor P = 0 at s = 2
     * d^3 / (1 - d^2). */
    return s * fma(s, (y - x) * (y + x), -2 * d * x * x) /
           (geometry->L * (y * s + x * geometry->L * geometry->inf.x));
}

/* Returns the error bound of energy_fuel_paper: the rounding errors of two terms that are subtracted, and the
 * error of theta_f. */
static real fuel_paper_error(const struct geometry *geometry)
{
    real s = geometry->s, x = geometry->h.x, y = geometry->h.y;
    if (geometry->detaches) {
        real rises = x * geometry->f.y + y * geometry->f.x, half = y * geometry->f.x / (1 + geometry->f.y);
        return rises * geometry_error_f(geometry) + 12 * UNIT * geometry->f.x * (half + x);
    }
    real made_of = s * fabs((y - x) * (y + x)) + 2 * geometry->d * x * x;
    return 4 * UNIT * s * made_of / (geometry->L * (y * s + x * geometry->L * geometry->inf.x)) +
           10 * UNIT * fabs(energy_fuel_paper(geometry));
}

KERNEL struct fuel fuel_of(const struct geometry *geometry, const struct sums *at_c)
{
    return (struct fuel){.exact = -at_c->dH,
                         .paper = energy_fuel_paper(geometry),
                         .inertia_ratio = geometry->inertia * at_c->J / geometry->upright};
}

KERNEL enum dom_status energy_fuel(const struct geometry *geometry, struct fuel *fuel, struct fuel *error)
{
    struct sums at_c, e;
    enum dom_status status = chain_fall(geometry, &at_c, error ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *fuel = fuel_of(geometry, &at_c);
    if (error) {
        *error = (struct fuel){e.dH, fuel_paper_error(geometry),
                               geometry->inertia * e.J + 4 * UNIT * fuel->inertia_ratio};
    }
    return DOM_OK;
}

/* ---- Collision ---- */

KERNEL struct launch launch_of(const struct geometry *geometry, enum dom_fuel fuel, const struct fuel *f)
{
    real P = fuel == DOM_FUEL_PAPER ? f->paper : f->exact, J0 = geometry->upright * (1 + f->inertia_ratio);
    /* (24; c6) with r^q J(0) - J(0) + 1 = r^q + T (r^q - 1): all terms have one sign. */
    real kinetic = P * f->inertia_ratio / (geometry->rq + f->inertia_ratio * geometry->rq_1);
    return (struct launch){.fuel = P,
                           .J0 = J0,
                           .inertia_ratio = f->inertia_ratio,
                           .velocity_ratio = collision_velocity_ratio(f->inertia_ratio),
                           .omegasq = kinetic / J0,
                           .kinetic = kinetic,
                           .arrives = kinetic + f->exact};
}

static enum dom_status energy_collide(const struct geometry *geometry, enum dom_fuel fuel,
                                      struct launch *launch, struct launch *error)
{
    struct fuel f, e;
    if (fuel == DOM_FUEL_PAPER && !geometry_level(geometry))
        return DOM_NO_METHOD;
    enum dom_status status = energy_fuel(geometry, &f, error ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *launch = launch_of(geometry, fuel, &f);
    real J0 = launch->J0, kinetic = launch->kinetic;
    if (error) {
        real size = fabs(kinetic), P_error = fuel == DOM_FUEL_PAPER ? e.paper : e.exact;
        real powers = 12 * UNIT; /* rounding errors of the denominator, and of the operations that follow */
        real of_kinetic = P_error * f.inertia_ratio / (geometry->rq + f.inertia_ratio * geometry->rq_1) +
                          size * (e.inertia_ratio / f.inertia_ratio + powers);
        real of_J0 = e.inertia_ratio + UNIT * J0;
        *error = (struct launch){
            .fuel = P_error,
            .J0 = of_J0,
            .inertia_ratio = e.inertia_ratio,
            .velocity_ratio =
                (e.inertia_ratio + of_J0 * f.inertia_ratio / J0) / J0 + UNIT * f.inertia_ratio / J0,
            .omegasq = (of_kinetic + size * (of_J0 / J0 + UNIT)) / J0,
            .kinetic = of_kinetic,
            .arrives = of_kinetic + e.exact,
        };
    }
    return isfinite(kinetic) ? DOM_OK : DOM_NOT_FINITE;
}

static enum dom_status energy_inertia_ratio(const struct geometry *next, const struct geometry *hitting,
                                            struct tilt at, real J, real *inertia_ratio)
{
    (void)hitting, (void)at;
    const real slope = geometry_hit_slope(next);
    *inertia_ratio = next->inertia * slope * slope * J / next->upright;
    return *inertia_ratio > 0 ? DOM_OK : DOM_UNDERFLOW;
}

/* ---- Motion ---- */

static enum dom_status energy_slope(const struct geometry *geometry, struct tilt head, bool rough,
                                    real *slope)
{
    struct sums sums = {0};
    if (rough)
        return chain_sign(geometry, head, slope);
    enum dom_status status = chain_sum(geometry, head, &sums);
    *slope = sums.H1;
    return status;
}

static enum dom_status energy_required(const struct geometry *geometry, struct tilt from, real p,
                                       real *energy)
{
    struct sums sums;
    enum dom_status status = chain_energy_change_from(geometry, from, tilt_half(p), &sums);
    *energy = sums.dH;
    return status;
}

/* Solves (21; c3) for tau^2 omega(theta)^2. */
static enum dom_status energy_speed(const struct geometry *geometry, const struct start *start, real theta,
                                    real *omegasq, real *error)
{
    struct tilt head;
    struct sums at = {0}, e = {0};
    enum dom_status status = geometry_tilt(geometry, theta, &head);
    if (status == DOM_OK)
        status = error ? chain_energy_change(geometry, head, &at, &e)
                       : chain_energy_change_from(geometry, start->from, head, &at);
    if (status != DOM_OK)
        return status;
    *omegasq = (start->kinetic - at.dH) / at.J;
    if (error)
        *error = (start->kinetic_error + e.dH + fabs(*omegasq) * (e.J + 3 * UNIT * at.J)) / at.J;
    return DOM_OK;
}

static enum dom_status energy_before_rest(const struct geometry *geometry, real end, real by, real *slowness)
{
    struct tilt head, rest;
    struct sums at;
    enum dom_status status = geometry_tilt(geometry, end - by, &head);
    if (status == DOM_OK)
        status = geometry_tilt(geometry, end, &rest);
    if (status == DOM_OK)
        status = chain_energy_change_by(geometry, rest, head, -by, &at);
    if (status == DOM_OK)
        *slowness = at.dH < 0 ? at.J / -at.dH : REAL_NAN;
    return status;
}

/* Adds the rest of J, H1 and J'/2 from this domino on, if its tilt is near enough to theta_inf (far_near). */
static bool acceleration_closes(const struct link *k, real second_derivative, struct sum_state *a,
                                real *half_J1)
{
    const struct geometry *geometry = k->geometry;
    const struct far *far = &geometry->far;
    if (geometry->n != CHAIN_ENDLESS || far->order == 0 || geometry->follower)
        return false;
    real z = far_off(geometry, k->tilt), share = far_share(far, z), H1 = k->weight * k->slope,
         J = k->inertia * k->slope * k->slope;
    if (!far_done(&a->H1, -H1 / 2 * far->H[1], H1 / 2 * far->rest_H * share, geometry->tol) ||
        !far_done(&a->J, J * far->J[0], J * far->rest_J * share, geometry->tol))
        return false;
    struct far_point J_far = far_J(far, z);
    series_add(&a->H1, H1 * far_H(far, z).first);
    series_add(&a->J, J * J_far.value);
    *half_J1 +=
        k->inertia * k->slope * (second_derivative * J_far.value + k->slope * k->slope * J_far.first / 2);
    return true;
}

/* Finds the acceleration of dominoes with rounded edges. */
static enum dom_status rolling_acceleration(const struct geometry *geometry, struct tilt head, real w,
                                            real *acceleration, size_t *n)
{
    struct sums at;
    real half_J1;
    enum dom_status status = rolling_rates(geometry, head, &at, &half_J1);
    if (n)
        *n = at.n;
    *acceleration = -(at.H1 / 2 + half_J1 * w) / at.J;
    return status;
}

KERNEL enum dom_status energy_acceleration(const struct geometry *geometry, struct tilt head, real w,
                                           real *acceleration, size_t *n)
{
    if (geometry->rounded.on)
        return rolling_acceleration(geometry, head, w, acceleration, n);
    struct sum_state a = {0};
    struct sums at;
    struct link k = link_head(geometry, head);
    real half_J1 = 0, second_derivative = 0;
    for (;;) {
        enum dom_status status = chain_watch(geometry, k.i);
        if (status != DOM_OK)
            return status;
        if (!n && acceleration_closes(&k, second_derivative, &a, &half_J1))
            break;
        add_J(&a, &k);
        add_H1(&a, &k);
        half_J1 += k.inertia * k.slope * second_derivative;
        if (k.i + 1 >= geometry->n || !k.leads || (done_J(&a, &k) && done_H1(&a, &k, geometry->tol)))
            break;
        second_derivative = link_second_derivative(&k, second_derivative);
        link_next(&k);
    }
    enum dom_status status = sum_result(geometry, &a, 0, k.i + 1, &at);
    if (n)
        *n = at.n;
    *acceleration = -(at.H1 / 2 + half_J1 * w) / at.J;
    return status;
}

static real energy_gain(const struct geometry *geometry, const struct start *start, real gain, real theta,
                        real J_at)
{
    (void)geometry, (void)theta;
    return gain * start->J / J_at;
}

static struct arms rounded_arms(const struct link *link)
{
    real b = link_arm_b(link);
    return (struct arms){.ratio = link_arm_a(link) / b, .b = b};
}

/* The law. Of dominoes with rounded edges no error bounds are known, and their contacts have other arms. */
#define ENERGY_BALANCE(bounds, contact_arms)                                                                 \
    {                                                                                                        \
        .text = &dom_energy_balance, .conservative = true, .bounded = (bounds), .collide = energy_collide,   \
        .inertia_ratio = energy_inertia_ratio, .slope = energy_slope, .required_energy = energy_required,    \
        .speed = energy_speed, .before_rest = energy_before_rest, .acceleration = energy_acceleration,       \
        .gain = energy_gain, .arms = (contact_arms),                                                         \
    }

static const struct dynamics energy_balance = ENERGY_BALANCE(true, NULL),
                             rounded_balance = ENERGY_BALANCE(false, rounded_arms);
