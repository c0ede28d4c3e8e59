/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows chance */
/* The public API of rows, counts, scales and effects, in both headers, and the simple functions. */
#include "support.h"
#include <float.h>

/* The largest allowed relative difference: a rounding error, or the effect of rounding errors in the sizes of
 * a row. */
static double rounding = DBL_EPSILON;

#define SAME(member) assert_in_both(#member, d.member, q.member, rounding)

/* ---- Rows ---- */

enum { ROW = 6 };

/* The same row in both headers: a row of a train, with or without a push, and with or without friction. */
struct rows {
    struct dom_domino domino[ROW];
    struct domq_domino dominoq[ROW];
    struct dom_row row;
    struct domq_row rowq;
    struct dom_compute compute;
    struct domq_compute computeq;
};

static void rows_make(struct rows *r, double growth, double push, double mu, enum dom_precision precision)
{
    struct dom_train train = dom_train_default();
    const struct dom_scale scale = dom_scale_default();
    train.r = growth;
    dom_row_of_train(&train, &scale, 1, r->domino, ROW);
    for (int k = 0; k < ROW; k++)
        r->dominoq[k] = (struct domq_domino){r->domino[k].height,
                                             r->domino[k].thickness,
                                             r->domino[k].gap,
                                             r->domino[k].mass,
                                             0,
                                             r->domino[k].lean,
                                             0};
    r->row = (struct dom_row){
        .domino = r->domino, .count = ROW, .g = scale.g, .push = push, .mu = mu, .floor = mu == 0};
    r->rowq = (struct domq_row){
        .domino = r->dominoq, .count = ROW, .g = scale.g, .push = push, .mu = mu, .floor = mu == 0};
    r->compute = dom_compute_default();
    r->computeq = domq_compute_default();
    r->compute.precision = r->computeq.precision = precision;
    r->compute.tol = precision == DOM_FLOAT ? 1e-5 : 1e-11;
    r->computeq.tol = r->compute.tol;
}

/* The falls of a run by <domino.h>. The run by <domino_quad.h> is compared with these. */
struct fallen {
    struct dom_fall fall[ROW];
    int count, compared;
};

static bool fall_seen(const struct dom_fall *fall, void *context)
{
    struct fallen *seen = context;
    seen->fall[seen->count++] = *fall;
    return true;
}

static bool fall_same(const struct domq_fall *fall, void *context)
{
    struct fallen *seen = context;
    const struct dom_fall d = seen->fall[seen->compared++];
    const struct domq_fall q = *fall;
    SAME(time), SAME(duration), SAME(omega), SAME(kinetic), SAME(barrier), SAME(margin), SAME(lost);
    assert_true(fabs(d.friction_work - (double)q.friction_work) <= rounding * d.kinetic ||
                isnan(d.friction_work));
    SAME(theta_m), SAME(theta), SAME(floor_motion), SAME(floor_hit);
    assert_true(d.domino == q.domino && d.moving == q.moving && d.floor_domino == q.floor_domino);
    return true;
}

static void row_same(const struct rows *r)
{
    struct fallen seen = {.count = 0};
    struct dom_verdict d = {0};
    struct domq_verdict q = {0};
    assert_status(dom_row_run(&r->row, &r->compute, true, fall_seen, &seen, &d), DOM_OK);
    assert_status(domq_row_run(&r->rowq, &r->computeq, true, fall_same, &seen, &q), DOM_OK);
    SAME(end), SAME(domino), SAME(weakest), SAME(short_by), SAME(seconds), SAME(spare);
    assert_int_equal(seen.count, seen.compared);
}

