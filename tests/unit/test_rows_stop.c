/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rows that stop. The missing energy is compared with the potential energy of the dominoes on a fine grid.
 * With high friction, the tilt at which a row comes to rest is compared with Newton's equations (direct.c).
 */
#include "run.h"
#include "support.h"

enum { MOST = 8, GRID = 4000 };

static const double g = 9.81;

/* Makes a row in which m g h / 2 of the first domino is 1. */
static void blocks_row(struct run *run, double size[][3], size_t count, double push, double mu)
{
    double unit = 2 / (g * size[0][0] * size[0][0] * size[0][0] * size[0][1]);
    for (size_t k = 0; k < count; k++)
        run->domino[k] = (struct domq_domino){
            size[k][0], size[k][1], size[k][2], unit * size[k][0] * size[k][0] * size[k][1], 0, 0, 0};
    run->row = row_setup_default(NULL, count, push);
    run->row.mu = mu;
}

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

static void random_row(struct run *run, uint64_t *seed, double push, double mu)
{
    double size[MOST][3];
    size_t count = 2 + (size_t)(4 * random_unit(seed));
    for (size_t k = 0; k < count; k++) {
        size[k][0] = k == 0 ? 0.1 : size[k - 1][0] * (0.9 + 1.4 * random_unit(seed));
        size[k][1] = size[k][0] * random_log(seed, 0.03, 0.8);
        size[k][2] = k == 0 ? 0 : size[k - 1][0] * fmin(0.998, random_log(seed, 0.1, 1.2));
    }
    blocks_row(run, size, count, push, mu);
}

/*
 * Checks rows without friction, in every precision. The maximum on the grid is found by a parabola through
 * three tilts. Its error, 1e-7, is of third order in the distance between the tilts, or of second order if a
 * domino detaches between them.
 */
TEST(short_of_the_highest_everywhere)
{
    static struct run run;
    uint64_t seed = 71;
    int stops = 0, behind = 0;
    for (int i = 0; i < 1500; i++) {
        random_row(&run, &seed, random_log(&seed, 3, 60), 0);
        run.row.precision = i % 25 == 0 ? IN_QUAD : i % 3 == 0 ? IN_FLOAT : IN_DOUBLE;
        run.row.tol = run.row.precision == IN_FLOAT ? 1e-5 : 1e-12;
        assert_status(run_whole(&run), DOM_OK);
        if (run.verdict.end != DOM_ROW_STOPS)
            continue;
        const struct domq_fall *last = &run.fall[run.falls - 1];
        size_t before = run.falls > 1 ? run.fall[run.falls - 2].moving : 0;
        double rise = highest_energy_change(&run, run.falls - 1, last->moving);
        double bound = run.row.precision == IN_FLOAT ? 2e-4 : 1e-6;
        if (!(fabs(rise - (double)last->barrier) <= bound * fmax(rise, last->kinetic)))
            fail_msg("row %d: barrier %.10g, on a grid %.10g", i, (double)last->barrier, rise);
        assert_near("short by", run.verdict.short_by, last->barrier - last->kinetic, 1e-3);
        stops++;
        behind += last->theta_m > 1.5 * last->theta && before > 0;
    }
    print_message("# %d stop, %d of them far below their top\n", stops, behind);
    assert_true(stops > 200 && behind > 25);
}

/* Checks that the energy that a head needs does not depend on its speed, even where the row stops. */
TEST(a_stop_needs_what_a_fall_needs)
{
    static struct run slow, fast;
    uint64_t seed = 72;
    int compared = 0;
    for (int i = 0; i < 1500; i++) {
        double mu = i % 2 ? 0.5 * random_unit(&seed) : 0;
        random_row(&slow, &seed, random_log(&seed, 3, 60), mu);
        fast = slow;
        fast.row.push *= 1.5;
        assert_status(run_whole(&slow), DOM_OK);
        assert_status(run_whole(&fast), DOM_OK);
        size_t last = slow.falls - 1;
        if (slow.verdict.end != DOM_ROW_STOPS || fast.falls < slow.falls ||
            fast.fall[last].moving != slow.fall[last].moving)
            continue;
        const struct domq_fall *a = &slow.fall[last], *b = &fast.fall[last];
        if (isinf((double)a->barrier) || isinf((double)b->barrier))
            assert_true(isinf((double)a->barrier) && isinf((double)b->barrier));
        else if (!(fabs((double)(a->barrier - b->barrier)) <= 1e-9 * (double)fmax(a->barrier, b->kinetic)))
            fail_msg("row %d: barriers %.12g and %.12g", i, (double)a->barrier, (double)b->barrier);
        compared++;
    }
    print_message("# %d rows\n", compared);
    assert_true(compared > 150);
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
    int falls = 0, stops = 0, locked = 0, jams = 0;
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
        bool wide = run.row.precision != IN_FLOAT, jam = run.verdict.end == DOM_ROW_LOCKS && last->margin < 0,
             near = fabs((double)last->margin) < (wide ? 1e-6 : 1e-2) * (double)last->kinetic;
        if (near || (run.verdict.end != DOM_ROW_FALLS && run.verdict.end != DOM_ROW_STOPS && !jam))
            continue;
        newton_run(&run, &n);
        if (jam) {
            assert_non_null(n.wrong);
            assert_int_equal(n.hits, run.falls);
            jams++;
            continue;
        }
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
    print_message("# %d fall, %d stop, %d of them before a lock, %d jam\n", falls, stops, locked, jams);
    assert_true(falls > 80 && stops > 300 && locked > 4);
}

/* Checks a light domino that tips over its edge and hits a thick one, which stops. No energy would be enough
 * to pass the tilt at which the row locks. */
TEST(stops_before_a_lock)
{
    static double size[][3] = {{0.03, 0.0034, 0}, {0.04, 0.018, 0.0034}};
    static struct run run;
    for (int precision = IN_FLOAT; precision <= IN_QUAD; precision++) {
        blocks_row(&run, size, 2, DOMQ_NAN, 1.35);
        run.row.precision = (enum precision)precision;
        run.row.tol = precision == IN_FLOAT ? 1e-5 : 1e-12;
        assert_status(run_whole(&run), DOM_OK);
        assert_true(run.verdict.end == DOM_ROW_STOPS && run.verdict.domino == 2);
        assert_true(isinf((double)run.verdict.short_by) && isinf((double)run.fall[1].barrier));
        assert_true(run.fall[1].theta > 0 && run.fall[1].theta < 1e-6);
    }
}
