/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: planning */
/* Designs, checked with the functions for trains and rows, and compared with all separations on a grid. */
#include "support.h"
#include <stddef.h>
#include <string.h>

static struct dom_wish wish_of(double height, double safety, double hall)
{
    return (struct dom_wish){
        .first = 0.048, .height = height, .safety = safety, .hall = hall, .g = 9.81, .push = DOM_NAN};
}

static double train_ratio(const struct dom_train *train, double s, double r)
{
    struct dom_train t = *train;
    struct dom_barrier b;
    t.s = s;
    t.r = r;
    enum dom_status status = dom_barrier_find(&t, NULL, &b);
    return status == DOM_OK || status == DOM_STOPS ? (b.kinetic / b.barrier) : 0;
}

/* The number of the weakest domino after domino 1: the first one with the smallest kinetic / barrier. */
static size_t weakest;

static bool least_seen(const struct dom_fall *fall, void *context)
{
    double *least = context, ratio = (fall->kinetic / fall->barrier);
    if (fall->domino > 1 && ratio < *least) {
        *least = ratio;
        weakest = fall->domino;
    }
    return true;
}

enum { MOST = 200 };

static struct dom_domino domino[MOST];

/* The sums of some trains with friction and rounded edges do not converge to every tolerance, so their rows
 * are run with a rough one. */
static const struct dom_compute rough = {.tol = 1e-7};

/* Returns the smallest kinetic / barrier of the dominoes after the first one, or 0 if not all dominoes
 * fall. */
static double row_least(const struct dom_train *train, const struct dom_wish *w, double s, size_t steps,
                        bool times, struct dom_verdict *v)
{
    struct dom_train t = *train;
    const struct dom_scale scale = {.h = w->first, .g = w->g};
    double least = HUGE_VAL;
    assert_true(steps < MOST);
    t.s = s;
    t.r = pow((w->height / w->first), 1.0 / (double)steps);
    dom_row_of_train(&t, &scale, 1, domino, steps + 1);
    const struct dom_row row = {.domino = domino,
                                .count = steps + 1,
                                .g = w->g,
                                .push = w->push,
                                .mu = t.mu,
                                .alpha = t.alpha,
                                .rho = t.rho};
    assert_status(dom_row_run(&row, t.rho > 0 ? &rough : NULL, times, least_seen, &least, v), DOM_OK);
    return v->end == DOM_ROW_FALLS ? least : 0;
}

/* Checks a design by running the row that it describes. */
static void row_holds(const struct dom_train *train, const struct dom_wish *w, const struct dom_design *d)
{
    struct dom_verdict v;
    double feet = 0, least = row_least(train, w, d->s, d->steps, true, &v);
    assert_int_equal(v.end, DOM_ROW_FALLS);
    assert_true((isinf(least) && isinf(d->row)) || fabs(d->row / least - 1) < 1e-8);
    assert_true(isinf(least) || d->weakest == weakest);
    assert_near("seconds", d->seconds, v.seconds, 1e-8);
    for (size_t k = 0; k <= d->steps; k++)
        feet += (domino[k].gap + domino[k].thickness);
    assert_near("feet", d->feet, feet, 1e-12);
    assert_near("length", d->length, feet + w->height, 1e-12);
    assert_near("height", domino[d->steps].height, w->height, 1e-12);
}

/* Checks with other functions that a design has the requested safety, and that with one domino fewer no
 * separation has this safety. */
