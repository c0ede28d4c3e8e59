/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The methods that keep passes short and few: series for the far tail, and a shortcut if H has a single
 * maximum. 'make guard' has the costs. */
#include "request.h"
#include "support.h"

enum { TRAINS = 400 };

static const struct tilt upright = {0, 1, 0};

/* Returns a random endless train, and a tilt of its head before theta_c. The radius of its edges is `rho`
 * times the largest possible one. */
static struct geometry random_geometry(uint64_t *seed, double tol, double rho, struct tilt *head)
{
    struct setup train = random_train(seed);
    struct geometry geometry;
    train.rho = rho * fmin((double)train.d / 2, 0.49);
    train.s = fmin((double)train.s, (1 - (double)train.rho / 2) / (double)train.r);
    train.tol = tol;
    assert_status(geometry_of(&train, &geometry), DOM_OK);
    *head = tilt_half(half_of_tilt(geometry.c) * random_unit(seed));
    return geometry;
}

/* Checks that two sums agree, relative to the sum of the absolute values of their terms, which decides where
 * a pass ends. */
static void assert_same(const char *what, const struct geometry *geometry, double a, double b, double scale,
                        double bound)
{
    if (!(fabs(a - b) <= bound * scale))
        fail_msg("s %.17g r %.17g d %.17g q %.17g: %s %.17g and %.17g, %.2g of %.2g", geometry->s,
                 geometry->r, geometry->d, geometry->q, what, a, b, fabs(a - b) / scale, scale);
}

/* Checks that the sums with the series for the far tail, of every order, agree with the sums over the whole
 * train, to their tolerance. The end of a pass does not depend on the tail of H2. */
TEST(the_far_tail_is_the_train)
{
    uint64_t seed = 31;
    int shorter = 0, orders = 0;
    for (int i = 0; i < 3 * TRAINS; i++) {
        const double tol = i % 3 == 0 ? 1e-15 : i % 3 == 1 ? 1e-12 : 1e-6;
        struct tilt head;
        struct geometry geometry = random_geometry(&seed, tol, 0, &head), fine = geometry;
        struct sums closed, whole = {0};
        fine.tol = 1e-15;
        fine.far.order = 0;
        far_make(&geometry, (int)random_log(&seed, 1, 100));
        orders |= 1 << geometry.far.order;
        assert_status(chain_change(&geometry, upright, head, PASS_SECOND_DERIVATIVE, &closed), DOM_OK);
        assert_status(chain_change(&fine, upright, head, PASS_SECOND_DERIVATIVE, &whole), DOM_OK);
        /* dH and H1 may cancel. In that case a pass is only correct to the rounding errors of its terms. */
        const double noise = 64 * REAL_EPSILON * geometry.steepest / tol;
        assert_same("dH", &geometry, closed.dH, whole.dH, fabs(whole.dH) + noise, 2 * tol);
        assert_same("H1", &geometry, closed.H1, whole.H1, fabs(whole.H1) + noise, 2 * tol);
        assert_same("H2", &geometry, closed.H2, whole.H2, fabs(whole.H2) + noise, 1000 * tol + 1e-10);
        assert_same("J", &geometry, closed.J, whole.J, whole.J, 2 * tol + 1e-14);
        shorter += closed.n < whole.n * 2 / 3;
    }
    print_message("# passes shorter by a third: %d of %d; orders: 0x%x\n", shorter, 3 * TRAINS,
                  (unsigned)orders);
    assert_true(shorter > TRAINS / 4);
    assert_true((orders & 1 << FAR_FIRST) && (orders & 1 << FAR_ORDER) && (orders & 1));
}

/* Checks trains for which barrier_single says that H has a single maximum: H must be concave from 0 to the
 * smaller of theta_u and theta_c. Checks that no barrier is higher than the barrier of a single domino. */
TEST(one_top_if_concave)
{
    uint64_t seed = 34;
    int single = 0;
    for (int i = 0; i < 10 * TRAINS; i++) {
        struct tilt head;
        struct geometry geometry = random_geometry(&seed, 1e-12, i % 8 < 4 ? 0 : random_unit(&seed), &head);
        struct barrier b;
        if (i % 4 == 0)
            geometry.n = 2;
        assert_status(barrier_search(&geometry, false, TOP_TOL(&geometry), &b), DOM_OK);
        assert_true(b.height <= barrier_most(&geometry) * (1 + 1e-14));
        if (!barrier_single(&geometry))
            continue;
        single++;
        const double highest = fmin(geometry_half_u(&geometry), half_of_tilt(geometry.c));
        for (int k = 0; k <= 16; k++) {
            struct sums at;
            assert_status(
                chain_change(&geometry, upright, tilt_half(highest * k / 16), PASS_SECOND_DERIVATIVE, &at),
                DOM_OK);
            if (!(at.H2 < 0))
                fail_msg("s %.17g r %.17g d %.17g q %.17g: H2 = %g at %d/16", geometry.s, geometry.r,
                         geometry.d, geometry.q, at.H2, k);
        }
    }
    print_message("# one top for sure: %d of %d\n", single, 10 * TRAINS);
    assert_true(single > TRAINS);
}
