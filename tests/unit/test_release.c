/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: pictures */
/* A first domino that is released at a tilt, in limiting cases, and with a push that brings it to the same
 * state; test_row compares such rows with Newton's equations. */
#include "run.h"
#include "support.h"

static const double g = 9.81, deg = M_PI / 180;

static void released(struct run *run, size_t count, double s, double r, double release)
{
    make_row(run, count, s, r, 0);
    run->row.push = 0;
    run->row.release = release;
}

/* ---- The first domino touches the second ---- */

TEST(touch)
{
    static struct run run;
    static struct newton n;
    int falls = 0, stops = 0;
    for (int i = 0; i < 24; i++) {
        const double s = 0.2 + 0.05 * (i / 2), c = asin(s);
        domq_real tilt;
        released(&run, 6, s, 1, INFINITY);
        run.row.mu = 0.1 * (i % 2);
        assert_status(run_whole(&run), DOM_OK);
        const struct domq_fall *f = run.fall;
        assert_true(f[0].kinetic == 0 && f[0].duration == 0 && f[0].omega == 0 && f[0].barrier == 0);
        assert_true(f[1].kinetic == 0 && f[1].omega == 0 && f[1].time == 0 && f[1].lost == 0);
        assert_near("tilt", (double)f[0].theta, c, 1e-14);
        const struct domq_row row = row_setup(&run.row);
        assert_status(any_row_touch(&row, (const struct any_compute[]){any_compute_default()}, &tilt),
                      DOM_OK);
        assert_near("touch", (double)tilt, c, 1e-14);
        /* The torque of domino 1 turns domino 2 only if it is larger than that of its own weight. */
        const double d = (double)(run.domino->thickness / run.domino->height);
        if (i % 2 == 0)
            assert_int_equal(run.verdict.end == DOM_ROW_FALLS, s - d * cos(c) > d);
        if (run.verdict.end == DOM_ROW_FALLS) {
            newton_run(&run, &n);
            newton_compare(&run, &n);
        } else
            assert_true(run.verdict.end == DOM_ROW_STOPS && run.verdict.domino == 2 && f[1].theta == 0 &&
                        f[1].margin < 0);
        falls += run.verdict.end == DOM_ROW_FALLS;
        stops += run.verdict.end == DOM_ROW_STOPS;
        /* the tilt of the contact, as a number, is the same start; a larger tilt is none */
        run.row.release = tilt;
        const double seconds = (double)run.verdict.seconds;
        assert_status(run_whole(&run), DOM_OK);
        assert_true(run.fall[1].kinetic == 0);
        assert_near("seconds", (double)run.verdict.seconds, seconds, 1e-12);
        run.row.release = tilt * (1 + 1e-6);
        assert_int_equal(row_end(&run), DOM_ROW_SKEWED);
        assert_int_equal(run.verdict.domino, 1);
    }
    assert_true(falls > 10 && stops > 3);
}

/* ---- The first domino falls back, or just tips over ---- */

TEST(tipping)
{
    static struct run run;
    released(&run, 8, 0.5, 1.2, NAN);
    run.row.push = NAN;
    run.row.release = 0;
    assert_status(run_whole(&run), DOM_OK);
    const double u = tips_at(run.domino), h = run.domino->height, d = run.domino->thickness,
                 m = run.domino->mass;
    domq_real omega[8];
    assert_int_equal(run.falls, 8);
    for (size_t k = 1; k < 8; k++)
        omega[k] = run.fall[k].omega;
    const double seconds = (double)run.verdict.seconds;
    run.row.push = 0;
    run.row.release = u * (1 + 1e-8);
    assert_status(run_whole(&run), DOM_OK);
    assert_int_equal(run.falls, 8);
    for (size_t k = 1; k < 8; k++)
        assert_near("omega", (double)run.fall[k].omega, (double)omega[k], 1e-13);
    assert_near("seconds", (double)(run.verdict.seconds - run.fall[1].time), seconds, 1e-11);
    for (int i = 1; i < 10; i++) {
        const double release = u * i / 10;
        run.row.release = release;
        assert_int_equal(row_end(&run), DOM_ROW_BACK);
        assert_int_equal(run.verdict.domino, 1);
        assert_near("short by", (double)run.verdict.short_by,
                    m * g / 2 * (hypot(h, d) - h * cos(release) - d * sin(release)), 1e-10);
    }
}

