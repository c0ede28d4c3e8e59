/* SPDX-License-Identifier: GPL-3.0-or-later */
/* First the solution of the equation of motion, for dominoes that lose energy (flow_...). Then the fuel, the
 * collision and the launch of a train (24; c6), and its speed at a tilt, by both laws of motion. */
#include "dynamics/dynamics.h"

/* ---- The equation of motion of dominoes that lose energy ---- */

/* The largest number of visits to dominoes that one solution may make, in all its passes along the chain. In
 * double precision, this many visits take half a second. */
#define FLOW_DOMINOES ((size_t)8000000)

struct flow_context {
    const struct geometry *geometry;
    enum dom_status status;
    real locked;     /* the last tilt at which friction was found to lock the motion */
    size_t dominoes; /* number of dominoes visited so far */
};

/* Computes the coefficients of dw/dtheta = (-2 B / A) w + 2 C / A. */
static bool flow_rate(real theta, void *context, struct num_rate *rate)
{
    struct flow_context *f = context;
    struct tilt head;
    struct equation_of_motion equation = {.n = 0};
    f->status = geometry_tilt(f->geometry, theta, &head);
    if (f->status == DOM_OK)
        f->status = chain_equation(f->geometry, head, &equation);
    f->dominoes += f->status == DOM_OK ? equation.n : 0;
    if (f->dominoes > FLOW_DOMINOES)
        f->status = DOM_TOO_LONG;
    if (f->status == DOM_OK && equation.locks) {
        f->status = DOM_LOCKS;
        f->locked = theta;
    }
    if (f->status != DOM_OK)
        return false;
    const real units = 32 * ROUNDOFF / equation.A, of_A = equation.A_size / equation.A;
    *rate = (struct num_rate){.p = -2 * equation.B / equation.A,
                              .c = 2 * equation.C / equation.A,
                              .p_noise = units * (equation.B_size + fabs(equation.B) * of_A),
                              .c_noise = units * (equation.C_size + fabs(equation.C) * of_A)};
    return true;
}

/*
 * Solves the equation of motion over one piece, in which no domino detaches. Near the start, the solution
 * changes on two scales that may be tiny:
 * - The first scale is d. Up to theta ~ d, u changes by only d^2. Afterwards it changes by much more.
 * - The second scale is sqrt(1 - r s). When the head has this tilt, followers that started near pi/2 have
 *   come down.
 *
 * So the panels near the start are narrow. Each panel ends at 8 times the tilt at which the previous panel
 * ends.
 */
static enum dom_status flow_piece(struct flow_context *c, real tol, real lo, real hi)
{
    const struct geometry *geometry = c->geometry;
    const bool begins = lo <= REAL_MIN || lo == geometry->lean;
    real to = geometry_finest(geometry);
    enum num_status solver = NUM_OK;
    /* Scales below the initial tilt of the head do not matter. */
    while (to <= lo && to < hi / 8)
        to *= 8;
    for (; begins && solver == NUM_OK && lo < to && to < hi / 8; lo = to, to *= 8)
        solver = num_linear_solve(flow_rate, c, lo, to, tol / 8, &geometry->flow->solution);
    if (solver == NUM_OK)
        solver = num_linear_solve(flow_rate, c, lo, hi, tol / 8, &geometry->flow->solution);
    return solver == NUM_OK ? DOM_OK : model_status(c->status, solver);
}

#define FLOW_FINER 64

/*
 * Empties the solution and returns a copy of the geometry with a finer tolerance. A sum over the chain leaves
 * out the last dominoes, whose terms are below the tolerance. How many dominoes it leaves out depends on the
 * tilt, and the sum jumps where this number changes. With the finer tolerance, the jumps are too small to
 * disturb a Chebyshev series.
 */
static struct geometry flow_begin(const struct geometry *geometry)
{
    struct geometry fine = *geometry;
    fine.tol = fmax(geometry->tol / FLOW_FINER, 64 * REAL_EPSILON);
    geometry->flow->solution.panels = 0;
    geometry->flow->tol = geometry->tol;
    return fine;
}

