/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hard cases, in which naive code is wrong. In each case the library must be right within 16 units
 * (reference.h) at its smallest tolerance, which is about 9 units: 1e-15 in double. */
#include "../unit/support.h"
#include "cases.h"
#include "library.h"
#include "sweep.h"
#include "workers.h"
#include <string.h>

static void none_fails(long failures)
{
    if (failures < 0)
        fail_msg("%s", "a worker broke down");
    if (failures > 0)
        fail_msg("%ld checks failed, see stderr", failures);
}

/* ---- Cases ---- */

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
static long check_train(const struct ref_input *input, enum precision precision,
                        const enum ref_quantity *check, double units, const char *name)
{
    struct tally *const tally = calloc(REF_COUNT, sizeof *tally);
    assert_non_null(tally);
    long failures = 0;
    sweep_check(input, precision, check, tally);
    for (int k = 0; k < REF_COUNT; k++) {
        const bool far_off = tally[k].units.excess > units;
        if (!far_off && tally[k].wrong == 0)
            continue;
        failures++;
        fprintf(stderr, "# %s, %s: %s\n", name, any_arithmetic(precision).name, tally[k].what);
        tally_print("hard", (enum ref_quantity)k, far_off ? &tally[k].units : &tally[k].mistake);
    }
    free(tally);
    return failures;
}

/* Returns the number of checks that fail. */
static long check_case(int number, void *context)
{
    const struct hard_case *c = &hard_cases[number];
    const enum precision precision = *(const enum precision *)context;
    enum ref_quantity check[CASE_CHECKS + 1];
    /* In a shortened run, quad takes only every fourth case, since its source is the same as that of
     * double. */
    if (sweep_size() < 1 && number % 4 != 0 && precision != IN_DOUBLE)
        return 0;
    memcpy(check, c->check, sizeof c->check);
    check[CASE_CHECKS] = REF_COUNT;
    const struct ref_input input = input_of(c, precision);
    return check_train(&input, precision, check, c->units > 0 ? c->units : 16, c->name);
}

static void check_cases(enum precision precision)
{
    none_fails(workers_run(hard_cases_number, check_case, &precision));
}

TEST(hard_cases_in_double)
{
    assert_true(hard_cases_number >= 60);
    check_cases(IN_DOUBLE);
}

TEST(hard_cases_in_quad)
{
    if (any_arithmetic(IN_QUAD).bits == 0)
        skip();
    check_cases(IN_QUAD);
}

/* Checks that a cycle has a duration, even in float, if its kinetic energy is only 1e-12 of the fuel. */
TEST(a_slow_cycle_in_float_has_a_duration)
{
    const struct ref_input input = {(domq_real)0x1.7656b2p-15f,
                                    (domq_real)0x1.5e2492p+14f,
                                    (domq_real)0x1.e54866p-23f,
                                    (domq_real)0x1.c0a998p-1f,
                                    0,
                                    false};
    assert_int_equal(check_train(&input, IN_FLOAT, (const enum ref_quantity[]){REF_DURATION, REF_COUNT}, 16,
                                 "a slow cycle"),
                     0);
}
