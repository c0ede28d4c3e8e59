/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hard cases, in which naive code is wrong. In each case the library must be right within 16 units
 * (reference.h) at its smallest tolerance, which is about 9 units: 1e-15 in double. */
#include "../unit/support.h"
#include "cases.h"
#include "growth.h"
#include "library.h"
#include "sweep.h"
#include "workers.h"

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

/* The error of an answer, and the scale of such errors (reference.h) or a large enough part of the scale. */
struct verdict {
    double want, scale, error;
};

static double allowed_units(const struct hard_case *c, enum precision precision)
{
    return (c->units > 0 ? c->units : 16) * library_unit(precision);
}

static struct verdict judge(const struct hard_case *c, enum precision precision, struct ref *ref,
                            enum ref_quantity quantity, domq_real got)
{
    struct verdict v = {.want = ref_double(ref, quantity), .error = ref_error(ref, quantity, got)};
    /* The scale of a lengthy train would take minutes, so errors are compared with |F| alone. */
    v.scale =
        c->lengthy ? fabs(v.want) : ref_scale_up_to(ref, quantity, v.error / allowed_units(c, precision));
    return v;
}

/* Judges a limit of growth, which is 1/s or a growth at which the margin is 0. */
static struct verdict judge_growth(const struct ref_input *input, enum ref_quantity quantity, int digits2,
                                   const struct answers *answers)
{
    const domq_real got = answers->value[quantity], reach = 1 / input->s;
    struct verdict v = {.want = (double)got, .scale = (double)got};
    v.error = fabs(answers->ends == DOM_END_REACH
                       ? (double)(got - reach)
                       : growth_error(input, quantity == REF_PAIR, digits2, got, &v.scale));
    return v;
}

static struct verdict judge_any(const struct hard_case *c, enum precision precision,
                                const struct ref_input *input, struct ref *ref, enum ref_quantity quantity,
                                int digits2, const struct answers *answers)
{
    const domq_real got = answers->value[quantity];
    if (quantity == REF_R_MAX || quantity == REF_PAIR)
        return judge_growth(input, quantity, digits2, answers);
    if (quantity != REF_STOP)
        return judge(c, precision, ref, quantity, got);
    struct ref_input at = *input;
    at.tilt = got; /* the number of bits depends on the tilt */
    ref = ref_open_for(&at, digits2);
    struct verdict v = judge(c, precision, ref, quantity, got);
    ref_close(ref);
    return v;
}

/* Returns the number of checks that fail. */
static long check_case(int number, void *context)
{
    const struct hard_case *c = &hard_cases[number];
    const enum precision precision = *(const enum precision *)context;
    /* In a shortened run, quad takes only every fourth case, since its source is the same as that of
     * double. */
    const bool part = sweep_size() < 1 && number % 4 != 0;
    if ((c->lengthy || part) && precision != IN_DOUBLE)
        return 0;
    const struct ref_input input = input_of(c, precision);
    const struct setup train = library_train(&input, precision);
    const int digits2 = precision == IN_QUAD ? 120 : 60;
    struct ref *ref = ref_open_for(&input, digits2);
    struct answers answers;
    long failures = 0;
    library_nothing(&answers);
    for (int k = 0; k < CASE_CHECKS && c->check[k] != REF_COUNT; k++) {
        const enum ref_quantity quantity = c->check[k];
        library_ask(&train, input.tilt, quantity, &answers);
        const domq_real got = answers.value[quantity];
        const struct verdict v = judge_any(c, precision, &input, ref, quantity, digits2, &answers);
        const double most = v.scale * allowed_units(c, precision);
        if (v.error <= most)
            continue;
        failures++;
        fprintf(stderr, "# %s (%s), %s, %s: got %.17g, wanted %.17g: off by %.3g, %.3g allowed\n", c->name,
                c->trap, any_arithmetic(precision).name, ref_name(quantity), (double)got, v.want, v.error,
                most);
    }
    ref_close(ref);
    return failures;
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
    struct setup train = library_train(&input, IN_FLOAT);
    struct answers answers;
    library_nothing(&answers);
    library_ask(&train, 0, REF_DURATION, &answers);
    struct ref *ref = ref_open_for(&input, 44);
    const double want = ref_double(ref, REF_DURATION);
    const double units = ref_error(ref, REF_DURATION, answers.value[REF_DURATION]) /
                         (ref_scale(ref, REF_DURATION) * library_unit(IN_FLOAT));
    ref_close(ref);
    if (answers.status[REF_DURATION] != DOM_OK || !(units <= 16))
        fail_msg("%s: %.9g, wanted %.9g", dom_status_text(answers.status[REF_DURATION]),
                 (double)answers.value[REF_DURATION], want);
}
