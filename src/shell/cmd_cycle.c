/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands about one cycle: from one collision to the next, at the session's s, r, d and q. */
#include "command.h"
#include "value.h"
#include <math.h>

#define ROW(...) ((const struct cell[]){__VA_ARGS__})

/* The first argument as a tilt in [0, theta_c]. */
static bool tilt_argument(struct session *session, const struct call *call, double *theta)
{
    char shown[VALUE_SHOWN];
    struct dom_angles angles;
    *theta = DOM_NAN;
    enum dom_status status = dom_angles_find(&session->train, &angles);
    if (status != DOM_OK)
        return session_status(session, status);
    const char *text = call->word[1], *wrong = value_parse(text, theta);
    if (!wrong && !(*theta >= 0 && *theta <= angles.theta_c))
        wrong = "is outside the cycle";
    if (wrong)
        return session_error(session, "theta = '%s' %s; it is a number in [0, theta_c] = [0, %.17g]",
                             value_shown(text, shown), wrong, angles.theta_c);
    return true;
}

static const char no_fuel[] = "no domino effect: the fuel P is not positive, a fallen domino lies no lower "
                              "than it stood (s is too small for this d)";

static const struct column thetac_columns[] = {
    {"theta_c", "rad", "the head hits the next domino: sin theta_c = r s (a2)", 0},
    {"theta_u", "rad", "a single domino tips over: tan theta_u = d (b1)", 0},
    {"theta_inf", "rad", "far followers rest at: cos theta_inf = d / (s + d) (A16)", 0},
    {"theta_f", "rad", "last angle that a follower reaches (A18)", 0},
    {"theta_leave", "rad", "a follower falls off when its leader is here", 0},
    {"falls_off", "", "are followers too short to lean on to the end? (A17)", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_thetac(struct session *session, const struct call *call)
{
    struct dom_angles a;
    enum dom_status status = dom_angles_find(&session->train, &a);
    if (status != DOM_OK)
        return session_status(session, status);
    answer_row(call->answer,
               ROW(cell_real(a.theta_c), cell_real(a.theta_u), cell_real(a.theta_inf), cell_real(a.theta_f),
                   cell_real(a.theta_leave), cell_flag(a.falls_off)),
               NULL);
    return true;
}

static const struct column theta1_columns[] = {
    {"theta", "rad", "tilt of the head", 0},
    {"theta_1", "rad", "tilt of its follower (b8)", 0},
    {"slope", "", "d theta_1 / d theta = a / b (b10)", 0},
    {"arm_a", "h", "arm of the contact force on the head", 0},
    {"arm_b", "h", "arm of the contact force on the follower", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_theta1(struct session *session, const struct call *call)
{
    double theta;
    struct dom_contact c;
    if (!tilt_argument(session, call, &theta))
        return false;
    enum dom_status status = dom_contact_find(&session->train, theta, &c);
    if (status != DOM_OK)
        return session_status(session, status);
    const char *why = isnan(c.arm_a) ? "the follower has fallen off: it lies at theta_f" : NULL;
    answer_row(call->answer,
               ROW(cell_real(theta), cell_real(c.theta_1), cell_real(c.slope), cell_real(c.arm_a),
                   cell_real(c.arm_b)),
               why);
    return true;
}

static const struct column chain_columns[] = {
    {"i", "", "number of the domino, 0 is the head", 6},
    {"theta_i", "rad", "its tilt (A2)", 0},
    {"slope_i", "", "d theta_i / d theta (A9)", 0},
    {"arm_a", "h", "arm of the force from its follower", 0},
    {"arm_b", "h", "arm of that force on the follower", 0},
    {"weight", "", "r^(-q i), its share in the energy (c1)", 0},
    {NULL, NULL, NULL, 0},
};

static bool chain_row(const struct dom_link *k, void *context)
{
    answer_row(context,
               ROW(cell_count((double)k->i), cell_real(k->theta), cell_real(k->slope), cell_real(k->arm_a),
                   cell_real(k->arm_b), cell_real(k->weight)),
               NULL);
    return !answer_lost(context);
}

static bool run_chain(struct session *session, const struct call *call)
{
    double theta;
    if (!tilt_argument(session, call, &theta))
        return false;
    enum dom_status status = dom_chain_walk(&session->train, theta, chain_row, call->answer);
    return status == DOM_OK || session_status(session, status);
}

static const struct column energy_columns[] = {
    {"theta", "rad", "tilt of the head", 0},
    {"dH", "mgh/2", "potential energy H(theta) - H(0) of the train (c1)", 0},
    {"J", "", "its inertia: kinetic energy = J tau^2 omega^2 (c2)", 0},
    {"J0", "", "the same at theta = 0, J(0) (d8)", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_energy(struct session *session, const struct call *call)
{
    double theta;
    struct dom_energy e;
    if (!tilt_argument(session, call, &theta))
        return false;
    enum dom_status status = dom_energy_find(&session->train, theta, &e);
    if (status != DOM_OK)
        return session_status(session, status);
    answer_row(call->answer, ROW(cell_real(theta), cell_real(e.dH), cell_real(e.J), cell_real(e.J0)), NULL);
    return true;
}

static const struct column fuel_columns[] = {
    {"fuel", "mgh/2", "P, the one that is in use: see 'show fuel'", 0},
    {"fuel_exact", "mgh/2", "from the energy balance of one cycle", 0},
    {"fuel_paper", "mgh/2", "1 - h(theta_f), the closed form in (c7)", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_fuel(struct session *session, const struct call *call)
{
    struct dom_fuels f;
    enum dom_status status = dom_fuel_find(&session->train, &f);
    if (status != DOM_OK)
        return session_status(session, status);
    double used = session->train.fuel == DOM_FUEL_PAPER ? f.paper : f.exact;
    answer_row(call->answer, ROW(cell_real(used), cell_real(f.exact), cell_real(f.paper)),
               used > 0 ? NULL : no_fuel);
    return true;
}

static const struct column launch_columns[] = {
    {"omega0sq", "", "tau^2 omega(0)^2 after the collision (c6)", 0},
    {"omega0", "rad/s", "omega(0), angular velocity of the head", 0},
    {"kinetic", "mgh/2", "kinetic energy of the train, J(0) tau^2 omega(0)^2", 0},
    {"J0", "", "inertia of the train, J(0) (d8)", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_launch(struct session *session, const struct call *call)
{
    struct dom_launch l;
    enum dom_status status = dom_launch_find(&session->train, &l);
    if (status != DOM_OK && status != DOM_NO_FUEL)
        return session_status(session, status);
    double tau = dom_scale_tau(&session->scale, session->train.d);
    answer_row(
        call->answer,
        ROW(cell_real(l.omegasq), cell_real(sqrt(l.omegasq) / tau), cell_real(l.kinetic), cell_real(l.J0)),
        status == DOM_OK ? NULL : no_fuel);
    return true;
}

/* "the train stops at theta = ..., below the barrier", into reason. */
static const char *stop_reason(const struct dom_train *train, char *reason, size_t size)
{
    double stop;
    if (dom_cycle_stop(train, &stop) == DOM_OK && isfinite(stop))
        snprintf(
            reason, size,
            "no domino effect: the kinetic energy is below the barrier, the train stops at theta = %.10g",
            stop);
    else
        snprintf(reason, size, "no domino effect: the kinetic energy is below the barrier");
    return reason;
}

static const struct column omega_columns[] = {
    {"theta", "rad", "tilt of the head", 0},
    {"omegasq", "", "tau^2 omega(theta)^2 (c3)", 0},
    {"omega", "rad/s", "omega(theta), angular velocity of the head", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_omega(struct session *session, const struct call *call)
{
    double theta, omegasq;
    char reason[160];
    if (!tilt_argument(session, call, &theta))
        return false;
    enum dom_status status = dom_cycle_omegasq(&session->train, theta, &omegasq);
    if (status != DOM_OK && status != DOM_NO_FUEL && status != DOM_STOPS)
        return session_status(session, status);
    double tau = dom_scale_tau(&session->scale, session->train.d);
    answer_row(call->answer, ROW(cell_real(theta), cell_real(omegasq), cell_real(sqrt(omegasq) / tau)),
               status == DOM_OK        ? NULL
               : status == DOM_NO_FUEL ? no_fuel
                                       : stop_reason(&session->train, reason, sizeof reason));
    return true;
}

static const struct column barrier_columns[] = {
    {"theta_m", "rad", "where the train is highest", 0},
    {"barrier", "mgh/2", "max of H(theta) - H(0), what there is to climb", 0},
    {"kinetic", "mgh/2", "what there is to climb it with, J(0) tau^2 omega(0)^2", 0},
    {"margin", "mgh/2", "kinetic - barrier: the train goes on if it is >= 0 (c8)", 0},
    {"verdict", "", "goes on, stops, or no fuel", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_barrier(struct session *session, const struct call *call)
{
    struct dom_barrier b;
    char reason[160];
    enum dom_status status = dom_barrier_find(&session->train, &b);
    if (status != DOM_OK && status != DOM_NO_FUEL && status != DOM_STOPS)
        return session_status(session, status);
    const char *verdict = status == DOM_OK ? "goes on" : status == DOM_STOPS ? "stops" : "no fuel";
    answer_row(call->answer,
               ROW(cell_real(b.theta_m), cell_real(b.barrier), cell_real(b.kinetic), cell_real(b.margin),
                   cell_word(verdict)),
               status == DOM_OK        ? NULL
               : status == DOM_NO_FUEL ? no_fuel
                                       : stop_reason(&session->train, reason, sizeof reason));
    return true;
}

static const struct column duration_columns[] = {
    {"duration", "tau", "t_f / tau, from one collision to the next", 0},
    {"tau", "s", "unit of time, sqrt((h^2 + d^2) / (3 g h)) (a1)", 0},
    {"seconds", "s", "t_f; each next cycle lasts sqrt(r) times as long", 0},
    {"speed", "m/s", "of the front in this cycle, (s + d) r h / t_f", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_duration(struct session *session, const struct call *call)
{
    double duration = DOM_NAN, tau = dom_scale_tau(&session->scale, session->train.d);
    char reason[160];
    enum dom_status status = dom_cycle_duration(&session->train, &duration);
    const char *why = NULL;
    if (status == DOM_NO_FUEL)
        why = no_fuel;
    else if (status == DOM_STOPS)
        why = stop_reason(&session->train, reason, sizeof reason);
    else if (status == DOM_NOT_CONVERGED)
        return session_error(session, "the margin is 0 to rounding: the duration grows like ln(1/margin) and "
                                      "has no value here; a slightly smaller r has");
    else if (status != DOM_OK)
        return session_status(session, status);
    double speed = why ? DOM_NAN : dom_scale_speed(&session->scale, &session->train, duration);
    answer_row(call->answer,
               ROW(cell_real(duration), cell_real(tau), cell_real(duration * tau), cell_real(speed)), why);
    return true;
}

const struct command cycle_commands[] = {
    {"thetac", "", "the angles that bound a cycle", NULL, 0, 0, ARGUMENT_ANY, thetac_columns, false,
     run_thetac},
    {"theta1", "T", "the follower that leans on the head at tilt T (radians)", NULL, 1, 1, ARGUMENT_ANY,
     theta1_columns, false, run_theta1},
    {"chain", "T", "every domino that matters behind the head at tilt T", NULL, 1, 1, ARGUMENT_ANY,
     chain_columns, true, run_chain},
    {"energy", "T", "potential energy and inertia of the train at tilt T", NULL, 1, 1, ARGUMENT_ANY,
     energy_columns, false, run_energy},
    {"fuel", "", "the energy that one cycle sets free",
     "(c7) of the paper has two right-hand sides. The sum over the train is the energy balance; the closed\n"
     "form that the paper computes with equals it only for r = 1, since the weights r^(-q i) spoil the\n"
     "telescoping. 'set fuel paper' gives the paper's figures.",
     0, 0, ARGUMENT_ANY, fuel_columns, false, run_fuel},
    {"launch", "", "the collision: with which speed a cycle begins", NULL, 0, 0, ARGUMENT_ANY, launch_columns,
     false, run_launch},
    {"omega", "T", "angular velocity of the head at tilt T", NULL, 1, 1, ARGUMENT_ANY, omega_columns, false,
     run_omega},
    {"barrier", "", "what the train must climb, and whether it can", NULL, 0, 0, ARGUMENT_ANY,
     barrier_columns, false, run_barrier},
    {"duration", "", "how long a cycle lasts, and how fast the front runs", NULL, 0, 0, ARGUMENT_ANY,
     duration_columns, false, run_duration},
    {.name = NULL},
};
