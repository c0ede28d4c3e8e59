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

#define NOTE(QUANTITY, from, member) note(answers, REF_##QUANTITY, status, from.member, from.error.member)

static void note_angles(const struct domq_train *train, const struct domq_compute *compute,
                        struct answers *answers)
{
    struct domq_angles angles = {.theta_c = DOMQ_NAN,
                                 .theta_u = DOMQ_NAN,
                                 .theta_inf = DOMQ_NAN,
                                 .theta_f = DOMQ_NAN,
                                 .theta_leave = DOMQ_NAN};
    enum dom_status status = domq_angles_find(train, compute, &angles);
    answers->detaches = angles.detaches;
    NOTE(THETA_C, angles, theta_c);
    NOTE(THETA_U, angles, theta_u);
    NOTE(THETA_INF, angles, theta_inf);
    NOTE(THETA_F, angles, theta_f);
    NOTE(THETA_LEAVE, angles, theta_leave);
}

static void note_contact(const struct domq_train *train, const struct domq_compute *compute, domq_real tilt,
                         struct answers *answers)
{
    struct domq_contact contact = {
        .theta_1 = DOMQ_NAN, .slope = DOMQ_NAN, .arm_a = DOMQ_NAN, .arm_b = DOMQ_NAN};
    enum dom_status status = domq_contact_find(train, compute, tilt, &contact);
    NOTE(THETA_1, contact, theta_1);
    NOTE(SLOPE, contact, slope);
    NOTE(ARM_A, contact, arm_a);
    NOTE(ARM_B, contact, arm_b);
}

struct look {
    size_t wanted;
    struct domq_link link;
};

static bool look_at_link(const struct domq_link *link, void *context)
{
    struct look *look = context;
    look->link = *link;
    return link->i < look->wanted;
}

void library_link(const struct asked *asked, domq_real tilt, size_t wanted, struct answers *answers)
{
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, true);
    struct look look = {.wanted = wanted};
    enum dom_status status = domq_chain_walk(&train, &compute, tilt, look_at_link, &look);
    struct domq_link link = look.link;
    if (status != DOM_OK)
        return;
    answers->link = link.i;
    NOTE(LINK_THETA, link, theta);
    NOTE(LINK_SLOPE, link, slope);
    NOTE(LINK_ARM_A, link, arm_a);
    NOTE(LINK_ARM_B, link, arm_b);
    NOTE(LINK_WEIGHT, link, weight);
}

static void note_energy(const struct domq_train *train, const struct domq_compute *compute, domq_real tilt,
                        struct answers *answers)
{
    struct domq_energy energy = {.dH = DOMQ_NAN, .J = DOMQ_NAN, .J0 = DOMQ_NAN};
    enum dom_status status = domq_energy_find(train, compute, tilt, &energy);
    NOTE(DH, energy, dH);
    NOTE(J, energy, J);
    NOTE(J0, energy, J0);
}

static void note_fuel(const struct domq_train *train, const struct domq_compute *compute,
                      struct answers *answers)
{
    struct domq_fuels fuels = {.exact = DOMQ_NAN, .paper = DOMQ_NAN};
    enum dom_status status = domq_fuel_find(train, compute, &fuels);
    NOTE(FUEL_EXACT, fuels, exact);
    NOTE(FUEL_PAPER, fuels, paper);
}

static void note_launch(const struct domq_train *train, const struct domq_compute *compute,
                        struct answers *answers)
{
    struct domq_launch launch = {.fuel = DOMQ_NAN,
                                 .J0 = DOMQ_NAN,
                                 .velocity_ratio = DOMQ_NAN,
                                 .omegasq = DOMQ_NAN,
                                 .kinetic = DOMQ_NAN};
    enum dom_status status = domq_launch_find(train, compute, &launch);
    NOTE(LAUNCH_OMEGASQ, launch, omegasq);
    NOTE(KINETIC, launch, kinetic);
}

static void note_barrier(const struct domq_train *train, const struct domq_compute *compute,
                         struct answers *answers)
{
    struct domq_barrier barrier = {
        .theta_m = DOMQ_NAN, .barrier = DOMQ_NAN, .kinetic = DOMQ_NAN, .margin = DOMQ_NAN};
    enum dom_status status = domq_barrier_find(train, compute, &barrier);
    NOTE(THETA_M, barrier, theta_m);
    NOTE(BARRIER, barrier, barrier);
    NOTE(KINETIC, barrier, kinetic);
    NOTE(MARGIN, barrier, margin);
}

static void note_cycle(const struct domq_train *train, const struct domq_compute *compute, domq_real tilt,
                       enum ref_quantity quantity, struct answers *answers)
{
    struct domq_value value = {DOMQ_NAN, DOMQ_NAN};
    enum dom_status status = quantity == REF_OMEGASQ ? domq_cycle_omegasq(train, compute, tilt, &value)
                             : quantity == REF_STOP  ? domq_cycle_stop(train, compute, &value)
                                                     : domq_cycle_duration(train, compute, &value);
    note(answers, quantity, status, value.value, value.error);
}

static void note_growth(const struct domq_train *train, const struct domq_compute *compute,
                        enum ref_quantity quantity, struct answers *answers)
{
    struct domq_limit limit = {.r_max = DOMQ_NAN};
    struct domq_best best = {.s = DOMQ_NAN, .r_max = DOMQ_NAN};
    enum dom_status status;
    if (quantity == REF_R_MAX || quantity == REF_PAIR) {
        status = quantity == REF_PAIR ? domq_limit_pair(train, compute, &limit)
                                      : domq_limit_rmax(train, compute, &limit);
        answers->ends = limit.ends;
        answers->why = limit.why;
        note(answers, quantity, status, limit.r_max, limit.error.r_max);
    } else {
        status = domq_limit_best(train, compute, &best);
        NOTE(BEST_S, best, s);
        NOTE(BEST_R, best, r_max);
    }
}

void library_ask(const struct asked *asked, domq_real tilt, enum ref_quantity quantity,
                 struct answers *answers)
{
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, true);
    switch (quantity) {
    case REF_THETA_C:
    case REF_THETA_U:
    case REF_THETA_INF:
    case REF_THETA_F:
    case REF_THETA_LEAVE:
        note_angles(&train, &compute, answers);
        break;
    case REF_THETA_1:
    case REF_SLOPE:
    case REF_ARM_A:
    case REF_ARM_B:
        note_contact(&train, &compute, tilt, answers);
        break;
    case REF_DH:
    case REF_J:
    case REF_J0:
        note_energy(&train, &compute, tilt, answers);
        break;
    case REF_FUEL_EXACT:
    case REF_FUEL_PAPER:
        note_fuel(&train, &compute, answers);
        break;
    case REF_LAUNCH_OMEGASQ:
    case REF_KINETIC:
        note_launch(&train, &compute, answers);
        break;
    case REF_THETA_M:
    case REF_BARRIER:
    case REF_MARGIN:
        note_barrier(&train, &compute, answers);
        break;
    case REF_OMEGASQ:
    case REF_STOP:
    case REF_DURATION:
        note_cycle(&train, &compute, tilt, quantity, answers);
        break;
    case REF_R_MAX:
    case REF_PAIR:
    case REF_BEST_S:
    case REF_BEST_R:
        note_growth(&train, &compute, quantity, answers);
        break;
    default:
        library_link(asked, tilt, 1, answers);
    }
}
