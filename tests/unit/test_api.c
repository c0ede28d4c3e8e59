/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The public API of trains: what the shell's functions for any precision (any.h) return is bit by bit what
 * the library returns. The functions for float and double are made from one text, so float is enough here.
 * NULL means the defaults. test_refusals.c checks errors.
 */
#include "domino_float.h"
#include "support.h"

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
            DOM_MEMBERS_##structure(NUMBER, NONE, NONE, OTHER)                                               \
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

/* Checks that each precision agrees with quad to its tolerance, and has digits of its own. */
TEST(precisions_differ_by_their_tolerance)
{
    const struct domq_train train = domq_train_default();
    domq_real r_max[3];
    for (enum precision p = IN_FLOAT; p <= IN_QUAD; p++) {
        struct any_compute compute = {.precision = p, .tol = any_arithmetic(p).tol_default};
        struct domq_limit limit = {0};
        if (any_arithmetic(p).bits == 0)
            return;
        assert_status(any_limit_rmax(&train, &compute, &limit), DOM_OK);
        r_max[p] = limit.r_max;
    }
    assert_near("float", (double)r_max[IN_FLOAT], (double)r_max[IN_QUAD], 1e-5);
    assert_near("double", (double)(r_max[IN_DOUBLE] - r_max[IN_QUAD]) + 1, 1, 1e-12);
    assert_true(r_max[IN_FLOAT] != r_max[IN_DOUBLE] && r_max[IN_DOUBLE] != r_max[IN_QUAD]);
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