TEST(rows)
{
    static const double some[][3] = {{1.1, NAN, 0}, {1.3, 5, 0}, {1.9, NAN, 0}, {1.05, 8, 0.2}, {1, 0.5, 0}};
    struct rows r;
    rounding = 1e-11;
    for (size_t i = 0; i < sizeof some / sizeof *some; i++)
        for (enum dom_precision p = DOM_FLOAT; p <= DOM_QUAD; p++)
            if (dom_arithmetic(p)->bits) {
                rows_make(&r, some[i][0], some[i][1], some[i][2], p);
                row_same(&r);
                r.domino[1].lean = -0.03125;
                r.domino[3].lean = 0.0625;
                for (int k = 1; k < ROW; k += 2)
                    r.dominoq[k].lean = r.domino[k].lean;
                row_same(&r);
            }
    rounding = DBL_EPSILON;
}

/* ---- Searches and studies: in double, whatever the precision is ---- */

static void row_of_growth(double growth, struct dom_domino *domino, size_t count, void *context)
{
    const struct dom_scale scale = dom_scale_default();
    struct dom_train train = dom_train_default();
    (void)context;
    train.r = growth;
    dom_row_of_train(&train, &scale, 1, domino, count);
}

static void part_done(size_t done, size_t of, void *context)
{
    size_t *parts = context;
    assert_true(done == *parts + 1 && done <= of);
    *parts = done;
}

/* What the searches find for a row. */
struct found {
    struct dom_row_growth growth;
    struct dom_mend mends[DOM_MENDS];
    struct dom_window windows[DOM_WINDOW_LEAN + 1][ROW];
    size_t count;
    double push;
};

static void search_all(enum dom_precision precision, double tol, struct found *found)
{
    struct rows r;
    size_t parts = 0;
    memset(found, 0, sizeof *found);
    rows_make(&r, 1.3, 6, 0, precision);
    r.compute.tol = tol;
    assert_status(dom_row_rmax(&r.row, &r.compute, 2.5, row_of_growth, NULL, &found->growth), DOM_OK);
    for (enum dom_window_of of = DOM_WINDOW_GAP; of <= DOM_WINDOW_LEAN; of++)
        assert_status(dom_row_windows(&r.row, &r.compute, of, NULL, NULL, found->windows[of]), DOM_OK);
    r.domino[3].gap *= 2.2;
    assert_status(dom_row_mend(&r.row, &r.compute, part_done, &parts, found->mends, &found->count), DOM_OK);
    assert_true(found->count > 0 && parts > 0);
    rows_make(&r, 1.3, 0.2, 0, precision);
    r.compute.tol = tol;
    assert_status(dom_row_weakest_push(&r.row, &r.compute, 100, &found->push), DOM_OK);
}

TEST(growths_mends_and_pushes)
{
    static struct found found, same;
    search_all(DOM_DOUBLE, 1e-12, &found);
    assert_true(found.growth.r_max > 1 && found.growth.r_max < 2.5 && found.push > 0.2);
    for (size_t k = 0; k + 1 < ROW; k++)
        assert_true(found.windows[DOM_WINDOW_GAP][k].low < found.windows[DOM_WINDOW_GAP][k].high);
    search_all(DOM_FLOAT, 1e-12, &same);
    assert_memory_equal(&same, &found, sizeof same);
    search_all(DOM_QUAD, 1e-12, &same);
    assert_memory_equal(&same, &found, sizeof same);
    search_all(DOM_QUAD, 1e-30, &same); /* double has no such tolerance; its default takes its place */
    assert_memory_equal(&same, &found, sizeof same);
}

/* Checks that what is found can be typed: the lower ends of windows have seven digits, and a push
 * has four. */
TEST(ends_have_few_digits)
{
    static struct found found;
    char digits[32];
    search_all(DOM_DOUBLE, 1e-12, &found);
    for (int of = DOM_WINDOW_GAP; of <= DOM_WINDOW_HEIGHT; of++)
        for (size_t k = 0; k + 1 < ROW; k++) {
            const struct dom_window *w = &found.windows[of][k];
            snprintf(digits, sizeof digits, "%.7g", w->low);
            assert_true(w->below == DOM_ROW_FALLS || strtod(digits, NULL) == w->low);
        }
    snprintf(digits, sizeof digits, "%.4g", found.push);
    assert_true(strtod(digits, NULL) == found.push);
}