/* Finds the tilts that divide the cycle into smooth pieces, then the inertia before and after the collision,
 * and then the solution, one piece after the other. */
KERNEL enum dom_status flow_solve(const struct geometry *geometry)
{
    struct flow *flow = geometry->flow;
    if (flow->solution.panels > 0 && flow->tol <= geometry->tol)
        return DOM_OK;
    struct geometry fine = flow_begin(geometry);
    real edge[CHAIN_EDGES], leave;
    int edges;
    size_t domino;
    enum dom_status status = chain_edges(geometry, edge, &edges, &leave, &domino);
    /* In the collision that begins a cycle, the chain of all other dominoes hits the upright new head. */
    struct sums sums = {0};
    struct geometry hitting = fine;
    hitting.n = fine.n == CHAIN_ENDLESS ? CHAIN_ENDLESS : fine.n - 1;
    if (status == DOM_OK)
        status = dynamics_inertia_ratio(&fine, &hitting, fine.c, REAL_NAN, &flow->inertia_ratio);
    if (status == DOM_OK)
        status = chain_sum(&hitting, fine.c, false, &sums);
    flow->J0 = fine.upright_inertia + fine.inertia * sums.J;
    flow->J_c = sums.J;
    /*
     * All sums over one piece must include the same dominoes. If the number of dominoes were computed from
     * the tilt, rounding could make it wrong near an end of the piece. So the loop below sets the number once
     * for each piece.
     */
    const bool counted = !isnan(leave);
    size_t moving = leave > edge[0] ? domino + 1 : domino;
    fine.detaches = fine.detaches && !counted;
    struct flow_context c = {.geometry = &fine};
    for (int i = 1; i < edges && status == DOM_OK; i++) {
        fine.n = counted ? moving-- : fine.n;
        status = flow_piece(&c, geometry->tol, edge[i - 1], edge[i]);
    }
    return status;
}

/*
 * Solves the equation of motion up to the tilt at which friction locks the motion (A = 0). The term 2 B / A
 * has a pole there, and near the pole, panels must be short. So each step covers only half of the remaining
 * distance.
 */
static enum dom_status flow_to_lock(const struct geometry *fine, real tol, real lo, real locked, real *hi)
{
    struct flow_context c = {.geometry = fine, .status = DOM_OK, .locked = locked};
    struct num_linear *solution = &fine->flow->solution;
    for (;;) {
        *hi = solution->panels > 0 ? solution->panel[solution->panels - 1].hi : lo;
        const real from = *hi, to = from + (c.locked - from) / 2;
        if (!(c.locked - from > tol * c.locked && to > from && to < c.locked))
            break;
        enum num_status solver = num_linear_solve(flow_rate, &c, from, to, tol / 8, solution);
        if (solver == NUM_NOT_CONVERGED && c.status == DOM_OK)
            break; /* panels this close to the pole have no significant digits */
        if (solver != NUM_OK && c.status != DOM_LOCKS)
            return model_status(c.status, solver);
    }
    return DOM_LOCKS;
}

KERNEL enum dom_status flow_solve_piece(const struct geometry *geometry, real J0, real lo, real *hi)
{
    struct geometry fine = flow_begin(geometry);
    struct flow_context c = {.geometry = &fine, .locked = REAL_NAN};
    geometry->flow->J0 = J0;
    enum dom_status status = flow_piece(&c, geometry->tol, lo, *hi);
    return status == DOM_LOCKS ? flow_to_lock(&fine, geometry->tol, lo, c.locked, hi) : status;
}

KERNEL_SHARED void flow_at(const struct geometry *geometry, real theta, real *ln_G, real *u)
{
    num_linear_at(&geometry->flow->solution, theta, ln_G, u);
    *u = -*u;
}

KERNEL_SHARED bool flow_rough(const struct geometry *geometry, real hi)
{
    struct flow_context c = {.geometry = geometry};
    geometry->flow->solution.panels = 0;
    /* A domino that touches the next one has no way to fall, and then there is no solution. */
    return hi > 0 &&
           num_linear_solve(flow_rate, &c, 0, hi, (real)INFINITY, &geometry->flow->solution) == NUM_OK;
}

