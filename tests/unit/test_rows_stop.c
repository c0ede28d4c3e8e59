/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rows that stop. The missing energy is compared with the potential energy of the dominoes on a fine grid.
 * With high friction, the tilt at which a row comes to rest is compared with Newton's equations (direct.c).
 */
#include "run.h"
#include "support.h"

enum { MOST = 8, GRID = 4000 };

static const double g = 9.81;

/*
 * Returns the largest increase of the potential energy of the `moving` dominoes up to the head, domino k, on
 * a grid of tilts of the head. A domino that its leader would turn back has detached. It keeps its height,
 * and so do all dominoes that lean on it.
 */
static double highest_energy_change(const struct run *run, size_t k, size_t moving)
{
    double end = k + 1 < run->row.count ? asin(run->domino[k + 1].gap / run->domino[k].height) : M_PI_2;
    double first = k + 1 - moving, at_most[MOST] = {0}, start = 0, top = 0, before[2] = {0};
    for (int i = 0; i <= GRID; i++) {
        double theta = end * i / GRID, sum = 0;
        bool fallen = false;
        for (size_t j = k;; j--) {
            const struct domq_domino *d = &run->domino[j];
            double h = d->height, t = d->thickness, gap = d->gap;
            if (theta < at_most[j] && i > 0)
                fallen = true;
            at_most[j] = theta = fallen ? at_most[j] : theta;
            sum += (double)d->mass * g * (h * cos(theta) + t * sin(theta)) / 2;
            if ((double)j == first)
                break;
            theta += asin(((gap + t) * cos(theta) - t) / (double)run->domino[j - 1].height);
        }
        start = i == 0 ? sum : start;
        sum -= start;
        double bend = before[0] - 2 * before[1] + sum, slope = (sum - before[0]) / 2;
        if (i > 1 && before[1] >= before[0] && before[1] >= sum && bend < 0)
            top = fmax(top, before[1] - slope * slope / (2 * bend));
        top = fmax(top, sum);
        before[0] = before[1];
        before[1] = sum;
    }
    return top;
}

/* Makes a row in which m g h / 2 of the first domino is 1. */
static void random_row(struct run *run, uint64_t *seed, double push, double mu)
{
    const size_t count = 2 + (size_t)(4 * random_unit(seed));
    run->row = row_setup_default(NULL, count, push);
    run->row.mu = mu;
    for (size_t k = 0; k < count; k++) {
        struct domq_domino *d = &run->domino[k];
        *d = (struct domq_domino){.height = k == 0 ? 0.1 : d[-1].height * (0.9 + 1.4 * random_unit(seed))};
        d->thickness = (double)d->height * random_log(seed, 0.03, 0.8);
        d->gap = k == 0 ? 0 : (double)d[-1].height * fmin(0.998, random_log(seed, 0.1, 1.2));
        d->mass = k == 0 ? 2 / (g * d->height) : (double)(d->height * d->height * d->thickness);
        if (k > 0)
            d->mass *=
                run->domino->mass / (run->domino->height * run->domino->height * run->domino->thickness);
    }
}

/*
 * Checks the energy that a head lacks. Without friction it is compared with the grid, in every precision. The
 * maximum on the grid is found by a parabola through three tilts. Its error, 1e-7, is of third order in the
 * distance between the tilts, or of second order if a domino detaches between them. In any case the energy
 * that the head needs does not depend on its speed.
 */
TEST(short_of_the_highest_everywhere)
{
    static struct run run, fast;
    uint64_t seed = 71;
    int stops = 0, behind = 0, compared[2] = {0, 0};
    for (int i = 0; i < 2400; i++) {
        random_row(&run, &seed, random_log(&seed, 3, 60), i % 3 == 2 ? 0.5 * random_unit(&seed) : 0);
        run.row.precision = i % 25 == 0 ? IN_QUAD : i % 4 == 0 ? IN_FLOAT : IN_DOUBLE;
        run.row.tol = run.row.precision == IN_FLOAT ? 1e-5 : 1e-12;
        assert_status(run_whole(&run), DOM_OK);
        if (run.verdict.end != DOM_ROW_STOPS)
            continue;
        const struct domq_fall *last = &run.fall[run.falls - 1], *same = &fast.fall[run.falls - 1];
        const double bound = run.row.precision == IN_FLOAT ? 2e-4 : 1e-6;
        if (run.row.mu == 0) {
            const double rise = highest_energy_change(&run, run.falls - 1, last->moving);
            if (!(fabs(rise - (double)last->barrier) <= bound * fmax(rise, last->kinetic)))
                fail_msg("row %d: barrier %.10g, on a grid %.10g", i, (double)last->barrier, rise);
            stops++;
            behind += last->theta_m > 1.5 * last->theta && run.falls > 1;
        }
        if (isfinite((double)last->barrier))
            assert_near("short by", run.verdict.short_by, last->barrier - last->kinetic, 1e-3);
        fast = run;
        fast.row.push *= 1.5;
        assert_status(run_whole(&fast), DOM_OK);
        if (fast.falls < run.falls || same->moving != last->moving)
            continue;
        if (last->barrier != same->barrier &&
            !(fabs((double)(last->barrier - same->barrier)) <=
              (run.row.precision == IN_FLOAT ? bound : 1e-9) * fmax(last->barrier, same->kinetic)))
            fail_msg("row %d: barriers %.12g and %.12g", i, (double)last->barrier, (double)same->barrier);
        compared[run.row.mu > 0]++;
    }
    print_message("# %d stop, %d far below their top; compared %d, %d with friction\n", stops, behind,
                  compared[0], compared[1]);
    assert_true(stops > 200 && behind > 25 && compared[0] > 100 && compared[1] > 50);
}

