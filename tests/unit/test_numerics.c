/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The solvers against one list of problems, the nasty ones included. */
#include "precision/kernel.inc"
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

static void roots(void **state)
{
    (void)state;
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
        double x = DOM_NAN;
        assert_int_equal(num_root(problems[i].f, NULL, problems[i].lo, problems[i].hi, 0, &x), NUM_OK);
        if (problems[i].f != flat) /* nine-fold: the values underflow around it */
            assert_near("root", x, problems[i].x, problems[i].bound);
        else
            assert_near("flat root", x, 1, 1e-12);
    }
}

static double nan_inside(double x, void *c)
{
    (void)c;
    return x > 0.3 && x < 0.7 ? DOM_NAN : x - 0.5;
}

static void failures_are_reported(void **state)
{
    (void)state;
    double x = -7;
    assert_int_equal(num_root(cubic, NULL, 2, 3, 0, &x), NUM_NOT_BRACKETED);
    assert_int_equal(num_root(nan_inside, NULL, 0, 1, 0, &x), NUM_NOT_FINITE);
    assert_int_equal(num_maximum(root_of_sine, NULL, 0, 0.5, 1, 0, &x), NUM_NOT_BRACKETED);
    assert_int_equal(num_maximum(nan_inside, NULL, 0, 0.75, 0.8, 0, &x), NUM_NOT_BRACKETED);
    assert_int_equal(num_integral(nan_inside, NULL, 0, 1, 1e-10, &x, NULL), NUM_NOT_FINITE);
    assert_near("untouched", x, -7, 0);
}

static double parabola(double x, void *c)
{
    (void)c;
    return -(x - 0.44) * (x - 0.44) + 2;
}

static double kink(double x, void *c)
{
    (void)c;
    return x < 0.7 ? x : 1.4 - x;
}

static void maxima(void **state)
{
    (void)state;
    double x = DOM_NAN;
    assert_int_equal(num_maximum(parabola, NULL, 0.39, 0.43, 0.48, 1e-12, &x), NUM_OK);
    assert_near("smooth top", x, 0.44, 1e-7);
    assert_int_equal(num_maximum(kink, NULL, 0, 0.6, 1.3, 1e-14, &x), NUM_OK);
    assert_near("kink", x, 0.7, 1e-13);
}

static double near_stop(double x, void *c)
{
    double margin = *(const double *)c;
    return 1 / sqrt(margin + x * x);
}

/* The peak of a train that nearly stops: the integral over [0, 1] is asinh(1 / sqrt(margin)). */
static void integrals(void **state)
{
    (void)state;
    for (double margin = 1; margin > 1e-25; margin /= 100) {
        double integral = DOM_NAN;
        assert_int_equal(num_integral(near_stop, &margin, 0, 1, 1e-13, &integral, NULL), NUM_OK);
        assert_near("integral", integral, asinh(1 / sqrt(margin)), 1e-13);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(roots),
        cmocka_unit_test(failures_are_reported),
        cmocka_unit_test(maxima),
        cmocka_unit_test(integrals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