/* Runs tasks from the last to the first and counts them. */
static enum dom_status last_first(size_t count, dom_task *task, void *context, void *pool)
{
    size_t *tasks = pool;
    for (size_t k = count; k-- > 0; ++*tasks)
        task(k, context);
    return DOM_OK;
}

TEST(studies)
{
    struct rows r;
    size_t tasks = 0;
    const struct dom_placement p = {
        .error = {[DOM_ERROR_gap].size = 0.01, [DOM_ERROR_thickness] = {0.1, true}}, .seed = 3, .rows = 40};
    struct dom_placement parallel = p;
    parallel.parallel = last_first;
    parallel.pool = &tasks;
    struct dom_study study, same, causes;
    struct dom_budget budget, budget_same;
    size_t stops[ROW], stops_same[ROW], without[DOM_ERROR_COUNT], all[(1 + DOM_ERROR_COUNT) * ROW];
    rows_make(&r, 1.3, 6, 0, DOM_DOUBLE);
    assert_status(dom_placement_study(&r.row, &r.compute, &p, &study, stops), DOM_OK);
    assert_status(dom_placement_budget(&r.row, &r.compute, &p, DOM_ERROR_gap, 0.8, &budget), DOM_OK);
    assert_true(study.rows == 40 && study.low < study.high && study.fall > 0 && study.fall < 40);
    assert_true(budget.low <= budget.sigma && budget.sigma <= budget.high);
    for (enum dom_precision precision = DOM_FLOAT; precision <= DOM_QUAD; precision++) {
        r.compute.precision = precision;
        assert_status(dom_placement_study(&r.row, &r.compute, &parallel, &same, stops_same), DOM_OK);
        assert_memory_equal(&same, &study, sizeof same);
        assert_memory_equal(stops_same, stops, sizeof stops);
        assert_status(dom_placement_budget(&r.row, &r.compute, &p, DOM_ERROR_gap, 0.8, &budget_same), DOM_OK);
        assert_memory_equal(&budget_same, &budget, sizeof budget);
    }
    assert_true(tasks > 0);
    assert_status(dom_placement_causes(&r.row, &r.compute, &p, &causes, without, all), DOM_OK);
    assert_memory_equal(&causes, &study, sizeof study);
    assert_memory_equal(all, stops, r.row.count * sizeof *all);
    /* A study without the error of the thickness counts as many rows as `without`. */
    struct dom_placement alone = p;
    alone.error[DOM_ERROR_thickness].size = 0;
    assert_status(dom_placement_study(&r.row, &r.compute, &alone, &causes, NULL), DOM_OK);
    assert_int_equal(causes.fall, without[DOM_ERROR_thickness]);
    assert_int_equal(without[DOM_ERROR_mass], study.fall); /* the masses have no error */
    study.low = 2;
    assert_status(dom_study_interval(&study), DOM_OK);
    assert_true(study.low == same.low);
}

/* ---- Counts, scales, arithmetic ---- */

TEST(counts)
{
    for (enum dom_precision p = DOM_FLOAT; p <= DOM_QUAD; p++)
        if (dom_arithmetic(p)->bits) {
            struct dom_compute compute = dom_compute_default();
            struct domq_compute computeq = domq_compute_default();
            struct dom_count d;
            struct domq_count q;
            compute.precision = computeq.precision = p;
            assert_status(dom_count_find(0.048, 112, 1.5, &compute, &d), DOM_OK);
            assert_status(domq_count_find(0.048, 112, 1.5, &computeq, &q), DOM_OK);
            SAME(dominoes), SAME(exact), SAME(last);
            assert_true(d.dominoes == 20);
        }
}

