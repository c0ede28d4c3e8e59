/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hard cases, in which naive code is wrong. In each case the library must be right within 16 units
 * (reference.h) at its smallest tolerance, which is about 9 units: 1e-15 in double. */
#include "../unit/support.h"
#include "sweep.h"
#include "workers.h"

/* Returns the input of a case. The tilt is computed with the library's theta_c. */
static struct ref_input input_of(const struct hard_case *c, enum precision precision)
{
    struct ref_input input = {(domq_real)c->s, (domq_real)c->r, (domq_real)c->d, (domq_real)c->q, 0,
                              c->paper};
    if (c->r == 1 / c->s) /* 1/s, rounded to this precision */
        input.r = precision == IN_QUAD ? 1 / input.s : (domq_real)c->r;
    if (c->tilt >= 0) {
        input.tilt = (domq_real)c->tilt;
    } else {
        struct answers answers;
        library_nothing(&answers);
        struct setup train = library_train(&input, precision);
        library_ask(&train, 0, REF_THETA_C, &answers);
        input.tilt = -(domq_real)c->tilt * answers.value[REF_THETA_C];
        if (precision == IN_DOUBLE)
            input.tilt = (domq_real)(double)input.tilt;
    }
    return input;
}

/* Returns the number of quantities of a train that are wrong or off by more than the allowed units. */
static long check_train(const struct ref_input *input, enum precision precision, int asks, double units,
                        const char *name)
{
    struct tally *const tally = calloc(REF_COUNT, sizeof *tally);
    assert_non_null(tally);
    long failures = 0, checked = 0;
    sweep_check(input, precision, asks, tally);
    for (int k = 0; k < REF_COUNT; k++) {
        /* each of hundreds of dominoes adds a rounding error to the tilt of the last */
        const bool far_off = tally[k].units.excess > units * (k == REF_LINK_THETA ? 1.5 : 1);
        checked += tally[k].checked;
        if (!far_off && tally[k].wrong == 0)
            continue;
        failures++;
        fprintf(stderr, "# %s, %s: %s\n", name, any_arithmetic(precision).name, tally[k].what);
        tally_print("hard", (enum ref_quantity)k, far_off ? &tally[k].units : &tally[k].mistake);
    }
    free(tally);
    return checked > 0 ? failures : 1;
}

/* Returns the number of checks that fail. In a shortened run, quad takes only every fourth case, since its
 * source is the same as that of double. */
static long check_case(int number, void *context)
{
    const struct hard_case *c = &hard_cases[number];
    const enum precision precision = *(const enum precision *)context;
    if (sweep_size() < 1 && number % 4 != 0 && precision != IN_DOUBLE)
        return 0;
    const struct ref_input input = input_of(c, precision);
    return check_train(&input, precision, c->asks, c->units > 0 ? c->units : 16, c->name);
}

TEST(hard_cases_are_right)
{
    assert_true(hard_cases_number >= 60);
    for (enum precision precision = IN_DOUBLE; precision <= IN_QUAD; precision++)
        if (any_arithmetic(precision).bits > 0)
            assert_int_equal(workers_run(hard_cases_number, check_case, &precision), 0);
}

/* Checks the energies of a train in which the tilts of head and follower differ by a few units of roundoff.
 * The place from which on its far tail is a series must not come from their difference. */
TEST(thin_dominoes_in_float_have_their_energies)
{
    const struct ref_input input = {.s = (domq_real)1.0932491e-06f,
                                    .r = (domq_real)1.2820297f,
                                    .d = (domq_real)2.0761383e-06f,
                                    .q = 3,
                                    .tilt = (domq_real)1.4e-06f};
    assert_int_equal(check_train(&input, IN_FLOAT, TILT, 16, "thin dominoes"), 0);
}

/* Checks that a cycle has a duration, even in float, if its kinetic energy is only 1e-12 of the fuel. */
TEST(a_slow_cycle_in_float_has_a_duration)
{
    const struct ref_input input = {.s = (domq_real)0x1.7656b2p-15f,
                                    .r = (domq_real)0x1.5e2492p+14f,
                                    .d = (domq_real)0x1.e54866p-23f,
                                    .q = (domq_real)0x1.c0a998p-1f};
    assert_int_equal(check_train(&input, IN_FLOAT, TIME, 16, "a slow cycle"), 0);
}
