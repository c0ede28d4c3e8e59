/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The public API of rows, counts, scales and effects, in both headers; and the simple functions. */
#include "support.h"
#include <float.h>

/* What numbers may differ by, relatively: a rounding, or what becomes of those in the sizes of a row. */
static double rounding = DBL_EPSILON;

#define SAME(member) assert_in_both(#member, d.member, q.member, rounding)

/* ---- Rows ---- */

enum { ROW = 6 };

struct fallen {
    struct dom_fall fall[ROW];
    int count;
};

struct fallenq {
    struct domq_fall fall[ROW];
    int count;
};

static bool fall_seen(const struct dom_fall *fall, void *context)
{
    struct fallen *seen = context;
    seen->fall[seen->count++] = *fall;
    return true;
}

static bool fall_seenq(const struct domq_fall *fall, void *context)
{
    struct fallenq *seen = context;
    seen->fall[seen->count++] = *fall;
    return true;
}

/* The same row for both headers: of a train of this growth, pushed or not, with friction or not. */
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
        r->dominoq[k] = (struct domq_domino){r->domino[k].height, r->domino[k].thickness, r->domino[k].gap,
                                             r->domino[k].mass};
    r->row = (struct dom_row){r->domino, ROW, scale.g, push, mu, mu == 0};
    r->rowq = (struct domq_row){r->dominoq, ROW, scale.g, push, mu, mu == 0};
    r->compute = dom_compute_default();
    r->computeq = domq_compute_default();
    r->compute.precision = r->computeq.precision = precision;
    r->compute.tol = precision == DOM_FLOAT ? 1e-5 : 1e-11;
    r->computeq.tol = r->compute.tol;
}

static void fall_same(const struct dom_fall *fall, const struct domq_fall *wide)
{
    const struct dom_fall d = *fall;
    const struct domq_fall q = *wide;
    SAME(time), SAME(duration), SAME(omega), SAME(kinetic), SAME(barrier), SAME(margin), SAME(lost);
    assert_true(fabs(d.friction_work - (double)q.friction_work) <= rounding * d.kinetic ||
                isnan(d.friction_work));
    SAME(theta_m), SAME(theta), SAME(floor_motion), SAME(floor_hit);
    assert_true(d.domino == q.domino && d.moving == q.moving && d.floor_domino == q.floor_domino);
}

static void row_same(const struct rows *r)
{
    struct fallen seen = {.count = 0};
    struct fallenq seenq = {.count = 0};
    struct dom_verdict d = {0};
    struct domq_verdict q = {0};
    enum dom_status status = dom_row_run(&r->row, &r->compute, true, fall_seen, &seen, &d);
    assert_status(domq_row_run(&r->rowq, &r->computeq, true, fall_seenq, &seenq, &q), status);
    assert_status(status, DOM_OK);
    assert_int_equal(d.end, q.end);
    assert_int_equal(d.domino, q.domino);
    assert_int_equal(d.weakest, q.weakest);
    SAME(short_by), SAME(seconds), SAME(spare);
    assert_int_equal(seen.count, seenq.count);
    for (int k = 0; k < seen.count; k++)
        fall_same(&seen.fall[k], &seenq.fall[k]);
}

static void rows(void **state)
{
    (void)state;
    static const double some[][3] = {{1.1, NAN, 0}, {1.3, 5, 0}, {1.9, NAN, 0}, {1.05, 8, 0.2}, {1, 0.5, 0}};
    struct rows r;
    rounding = 1e-11;
    for (size_t i = 0; i < sizeof some / sizeof *some; i++)
        for (enum dom_precision p = DOM_FLOAT; p <= DOM_QUAD; p++)
            if (dom_arithmetic(p)->bits) {
                rows_make(&r, some[i][0], some[i][1], some[i][2], p);
                row_same(&r);
            }
    rounding = DBL_EPSILON;
}

static void studies(void **state)
{
    (void)state;
    struct rows r;
    const struct dom_placement p = {.sigma = 0.01, .heights = 0.01, .seed = 3, .rows = 40, .threads = 1};
    const struct domq_placement pq = {
        .sigma = p.sigma, .heights = p.heights, .seed = 3, .rows = 40, .threads = 1};
    struct dom_study study;
    struct domq_study studyq;
    struct dom_budget budget;
    struct domq_budget budgetq;
    size_t stops[ROW], stopsq[ROW];
    rows_make(&r, 1.3, 6, 0, DOM_DOUBLE);
    assert_status(dom_placement_study(&r.row, &r.compute, &p, &study, stops), DOM_OK);
    assert_status(domq_placement_study(&r.rowq, &r.computeq, &pq, &studyq, stopsq), DOM_OK);
    assert_true(study.rows == 40 && study.fall == studyq.fall && study.unknown == studyq.unknown);
    assert_true(study.low == studyq.low && study.high == studyq.high && study.low < study.high);
    assert_memory_equal(stops, stopsq, sizeof stops);
    study.low = studyq.low = 2;
    assert_status(dom_study_interval(&study), DOM_OK);
    assert_status(domq_study_interval(&studyq), DOM_OK);
    assert_true(study.low == studyq.low && study.low <= 1);
    assert_status(dom_placement_budget(&r.row, &r.compute, &p, 0.8, &budget), DOM_OK);
    assert_status(domq_placement_budget(&r.rowq, &r.computeq, &pq, 0.8, &budgetq), DOM_OK);
    assert_near("sigma", budget.sigma, budgetq.sigma, 1e-9);
    assert_true(budget.low <= budget.sigma && budget.sigma <= budget.high);
}

