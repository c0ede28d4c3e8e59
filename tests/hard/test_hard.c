/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Hard cases, in which naive code is wrong. In each case the library must be right within 16 units
 * (reference.h) at its smallest tolerance, 1e-15, which corresponds to 9 units. The first tests check the
 * reference itself.
 */
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

/* ---- The reference against digits that were computed elsewhere ---- */

static domq_real csv_real(const struct csv *csv, const char *name)
{
    return (domq_real)csv_number(csv, name);
}

/* Checks that |value / text - 1| <= bound. */
static void assert_digits(const struct csv *csv, const char *column, struct ref *ref,
                          enum ref_quantity quantity, double bound)
{
    const char *text = csv_text(csv, column);
    mpfr_srcptr value = ref_value(ref, quantity);
    mpfr_t want, error;
    if (*text == '\0')
        return;
    mpfr_inits2(ref->bits, want, error, (mpfr_ptr)0);
    mpfr_set_str(want, text, 10, MPFR_RNDN);
    mpfr_sub(error, value, want, MPFR_RNDN);
    if (!mpfr_zero_p(want))
        mpfr_div(error, error, want, MPFR_RNDN);
    double e = fabs(mpfr_get_d(error, MPFR_RNDN));
    mpfr_clears(want, error, (mpfr_ptr)0);
    if (!(e <= bound))
        fail_msg("%s: %s: the reference is %.17g, the table has %s: %.2g > %.2g", csv_text(csv, "name"),
                 column, ref_double(ref, quantity), text, e, bound);
}

TEST(reference_of_points)
{
    static const struct {
        const char *column;
        enum ref_quantity quantity;
        bool paper;
        double bound;
    } known[] = {
        {"theta_c", REF_THETA_C, false, 1e-24},
        {"theta_f", REF_THETA_F, false, 1e-24},
        {"theta_leave", REF_THETA_LEAVE, false, 1e-24},
        {"theta_1", REF_THETA_1, false, 1e-24},
        {"dtheta_1", REF_SLOPE, false, 1e-24},
        {"J0", REF_J0, false, 1e-24},
        {"J", REF_J, false, 1e-24},
        {"dH", REF_DH, false, 1e-24},
        {"fuel_paper", REF_FUEL_PAPER, false, 1e-24},
        {"fuel_exact", REF_FUEL_EXACT, false, 1e-24},
        {"omega0sq_paper", REF_LAUNCH_OMEGASQ, true, 1e-24},
        {"omega0sq_exact", REF_LAUNCH_OMEGASQ, false, 1e-24},
        {"theta_m", REF_THETA_M, false, 1e-24},
        {"barrier", REF_BARRIER, false, 1e-24},
        {"omegasq_paper", REF_OMEGASQ, true, 1e-24},
        {"omegasq_exact", REF_OMEGASQ, false, 1e-24},
        {"duration_paper", REF_DURATION, true, 1e-13},
        {"duration_exact", REF_DURATION, false, 1e-13},
    };
    int rows = 0;
    struct csv *csv = csv_open("tests/reference/points.csv");
    for (; csv_next(csv); rows++) {
        struct ref_input input = {csv_real(csv, "s"), csv_real(csv, "r"),     csv_real(csv, "d"),
                                  csv_real(csv, "q"), csv_real(csv, "theta"), false};
        struct ref *exact = ref_open_for(&input, 90), *paper;
        input.paper = true;
        paper = ref_open_for(&input, 90);
        for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
            struct ref *ref = known[k].paper ? paper : exact;
            bool fuel = !isnan(ref_double(ref, REF_KINETIC));
            /* Without fuel the table still has the value of the formula, but the reference has none, since
             * there is no cycle. */
            if (fuel || !isnan(ref_double(ref, known[k].quantity)))
                assert_digits(csv, known[k].column, ref, known[k].quantity, known[k].bound);
        }
        ref_close(exact);
        ref_close(paper);
    }
    assert_int_equal(rows, 16);
}

enum { GROWTHS = 60 };

struct known_growth {
    struct ref_input input;
    bool pair, by_reach;
    long double r_max;
};

/* Checks a growth to 18 digits, except that the table has 1/s rounded to a double. */
static long check_growth(int number, void *context)
{
    const struct known_growth *known = (const struct known_growth *)context + number;
    const struct growth found = growth_find(&known->input, known->pair, 64);
    const long double error = fabsl((long double)found.r_max / known->r_max - 1);
    if (found.grows && found.by_reach == known->by_reach && error <= (found.by_reach ? 1e-16L : 5e-18L))
        return 0;
    fprintf(stderr, "# s = %g, q = %g: the reference has r_max = %.20Lg%s, the table %.20Lg%s\n",
            (double)known->input.s, (double)known->input.q, (long double)found.r_max,
            found.by_reach ? " by reach" : "", known->r_max, known->by_reach ? " by reach" : "");
    return 1;
}

TEST(reference_of_growth)
{
    if (sweep_size() < 1)
        skip(); /* a shortened run of the tests relies on the reference */
    static const char *const tables[] = {"tests/reference/rmax.csv", "tests/reference/pair.csv"};
    static struct known_growth known[GROWTHS];
    int rows = 0;
    for (int pair = 0; pair < 2; pair++) {
        struct csv *csv = csv_open(tables[pair]);
        for (; csv_next(csv) && rows < GROWTHS; rows++) {
            struct ref_input input = {
                .s = csv_real(csv, "s"), .q = csv_real(csv, "q"), .d = (domq_real)(7.0 / 48)};
            if (!pair) {
                input.d = csv_real(csv, "d");
                input.paper = strcmp(csv_text(csv, "fuel"), "paper") == 0;
            }
            known[rows] = (struct known_growth){input, pair, strcmp(csv_text(csv, "ends_by"), "reach") == 0,
                                                strtold(csv_text(csv, "r_max"), NULL)};
        }
    }
    assert_int_equal(rows, GROWTHS);
    none_fails(workers_run(GROWTHS, check_growth, known));
}

