/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: pictures */
/* The tilts of all dominoes of a row at given times: at hits, between hits by the energy and by difference
 * quotients, and at the end. */
#include "run.h"
#include "support.h"

enum { FRAMES = 400, DOMINOES = 24 };

/* The states at the requested times. */
struct seen {
    size_t count, dominoes;
    double time[FRAMES], tilt[FRAMES][DOMINOES], omega[FRAMES][DOMINOES];
    size_t head[FRAMES], moving[FRAMES];
    size_t most; /* number of visits after which the visitor ends the run */
};

static bool moment_seen(const struct dom_moment *m, void *context)
{
    struct seen *s = context;
    assert_true(s->count < FRAMES);
    s->time[s->count] = m->time;
    s->head[s->count] = m->head;
    s->moving[s->count] = m->moving;
    for (size_t k = 0; k < s->dominoes; k++) {
        s->tilt[s->count][k] = m->tilt[k];
        s->omega[s->count][k] = m->omega[k];
    }
    return ++s->count < s->most;
}

static enum dom_status watch(struct run *run, const double *times, size_t count, struct seen *seen)
{
    assert_true(run->row.count <= DOMINOES);
    seen->count = 0;
    seen->dominoes = run->row.count;
    seen->most = FRAMES + 1;
    run->row.domino = run->domino;
    struct dom_verdict verdict = {.end = run->verdict.end, .domino = run->verdict.domino};
    const enum dom_status status = ask_row_watch(&run->row, times, count, moment_seen, seen, &verdict);
    run->verdict.end = verdict.end;
    run->verdict.domino = verdict.domino;
    return status;
}

/* Returns the potential and kinetic energy of all dominoes, in J. */
static double energy(const struct run *run, const double *tilt, const double *omega)
{
    double sum = 0;
    for (size_t k = 0; k < run->row.count; k++) {
        const struct domq_domino *p = &run->domino[k];
        double h = (double)p->height, d = (double)p->thickness, m = (double)p->mass;
        sum += m * 9.81 * (h * cos(tilt[k]) + d * sin(tilt[k])) / 2;
        sum += m * (h * h + d * d) / 3 * omega[k] * omega[k] / 2;
    }
    return sum;
}

/* Returns the distance of the tip of domino k from the face of its leader, which is 0 if the domino leans on
 * the leader. */
static double clearance(const struct run *run, const double *tilt, size_t k)
{
    const struct domq_domino *own = &run->domino[k], *leader = &run->domino[k + 1];
    double turn = tilt[k] - tilt[k + 1], d = (double)leader->thickness;
    return ((double)leader->gap + d) * cos(tilt[k + 1]) - d - (double)own->height * sin(turn);
}

enum { ROWS = 8, PLUMB = 5 };

/* Makes row number i. Rows fall or stop, and have uneven dominoes, some of which detach. From number PLUMB
 * on, dominoes lean to either side. */
static void rows(struct run *run, int i)
{
    static const double s[ROWS] = {0.3, 0.4, 0.55, 0.4, 0.6, 0.3, 0.45, 0.5},
                        r[ROWS] = {1, 1.3, 1.6, 2.1, 1.5, 1, 1.4, 1.2}, mu[ROWS] = {[4] = 0.2, [7] = 0.2};
    make_row(run, i == 3 ? 6 : 12, s[i], r[i], mu[i]);
    for (size_t k = 0; i >= PLUMB && k < run->row.count; k++)
        run->domino[k].lean = (domq_real)(k % 3 == 0 ? -0.02 : 0.03);
}