TEST(scales_and_precisions)
{
    struct dom_train t = dom_train_default();
    struct dom_scale d = dom_scale_default();
    struct domq_scale q = domq_scale_default();
    SAME(h), SAME(g);
    struct domq_train tq = domq_train_default();
    assert_in_both("tau", dom_scale_tau(&d, &t), domq_scale_tau(&q, &tq), rounding);
    t.walls = 0.02, tq.walls = 0.02;
    assert_in_both("tau of a box", dom_scale_tau(&d, &t), domq_scale_tau(&q, &tq), rounding);
    t.walls = tq.walls = 0;
    assert_near("speed", dom_scale_speed(&d, &t, 9), (double)domq_scale_speed(&q, &tq, 9), 4 * DBL_EPSILON);
    for (enum dom_precision p = DOM_FLOAT; p <= DOM_QUAD; p++) {
        const struct dom_arithmetic *a = dom_arithmetic(p);
        const struct domq_arithmetic *aq = domq_arithmetic(p);
        assert_string_equal(a->name, aq->name);
        assert_string_equal(a->type, aq->type);
        assert_true(a->bits == aq->bits && a->digits == aq->digits && a->epsilon == aq->epsilon);
        assert_in_both("tol_default", a->tol_default, aq->tol_default, rounding);
        assert_in_both("tol_floor", a->tol_floor, aq->tol_floor, rounding);
    }
}

/* ---- Effects ---- */

static void text_same(const char *text, const char *wide)
{
    assert_int_equal(!text, !wide);
    if (text)
        assert_string_equal(text, wide);
}

static void effect_same(const struct dom_effect *e, const struct domq_effect *eq)
{
    text_same(e->name, eq->name), text_same(e->adds, eq->adds), text_same(e->help, eq->help);
    text_same(e->source, eq->source), text_same(e->plan, eq->plan);
    text_same(e->dissipates, eq->dissipates);
    assert_true(e->needs == eq->needs && !e->equations == !eq->equations);
    for (int i = 0; e->equations && (i == 0 || e->equations[i - 1]); i++)
        text_same(e->equations[i], eq->equations[i]);
    for (int i = 0; i < DOM_EFFECT_ARGUMENTS; i++) {
        const struct dom_effect_argument d = e->argument[i];
        const struct domq_effect_argument q = eq->argument[i];
        text_same(d.name, q.name);
        if (!d.name)
            break;
        text_same(d.unit, q.unit), text_same(d.meaning, q.meaning), text_same(d.or_file, q.or_file);
        SAME(lowest), SAME(highest), SAME(usual);
        assert_true(d.optional == q.optional && d.whole == q.whole);
    }
}