/* ---- Counts, scales, effects ---- */

static void counts(void **state)
{
    (void)state;
    for (enum dom_precision p = DOM_FLOAT; p <= DOM_QUAD; p++)
        for (int errors = 0; errors <= 1 && dom_arithmetic(p)->bits; errors++) {
            struct dom_compute compute = dom_compute_default();
            struct domq_compute computeq = domq_compute_default();
            struct dom_count d;
            struct domq_count q;
            compute.precision = computeq.precision = p;
            compute.errors = computeq.errors = errors;
            assert_status(dom_count_find(0.048, 112, 1.5, &compute, &d), DOM_OK);
            assert_status(domq_count_find(0.048, 112, 1.5, &computeq, &q), DOM_OK);
            SAME(dominoes), SAME(exact), SAME(last), SAME(error.exact), SAME(error.last);
            assert_true(d.dominoes == 20 && isnan(d.error.exact) == !errors);
        }
}

static void scales_and_lists(void **state)
{
    (void)state;
    struct dom_train t = dom_train_default();
    struct dom_scale d = dom_scale_default();
    struct domq_scale q = domq_scale_default();
    SAME(h), SAME(g);
    assert_in_both("tau", dom_scale_tau(&d, t.d), domq_scale_tau(&q, domq_train_default().d), rounding);
    const struct domq_train tq = domq_train_default();
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
    for (int k = 0; k < DOM_EFFECT_COUNT; k++) {
        const struct dom_effect *e = dom_effect((enum dom_effect_name)k);
        const struct domq_effect *eq = domq_effect((enum dom_effect_name)k);
        assert_string_equal(e->name, eq->name);
        assert_string_equal(e->help, eq->help);
        assert_int_equal(e->needs, eq->needs);
        for (int i = 0; i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++) {
            assert_string_equal(e->argument[i].name, eq->argument[i].name);
            assert_in_both("lowest", e->argument[i].lowest, eq->argument[i].lowest, rounding);
            assert_in_both("highest", e->argument[i].highest, eq->argument[i].highest, rounding);
            assert_in_both("usual", e->argument[i].usual, eq->argument[i].usual, rounding);
        }
    }
}

/* ---- The simple functions ---- */

static void simple(void **state)
{
    (void)state;
    struct dom_train t = dom_train_default();
    const struct dom_scale scale = dom_scale_default();
    struct dom_limit limit;
    struct dom_value duration;
    t.s = 0.3;
    t.d = 0.2;
    t.q = 3;
    assert_status(dom_limit_rmax(&t, NULL, &limit), DOM_OK);
    assert_true(dom_rmax(0.3, 0.2, 3) == limit.r_max);
    assert_in_both("rmax", limit.r_max, domq_rmax(0.3, t.d, 3), rounding); /* to 1e-12 of it below */
    assert_true(isnan(dom_rmax(2, 0.2, 3)) && isnan(dom_rmax(0.3, -1, 3)) && isnan(dom_rmax(0.3, 1.5, NAN)));
    assert_true(isnan(dom_rmax(0.3, 1.5, 3))); /* no growth */
    assert_true(dom_dominoes(0.048, 112, 1.5) == 20 && domq_dominoes(0.048, 112, 1.5) == 20);
    assert_true(isinf(dom_dominoes(0.048, 112, 1)) && isnan(dom_dominoes(0.048, 112, 0.9)));
    assert_true(isnan(dom_dominoes(0, 112, 1.5)) && isnan(dom_dominoes(0.048, NAN, 1.5)));
    t = dom_train_default();
    t.r = 1;
    assert_status(dom_cycle_duration(&t, NULL, &duration), DOM_OK);
    assert_near("speed", dom_speed(scale.h, t.s, t.d), dom_scale_speed(&scale, &t, duration.value), 1e-15);
    assert_near("wide speed", (double)domq_speed(scale.h, t.s, t.d), dom_speed(scale.h, t.s, t.d), 1e-11);
    assert_true(isnan(dom_speed(0, 0.4, 0.15)) && isnan(dom_speed(NAN, 0.4, 0.15)));
    assert_true(isnan(dom_speed(0.048, 2, 0.15)) && isnan(dom_speed(0.048, 0.001, 1)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows),   cmocka_unit_test(studies),
        cmocka_unit_test(counts), cmocka_unit_test(scales_and_lists),
        cmocka_unit_test(simple),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
