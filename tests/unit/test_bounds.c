/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Searches and studies save work by bounds, which are compared here with full computations: with the trains
 * of a strip, with runs of whole rows, and with the motion of heads that certainly keep falling. */
#include "library.h" /* the names of functions that the files of the library share */

#include "request.h"
#include "support.h"

static double uniform(uint64_t *seed, double lo, double hi)
{
    return lo + (hi - lo) * random_unit(seed);
}

/* ---- Strips ---- */

enum { SAMPLES = 6 };

/* A strip of growths, or of separations. */
struct strip_case {
    struct margin_context context;
    bool in_r;
    double lo, hi, other; /* both ends of the strip, and the separation or the growth that is constant */
    struct geometry at_lo, at_hi;
};

/* Returns the margin of a train in the strip and sets *along to its ln r or its s. */
static struct margin margin_in(struct strip_case *c, double share, double *along)
{
    const double at = c->lo * pow(c->hi / c->lo, share);
    c->context.s = c->in_r ? c->other : at;
    *along = c->in_r ? log(at) : at;
    return margin_rough(&c->context, c->in_r ? at : c->other, 1e-11);
}

static bool strip_of(struct strip_case *c, struct strip *strip)
{
    c->at_lo = c->at_hi = c->context.geometry;
    return geometry_set(&c->at_lo, c->in_r ? c->other : c->lo, c->in_r ? c->lo : c->other) == DOM_OK &&
           geometry_set(&c->at_hi, c->in_r ? c->other : c->hi, c->in_r ? c->hi : c->other) == DOM_OK &&
           strip_walk(&c->at_lo, &c->at_hi, c->context.train->fuel, INFINITY, 1e-13, strip) == DOM_OK;
}

/* Checks the bounds of the tilt at which H has its maximum. */
static void top_check(struct strip_case *c, const struct strip *strip, const struct margin *m)
{
    const double kinetic = fmax(strip->kinetic_least, 0), theta_m = c->context.barrier.theta_m;
    assert_true(m->barrier == 0 ||
                theta_m <= 2 * atan(strip_top(&c->at_lo, &c->at_hi, c->at_lo.c)) * (1 + 1e-7));
    if (c->in_r && isfinite(strip->grows) && m->barrier >= kinetic)
        assert_true(theta_m >=
                    (1 - 1e-7) * tilt_angle(strip_least_top(&c->at_lo, &c->at_hi, kinetic, strip->grows)));
}

/* The number of strips, and the number of strips with useful bounds. */
struct strips {
    int all, slopes, grows, close;
};

static void strip_check(struct strip_case *c, const struct strip *strip, struct strips *count)
{
    const double most = barrier_most(&c->context.geometry);
    double along[SAMPLES], slack = 0;
    struct margin m[SAMPLES];
    for (int k = 0; k < SAMPLES; k++) {
        m[k] = margin_in(c, k / (SAMPLES - 1.0), &along[k]);
        if (c->context.status != DOM_OK)
            return;
        top_check(c, strip, &m[k]);
        slack = fmax(slack, 1e-9 * (fabs(m[k].kinetic) + m[k].barrier));
    }
    const double width = along[SAMPLES - 1] - along[0],
                 highest = strip_barrier_most(strip, m[SAMPLES - 1].barrier, most, width),
                 lowest = strip_barrier_least(strip, m[0].barrier, most, width);
    for (int k = 0; k < SAMPLES; k++) {
        assert_true(strip->kinetic_least <= 0 || m[k].kinetic >= strip->kinetic_least - slack);
        assert_true(m[k].kinetic <= strip->kinetic_most + slack);
        assert_true(m[k].barrier <= highest + slack && m[k].barrier >= lowest - slack);
        if (k == 0 || !(m[k - 1].kinetic >= 0 && m[k].kinetic >= 0)) /* without fuel, there is no slope */
            continue;
        const double step = along[k] - along[k - 1], rise = margin_value(&m[k]) - margin_value(&m[k - 1]);
        assert_true(m[k - 1].barrier - m[k].barrier <= strip->drops * step + slack);
        assert_true(!c->in_r || rise <= strip->margin_slope * step + slack);
        if (c->in_r && fmin(m[k].barrier, m[k - 1].barrier) >= strip->kinetic_least)
            assert_true(rise <= strip->root_slope * step + slack);
    }
    count->all++;
    count->slopes += c->in_r && strip->root_slope < 0;
    count->grows += lowest > 0.5 * m[0].barrier && highest < 2 * m[0].barrier;
    count->close += strip->kinetic_least > 0.5 * strip->kinetic_most;
}

