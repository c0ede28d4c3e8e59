/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sweep.h"

#include <string.h>

struct setup library_train(const struct ref_input *input, enum precision precision)
{
    struct setup train = setup_default();
    train.s = input->s;
    train.r = input->r;
    train.d = input->d;
    train.q = input->q;
    train.fuel = input->paper ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
    train.precision = precision;
    train.tol = any_arithmetic(precision).tol_floor;
    return train;
}

double library_unit(enum precision precision)
{
    return any_arithmetic(precision).epsilon / 2;
}

void library_nothing(struct answers *answers)
{
    *answers = (struct answers){.ends = DOM_END_NONE, .why = DOM_OK};
    for (int k = 0; k < REF_COUNT; k++)
        answers->value[k] = DOMQ_NAN;
}

static void note(struct answers *answers, enum ref_quantity quantity, enum dom_status status, domq_real value)
{
    answers->status[quantity] = status;
    answers->value[quantity] = value;
}

#define NOTE(QUANTITY, from, member) note(answers, REF_##QUANTITY, status, from.member)

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

void library_link(const struct setup *setup, domq_real tilt, size_t wanted, struct answers *answers)
{
    const struct domq_train train = setup_train(setup);
    const struct any_compute compute = setup_compute(setup);
    struct look look = {.wanted = wanted};
    enum dom_status status = any_chain_walk(&train, &compute, tilt, look_at_link, &look);
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

/* The results of the library. Where nothing has been written, every byte is 0xff, so that every number is
 * NaN. */
union found {
    struct domq_angles angles;
    struct domq_contact contact;
    struct domq_energy energy;
    struct domq_fuels fuels;
    struct domq_launch launch;
    struct domq_barrier barrier;
    domq_real value;
    struct domq_limit limit;
    struct domq_best best;
};

static void ask_growth(const struct domq_train *train, const struct any_compute *compute,
                       enum ref_quantity quantity, union found *f, struct answers *answers)
{
    enum dom_status status;
    if (quantity == REF_BEST_S || quantity == REF_BEST_R) {
        status = any_limit_best(train, compute, &f->best);
        NOTE(BEST_S, f->best, s);
        NOTE(BEST_R, f->best, r_max);
        answers->best_s_uncertainty = f->best.s_uncertainty;
        return;
    }
    status = quantity == REF_PAIR ? any_limit_pair(train, compute, &f->limit)
                                  : any_limit_rmax(train, compute, &f->limit);
    if (status == DOM_OK) {
        answers->ends = f->limit.ends;
        answers->why = f->limit.why;
    }
    note(answers, quantity, status, f->limit.r_max);
}

void library_ask(const struct setup *setup, domq_real tilt, enum ref_quantity quantity,
                 struct answers *answers)
{
    const struct domq_train train = setup_train(setup);
    const struct any_compute compute = setup_compute(setup);
    union found f;
    enum dom_status status;
    memset(&f, 0xff, sizeof f);
    if (quantity <= REF_THETA_LEAVE) {
        status = any_angles_find(&train, &compute, &f.angles);
        answers->detaches = status == DOM_OK && f.angles.detaches;
        NOTE(THETA_C, f.angles, theta_c);
        NOTE(THETA_U, f.angles, theta_u);
        NOTE(THETA_INF, f.angles, theta_inf);
        NOTE(THETA_F, f.angles, theta_f);
        NOTE(THETA_LEAVE, f.angles, theta_leave);
    } else if (quantity <= REF_ARM_B) {
        status = any_contact_find(&train, &compute, tilt, &f.contact);
        NOTE(THETA_1, f.contact, theta_1);
        NOTE(SLOPE, f.contact, slope);
        NOTE(ARM_A, f.contact, arm_a);
        NOTE(ARM_B, f.contact, arm_b);
    } else if (quantity <= REF_J0) {
        status = any_energy_find(&train, &compute, tilt, &f.energy);
        NOTE(DH, f.energy, dH);
        NOTE(J, f.energy, J);
        NOTE(J0, f.energy, J0);
    } else if (quantity <= REF_FUEL_PAPER) {
        status = any_fuel_find(&train, &compute, &f.fuels);
        NOTE(FUEL_EXACT, f.fuels, exact);
        NOTE(FUEL_PAPER, f.fuels, paper);
    } else if (quantity <= REF_KINETIC) {
        status = any_launch_find(&train, &compute, &f.launch);
        NOTE(LAUNCH_OMEGASQ, f.launch, omegasq);
        NOTE(KINETIC, f.launch, kinetic);
    } else if (quantity <= REF_MARGIN) {
        status = any_barrier_find(&train, &compute, &f.barrier);
        NOTE(THETA_M, f.barrier, theta_m);
        NOTE(BARRIER, f.barrier, barrier);
        NOTE(KINETIC, f.barrier, kinetic);
        NOTE(MARGIN, f.barrier, margin);
        note(answers, REF_STOP, status == DOM_STOPS ? DOM_OK : status, f.barrier.stop);
    } else if (quantity <= REF_DURATION) {
        status = quantity == REF_OMEGASQ ? any_cycle_omegasq(&train, &compute, tilt, &f.value)
                                         : any_cycle_duration(&train, &compute, &f.value);
        note(answers, quantity, status, f.value);
    } else {
        ask_growth(&train, &compute, quantity, &f, answers);
    }
}
