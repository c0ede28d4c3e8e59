/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library.h"

struct asked library_train(const struct ref_input *input, enum dom_precision precision)
{
    struct asked train = asked_default();
    train.s = input->s;
    train.r = input->r;
    train.d = input->d;
    train.q = input->q;
    train.fuel = input->paper ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
    train.precision = precision;
    train.tol = domq_arithmetic(precision)->tol_floor;
    return train;
}

double library_unit(enum dom_precision precision)
{
    return domq_arithmetic(precision)->epsilon / 2;
}

double library_floor(enum dom_precision precision)
{
    return (double)domq_arithmetic(precision)->tol_floor;
}

void library_nothing(struct answers *answers)
{
    *answers = (struct answers){.ends = DOM_END_NONE, .why = DOM_OK};
    for (int k = 0; k < REF_COUNT; k++)
        answers->value[k] = answers->error[k] = DOMQ_NAN;
}

static void note(struct answers *answers, enum ref_quantity quantity, enum dom_status status, domq_real value,
                 domq_real error)
{
    answers->status[quantity] = status;
    answers->value[quantity] = value;
    answers->error[quantity] = error;
}

#define NOTE(QUANTITY, from, member) note(answers, REF_##QUANTITY, status, from.member, from##_error.member)

static void ask_angles(const struct asked *train, struct answers *answers)
{
    struct domq_angles angles = {.theta_c = DOMQ_NAN,
                                 .theta_u = DOMQ_NAN,
                                 .theta_inf = DOMQ_NAN,
                                 .theta_f = DOMQ_NAN,
                                 .theta_leave = DOMQ_NAN},
                       angles_error = angles;
    enum dom_status status = ask_angles_find(train, &angles, &angles_error);
    answers->detaches = angles.detaches;
    NOTE(THETA_C, angles, theta_c);
    NOTE(THETA_U, angles, theta_u);
    NOTE(THETA_INF, angles, theta_inf);
    NOTE(THETA_F, angles, theta_f);
    NOTE(THETA_LEAVE, angles, theta_leave);
}

static void ask_contact(const struct asked *train, domq_real tilt, struct answers *answers)
{
    struct domq_contact contact = {.theta_1 = DOMQ_NAN,
                                   .slope = DOMQ_NAN,
                                   .arm_a = DOMQ_NAN,
                                   .arm_b = DOMQ_NAN},
                        contact_error = contact;
    enum dom_status status = ask_contact_find(train, tilt, &contact, &contact_error);
    NOTE(THETA_1, contact, theta_1);
    NOTE(SLOPE, contact, slope);
    NOTE(ARM_A, contact, arm_a);
    NOTE(ARM_B, contact, arm_b);
}

struct look {
    size_t wanted;
    struct domq_link link, link_error;
};

static bool look_at_link(const struct domq_link *link, const struct domq_link *error, void *context)
{
    struct look *look = context;
    look->link = *link;
    look->link_error = *error;
    return link->i < look->wanted;
}

void library_link(const struct asked *train, domq_real tilt, size_t wanted, struct answers *answers)
{
    struct look look = {.wanted = wanted};
    enum dom_status status = ask_chain_walk(train, tilt, true, look_at_link, &look);
    struct domq_link link = look.link, link_error = look.link_error;
    if (status != DOM_OK)
        return;
    answers->link = link.i;
    NOTE(LINK_THETA, link, theta);
    NOTE(LINK_SLOPE, link, slope);
    NOTE(LINK_ARM_A, link, arm_a);
    NOTE(LINK_ARM_B, link, arm_b);
    NOTE(LINK_WEIGHT, link, weight);
}

static void ask_energy(const struct asked *train, domq_real tilt, struct answers *answers)
{
    struct domq_energy energy = {.dH = DOMQ_NAN, .J = DOMQ_NAN, .J0 = DOMQ_NAN}, energy_error = energy;
    enum dom_status status = ask_energy_find(train, tilt, &energy, &energy_error);
    NOTE(DH, energy, dH);
    NOTE(J, energy, J);
    NOTE(J0, energy, J0);
}