/* ---- Cases ---- */

/* Returns the input of a case. The tilt is computed with the library's theta_c. */
static struct ref_input input_of(const struct hard_case *c, enum dom_precision precision)
{
    struct ref_input input = {(domq_real)c->s, (domq_real)c->r, (domq_real)c->d, (domq_real)c->q, 0,
                              c->paper};
    if (c->r == 1 / c->s) /* 1/s, rounded to this precision */
        input.r = precision == DOM_QUAD ? 1 / input.s : (domq_real)c->r;
    if (c->tilt >= 0) {
        input.tilt = (domq_real)c->tilt;
    } else {
        struct answers answers;
        library_nothing(&answers);
        struct asked train = library_train(&input, precision);
        library_ask(&train, 0, REF_THETA_C, &answers);
        input.tilt = -(domq_real)c->tilt * answers.value[REF_THETA_C];
        if (precision == DOM_DOUBLE)
            input.tilt = (domq_real)(double)input.tilt;
    }
    return input;
}

/* The error of an answer, and the scale of such errors (reference.h). */
struct verdict {
    double want, scale, error;
};

static struct verdict judge(const struct hard_case *c, struct ref *ref, enum ref_quantity quantity,
                            domq_real got)
{
    struct verdict v = {.want = ref_double(ref, quantity), .error = ref_error(ref, quantity, got)};
    /* The scale of a lengthy train would take minutes, so errors are compared with |F| alone. */
    v.scale = c->lengthy ? fabs(v.want) : ref_scale(ref, quantity);
    return v;
}

static struct verdict judge_any(const struct hard_case *c, const struct ref_input *input, struct ref *ref,
                                enum ref_quantity quantity, int digits2, domq_real got)
{
    if (quantity == REF_R_MAX || quantity == REF_PAIR) {
        struct growth found = growth_find(input, quantity == REF_PAIR, digits2);
        return (struct verdict){(double)found.r_max, found.scale, fabs((double)(got - found.r_max))};
    }
    if (quantity != REF_STOP)
        return judge(c, ref, quantity, got);
    struct ref_input at = *input;
    at.tilt = got; /* the number of bits depends on the tilt */
    ref = ref_open_for(&at, digits2);
    struct verdict v = judge(c, ref, quantity, got);
    ref_close(ref);
    return v;
}

/* Returns the number of checks that fail. */
static long check_case(int number, void *context)
{
    const struct hard_case *c = &hard_cases[number];
    const enum dom_precision precision = *(const enum dom_precision *)context;
    /* In a shortened run, quad takes only every fourth case, since its source is the same as that of
     * double. */
    const bool part = sweep_size() < 1 && number % 4 != 0;
    if ((c->lengthy || part) && precision != DOM_DOUBLE)
        return 0;
    const struct ref_input input = input_of(c, precision);
    const struct asked train = library_train(&input, precision);
    const int digits2 = precision == DOM_QUAD ? 120 : 60;
    struct ref *ref = ref_open_for(&input, digits2);
    struct answers answers;
    long failures = 0;
    library_nothing(&answers);
    for (int k = 0; k < CASE_CHECKS && c->check[k] != REF_COUNT; k++) {
        const enum ref_quantity quantity = c->check[k];
        library_ask(&train, input.tilt, quantity, &answers);
        const domq_real got = answers.value[quantity];
        const struct verdict v = judge_any(c, &input, ref, quantity, digits2, got);
        const double unit = v.scale * library_unit(precision), allowed = c->units > 0 ? c->units : 16;
        if (v.error <= allowed * unit)
            continue;
        failures++;
        fprintf(stderr, "# %s (%s), %s, %s: got %.17g, wanted %.17g: %.3g units of %.3g allowed\n", c->name,
                c->trap, domq_arithmetic(precision)->name, ref_name(quantity), (double)got, v.want,
                v.error / unit, allowed);
    }
    ref_close(ref);
    return failures;
}

static void check_cases(enum dom_precision precision)
{
    none_fails(workers_run(hard_cases_number, check_case, &precision));
}

TEST(hard_cases_in_double)
{
    assert_true(hard_cases_number >= 60);
    check_cases(DOM_DOUBLE);
}

TEST(hard_cases_in_quad)
{
    if (domq_arithmetic(DOM_QUAD)->bits == 0)
        skip();
    check_cases(DOM_QUAD);
}

/* Checks that a kinetic energy of 1e-12 next to a fuel of 1 has a duration, even in float. */
TEST(a_slow_cycle_in_float_has_a_duration)
{
    const struct ref_input input = {(domq_real)0x1.7656b2p-15f,
                                    (domq_real)0x1.5e2492p+14f,
                                    (domq_real)0x1.e54866p-23f,
                                    (domq_real)0x1.c0a998p-1f,
                                    0,
                                    false};
    struct asked train = library_train(&input, DOM_FLOAT);
    struct answers answers;
    library_nothing(&answers);
    library_ask(&train, 0, REF_DURATION, &answers);
    struct ref *ref = ref_open_for(&input, 44);
    const double want = ref_double(ref, REF_DURATION);
    const double units = ref_error(ref, REF_DURATION, answers.value[REF_DURATION]) /
                         (ref_scale(ref, REF_DURATION) * library_unit(DOM_FLOAT));
    ref_close(ref);
    if (answers.status[REF_DURATION] != DOM_OK || !(units <= 16))
        fail_msg("%s: %.9g, wanted %.9g", dom_status_text(answers.status[REF_DURATION]),
                 (double)answers.value[REF_DURATION], want);
}