/* ---- The same state, by a push ---- */

struct seen {
    double tilt, omega;
};

static bool state_seen(const struct dom_moment *m, void *context)
{
    *(struct seen *)context = (struct seen){m->tilt[0], m->omega[0]};
    return false;
}

/* Returns the state of the first domino at a time. */
static struct seen state_at(struct run *run, double time)
{
    struct seen seen;
    struct dom_verdict verdict;
    run->row.domino = run->domino;
    assert_status(ask_row_watch(&run->row, &time, 1, state_seen, &seen, &verdict), DOM_OK);
    return seen;
}

/* A row whose first domino is released in a state that it passes after a push moves on as after the push. */
TEST(every_effect)
{
    static struct run run, after;
    for (int i = 0; i < 7; i++) {
        make_row(&run, 6, 0.5, 1.1, i == 1 || i == 6 ? 0.2 : 0);
        run.row.alpha = i == 2 ? 0.03 : 0;
        run.row.rho = i == 3 || i == 6 ? 0.02 : 0;
        run.row.walls = i == 4 ? 1e-3 : 0;
        run.row.air = i == 5 || i == 6 ? 1.2 : 0;
        run.row.precision = i == 0 ? IN_QUAD : IN_DOUBLE;
        assert_status(run_whole(&run), DOM_OK);
        assert_int_equal(run.verdict.end, DOM_ROW_FALLS);
        const double time = (double)run.fall[1].time / 2;
        const struct seen seen = state_at(&run, time);
        after = run;
        after.row.release = seen.tilt;
        after.row.push = seen.omega;
        assert_status(run_whole(&after), DOM_OK);
        assert_int_equal(after.falls, run.falls);
        for (size_t k = 1; k < run.falls; k++) {
            assert_near("omega", (double)after.fall[k].omega, (double)run.fall[k].omega, 1e-10);
            assert_near("time", (double)(after.fall[k].time + time), (double)run.fall[k].time, 1e-10);
        }
    }
}

/* Released at rest, the domino has moved by alpha t^2 / 2 after a short time, with every effect that changes
 * the motion of a single domino. */
TEST(first_moments)
{
    static struct run run;
    for (int i = 0; i < 4; i++) {
        const double at = 20 * deg;
        released(&run, 4, 0.5, 1.1, at);
        run.row.air = i == 1 ? 1.2 : 0;
        run.row.rho = i == 2 ? 0.02 : 0;
        run.row.mu = i == 3 ? 0.3 : 0;
        const struct seen first = state_at(&run, 0), seen = state_at(&run, 1e-4);
        assert_true(first.tilt == at && first.omega == 0);
        const double h = run.domino->height, d = run.domino->thickness,
                     alpha = 3 * g / 2 * (h * sin(at) - d * cos(at)) / (h * h + d * d),
                     bound = i == 1 || i == 2 ? 0.2 : 1e-5;
        assert_near("omega", seen.omega, alpha * 1e-4, bound);
        assert_near("tilt", seen.tilt, at + alpha * 1e-8 / 2, bound * 1e-6);
    }
}

TEST(what_a_release_replaces)
{
    static struct run run;
    released(&run, 4, 0.5, 1, 0.4);
    /* The release replaces the lean of the first domino. */
    run.domino->lean = 0.1;
    assert_status(run_whole(&run), DOM_OK);
    const domq_real omega = run.fall[1].omega;
    run.domino->lean = 0;
    assert_status(run_whole(&run), DOM_OK);
    assert_true(run.fall[1].omega == omega);
    /* Without a push, and with a tilt of 0, the row starts as usual. */
    released(&run, 4, 0.5, 1, 0.4);
    run.row.push = NAN;
    assert_status(run_whole(&run), DOM_OK);
    const domq_real tipped = run.fall[1].omega;
    run.row.release = 0;
    assert_status(run_whole(&run), DOM_OK);
    assert_true(run.fall[1].omega == tipped && tipped != omega);
}