/* Checks that each effect has its number and its name, and that the law without effects has a description. */
TEST(effects)
{
    for (int k = 0; k < DOM_EFFECT_COUNT; k++)
        effect_same(dom_effect((enum dom_effect_name)k), domq_effect((enum dom_effect_name)k));
    effect_same(&dom_energy_balance, &domq_energy_balance);
    effect_same(&dom_equation_of_motion, &domq_equation_of_motion);
#define NAMED(effect)                                                                                        \
    assert_ptr_equal(dom_effect(DOM_EFFECT_##effect), &dom_effect_##effect);                                 \
    assert_ptr_equal(domq_effect(DOM_EFFECT_##effect), &domq_effect_##effect);                               \
    assert_string_equal(dom_effect_##effect.name, #effect);
#define NAMED_DYNAMICS(effect, member, status) NAMED(effect)
    DOM_DYNAMICS(NAMED_DYNAMICS)
    DOM_EFFECTS(NAMED)
}

/* Checks dom_first_effect and dom_law for a train without effects, and with one effect at a time. */
TEST(laws)
{
    struct dom_train t = dom_train_default();
    struct domq_train tq = domq_train_default();
    assert_true(!dom_first_effect(&t) && !domq_first_effect(&tq));
    assert_ptr_equal(dom_law(&t), &dom_energy_balance);
    assert_ptr_equal(domq_law(&tq), &domq_energy_balance);
#define LAW(effect, member, status)                                                                          \
    t.member = tq.member = dom_effect_##effect.argument[0].highest;                                          \
    assert_ptr_equal(dom_first_effect(&t), dom_effect_##effect.cancels ? NULL : &dom_effect_##effect);       \
    assert_ptr_equal(domq_first_effect(&tq), domq_effect_##effect.cancels ? NULL : &domq_effect_##effect);   \
    assert_ptr_equal(dom_law(&t),                                                                            \
                     dom_effect_##effect.dissipates ? &dom_equation_of_motion : &dom_energy_balance);        \
    assert_ptr_equal(domq_law(&tq),                                                                          \
                     domq_effect_##effect.dissipates ? &domq_equation_of_motion : &domq_energy_balance);     \
    t.member = tq.member = 0;
    DOM_DYNAMICS(LAW)
}

/* ---- The simple functions ---- */

TEST(simple)
{
    struct dom_train t = dom_train_default();
    const struct dom_scale scale = dom_scale_default();
    struct dom_limit limit;
    double duration;
    t.s = 0.3;
    t.d = 0.2;
    t.q = 3;
    assert_status(dom_limit_rmax(&t, NULL, &limit), DOM_OK);
    assert_true(dom_rmax(0.3, 0.2, 3) == limit.r_max);
    assert_in_both("rmax", limit.r_max, domq_rmax(0.3, t.d, 3), rounding);
    assert_true(isnan(dom_rmax(2, 0.2, 3)) && isnan(dom_rmax(0.3, -1, 3)) && isnan(dom_rmax(0.3, 1.5, NAN)));
    assert_true(isnan(dom_rmax(0.3, 1.5, 3))); /* no growth */
    assert_true(dom_dominoes(0.048, 112, 1.5) == 20 && domq_dominoes(0.048, 112, 1.5) == 20);
    assert_true(isinf(dom_dominoes(0.048, 112, 1)) && isnan(dom_dominoes(0.048, 112, 0.9)));
    assert_true(isnan(dom_dominoes(0, 112, 1.5)) && isnan(dom_dominoes(0.048, NAN, 1.5)));
    t = dom_train_default();
    t.r = 1;
    assert_status(dom_cycle_duration(&t, NULL, &duration), DOM_OK);
    assert_near("speed", dom_speed(scale.h, t.s, t.d), dom_scale_speed(&scale, &t, duration), 1e-15);
    assert_near("wide speed", (double)domq_speed(scale.h, t.s, t.d), dom_speed(scale.h, t.s, t.d), 1e-11);
    assert_true(isnan(dom_speed(0, 0.4, 0.15)) && isnan(dom_speed(NAN, 0.4, 0.15)));
    assert_true(isnan(dom_speed(0.048, 2, 0.15)) && isnan(dom_speed(0.048, 0.001, 1)));
}

/* Checks that a default row needs only its dominoes, and that the library is as new as its header. */
TEST(row_default)
{
    const struct dom_domino domino[] = {{.height = 0.05, .thickness = 0.008, .mass = 0.01},
                                        {.height = 0.05, .thickness = 0.008, .gap = 0.02, .mass = 0.01}};
    struct dom_verdict verdict;
    struct dom_row row = dom_row_default();
    row.domino = domino;
    assert_status(dom_row_run(&row, NULL, false, NULL, NULL, &verdict), DOM_BAD_COUNT);
    row.count = 2;
    assert_status(dom_row_run(&row, NULL, false, NULL, NULL, &verdict), DOM_OK);
    assert_int_equal(verdict.end, DOM_ROW_FALLS);
    assert_true(row.g == dom_scale_default().g && isnan(row.push) && row.mu == 0 && row.rho == 0);
    assert_string_equal(dom_version(), DOM_VERSION);
}
