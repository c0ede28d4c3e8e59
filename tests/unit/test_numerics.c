/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each solver is tried on a list of problems, some of them difficult. */
#include "precision/double.c"
#include "support.h"
#include <float.h>

static double cubic(double x, void *c)
{
    (void)c;
    return x * x * x - 2;
}

static double flat(double x, void *c)
{
    (void)c;
    return pow(x - 1, 9);
}

static double jump(double x, void *c)
{
    (void)c;
    return x < 1.0 / 3 ? -1 : 1e-300;
}

static double tiny(double x, void *c)
{
    (void)c;
    return x - 1e-17;
}

static double root_of_sine(double x, void *c)
{
    (void)c;
    return sin(x);
}

TEST(roots)
{
    static const struct {
        num_function *f;
        double lo, hi, x, bound;
    } problems[] = {
        {cubic, 0, 10, 1.2599210498948732, 1e-15},
        {cubic, -1e6, 1e6, 1.2599210498948732, 1e-15},
        {flat, -3, 8, 1, 1e-15},
        {jump, 0, 1, 1.0 / 3, 1e-15},
        {tiny, 0, 1, 1e-17, 1e-15},
        {root_of_sine, 3, 4, 3.141592653589793, 1e-15},
        {cubic, 1.2599210498948732, 2, 1.2599210498948732, 1e-15},
    };
    for (size_t i = 0; i < sizeof problems / sizeof *problems; i++) {
        double x = DOMQ_NAN;
        assert_int_equal(num_root(problems[i].f, NULL, problems[i].lo, problems[i].hi, 0, &x), NUM_OK);
        if (problems[i].f != flat) /* a ninefold root, near which the values underflow */
            assert_near("root", x, problems[i].x, problems[i].bound);
        else
            assert_near("flat root", x, 1, 1e-12);
    }
}

static double nan_inside(double x, void *c)
{
    (void)c;
    return x > 0.3 && x < 0.7 ? DOMQ_NAN : x - 0.5;
}

TEST(failures_are_reported)
{
    double x = -7;
    assert_int_equal(num_root(cubic, NULL, 2, 3, 0, &x), NUM_NOT_BRACKETED);
    assert_int_equal(num_root(nan_inside, NULL, 0, 1, 0, &x), NUM_NOT_FINITE);
    assert_near("untouched", x, -7, 0);
}

/* ---- Linear equations whose G and v are known in closed form ---- */

struct linear {
    double a; /* distance of the singularity from the real axis */
    int kind;
    size_t calls;
};

static double square(double x)
{
    return x * x;
}

static double linear_G(const struct linear *l, double x)
{
    return l->kind == 0 ? 1 / (1 + x * x) : l->kind == 1 ? sqrt((x + l->a) / l->a) : exp(-x);
}

static double linear_v(const struct linear *l, double x)
{
    return l->kind == 0   ? sin(3 * x) / 3
           : l->kind == 1 ? log1p(x / l->a)
                          : (atan((x - 0.3) / l->a) + atan(0.3 / l->a)) / l->a;
}

static bool linear_rate(double x, void *context, struct num_rate *rate)
{
    struct linear *l = context;
    l->calls++;
    rate->p = l->kind == 0 ? -2 * x / (1 + x * x) : l->kind == 1 ? 0.5 / (x + l->a) : -1;
    double slope = l->kind == 0   ? cos(3 * x)
                   : l->kind == 1 ? 1 / (x + l->a)
                                  : 1 / (l->a * l->a + square(x - 0.3));
    rate->c = slope * linear_G(l, x);
    return true;
}

static const struct linear linears[] = {
    {1, 0, 0}, {1e-2, 1, 0}, {1e-6, 1, 0}, {1e-10, 1, 0}, {1e-1, 2, 0}, {1e-2, 2, 0}, {1e-3, 2, 0},
};

TEST(linear_everywhere)
{
    static struct num_linear solution;
    for (size_t i = 0; i < sizeof linears / sizeof *linears; i++) {
        struct linear l = linears[i];
        solution.panels = 0;
        /* Solve in two parts, as for a function with a kink at 0.4. */
        assert_int_equal(num_linear_solve(linear_rate, &l, 0, 0.4, 1e-13, &solution), NUM_OK);
        assert_int_equal(num_linear_solve(linear_rate, &l, 0.4, 1, 1e-13, &solution), NUM_OK);
        double most = linear_v(&l, 1);
        for (double x = 1e-12; x <= 1; x = x < 1e-3 ? 3 * x : x + 0.0101) {
            double ln_G, v;
            num_linear_at(&solution, x, &ln_G, &v);
            /* The error of v is relative to the range of v. */
            assert_true(fabs(ln_G - log(linear_G(&l, x))) < 1e-12);
            if (!(fabs(v - linear_v(&l, x)) <= 2e-12 * fabs(most)))
                fail_msg("problem %zu: v(%g) = %.17g, expected %.17g", i, x, v, linear_v(&l, x));
        }
    }
}

static bool linear_nan(double x, void *context, struct num_rate *rate)
{
    (void)context;
    rate->p = rate->c = x > 0.5 ? DOMQ_NAN : 1;
    return true;
}

/* A function with a jump, which uses up all panels. */
static bool linear_jump(double x, void *context, struct num_rate *rate)
{
    (void)context;
    rate->p = 0;
    rate->c = x > 1.0 / 3 ? 1 : 2;
    return true;
}

TEST(linear_failures)
{
    static struct num_linear solution;
    solution.panels = 0;
    assert_int_equal(num_linear_solve(linear_nan, NULL, 0, 1, 1e-12, &solution), NUM_NOT_FINITE);
    solution.panels = 0;
    double ln_G, v;
    enum num_status status = num_linear_solve(linear_jump, NULL, 0, 1, 1e-12, &solution);
    /* The result must be right or an error, but never a wrong number. */
    if (status == NUM_OK) {
        num_linear_at(&solution, 1, &ln_G, &v);
        assert_near("across a jump", v, 2.0 / 3 + 2.0 / 3, 1e-9);
    } else
        assert_int_equal(status, NUM_NOT_CONVERGED);
}