TEST(strips_enclose_their_trains)
{
    uint64_t seed = 41;
    struct strips count[2] = {{0}, {0}};
    for (int i = 0; i < 600; i++) {
        struct setup train = setup_default();
        struct strip strip;
        train.s = random_log(&seed, 0.02, 0.9);
        train.d = random_log(&seed, 0.01, 0.5);
        train.q = uniform(&seed, 1, 5);
        train.r = pow(1 / train.s, random_unit(&seed));
        train.fuel = i % 4 == 1 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        const struct request request = request_of(&train);
        struct strip_case c = {.context = margin_of_train(&request), .in_r = i % 2};
        const double wide = exp(random_log(&seed, 1e-4, 0.2)), reach = 1 - 1e-9;
        c.lo = c.in_r ? train.r : train.s;
        c.other = c.in_r ? train.s : train.r;
        c.hi = fmin(c.lo * wide, reach / c.other);
        if (c.context.status == DOM_OK && c.hi > c.lo && strip_of(&c, &strip))
            strip_check(&c, &strip, &count[c.in_r]);
    }
    print_message("# %d strips of growths: %d in which the margin decreases at a root, %d with close bounds "
                  "of the barrier, %d of the energy; %d strips of separations: %d with close bounds of the "
                  "barrier, %d of the energy\n",
                  count[1].all, count[1].slopes, count[1].grows, count[1].close, count[0].all, count[0].grows,
                  count[0].close);
    assert_true(count[1].all > 200 && count[1].slopes > 150 && count[1].grows > 100 && count[0].grows > 100);
}

/* ---- Rows that are run again ---- */

enum { ROW = 24 };

struct random_dominoes {
    struct dom_domino domino[ROW];
    struct row_request request;
};

/* Makes a row of dominoes whose sizes differ. */
static void dominoes_make(struct random_dominoes *row, uint64_t *seed, double mu)
{
    const double s = uniform(seed, 0.2, 0.6), r = uniform(seed, 1, 1.35);
    double height = 0.05;
    row->request = (struct row_request){.domino = row->domino,
                                        .count = 3 + (size_t)(random_unit(seed) * (ROW - 3)),
                                        .g = 9.81,
                                        .push = uniform(seed, 3, 9),
                                        .tol = 1e-12,
                                        .effect = {[DOM_EFFECT_friction] = mu},
                                        .precision = DOM_DOUBLE};
    for (size_t k = 0; k < ROW; k++, height *= r) {
        struct dom_domino *d = &row->domino[k];
        const double thickness = 0.15 * uniform(seed, 0.7, 1.4);
        *d = (struct dom_domino){.height = height * uniform(seed, 0.97, 1.03)};
        d->thickness = thickness * d->height;
        d->gap = s * d->height * uniform(seed, 0.8, 1.25);
        d->mass = 500 * d->thickness * d->height * d->height * uniform(seed, 0.8, 1.25);
    }
}

/* Changes one property of a domino. */
static void domino_change(struct dom_domino *d, uint64_t *seed)
{
    const double factor = random_unit(seed) < 0.5 ? uniform(seed, 0.6, 1.7) : uniform(seed, 0.99, 1.01);
    double *const measure[] = {&d->gap, &d->mass, &d->height, &d->thickness};
    *measure[(int)(random_unit(seed) * 4)] *= factor;
}

static bool falls_all(const struct row_request *request)
{
    struct dom_verdict verdict;
    assert_status(row_run(request, false, NULL, NULL, &verdict), DOM_OK);
    return verdict.end == DOM_ROW_FALLS;
}

/*
 * Makes the last domino almost heavy enough to stop the row, or slightly heavier, so that a small change of a
 * much earlier domino decides how the row ends. If even a light last domino does not fall, the last domino
 * stays light.
 */
static void last_domino_balance(struct random_dominoes *row, uint64_t *seed)
{
    double *mass = &row->domino[row->request.count - 1].mass, light = 1e-3 * *mass, heavy = 1e3 * *mass;
    *mass = light;
    if (!falls_all(&row->request))
        return;
    while (heavy > light * (1 + 1e-9)) {
        *mass = sqrt(light * heavy);
        *(falls_all(&row->request) ? &light : &heavy) = *mass;
    }
    *mass *= 1 + (random_unit(seed) < 0.5 ? 1 : -1) * random_log(seed, 1e-7, 1e-2);
}

/* Checks that a row with one changed domino ends in the same way, whether the whole row is run or only the
 * part that the change can affect. */
