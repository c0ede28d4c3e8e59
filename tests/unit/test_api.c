/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The public API of trains, rows, scales and effects: what the shell's functions for any precision (any.h)
 * return is bit by bit what the library returns. The functions for float and double are made from one text,
 * so float is enough here. NULL means the defaults. test_refusals.c checks errors.
 */
#include "domino_float.h"
#include "support.h"
#include <float.h>

/* The largest allowed relative difference of numbers in both headers. */
static const double rounding = DBL_EPSILON;

#define BOTH(member) assert_in_both(#member, d.member, q.member, rounding)

/* Trains that keep falling, that stop, that have no fuel, that are at the reach, and that have friction: s,
 * r, d, q, mu. */
static const float trains[][5] = {{0.4F, 1.5F, 0.15F, 4, 0},   {0.5F, 1.9F, 0.15F, 3, 0},
                                  {0.3F, 2.5F, 0.15F, 4, 0},   {0.3F, 1.1F, 1.5F, 3, 0},
                                  {0.5F, 2, 0.1F, 3, 0},       {0.9F, 1, 0.02F, 5, 0},
                                  {0.4F, 1.3F, 0.15F, 4, 0.2F}};

static void same(const char *what, domq_real wide, domq_real own)
{
    if (wide != own && !(wide != wide && own != own))
        fail_msg("%s: %.17g, but the library has %.17g", what, (double)wide, (double)own);
}

#define NUMBER(member) same(#member, wide.member, own.member);
#define OTHER(member)  assert_true(wide.member == own.member);
#define NONE(...)

