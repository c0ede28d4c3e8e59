/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hard cases, in which naive code is wrong. In each case the library must be right within 16 units
 * (reference.h) at its smallest tolerance, which is about 9 units: 1e-15 in double. */
#include "../unit/support.h"
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

enum { CASE_CHECKS = 6 };

struct hard_case {
    const char *name, *trap; /* `trap` says what makes the case difficult */
    double s, r, d, q, tilt;
    bool paper;
    double units; /* allowed error of the library in units (reference.h); 0 means 16 */
    enum ref_quantity check[CASE_CHECKS]; /* quantities to check; REF_COUNT ends the list */
};

#define STANDARD (7.0 / 48)
#define END      REF_COUNT
/* Stands for the tilt f theta_c, where theta_c comes from the library. */
#define PART_OF_C(f) (-(f))
/* r s = 1 - u */
#define REACH(s, u) ((1 - (u)) / (s))

static const struct hard_case hard_cases[] = {
    /* H and H(0) are infinite sums for r = 1: only their difference is finite. */
    {"equal", "H diverges", 0.3, 1, STANDARD, 4, 0.2, .check = {REF_FUEL_EXACT, END}},
    {"equal, wide", "H diverges", 0.9, 1, STANDARD, 3, 0.2,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_KINETIC, END}},
    {"equal, thick", "H diverges", 0.2, 1, 0.5, 3, 0.1, .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"equal, close", "a thousand dominoes matter", 0.01, 1, STANDARD, 3, 0.005,
     .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"equal, very close", "fourteen thousand dominoes", 1e-4, 1, STANDARD, 3, 5e-5,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, END}},
    {"equal, paper thin", "d = 1e-8, r = 1", 0.01, 1, 1e-8, 3, 5e-3,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, END}},
    {"equal + 1e-12", "nearly divergent H", 0.3, 1 + 1e-12, STANDARD, 3, 0.2,
     .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"close + 1e-12", "nearly divergent H, 4000 dominoes", 1e-3, 1 + 1e-12, STANDARD, 3, 2e-4,
     .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"equal + ulp", "r = 1 + 2^-52", 0.2, 1 + 0x1p-52, 0.5, 3, 0.1, .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"close, q = 10", "r = 1 + 1e-6", 0.01, 1 + 1e-6, 0.01, 10, 0.001,
     .check = {REF_DH, REF_FUEL_EXACT, REF_KINETIC, REF_MARGIN, END}},
    {"close, r = 1.0001", "14000 dominoes", 1e-3, 1.0001, 0.01, 10, 0.001,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_KINETIC, END}},

    /* r s -> 1: 1 - r s, 1 - X and 1 - sin theta_f cancel; followers detach at once. */
    {"reach - 1e-15", "1 - r s", 0.3, REACH(0.3, 1e-15), STANDARD, 3, 1e-8,
     .check = {REF_THETA_C, REF_THETA_LEAVE, REF_THETA_F, REF_SLOPE, REF_ARM_B, END}},
    {"reach - 1e-15, energy", "1 - r s", 0.3, REACH(0.3, 1e-15), STANDARD, 3, 1e-8,
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_FUEL_PAPER, REF_BARRIER, REF_MARGIN}},
    {"reach - 1e-15, s = 1/2", "1 - r s", 0.5, REACH(0.5, 1e-15), STANDARD, 3, 1e-8,
     .check = {REF_THETA_LEAVE, REF_THETA_F, REF_SLOPE, REF_ARM_A, REF_ARM_B, END}},
    {"reach - 1e-15, s = 1/2, energy", "the follower leaves at 7e-8", 0.5, REACH(0.5, 1e-15), STANDARD, 3,
     1e-8, .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN, END}},
    {"reach - 1e-12", "1 - r s", 0.9, REACH(0.9, 1e-12), STANDARD, 3, 1e-8,
     .check = {REF_THETA_C, REF_THETA_LEAVE, REF_THETA_F, REF_SLOPE, REF_ARM_B, END}},
    {"reach - 1e-12, energy", "x never exceeds x_f", 0.9, REACH(0.9, 1e-12), STANDARD, 3, 1e-8,
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN, REF_DURATION}},
    {"reach - 1e-6", "1 - r s", 0.7, REACH(0.7, 1e-6), STANDARD, 4, 1e-3,
     .check = {REF_THETA_LEAVE, REF_THETA_F, REF_DH, REF_SLOPE, REF_BARRIER, END}},
    {"reach, rounded up", "r s > 1 by rounding alone", 0.3, 1 / 0.3, STANDARD, 3, 0.1,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN}},
    {"reach, exactly", "r s = 1", 0.5, 2, STANDARD, 3, 0.1,
     .check = {REF_THETA_F, REF_DH, REF_J0, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN}},
    {"reach, s = 1", "r = s = 1", 1, 1, STANDARD, 3, 0.1,
     .check = {REF_DH, REF_J0, REF_FUEL_EXACT, REF_OMEGASQ, REF_DURATION, END}},
    {"reach, s = 1e-6", "1 - r s, T = 1e-24", 1e-6, REACH(1e-6, 1e-15), STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_FUEL_EXACT, REF_KINETIC, REF_BARRIER, REF_MARGIN, REF_THETA_F, REF_STOP}},

    /* J(0) - 1 = r^-(q+1) ... is lost in J(0). */
    {"large r", "T = 1e-12", 1e-3, 900, STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_DH, REF_KINETIC, REF_FUEL_EXACT, REF_BARRIER, REF_THETA_F, REF_STOP}},
    {"large r, close to reach", "T = 1e-12", 0.01, 99, STANDARD, 5, PART_OF_C(0.5),
     .check = {REF_DH, REF_LAUNCH_OMEGASQ, REF_KINETIC, REF_FUEL_EXACT, REF_BARRIER, REF_STOP}},
    {"large r, far from reach", "T = 1e-23", 1e-6, 5e5, STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_LAUNCH_OMEGASQ, REF_KINETIC, REF_BARRIER, REF_THETA_F, REF_STOP, END}},
    {"large q", "T = 1e-13", 0.2, 2.1, STANDARD, 40, 0.1,
     .check = {REF_LAUNCH_OMEGASQ, REF_KINETIC, REF_BARRIER, REF_MARGIN, REF_STOP, END}},
    {"q = 100", "T = 1e-31", 0.4, 2, STANDARD, 100, 0.1,
     .check = {REF_LAUNCH_OMEGASQ, REF_KINETIC, REF_BARRIER, REF_STOP, END}},

    /* A follower detaches: x never exceeds x_f, so the sum never meets the paper's condition for its end. */
    {"q = 1/3", "detaching, heavy followers", 0.45, 2, STANDARD, 1 / 3.0, 0.3,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_KINETIC, REF_MARGIN}},
    {"q = pi", "detaching, real q", 0.4, 2, STANDARD, 3.141592653589793, 0.1,
     .check = {REF_DH, REF_KINETIC, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN, REF_J}},
    {"q = 3", "detaching", 0.45, 2, STANDARD, 3, 0.3,
     .check = {REF_DH, REF_J0, REF_FUEL_EXACT, REF_BARRIER, REF_OMEGASQ, REF_DURATION}},
    {"q = 4", "detaching", 0.9, 1.1, STANDARD, 4, 0.3,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_OMEGASQ, REF_DURATION}},
    {"beyond theta_leave", "no follower at this tilt", 0.5, 1.9, STANDARD, 3, 0.7,
     .check = {REF_DH, REF_J, REF_THETA_1, REF_SLOPE, REF_OMEGASQ, REF_MARGIN}},
    {"at theta_c", "no follower at theta_c", 0.5, 1.9, STANDARD, 3, PART_OF_C(1),
     .check = {REF_DH, REF_J, REF_THETA_1, REF_SLOPE, REF_OMEGASQ, END}},
    {"beside theta_c", "no follower beside theta_c", 0.8, 1.2, STANDARD, 3, PART_OF_C(1 - 1e-15),
     .check = {REF_DH, REF_J, REF_THETA_1, REF_SLOPE, REF_OMEGASQ, END}},
    {"just detaching", "where theta_f meets theta_inf", 0.5, 1.5896, STANDARD, 3, PART_OF_C(0.9),
     .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"edge of (A17), close", "theta_f = theta_inf = theta_leave, small angles", 1e-4, 100, 0.49995, 3,
     PART_OF_C(0.5), .check = {REF_DH, REF_FUEL_EXACT, REF_THETA_F, REF_THETA_INF, END}},
    {"edge of (A17), thick", "theta_f = theta_inf = theta_leave", 0.01, 1, 49.995, 3, PART_OF_C(0.5),
     .check = {REF_DH, REF_J0, REF_FUEL_EXACT, REF_BARRIER, REF_THETA_F, REF_THETA_INF}},

    /* Thin and thick dominoes. */
    {"thin", "d = 1e-8: dH = 1e-9", 0.4, 2, 1e-8, 3, 1e-8, .check = {REF_DH, END}},
    {"thin, alone", "d = 1e-8: the barrier is 5e-17", 0.4, 2.3, 1e-8, 30, 1e-8,
     .check = {REF_DH, REF_KINETIC, REF_THETA_M, REF_BARRIER, REF_MARGIN, END}},
    {"thin, at the reach", "d = 1e-8, r s = 1", 0.3, 1 / 0.3, 1e-8, 3, 1e-8,
     .check = {REF_DH, REF_KINETIC, REF_BARRIER, REF_MARGIN, END}},
    {"thin, near the reach", "a and b differ by d", 0.3, REACH(0.3, 1e-6), 1e-4, 3, 0.05,
     .check = {REF_DH, REF_SLOPE, REF_ARM_A, REF_MARGIN, END}},
    {"thinner, near the reach", "a and b differ by d", 0.3, REACH(0.3, 1e-10), 1e-8, 3, 0.005,
     .check = {REF_DH, REF_SLOPE, REF_ARM_A, REF_MARGIN, END}},
    {"d = 1.5", "no fuel, the maximum is at theta_c", 0.3, 1.1, 1.5, 3, 0.05,
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, END}},
    {"d = 3", "no fuel, the maximum is at theta_c", 0.9, 1, 3, 3, PART_OF_C(0.5),
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, END}},
    {"d = 3, growing", "no fuel, detaching", 0.1, 5, 3, 3, PART_OF_C(0.5),
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, END}},
    {"d = 100", "no fuel, small angles", 1e-3, 1, 100, 3, PART_OF_C(0.5),
     .check = {REF_THETA_INF, REF_DH, REF_J0, REF_FUEL_EXACT, END}},

    /* P -> 0+ */
    {"fuel 2e-7", "P -> 0", 0.0063378, 1, STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_FUEL_EXACT, REF_KINETIC, REF_DH, END}},
    {"fuel 1e-12", "P -> 0", 0.00633776, 1, STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_FUEL_EXACT, REF_DH, END}},

    /* margin -> 0+ */
    {"margin 1e-6", "duration diverges", 0.4, 1.6442, STANDARD, 4, 0.1, .check = {REF_DURATION, END}},
    {"margin 1e-12", "duration diverges", 0.4, 1.64422903953, STANDARD, 4, 0.1, .check = {REF_DURATION, END}},
    {"margin 1e-9, detaching", "duration diverges", 0.4, 2.06377177, STANDARD, 3, 0.1,
     .check = {REF_DURATION, REF_MARGIN, END}},
    {"slow launch", "rounding errors of the distance count at the launch", 0.052010575617230437,
     19.226858892691848, 2.2493188156625961e-06, 4, 0, .check = {REF_DURATION, END}},

    /* Difficult maxima of H. */
    {"two maxima", "H falls first, rises later", 0.54, 1.8515, STANDARD, 3, 0.1,
     .check = {REF_THETA_M, REF_BARRIER, REF_MARGIN, REF_DURATION, END}},
    {"two maxima, at rest", "H falls first, rises later", 0.5, 1.999, STANDARD, 3, 0.1,
     .check = {REF_BARRIER, REF_MARGIN, REF_STOP, END}},
    {"maximum at 0", "after the follower detaches, H must not rise again", 0.54, 1.8318, STANDARD, 3, 0.1,
     .check = {REF_MARGIN, REF_DH, REF_DURATION, END}},
    {"maximum beside 0", "H rises by 1e-11 only", 0.4, 1.5, STANDARD, 3.42071, 0.1,
     .check = {REF_BARRIER, END}},
    {"thin, two maxima", "H dips within 1e-8, then rises by 4e-18", 0.0029027851676659763, 344.4967306361371,
     2.0823454055730516e-08, 3, 1e-8, .paper = true,
     .check = {REF_DH, REF_BARRIER, REF_MARGIN, REF_STOP, END}},
    {"maximum at theta_c", "close, with the paper's fuel", 0.05, 1.53, STANDARD, 3, PART_OF_C(1),
     .paper = true, .check = {REF_BARRIER, END}},

    /* Small tilts. */
    {"tilt 1e-15", "H(theta) - H(0)", 0.4, 1.5, STANDARD, 3, 1e-15, .check = {REF_DH, END}},
    {"tilt 1e-30", "H(theta) - H(0)", 0.4, 1.5, STANDARD, 3, 1e-30, .check = {REF_DH, END}},

    /* The first r at which the train stops. */
    {"r_max, detaching", "x never exceeds x_f", 0.4, 1, STANDARD, 3, 0, .check = {REF_R_MAX, END}},
    {"r_max, near the reach", "the margin falls within 1e-3", 0.5, 1, STANDARD, 3, 0,
     .check = {REF_R_MAX, REF_PAIR, END}},
    {"r_max, beside the reach", "two maxima", 0.6, 1, STANDARD, 4, 0, .check = {REF_R_MAX, REF_PAIR, END}},
    {"r_max, thin", "a window of 1e-5 before the reach", 0.327, 1, 0.015, 3.7, 0,
     .check = {REF_R_MAX, REF_PAIR, END}},
    {"r_max, thin, paper", "a window before the reach", 0.3, 1, 0.015, 3.7, 0, .paper = true,
     .check = {REF_R_MAX, END}},
    {"r_max, close", "trains of hundreds", 0.02, 1, STANDARD, 4, 0, .check = {REF_R_MAX, END}},
    {"r_max, q = 1/2", "heavy followers; in quad, r_max has 32 units", 0.1, 1, STANDARD, 0.5, 0, .units = 40,
     .check = {REF_R_MAX, REF_PAIR, END}},
    {"r_max, a band", "equal dominoes fail, larger ones do not", 0.1, 1, 0.25, 0.5, 0,
     .check = {REF_PAIR, END}},
    {"r_max, a band up to the reach", "equal dominoes fail, larger ones do not", 0.25, 1, 0.2, 0.5, 0,
     .check = {REF_PAIR, END}},
};
enum { CASES = sizeof hard_cases / sizeof *hard_cases };

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
    struct tally tally[REF_COUNT] = {{0}};
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
    none_fails(workers_run(CASES, check_case, &precision));
}

TEST(hard_cases_in_double)
{
    assert_true(CASES >= 60);
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