TEST(designs_hold)
{
    uint64_t seed = 181;
    int fit = 0, limits[4] = {0};
    for (int i = 0; i < 24; i++) {
        struct dom_train train = dom_train_default();
        struct dom_design d;
        train.q = i % 2 ? 3 : 4;
        train.mu = i % 3 ? 0.6 * random_unit(&seed) : 0;
        train.alpha = i % 5 ? 0 : 0.04 * random_unit(&seed) - 0.02;
        double height = random_log(&seed, 0.06, 20), safety = 1 + random_log(&seed, 0.05, 4);
        struct dom_wish w = wish_of(height, safety, i % 4 ? HUGE_VAL : height * (2 + random_unit(&seed)));
        assert_status(dom_design_find(&train, &w, NULL, NULL, &d, NULL), DOM_OK);
        limits[d.limit]++;
        if (d.limit != DOM_DESIGN_FITS)
            continue;
        fit++;
        row_holds(&train, &w, &d);
        double ratio = train_ratio(&train, d.s, d.r);
        assert_true((isinf(ratio) && isinf(d.train)) || fabs(d.train / ratio - 1) < 1e-9);
        assert_true(d.row >= safety && d.train >= safety);
        assert_true(d.length <= w.hall && fabs(d.s * 1000 - round(d.s * 1000)) < 1e-12);
        double fewer = pow(height / 0.048, 1.0 / (d.steps - 1));
        struct dom_verdict v;
        for (int k = 5; d.steps > 1 && i % 4 && k <= 1000 && k / 1000.0 * fewer <= 1; k += 15)
            assert_true(train_ratio(&train, k / 1000.0, fewer) < safety ||
                        row_least(&train, &w, k / 1000.0, d.steps - 1, false, &v) < safety);
    }
    print_message("# %d fit, %d safety, %d start, %d hall\n", fit, limits[1], limits[2], limits[3]);
    assert_true(fit >= 12 && limits[DOM_DESIGN_HALL] >= 2);
}

TEST(friction_with_edges)
{
    uint64_t seed = 7;
    for (int i = 0; i < 8; i++) {
        struct dom_train train = dom_train_default();
        struct dom_design d;
        struct dom_verdict v;
        train.q = 3 + i % 2;
        train.d = 0.12 + 0.2 * random_unit(&seed);
        train.mu = 0.1 + 0.3 * random_unit(&seed);
        train.rho = 0.003 + 0.03 * random_unit(&seed);
        const struct dom_wish w = wish_of(5, 1.5, HUGE_VAL);
        assert_status(dom_design_find(&train, &w, NULL, NULL, &d, NULL), DOM_OK);
        assert_int_equal(d.limit, DOM_DESIGN_FITS);
        assert_true(d.row >= w.safety && d.train >= w.safety);
        assert_near("row", d.row, row_least(&train, &w, d.s, d.steps, false, &v), 1e-4);
    }
}

/* Checks that `needs` makes an impossible wish possible, and that a slightly smaller number does not. */
TEST(needs_are_enough)
{
    struct dom_train train = dom_train_default();
    struct dom_design d;
    train.q = 3;
    train.mu = 0.3;
    struct dom_wish w = wish_of(8, 2, 15);
    assert_status(dom_design_find(&train, &w, NULL, NULL, &d, NULL), DOM_OK);
    assert_int_equal(d.limit, DOM_DESIGN_HALL);
    double shortest = d.needs;
    w.hall = shortest;
    assert_status(dom_design_find(&train, &w, NULL, NULL, &d, NULL), DOM_OK);
    assert_int_equal(d.limit, DOM_DESIGN_FITS);
    w.hall = shortest * (1 - 1e-9);
    assert_status(dom_design_find(&train, &w, NULL, NULL, &d, NULL), DOM_OK);
    assert_int_equal(d.limit, DOM_DESIGN_HALL);

    w = wish_of(8, 2, HUGE_VAL);
    w.push = 0.5;
    assert_status(dom_design_find(&train, &w, NULL, NULL, &d, NULL), DOM_OK);
    assert_int_equal(d.limit, DOM_DESIGN_START);
    w.push = d.needs;
    assert_status(dom_design_find(&train, &w, NULL, NULL, &d, NULL), DOM_OK);
    assert_int_equal(d.limit, DOM_DESIGN_FITS);

    train.mu = 3;
    w = wish_of(8, 2, HUGE_VAL);
    assert_status(dom_design_find(&train, &w, NULL, NULL, &d, NULL), DOM_OK);
    assert_int_equal(d.limit, DOM_DESIGN_SAFETY);
    double most = 0;
    for (int k = 1; k < 1000; k++)
        most = fmax(most, train_ratio(&train, k / 1000.0, 1));
    assert_near("safety", d.needs, most, 1e-3);
    assert_true(isnan(d.s) && d.steps == 0);
}

