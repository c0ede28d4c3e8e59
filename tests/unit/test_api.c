/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The public API of trains: what the shell's functions for any precision (any.h) return is bit by bit what
 * the library returns in that precision. NULL means the defaults. test_refusals.c checks errors.
 */
#include "domino_float.h"
#include "support.h"
#include <float.h>

/* Trains that keep falling, that stop, that have no fuel, that are at the reach, and that have friction: s,
 * r, d, q, mu. */
static const double trains[][5] = {{0.4, 1.5, 0.15, 4, 0},  {0.5, 1.9, 0.15, 3, 0}, {0.3, 2.5, 0.15, 4, 0},
                                   {0.3, 1.1, 1.5, 3, 0},   {0.5, 2, 0.1, 3, 0},    {0.9, 1, 0.02, 5, 0},
                                   {0.4, 1.3, 0.15, 4, 0.2}};
enum { TRAINS = sizeof trains / sizeof *trains };

static double tol_of(enum precision precision)
{
    return precision == IN_FLOAT ? 1e-5 : 1e-11;
}

static struct domq_train wide_train(const double p[5])
{
    struct domq_train train = domq_train_default();
    train.s = p[0];
    train.r = p[1];
    train.d = p[2];
    train.q = p[3];
    train.mu = p[4];
    return train;
}

static struct any_compute wide_compute(enum precision precision)
{
    struct any_compute compute = any_compute_default();
    compute.precision = precision;
    compute.tol = tol_of(precision);
    return compute;
}

static void same(const char *what, domq_real wide, domq_real own)
{
    if (wide != own && !(wide != wide && own != own))
        fail_msg("%s: %.17g, but the library has %.17g", what, (double)wide, (double)own);
}

#define NUMBER(member) same(#member, wide.member, own.member);
#define OTHER(member)  assert_true(wide.member == own.member);
#define NONE(...)

/* Defines P_train and P_compute, which make a train and its settings for the functions with the prefix P. */
#define TRAIN(P)                                                                                             \
    static struct P##_train P##_train_of(const double p[5])                                                  \
    {                                                                                                        \
        struct P##_train train = P##_train_default();                                                        \
        train.s = (P##_real)p[0];                                                                            \
        train.r = (P##_real)p[1];                                                                            \
        train.d = (P##_real)p[2];                                                                            \
        train.q = (P##_real)p[3];                                                                            \
        train.mu = (P##_real)p[4];                                                                           \
        return train;                                                                                        \
    }                                                                                                        \
    static struct P##_compute P##_compute_of(enum precision precision)                                       \
    {                                                                                                        \
        struct P##_compute compute = P##_compute_default();                                                  \
        compute.tol = (P##_real)tol_of(precision);                                                           \
        return compute;                                                                                      \
    }
TRAIN(domf)
TRAIN(dom)
TRAIN(domq)

/* Asks the library, and the shell's function, and compares all members of the answers. */
#define SAME(P, find, structure, ...)                                                                        \
    do {                                                                                                     \
        struct P##_##structure own;                                                                          \
        struct domq_##structure wide;                                                                        \
        memset(&own, 0xff, sizeof own);                                                                      \
        memset(&wide, 0xff, sizeof wide);                                                                    \
        const enum dom_status status = P##_##find(&t, how, __VA_ARGS__ & own);                               \
        assert_status(any_##find(&train, &compute, __VA_ARGS__ &wide), status);                              \
        if (status == DOM_OK || status == DOM_STOPS) {                                                       \
            DOM_MEMBERS_##structure(NUMBER, NONE, NONE, OTHER)                                               \
        }                                                                                                    \
    } while (0);
#define SAME_NUMBER(P, find, ...)                                                                            \
    do {                                                                                                     \
        P##_real own = (P##_real)NAN;                                                                        \
        domq_real wide = (domq_real)NAN;                                                                     \
        const enum dom_status status = P##_##find(&t, how, __VA_ARGS__ & own);                               \
        assert_status(any_##find(&train, &compute, __VA_ARGS__ &wide), status);                              \
        same(#find, wide, own);                                                                              \
    } while (0);

/* ---- Questions ---- */

#define QUESTIONS(P)                                                                                         \
    static void P##_questions(const double p[5], enum precision precision, bool by_default)                  \
    {                                                                                                        \
        const struct P##_train t = P##_train_of(p);                                                          \
        const struct P##_compute c = P##_compute_of(precision), *how = by_default ? NULL : &c;               \
        const struct domq_train train = wide_train(p);                                                       \
        const struct any_compute compute = by_default ? any_compute_default() : wide_compute(precision);     \
        DOM_FINDS_AT(P##_AT)                                                                                 \
        DOM_NUMBERS(P##_NUMBER)                                                                              \
        DOM_NUMBERS_AT(P##_NUMBER_AT)                                                                        \
        if (precision != IN_QUAD || p[4] == 0) {                                                             \
            DOM_FINDS(P##_FIND)                                                                              \
        }                                                                                                    \
    }
#define domf_FIND(find, structure) SAME(domf, find, structure, )
#define domf_AT(find, structure)   SAME(domf, find, structure, 0.25F, )
#define domf_NUMBER(find)          SAME_NUMBER(domf, find, )
#define domf_NUMBER_AT(find)       SAME_NUMBER(domf, find, 0.25F, )
#define dom_FIND(find, structure)  SAME(dom, find, structure, )
#define dom_AT(find, structure)    SAME(dom, find, structure, 0.25, )
#define dom_NUMBER(find)           SAME_NUMBER(dom, find, )
#define dom_NUMBER_AT(find)        SAME_NUMBER(dom, find, 0.25, )
#define domq_FIND(find, structure) SAME(domq, find, structure, )
#define domq_AT(find, structure)   SAME(domq, find, structure, 0.25, )
#define domq_NUMBER(find)          SAME_NUMBER(domq, find, )
#define domq_NUMBER_AT(find)       SAME_NUMBER(domq, find, 0.25, )
QUESTIONS(domf)
QUESTIONS(dom)
QUESTIONS(domq)

TEST(any_precision_asks_the_library)
{
    for (int i = 0; i < TRAINS; i++) {
        domf_questions(trains[i], IN_FLOAT, false);
        dom_questions(trains[i], IN_DOUBLE, false);
        if (any_arithmetic(IN_QUAD).bits > 0) {
            domq_questions(trains[i], IN_QUAD, false);
        }
    }
}

/* Checks that each precision agrees with quad to its tolerance, and has digits of its own. */
TEST(precisions_differ_by_their_tolerance)
{
    const struct domq_train train = wide_train(trains[0]);
    domq_real r_max[3];
    for (enum precision p = IN_FLOAT; p <= IN_QUAD; p++) {
        struct any_compute compute = wide_compute(p);
        struct domq_limit limit = {0};
        compute.tol = any_arithmetic(p).tol_default;
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
    assert_true(compute.tol == 1e-12);
    assert_true(!compute.work && !compute.interrupt);
    assert_true(any_compute_default().tol == 1 / (domq_real)1e12 &&
                any_compute_default().precision == IN_DOUBLE);
    dom_questions(trains[0], IN_DOUBLE, true);
}