/* Checks the states at the hits, and at the end of the row. */
TEST(agrees_with_hits)
{
    static struct run run;
    static struct seen seen;
    const double late[] = {1, 1e6, (double)INFINITY};
    for (int i = 0; i < ROWS; i++) {
        double times[ROW_MOST];
        rows(&run, i);
        assert_status(run_whole(&run), DOM_OK);
        struct domq_verdict verdict = run.verdict;
        for (size_t k = 0; k < run.falls; k++)
            times[k] = (double)run.fall[k].time;
        assert_status(watch(&run, times, run.falls, &seen), DOM_OK);
        assert_int_equal(seen.count, run.falls);
        assert_true(run.verdict.end == verdict.end && run.verdict.domino == verdict.domino);
        for (size_t k = 0; k < run.falls; k++) {
            assert_near("time", seen.time[k], times[k], 0);
            assert_int_equal(seen.head[k], k + 1);
            /* A domino may detach at the moment of the hit. */
            assert_true(seen.moving[k] <= run.fall[k].moving && seen.moving[k] + 1 >= run.fall[k].moving);
            assert_near("a domino that is just hit", seen.tilt[k][k], (double)run.domino[k].lean, 1e-7);
            assert_near("its omega", seen.omega[k][k], (double)run.fall[k].omega, 1e-9);
            if (k > 0)
                assert_near("where the one before hits", seen.tilt[k][k - 1], (double)run.fall[k - 1].theta,
                            1e-9);
            for (size_t j = k + 1; j < run.row.count; j++)
                assert_true(seen.tilt[k][j] == (double)run.domino[j].lean && seen.omega[k][j] == 0);
        }
        const struct domq_fall *last = &run.fall[run.falls - 1];
        assert_status(watch(&run, late, 3, &seen), DOM_OK);
        assert_int_equal(seen.head[2], run.falls);
        assert_near("the last tilt", seen.tilt[2][run.falls - 1], (double)last->theta, 1e-10);
        assert_true(seen.time[1] == seen.time[2]);
        if (verdict.end == DOM_ROW_FALLS) {
            assert_near("the time when it lies", seen.time[2], (double)verdict.seconds, 1e-12);
        } else {
            assert_int_equal(verdict.end, DOM_ROW_STOPS);
            assert_true(seen.time[2] > (double)last->time && seen.omega[2][run.falls - 1] == 0);
        }
    }
}

TEST(keeps_the_laws_between)
{
    static struct run run;
    static struct seen seen;
    size_t detached = 0;
    for (int i = 0; i < ROWS; i++) {
        double times[FRAMES];
        rows(&run, i);
        assert_status(run_whole(&run), DOM_OK);
        double whole = (double)(run.fall[run.falls - 1].time) * 1.05;
        for (size_t k = 0; k < FRAMES; k++)
            times[k] = whole * (double)k / FRAMES;
        assert_status(watch(&run, times, FRAMES, &seen), DOM_OK);
        for (size_t k = 1; k < seen.count; k++) {
            const double *tilt = seen.tilt[k], *before = seen.tilt[k - 1];
            size_t head = seen.head[k] - 1;
            bool same = seen.head[k] == seen.head[k - 1] && seen.moving[k] == seen.moving[k - 1];
            for (size_t j = 0; j < run.row.count; j++)
                assert_true(tilt[j] >= before[j]);
            for (size_t j = head + 1 - seen.moving[k]; j < head; j++) {
                assert_true(fabs(clearance(&run, tilt, j)) < 1e-11 * (double)run.domino[j].height);
                double h = seen.time[k] - seen.time[k - 1], rise = tilt[j] - before[j];
                /* The trapezoidal rule for the tilt has an error of third order in the step. */
                if (same)
                    assert_true(fabs(rise - h * (seen.omega[k][j] + seen.omega[k - 1][j]) / 2) <
                                1e-7 + 0.1 * rise);
            }
            detached += head + 1 - seen.moving[k];
            for (size_t j = 0; j + seen.moving[k] < head + 1; j++)
                assert_true(seen.omega[k][j] == 0);
            if (same && run.row.mu == 0)
                assert_near("energy", energy(&run, tilt, seen.omega[k]),
                            energy(&run, before, seen.omega[k - 1]), 1e-11);
            else if (same)
                assert_true(energy(&run, tilt, seen.omega[k]) <
                            energy(&run, before, seen.omega[k - 1]) * (1 + 1e-11));
        }
    }
    assert_true(detached > 0);
}

TEST(the_clock_starts_at_the_first_hit)
{
    static struct run run;
    static struct seen seen;
    const double early = -0.05, now = 0;
    make_row(&run, 5, 0.4, 1.2, 0);
    run.row.push = (domq_real)NAN;
    assert_status(watch(&run, &early, 1, &seen), DOM_BAD_TIME);
    assert_status(watch(&run, &now, 1, &seen), DOM_OK);
    assert_true(seen.count == 1 && seen.head[0] == 2);
    assert_near("where it hits", sin(seen.tilt[0][0]), (double)(run.domino[1].gap / run.domino[0].height),
                1e-12);
    /* The next domino is so close that the first one touches it before tipping over. */
    run.domino[1].gap = 1e-3;
    assert_status(watch(&run, &now, 1, &seen), DOM_OK);
    assert_int_equal(run.verdict.end, DOM_ROW_LEANS);
    assert_near("leans", sin(seen.tilt[0][0]), 1e-3 / (double)run.domino[0].height, 1e-12);
    assert_true(seen.count == 1 && seen.omega[0][0] == 0 && seen.time[0] == 0);
}