/* Asks the library, and the shell's function, and compares all members of the answers. */
#define SAME(find, structure, ...)                                                                           \
    do {                                                                                                     \
        struct domf_##structure own;                                                                         \
        struct domq_##structure wide;                                                                        \
        memset(&own, 0xff, sizeof own);                                                                      \
        memset(&wide, 0xff, sizeof wide);                                                                    \
        const enum dom_status status = domf_##find(&t, &c, __VA_ARGS__ & own);                               \
        assert_status(any_##find(&train, &compute, __VA_ARGS__ &wide), status);                              \
        if (status == DOM_OK || status == DOM_STOPS) {                                                       \
            DOM_MEMBERS_##structure(NUMBER, NONE, OTHER)                                                     \
        }                                                                                                    \
    } while (0);
#define SAME_NUMBER(find, ...)                                                                               \
    do {                                                                                                     \
        float own = NAN;                                                                                     \
        domq_real wide = (domq_real)NAN;                                                                     \
        const enum dom_status status = domf_##find(&t, &c, __VA_ARGS__ & own);                               \
        assert_status(any_##find(&train, &compute, __VA_ARGS__ &wide), status);                              \
        same(#find, wide, own);                                                                              \
    } while (0);
#define FIND(find, structure) SAME(find, structure, )
#define AT(find, structure)   SAME(find, structure, 0.25F, )
#define FIND_NUMBER(find)     SAME_NUMBER(find, )
#define AT_NUMBER(find)       SAME_NUMBER(find, 0.25F, )

TEST(any_precision_asks_the_library)
{
    for (size_t i = 0; i < sizeof trains / sizeof *trains; i++) {
        const float *p = trains[i];
        struct domf_train t = domf_train_default();
        struct domq_train train = domq_train_default();
        struct domf_compute c = domf_compute_default();
        struct any_compute compute = any_compute_default();
        train.s = t.s = p[0];
        train.r = t.r = p[1];
        train.d = t.d = p[2];
        train.q = t.q = p[3];
        train.mu = t.mu = p[4];
        compute.precision = IN_FLOAT;
        compute.tol = c.tol = 2e-5F;
        DOM_FINDS(FIND)
        DOM_FINDS_AT(AT)
        DOM_NUMBERS(FIND_NUMBER)
        DOM_NUMBERS_AT(AT_NUMBER)
    }
}

TEST(null_is_the_default)
{
    const struct dom_compute compute = dom_compute_default();
    const struct any_compute any = any_compute_default();
    const struct dom_train train = dom_train_default();
    double given, none;
    assert_true(compute.tol == 1e-12 && !compute.work && !compute.interrupt);
    assert_true(any.tol == 1 / (domq_real)1e12 && any.precision == IN_DOUBLE);
    assert_status(dom_cycle_duration(&train, &compute, &given), DOM_OK);
    assert_status(dom_cycle_duration(&train, NULL, &none), DOM_OK);
    assert_true(given == none);
}

/* ---- Rows: what the shell's functions for any precision return is what the library returns ---- */

enum { ROW = 6 };

enum { KEPT = 400 };

/* What a visitor has seen. */
struct seen {
    domq_real number[KEPT];
    int count;
};

#define KEEP(member) seen->number[seen->count++] = from->member;

static bool domf_fall_seen(const struct domf_fall *from, void *context)
{
    struct seen *seen = context;
    DOM_MEMBERS_fall(KEEP, NONE, KEEP) return true;
}

static bool domq_fall_seen(const struct domq_fall *from, void *context)
{
    struct seen *seen = context;
    DOM_MEMBERS_fall(KEEP, NONE, KEEP) return true;
}

/* Runs rows by the library's function for float, and by the shell's in this precision. */
TEST(rows)
{
    static const float some[][3] = {
        {1.1F, NAN, 0}, {1.3F, 5, 0}, {1.9F, NAN, 0}, {1.05F, 8, 0.2F}, {1, 0.5F, 0}};
    const struct domf_compute compute = {.tol = 1e-5F};
    const struct any_compute any = {.tol = compute.tol, .precision = IN_FLOAT};
    const struct domf_scale scale = domf_scale_default();
    for (size_t i = 0; i < 2 * sizeof some / sizeof *some; i++) {
        const float *p = some[i / 2];
        struct domf_domino domino[ROW];
        struct domq_domino wide_domino[ROW];
        struct domf_train train = domf_train_default();
        train.r = p[0];
        domf_row_of_train(&train, &scale, 1, domino, ROW);
        for (int k = 0; k < ROW; k++) {
            domino[k].lean = i % 2 && k % 2 ? (float)k * 0.015625F : 0;
            const struct domf_domino *d = &domino[k];
            wide_domino[k] =
                (struct domq_domino){d->height, d->thickness, d->gap, d->mass, d->radius, d->lean, d->width};
        }
        const struct domf_row row = {.domino = domino, .count = ROW, .g = 9.81F, .push = p[1], .mu = p[2]};
        const struct domq_row wide_row = {
            .domino = wide_domino, .count = ROW, .g = row.g, .push = row.push, .mu = row.mu};
        struct seen of_own = {.count = 0}, of_wide = {.count = 0};
        struct domf_verdict own = {0};
        struct domq_verdict wide = {0};
        assert_status(domf_row_run(&row, &compute, true, domf_fall_seen, &of_own, &own), DOM_OK);
        assert_status(any_row_run(&wide_row, &any, true, domq_fall_seen, &of_wide, &wide), DOM_OK);
        DOM_MEMBERS_verdict(NUMBER, NONE, OTHER)
            assert_true(of_own.count > 8 && of_own.count == of_wide.count);
        for (int k = 0; k < of_own.count; k++)
            same("a visitor's number", of_wide.number[k], of_own.number[k]);
    }
}

/* ---- Scales, arithmetic ---- */

TEST(scales_and_precisions)
{
    struct dom_train t = dom_train_default();
    struct dom_scale d = dom_scale_default();
    struct domq_scale q = domq_scale_default();
    BOTH(h), BOTH(g);
    struct domq_train tq = domq_train_default();
    assert_in_both("tau", dom_scale_tau(&d, &t), domq_scale_tau(&q, &tq), rounding);
    t.walls = 0.02, tq.walls = 0.02;
    assert_in_both("tau of a box", dom_scale_tau(&d, &t), domq_scale_tau(&q, &tq), rounding);
    t.walls = tq.walls = 0;
    assert_near("speed", dom_scale_speed(&d, &t, 9), (double)domq_scale_speed(&q, &tq, 9), 4 * DBL_EPSILON);
    const struct domq_arithmetic in_double = any_arithmetic(IN_DOUBLE), in_float = any_arithmetic(IN_FLOAT);
    assert_string_equal(in_double.name, "double");
    assert_string_equal(in_float.name, "float");
    assert_true((double)in_double.tol_default == dom_arithmetic()->tol_default && in_double.bits == 53);
    assert_true((float)in_float.tol_floor == domf_arithmetic()->tol_floor && in_float.bits == 24);
    assert_true(in_double.tol_default == 1 / (domq_real)1e12 && in_float.tol_floor == 1 / (domq_real)1e6);
}

/* ---- Effects ---- */

/* Checks that each effect has its number and its name. */
TEST(effects)
{
#define NAMED(effect)                                                                                        \
    assert_ptr_equal(dom_effect(DOM_EFFECT_##effect), &dom_effect_##effect);                                 \
    assert_ptr_equal(domq_effect(DOM_EFFECT_##effect), &domq_effect_##effect);                               \
    assert_string_equal(dom_effect_##effect.name, #effect);
#define NAMED_DYNAMICS(effect, member, status) NAMED(effect)
    DOM_DYNAMICS(NAMED_DYNAMICS)
    DOM_EFFECTS(NAMED)
}

/* Checks dom_first_effect and dom_dissipates for a train without effects, and with one effect at a time. */
TEST(laws)
{
    struct dom_train t = dom_train_default();
    assert_ptr_equal(dom_first_effect(&t), NULL);
    assert_false(dom_dissipates(&t));
#define LAW(effect, member, status)                                                                          \
    t.member = dom_effect_##effect.argument[0].highest;                                                      \
    assert_ptr_equal(dom_first_effect(&t), dom_effect_##effect.cancels ? NULL : &dom_effect_##effect);       \
    assert_true(dom_dissipates(&t) == (dom_effect_##effect.dissipates != NULL));                             \
    t.member = 0;
    DOM_DYNAMICS(LAW)
}

TEST(simple)
{
    struct dom_train t = dom_train_default();
    struct dom_limit limit;
    t.s = 0.3;
    t.d = 0.2;
    t.q = 3;
    assert_status(dom_limit_rmax(&t, NULL, &limit), DOM_OK);
    assert_true(dom_rmax(0.3, 0.2, 3) == limit.r_max);
    assert_in_both("rmax", limit.r_max, domq_rmax(0.3, t.d, 3), rounding);
    assert_true(isnan(dom_rmax(2, 0.2, 3)) && isnan(dom_rmax(0.3, -1, 3)) && isnan(dom_rmax(0.3, 1.5, NAN)));
    assert_true(isnan(dom_rmax(0.3, 1.5, 3))); /* no growth */
}

/* Checks that a default row needs only its dominoes, and that the library is as new as its header. */
TEST(row_default)
{
    const struct dom_domino domino[] = {{.height = 0.05, .thickness = 0.008, .mass = 0.01},
                                        {.height = 0.05, .thickness = 0.008, .gap = 0.02, .mass = 0.01}};
    struct dom_verdict verdict;
    struct dom_row row = dom_row_default();
    row.domino = domino;
    assert_status(dom_row_run(&row, NULL, false, NULL, NULL, &verdict), DOM_BAD_COUNT);
    row.count = 2;
    assert_status(dom_row_run(&row, NULL, false, NULL, NULL, &verdict), DOM_OK);
    assert_int_equal(verdict.end, DOM_ROW_FALLS);
    assert_true(row.g == dom_scale_default().g && isnan(row.push) && row.mu == 0 && row.rho == 0);
    assert_string_equal(dom_version(), DOM_VERSION);
}