/* ---- At the reach ---- */

/* Checks that a row with r = 1/s, rounded in the widest type, is within reach in every precision, like a
 * train. A row whose gaps are wider by 1e-5 must be out of reach. */
TEST(rounded_reach_is_reached)
{
    static struct run run, near;
    struct domq_scale scale = domq_scale_default();
    int falls = 0, stops = 0;
    for (int i = 0; i < 3 * 100; i++) {
        struct setup train = setup_default();
        train.s = (domq_real)(100 + i) / 500;
        train.r = 1 / train.s;
        train.q = 1 + i % 7;
        ask_row_of_train(&train, &scale, 1, run.domino, 6);
        run.row = row_setup_default(NULL, 6, i % 2 ? 60 : DOMQ_NAN);
        run.row.precision = (enum precision)(i % 3);
        run.row.tol = i % 3 == IN_FLOAT ? 1e-5 : 1e-12;
        assert_status(run_whole(&run), DOM_OK);
        assert_true(run.verdict.end == DOM_ROW_FALLS || run.verdict.end == DOM_ROW_STOPS);
        train.r *= 1 - (domq_real)(i % 3 == IN_FLOAT ? 1e-4 : 1e-9); /* slightly below the reach */
        near = run;
        ask_row_of_train(&train, &scale, 1, near.domino, 6);
        assert_status(run_whole(&near), DOM_OK);
        for (size_t k = 0; k < run.falls && k < near.falls; k++)
            if (fabs((double)run.fall[k].margin) > 0.1 * (double)run.fall[k].kinetic)
                assert_true((run.fall[k].margin > 0) == (near.fall[k].margin > 0));
        falls += run.verdict.end == DOM_ROW_FALLS;
        stops += run.verdict.end == DOM_ROW_STOPS;
        for (size_t k = 1; k < 6; k++)
            run.domino[k].gap *= 1 + (domq_real)1e-5;
        run.row.push = 60;
        assert_status(run_whole(&run), DOM_OK);
        assert_true(run.verdict.end == DOM_ROW_MISSES && run.verdict.domino == 1);
    }
    print_message("# %d fall, %d stop\n", falls, stops);
    assert_true(falls > 15 && stops > 15);
}

/* ---- High friction ---- */

/*
 * Checks rows with high friction. The motion may lock, because lever arms become 0 (Painleve), but most rows
 * come to rest before that. In every precision, the hits and the stop must agree with Newton's equations, and
 * no row may be an error. Heads that are still moving when they lock are left out, since Newton's equations
 * are singular there.
 */
TEST(much_friction)
{
    static struct run run;
    static struct newton n;
    uint64_t seed = 73;
    int falls = 0, stops = 0, locked = 0;
    for (int i = 0; i < 3000; i++) {
        bool light = i % 4 == 0; /* light followers, which end up flat on the floor */
        random_row(&run, &seed, random_log(&seed, 3, 60), random_log(&seed, 0.5, 5));
        run.row.count = light ? 2 : run.row.count;
        run.domino[1].thickness *= light ? 2 : 1;
        run.row.precision = i % 500 == 3 ? IN_QUAD : i % 20 == 5 ? IN_FLOAT : IN_DOUBLE;
        run.row.tol = run.row.precision == IN_FLOAT ? 1e-5 : 1e-12;
        enum dom_status status = run_whole(&run);
        if (status != DOM_OK)
            fail_msg("row %d, mu %g: %s", i, (double)run.row.mu, dom_status_text(status));
        const struct domq_fall *last = &run.fall[run.falls - 1];
        bool wide = run.row.precision != IN_FLOAT,
             near = fabs((double)last->margin) < (wide ? 1e-6 : 1e-2) * (double)last->kinetic;
        if (near || (run.verdict.end != DOM_ROW_FALLS && run.verdict.end != DOM_ROW_STOPS))
            continue;
        newton_run(&run, &n);
        if (n.wrong || n.hits != run.falls || n.all_fall != (run.verdict.end == DOM_ROW_FALLS))
            fail_msg("row %d, mu %g: hits %zu, by Newton %zu %s", i, (double)run.row.mu, run.falls, n.hits,
                     n.wrong ? n.wrong : "");
        falls += run.verdict.end == DOM_ROW_FALLS;
        if (run.verdict.end != DOM_ROW_STOPS)
            continue;
        if (!(fabs(n.stop_theta - (double)last->theta) < (wide ? 1e-7 : 1e-2)))
            fail_msg("row %d, mu %g: rests at %.12g, by Newton %.12g", i, (double)run.row.mu,
                     (double)last->theta, n.stop_theta);
        assert_true(run.verdict.short_by > 0 && run.verdict.short_by == -last->margin);
        stops++;
        locked += isinf((double)last->barrier);
    }
    print_message("# %d fall, %d stop, %d of them before a lock\n", falls, stops, locked);
    assert_true(falls > 80 && stops > 300 && locked > 4);
}