/* Returns the shortest row that has a wished safety: it just fits into the shortest possible hall. */
static struct dom_design shortest(const struct dom_train *train, struct dom_wish *w)
{
    struct dom_design d;
    w->hall = w->height * (1 + 1e-9);
    assert_status(dom_design_find(train, w, NULL, NULL, &d, NULL), DOM_OK);
    assert_int_equal(d.limit, DOM_DESIGN_HALL);
    w->hall = d.needs;
    assert_status(dom_design_find(train, w, NULL, NULL, &d, NULL), DOM_OK);
    assert_int_equal(d.limit, DOM_DESIGN_FITS);
    return d;
}

/* Checks that no possible row is shorter than the shortest one that is found. */
TEST(shortest_is_shortest)
{
    struct dom_train train = dom_train_default();
    train.q = 3;
    train.mu = 0.3;
    struct dom_wish w = wish_of(2, 2.5, HUGE_VAL);
    const double length = shortest(&train, &w).length;
    struct dom_verdict v;
    for (size_t n = 4; n < 16; n++)
        for (int k = 200; k < 600; k += 4) {
            double r = pow(2 / 0.048, 1.0 / (double)n), feet = 0, height = 0.048;
            for (size_t j = 0; j <= n; j++, height *= r)
                feet += height * (train.d + (j ? k / 1000.0 : 0));
            assert_true(feet + 2 >= length * (1 - 1e-9) || train_ratio(&train, k / 1000.0, r) < 2.5 ||
                        row_least(&train, &w, k / 1000.0, n, false, &v) < 2.5);
        }
}

/* Checks rows of thin dominoes that stand as close as the steps of the search allow. One step closer, the
 * rows lack the requested safety, or there is no closer step. */
TEST(closest_of_thin_dominoes)
{
    static const struct {
        double d, height;
        int k;
    } cases[] = {{0.001, 0.053, 2}, {0.0005, 0.05, 1}};
    for (int i = 0; i < 2; i++) {
        struct dom_train train = dom_train_default();
        struct dom_verdict v;
        train.d = cases[i].d;
        struct dom_wish w = wish_of(cases[i].height, 1.01, HUGE_VAL);
        const struct dom_design d = shortest(&train, &w);
        assert_near("s", d.s, cases[i].k / 1000.0, 1e-12);
        row_holds(&train, &w, &d);
        double closer = (cases[i].k - 1) / 1000.0;
        assert_true(closer == 0 || train_ratio(&train, closer, d.r) < 1.01 ||
                    row_least(&train, &w, closer, d.steps, false, &v) < 1.01);
    }
}

/* Checks each member of a wish with values outside its range. */
TEST(wrong_wishes)
{
    static const struct {
        size_t member;
        enum dom_status status;
        double values[4];
    } wrong[] = {{offsetof(struct dom_wish, first), DOM_BAD_HEIGHT, {0, -1, NAN, INFINITY}},
                 {offsetof(struct dom_wish, height), DOM_BAD_HEIGHT, {0, 0.048, NAN, INFINITY}},
                 {offsetof(struct dom_wish, safety), DOM_BAD_SAFETY, {0, 1, NAN, INFINITY}},
                 {offsetof(struct dom_wish, hall), DOM_BAD_HALL, {0, -1, NAN, 1}},
                 {offsetof(struct dom_wish, g), DOM_BAD_G, {0, -1, NAN, INFINITY}},
                 {offsetof(struct dom_wish, push), DOM_BAD_PUSH, {-1, -2, INFINITY, -INFINITY}}};
    struct dom_train train = dom_train_default();
    struct dom_wish w = wish_of(1, 2, HUGE_VAL);
    struct dom_design d;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        for (int k = 0; k < 4; k++) {
            struct dom_wish changed = w;
            memcpy((char *)&changed + wrong[i].member, &wrong[i].values[k], sizeof(double));
            assert_status(dom_design_find(&train, &changed, NULL, NULL, &d, NULL), wrong[i].status);
        }
    volatile sig_atomic_t stop = 1;
    struct dom_compute compute = dom_compute_default();
    compute.interrupt = &stop;
    assert_status(dom_design_find(&train, &w, NULL, &compute, &d, NULL), DOM_INTERRUPTED);
    train.d = 0;
    assert_status(dom_design_find(&train, &w, NULL, NULL, &d, NULL), DOM_BAD_D);
}