static void ask_fuel(const struct asked *train, struct answers *answers)
{
    struct domq_fuels fuels = {.exact = DOMQ_NAN, .paper = DOMQ_NAN}, fuels_error = fuels;
    enum dom_status status = ask_fuel_find(train, &fuels, &fuels_error);
    NOTE(FUEL_EXACT, fuels, exact);
    NOTE(FUEL_PAPER, fuels, paper);
}

static void ask_launch(const struct asked *train, struct answers *answers)
{
    struct domq_launch launch = {.fuel = DOMQ_NAN,
                                 .J0 = DOMQ_NAN,
                                 .velocity_ratio = DOMQ_NAN,
                                 .omegasq = DOMQ_NAN,
                                 .kinetic = DOMQ_NAN},
                       launch_error = launch;
    enum dom_status status = ask_launch_find(train, &launch, &launch_error);
    NOTE(LAUNCH_OMEGASQ, launch, omegasq);
    NOTE(KINETIC, launch, kinetic);
}

static void ask_barrier(const struct asked *train, struct answers *answers)
{
    struct domq_barrier barrier = {.theta_m = DOMQ_NAN,
                                   .barrier = DOMQ_NAN,
                                   .kinetic = DOMQ_NAN,
                                   .margin = DOMQ_NAN},
                        barrier_error = barrier;
    enum dom_status status = ask_barrier_find(train, &barrier, &barrier_error);
    NOTE(THETA_M, barrier, theta_m);
    NOTE(BARRIER, barrier, barrier);
    NOTE(KINETIC, barrier, kinetic);
    NOTE(MARGIN, barrier, margin);
}

static void ask_cycle(const struct asked *train, domq_real tilt, enum ref_quantity quantity,
                      struct answers *answers)
{
    domq_real value = DOMQ_NAN, error = DOMQ_NAN;
    enum dom_status status = quantity == REF_OMEGASQ ? ask_cycle_omegasq(train, tilt, &value, &error)
                             : quantity == REF_STOP  ? ask_cycle_stop(train, &value, &error)
                                                     : ask_cycle_duration(train, &value, &error);
    note(answers, quantity, status, value, error);
}

static void ask_growth(const struct asked *train, enum ref_quantity quantity, struct answers *answers)
{
    struct domq_limit limit = {.r_max = DOMQ_NAN}, limit_error = limit;
    struct domq_best best = {.s = DOMQ_NAN, .r_max = DOMQ_NAN}, best_error = best;
    enum dom_status status;
    if (quantity == REF_R_MAX || quantity == REF_PAIR) {
        status = quantity == REF_PAIR ? ask_limit_pair(train, &limit, &limit_error)
                                      : ask_limit_rmax(train, &limit, &limit_error, &answers->why);
        answers->ends = limit.ends;
        note(answers, quantity, status, limit.r_max, limit_error.r_max);
    } else {
        status = ask_limit_best(train, &best, &best_error);
        NOTE(BEST_S, best, s);
        NOTE(BEST_R, best, r_max);
    }
}

void library_ask(const struct asked *train, domq_real tilt, enum ref_quantity quantity,
                 struct answers *answers)
{
    switch (quantity) {
    case REF_THETA_C:
    case REF_THETA_U:
    case REF_THETA_INF:
    case REF_THETA_F:
    case REF_THETA_LEAVE:
        ask_angles(train, answers);
        break;
    case REF_THETA_1:
    case REF_SLOPE:
    case REF_ARM_A:
    case REF_ARM_B:
        ask_contact(train, tilt, answers);
        break;
    case REF_DH:
    case REF_J:
    case REF_J0:
        ask_energy(train, tilt, answers);
        break;
    case REF_FUEL_EXACT:
    case REF_FUEL_PAPER:
        ask_fuel(train, answers);
        break;
    case REF_LAUNCH_OMEGASQ:
    case REF_KINETIC:
        ask_launch(train, answers);
        break;
    case REF_THETA_M:
    case REF_BARRIER:
    case REF_MARGIN:
        ask_barrier(train, answers);
        break;
    case REF_OMEGASQ:
    case REF_STOP:
    case REF_DURATION:
        ask_cycle(train, tilt, quantity, answers);
        break;
    case REF_R_MAX:
    case REF_PAIR:
    case REF_BEST_S:
    case REF_BEST_R:
        ask_growth(train, quantity, answers);
        break;
    default:
        library_link(train, tilt, 1, answers);
    }
}