TEST(rows_again_end_like_whole_rows)
{
    uint64_t seed = 43;
    int falls = 0, other = 0;
    for (int i = 0; i < 150; i++) {
        static struct random_dominoes row;
        struct dom_domino changed[ROW];
        struct course *course;
        struct dom_verdict before, again, whole;
        dominoes_make(&row, &seed, i % 5 ? 0 : 0.2);
        if (i % 4)
            last_domino_balance(&row, &seed);
        enum dom_status status = row_course(&row.request, &course, &before);
        for (int j = 0; j < 20 && status == DOM_OK; j++) {
            const size_t k = (size_t)(random_unit(&seed) * (double)row.request.count);
            struct row_request request = row.request;
            struct dom_work work = {0};
            memcpy(changed, row.domino, sizeof changed);
            domino_change(&changed[k], &seed);
            request.domino = changed;
            request.work = &work;
            assert_status(row_run(&request, false, NULL, NULL, &whole), DOM_OK);
            assert_status(row_again(course, changed, k, k, &again), DOM_OK);
            assert_int_equal(again.end == DOM_ROW_FALLS, whole.end == DOM_ROW_FALLS);
            falls += whole.end == DOM_ROW_FALLS;
            other += (whole.end == DOM_ROW_FALLS) != (before.end == DOM_ROW_FALLS);
        }
        row.domino[1].thickness *= -1;
        assert_status(row_again(course, row.domino, 0, 1, &again), DOM_BAD_THICKNESS);
        (void)row_course_end(course);
    }
    print_message("# %d rows fall; %d changes also change the verdict\n", falls, other);
    assert_true(falls > 500 && other > 100);
}

/* ---- Heads that certainly keep falling ---- */

/* Returns the tilt of follower i at a tilt of the head. */
static double follower_tilt(const struct geometry *head, size_t i, double theta)
{
    struct link link = link_head(head, tilt_make(sin(theta), cos(theta)));
    while (link.i < i)
        link_next(&link);
    return tilt_angle(link.tilt);
}

/* Checks the bound of -theta_i'' while the head moves, for the first dominoes of a chain. */
static void curve_check(const struct geometry *head, size_t moving)
{
    const double end = tilt_angle(head->c), by = 1e-3 * end;
    struct link a = link_head(head, head->c), b = link_head(head, standing);
    struct glide g = {.t = half_of_tilt(head->c)};
    while (a.i + 1 < moving && a.i < 5 && a.tilt.v < a.geometry->leave.v) {
        glide_next(&g, &a, &b);
        link_next(&a);
        link_next(&b);
        for (int k = 1; k < 8; k++) {
            const double at = end * k / 8, bend = 2 * follower_tilt(head, a.i, at) -
                                                  follower_tilt(head, a.i, at - by) -
                                                  follower_tilt(head, a.i, at + by);
            assert_true(bend / (by * by) <= g.curve + 1e-6);
        }
    }
}

/* Checks the next head of a run. With too little energy, the head must not be certain to keep falling. A head
 * that is certain to keep falling must arrive with the energy of a full run. */
static void head_check(struct random_row *s, const struct run *run, size_t k, int *count)
{
    struct run full = *run, slow = *run;
    struct descent d;
    struct dom_fall fall = {.domino = k + 1};
    struct start at;
    s->geometry[k].n = run->moving;
    curve_check(&s->geometry[k], run->moving);
    assert_status(row_descend(&full, k, &d, &fall), DOM_OK);
    count[0]++;
    const bool goes = head_goes(s, run, k, &at);
    const double need = run->omegasq - d.least_margin / d.J0;
    slow.omegasq = need * (1 - 1e-7);
    s->head = SIZE_MAX;
    assert_false(need > 1e-9 * run->omegasq && head_goes(s, &slow, k, &(struct start){.J = 0}));
    if (!goes)
        return;
    count[1]++;
    assert_false(d.stops);
    assert_near("omegasq", at.omegasq, d.st.start.omegasq, 1e-9);
}

TEST(heads_that_keep_falling)
{
    uint64_t seed = 47;
    int count[2] = {0, 0};
    for (int i = 0; i < 150; i++) {
        static struct random_dominoes row;
        struct random_row *s;
        dominoes_make(&row, &seed, 0);
        assert_status(row_sample_begin(&row.request, &s), DOM_OK);
        struct run run = {.request = &s->request, .geometry = s->geometry, .verdict = {.end = DOM_ROW_FALLS}};
        row_launch(&run);
        s->head = SIZE_MAX;
        for (size_t k = 0; k < row.request.count && run.verdict.end == DOM_ROW_FALLS; k++) {
            struct descent d;
            struct dom_fall fall;
            head_check(s, &run, k, count);
            assert_status(row_head(&run, k, &d, &fall), DOM_OK);
            if (k + 1 < row.request.count && run.verdict.end == DOM_ROW_FALLS)
                assert_status(row_hit(&run, k, &d.st.geometry, &d.st.start), DOM_OK);
        }
        (void)row_sample_end(s);
    }
    print_message("# %d of %d heads certainly keep falling\n", count[1], count[0]);
    assert_true(count[1] > 300 && count[1] > count[0] / 2);
}