/* The error consists of the error of the solution, and of the error from leaving out the tail of the
 * chain. */
KERNEL real flow_required_error(const struct geometry *geometry)
{
    if (geometry->conservative)
        return 0;
    const struct num_linear *solution = &geometry->flow->solution;
    real ln_G, u;
    flow_at(geometry, tilt_angle(geometry->c), &ln_G, &u);
    return geometry->flow->J0 *
           (solution->v_error + (solution->ln_G_error + TAIL_SHARE * geometry->tol / FLOW_FINER) * fabs(u));
}

KERNEL enum dom_status dynamics_tipped(const struct geometry *geometry, real *omegasq)
{
    *omegasq = geometry->drag == 0 ? geometry_tipped_omegasq(geometry) : 0;
    if (geometry->drag == 0)
        return DOM_OK;
    struct geometry alone = *geometry;
    alone.n = 1;
    real lo = geometry_theta_u(geometry), hi = tilt_angle(geometry->c), ln_G, u;
    if (!(lo < hi))
        return DOM_OK;
    enum dom_status status = flow_solve_piece(&alone, REAL_NAN, lo, &hi);
    if (status != DOM_OK)
        return status;
    flow_at(&alone, hi, &ln_G, &u);
    *omegasq = fmax(-exp(ln_G) * u, 0);
    return DOM_OK;
}

/* ---- Both laws ---- */

KERNEL enum dom_status dynamics_fuel(const struct geometry *geometry, real *fuel, real *inertia_ratio)
{
    struct sums at_c = {0};
    const enum dom_status status =
        chain_change_by(geometry, standing, geometry->c, half_of_tilt(geometry->c), PASS_FUEL, &at_c);
    *fuel = -at_c.dH;
    if (inertia_ratio)
        *inertia_ratio = geometry->inertia * at_c.J / geometry->upright_inertia;
    return status;
}

/* ---- Collision ---- */

KERNEL enum dom_status dynamics_inertia_ratio(const struct geometry *next, const struct geometry *hitting,
                                              struct tilt at, real J, real *inertia_ratio)
{
    if (next->conservative) {
        const real slope = geometry_hit_slope(next);
        *inertia_ratio = next->inertia * slope * slope * J / next->upright_inertia;
        return *inertia_ratio > 0 ? DOM_OK : DOM_UNDERFLOW;
    }
    struct equation_of_motion at_hit;
    const struct link rest = link_head(next, geometry_rest(next), next->rolls);
    const struct arms arms = link_arms(&rest, next->rolls);
    *inertia_ratio = 0;
    if (next->mu != 0 && !(arms.a > 0))
        return DOM_LOCKS;
    enum dom_status status = chain_equation(hitting, at, &at_hit);
    if (status == DOM_OK)
        *inertia_ratio = next->inertia * rest.contact.slope * at_hit.A * arms.ratio / next->upright_inertia;
    return status != DOM_OK || *inertia_ratio > 0 ? status : DOM_LOCKS;
}

/*
 * Without losses, the launch is equation (24; c6). With losses, let w = tau^2 omega^2. A cycle begins with
 * the value w(0), and by the solution in dynamics.h it ends with w(theta_c) = G (w(0) - u). The next cycle
 * begins after the collision, and its w is in the units of a new head, which is r times as tall. The
 * collision and the change of units together multiply w(theta_c) by kappa = r (T / (1 + T))^2, where T is the
 * inertia ratio of the collision. The cycles repeat if the product kappa w(theta_c) equals w(0).
 */
KERNEL enum dom_status dynamics_launch(const struct geometry *geometry, enum dom_fuel fuel,
                                       struct launch *launch)
{
    const struct flow *flow = geometry->flow;
    real exact = 0, T = 0, ln_G, u;
    if (fuel == DOM_FUEL_PAPER && !dynamics_paper_holds(geometry))
        return DOM_NO_METHOD;
    enum dom_status status =
        geometry->conservative ? dynamics_fuel(geometry, &exact, &T) : flow_solve(geometry);
    if (status != DOM_OK)
        return status;
    if (geometry->conservative) {
        /* This is J(0) times equation (24; c6). With sharp edges, the inertia ratio T is J(0) - 1. With T,
         * the denominator r^q J(0) - J(0) + 1 is r^q + T (r^q - 1): no digits cancel if r >= 1. */
        const real P = fuel == DOM_FUEL_PAPER ? geometry_paper_fuel(geometry) : exact,
                   kinetic = P * T / (geometry->rq + T * geometry->rq_1),
                   J0 = geometry->upright_inertia * (1 + T);
        *launch = (struct launch){.fuel = P,
                                  .J0 = J0,
                                  .inertia_ratio = T,
                                  .omegasq = kinetic / J0,
                                  .kinetic = kinetic,
                                  .kinetic_at_hit = kinetic + exact};
    } else {
        flow_at(geometry, tilt_angle(geometry->c), &ln_G, &u);
        const real G = exp(ln_G), remains = collision_velocity_ratio(flow->inertia_ratio),
                   kappa = geometry->r * remains * remains, omegasq = -kappa * G * u / (1 - kappa * G);
        *launch = (struct launch){.fuel = -flow->J_c * G * u,
                                  .J0 = flow->J0,
                                  .inertia_ratio = flow->inertia_ratio,
                                  .omegasq = omegasq,
                                  .kinetic = flow->J0 * omegasq,
                                  .kinetic_at_hit = flow->J_c * omegasq / kappa};
    }
    return isfinite(launch->kinetic) ? DOM_OK : DOM_NOT_FINITE;
}

KERNEL enum dom_status dynamics_slope(const struct geometry *geometry, struct tilt head, bool rough,
                                      real *slope)
{
    struct equation_of_motion equation = {.C = 0};
    if (geometry->conservative) {
        struct sums sums = {.H1 = REAL_NAN};
        enum dom_status status = chain_sum(geometry, head, rough, &sums);
        *slope = sums.H1;
        return status;
    }
    if (rough) {
        *slope = -num_linear_moved(&geometry->flow->solution, tilt_angle(head), REAL_EPSILON) / REAL_EPSILON;
        return DOM_OK;
    }
    enum dom_status status = chain_equation(geometry, head, &equation);
    *slope = -2 * equation.C;
    return status;
}

KERNEL_SHARED enum dom_status dynamics_speed(const struct geometry *geometry, const struct start *start,
                                             real theta, real *omegasq)
{
    struct tilt head;
    struct sums at = {0};
    enum dom_status status = geometry_tilt(geometry, theta, &head);
    if (status == DOM_OK && !geometry->conservative) {
        real ln_G, u;
        flow_at(geometry, theta, &ln_G, &u);
        *omegasq = exp(ln_G) * (start->omegasq - u);
        return DOM_OK;
    }
    if (status == DOM_OK)
        status = chain_change(geometry, start->from, head, PASS_PLAIN, &at);
    if (status == DOM_OK)
        *omegasq = (start->kinetic - at.dH) / at.J; /* (21; c3) */
    return status;
}

KERNEL enum dom_status dynamics_near_rest(const struct geometry *geometry, real end, real by, real *slowness)
{
    struct tilt head, rest;
    struct sums at;
    if (!geometry->conservative) {
        const struct num_linear *solution = &geometry->flow->solution;
        real ln_G, u;
        flow_at(geometry, end - by, &ln_G, &u);
        /* w is G (u(end) - u), computed without cancellation. */
        const real left = by < 0 ? num_linear_moved(solution, end - by, -by)
                                 : -num_linear_moved(solution, end, by),
                   w = exp(ln_G) * left;
        *slowness = w > 0 ? 1 / w : REAL_NAN;
        return DOM_OK;
    }
    /* At the start, rounding may put `end - by` slightly below the initial tilt. */
    enum dom_status status = geometry_tilt(geometry, fmax(end - by, geometry->lean), &head);
    if (status == DOM_OK)
        status = geometry_tilt(geometry, end, &rest);
    if (status == DOM_OK)
        status = chain_change_by(geometry, rest, head, tan(-by / 2), PASS_PLAIN, &at);
    if (status == DOM_OK)
        *slowness = at.dH < 0 ? at.J / -at.dH : REAL_NAN;
    return status;
}
