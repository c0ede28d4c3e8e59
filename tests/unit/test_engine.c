/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows chance engine */
/*
 * The rigid-body engine: growths, which are those of the library where both can answer, and published and
 * known values where only the engine can; how its runs end; and how the library calls the engine of a caller.
 */
#include "engine/engine.h"
#include "support.h"
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <unistd.h>

enum { MOST = 14 };
#define THICK (7.0 / 48)

/* A row of hollow dominoes in the engine: the first is 1 tall, and g is 1. */
struct boxes {
    struct dom_domino box[MOST];
    struct engine_row engine;
    struct engine_hit hit[MOST];
    struct engine_fall fall;
};

static void boxes_make(struct boxes *b, double s, double r, size_t count, double push)
{
    b->engine.row =
        (struct dom_row){.domino = b->box, .count = count, .g = 1, .push = push, .feet = (double)INFINITY};
    b->engine.bounce = b->engine.bevel = 0;
    for (size_t k = 0; k < count; k++) {
        double h = pow(r, (double)k);
        b->box[k] =
            (struct dom_domino){.height = h, .thickness = THICK * h, .gap = k ? s * h : 0, .mass = h * h};
    }
}

static const struct engine_grain grain = {200, 1e-3};

static bool boxes_fall(struct boxes *b)
{
    assert_int_equal(engine_run(&b->engine, &grain, NULL, b->hit, NULL, NULL, &b->fall), DOM_OK);
    return b->fall.all;
}

/* ---- Loading ---- */

static atomic_int printed;
static atomic_bool is_over;

/* Prints the numbers from 0 on, one on each line. */
static void *numbers_print(void *nothing)
{
    for (int k = 0; !is_over; k++) {
        printf("%d\n", k);
        printed = k;
    }
    return nothing;
}

/* While the library is loaded, it prints nothing, and another thread loses no line. This is the first test,
 * because the library is loaded only once. */
TEST(standard_output_keeps_the_lines_of_other_threads)
{
    char line[80];
    pthread_t thread;
    FILE *lines = tmpfile();
    assert_non_null(lines);
    fflush(stdout);
    const int before = dup(STDOUT_FILENO);
    dup2(fileno(lines), STDOUT_FILENO);
    assert_int_equal(pthread_create(&thread, NULL, numbers_print, NULL), 0);
    while (printed < 1000)
        sched_yield();
    assert_int_equal(engine_load(), DOM_OK);
    for (const int at = printed; printed < at + 1000;)
        sched_yield();
    is_over = true;
    pthread_join(thread, NULL);
    fflush(stdout);
    dup2(before, STDOUT_FILENO);
    close(before);
    rewind(lines);
    for (int k = 0; k <= printed; k++) {
        char expected[80];
        snprintf(expected, sizeof expected, "%d\n", k);
        assert_non_null(fgets(line, sizeof line, lines));
        assert_string_equal(line, expected);
    }
    assert_null(fgets(line, sizeof line, lines));
    fclose(lines);
}

/* ---- Against known values ---- */

/* The row falls at a slightly smaller growth, and stops at a slightly larger one. */
TEST(growths_are_known)
{
    const double hinge = (double)INFINITY, degree = M_PI / 180;
    const struct {
        double s, mu, feet, bounce, slope, radius, r, push, off;
    } known[] = {
        {0.3, 0, hinge, 0, 0, 0, 1.8135, 8, 0.003},
        {0.2, 0.2, hinge, 0, 0, 0, 1.4847, 8, 0.003},
        {0.3, 0, hinge, 0, degree, 0, 1.9307, 8, 0.003},
        {0.3, 0, hinge, 0, 0, 0.01, 1.9358, 8, 0.005},
        /* Feet that slip: the row stops at a growth at which it falls on hinges. */
        {0.3, 0, 0.4, 0, 0, 0, 1.638, 8, 0.01},
        {0.4, 0, 0.5, 0, 0, 0, 1.917, 8, 0.01},
        {0.3, 0.2, 0.3, 0, 0, 0, 1.626, 8, 0.01},
        /* With friction between dominoes, the growth is close to the one on hinges, 1.674. */
        {0.3, 0.2, 0.5, 0, 0, 0, 1.679, 8, 0.01},
        {0.2, 0, hinge, 0.5, 0, 0, 1.407, 8, 0.01},
        {0.3, 0, hinge, 0.5, 0, 0, 1.716, 8, 0.01},
        {0.3, 0, hinge, 0.2, 0, 0, 1.8135, 8, 0.004},
        {0.2, 0, hinge, 0, -degree, 0, 1.48052, 8, 0.003},
        {0.3, 0, hinge, 0, 0, 0.02, 2.09291, 8, 0.005},
        {0.2, 0, 0.5, 0, 0, 0, 1.463, 8, 0.016},
        {0.4, 0.2, 0.2, 0, 0, 0, 1.611, 8, 0.016},
    };
    for (size_t i = 0; i < 2 * sizeof known / sizeof *known; i++) {
        struct boxes b;
        const bool falls = i % 2 == 0;
        const double r = known[i / 2].r * (1 + (falls ? -1 : 1) * known[i / 2].off);
        boxes_make(&b, known[i / 2].s, r, 12, known[i / 2].push);
        b.engine.row.mu = known[i / 2].mu;
        b.engine.row.feet = known[i / 2].feet;
        b.engine.bounce = known[i / 2].bounce;
        b.engine.row.alpha = known[i / 2].slope;
        b.engine.row.rho = known[i / 2].radius;
        if (boxes_fall(&b) != falls)
            fail_msg("row %zu of the table: %s at r %g", i / 2, falls ? "stops" : "falls", r);
    }
}

/* ---- How the engine runs ---- */

TEST(a_floor_without_friction_lets_feet_slide)
{
    struct boxes b;
    boxes_make(&b, 0.4, 1, 1, 0.6); /* a push above sqrt(2) would lift the domino at once */
    b.engine.row.feet = 0;
    assert_true(boxes_fall(&b));
    /* No force acts along the floor, so the centre keeps its speed. In the end the centre is half a height in
     * front of the foot. */
    double centre = b.engine.row.push / 2 * b.fall.seconds - THICK / 2;
    assert_near("slid", b.hit[0].slid, centre - 0.5, 0.01);
    b.engine.row.feet = 10;
    assert_true(boxes_fall(&b));
    assert_true(fabs(b.hit[0].slid) < 0.05);
}

TEST(settled_steps_no_longer_matter)
{
    struct boxes b;
    struct engine_fall fall;
    boxes_make(&b, 0.3, 1.3, 6, (double)NAN);
    b.engine.row.feet = 0.5;
    assert_int_equal(engine_settle(&b.engine, true, NULL, b.hit, &fall), DOM_OK);
    assert_true(fall.same && fall.all && fall.change < ENGINE_AGREES);
    assert_true(fall.grain.steps >= 2 * engine_coarsest.steps);
    /* If the first box tips over its edge, times are measured from the first hit. */
    assert_true(isnan(b.hit[0].time));
    assert_true(b.hit[1].time == 0 && b.hit[2].time > 0);
}

/* Checks that coarse runs, which end as soon as the verdict is certain, have the verdict of a fine run to the
 * end. */
TEST(verdicts_of_coarse_steps)
{
    static const struct engine_grain fine = {800, 1e-4};
    uint64_t seed = 5;
    int falls = 0, coarse[2] = {0, 0};
    for (int i = 0; i < 24; i++) {
        struct boxes b;
        struct engine_fall fall;
        boxes_make(&b, 0.1 + 0.5 * random_unit(&seed), 1 + 1.2 * random_unit(&seed), 5,
                   4 * random_unit(&seed));
        b.engine.row.feet = i % 4 == 0 ? (double)INFINITY : 0.2 + 0.6 * random_unit(&seed);
        b.engine.row.mu = i % 3 == 0 ? 0 : 0.3 * random_unit(&seed);
        b.engine.row.rho = i % 5 == 0 ? 0.02 : 0;
        b.engine.row.alpha = i % 7 == 0 ? 0.02 : 0;
        assert_int_equal(engine_settle(&b.engine, false, NULL, NULL, &fall), DOM_OK);
        assert_int_equal(engine_run(&b.engine, &fine, NULL, b.hit, NULL, NULL, &b.fall), DOM_OK);
        assert_int_equal(fall.all, b.fall.all);
        falls += b.fall.all;
        coarse[b.fall.all] += fall.grain.steps < engine_coarsest.steps;
    }
    print_message("# %d of 24 rows fall; coarse steps decide %d of them, and %d of the others\n", falls,
                  coarse[1], coarse[0]);
    assert_true(falls > 6 && falls < 18 && coarse[0] > 2 && coarse[1] > 4);
}

TEST(rows_end)
{
    struct boxes b;
    boxes_make(&b, 0.4, 1, 4, 0.1); /* too weak a push */
    assert_false(boxes_fall(&b));
    assert_int_equal(b.fall.hits, 1);
    assert_false(b.fall.lies);
    boxes_make(&b, 0.4, 1, 4, 3);
    b.box[2].gap = 1.2; /* out of reach */
    assert_false(boxes_fall(&b));
    assert_int_equal(b.fall.hits, 2);
    assert_true(b.fall.lies);
    boxes_make(&b, 0.05, 1, 4, (double)NAN); /* touches the next box before it tips over */
    assert_false(boxes_fall(&b));
    assert_true(b.fall.leans);
    const volatile sig_atomic_t raised = 1;
    boxes_make(&b, 0.4, 1, 4, 3);
    assert_int_equal(engine_run(&b.engine, &grain, &raised, NULL, NULL, NULL, &b.fall), DOM_INTERRUPTED);
}

/* ---- The engine of a caller ---- */

/* An engine in which rows fall if domino 2 is at most 1.2345 times as tall as domino 1. */
static enum dom_status in_limits(const struct dom_row *row, const struct dom_compute *compute, bool times,
                                 dom_fall_visit *visit, void *context, struct dom_verdict *verdict)
{
    (void)compute, (void)times, (void)visit, (void)context;
    ++*(int *)row->engine->context;
    *verdict = (struct dom_verdict){
        .end = row->domino[1].height <= 1.2345 * row->domino[0].height ? DOM_ROW_FALLS : DOM_ROW_MISSES,
        .domino = 2};
    return DOM_OK;
}

TEST(the_library_asks_an_engine)
{
    int runs = 0;
    const struct dom_engine engine = {.run = in_limits, .context = &runs};
    struct dom_domino domino[3];
    struct dom_verdict verdict;
    struct dom_study study;
    for (size_t k = 0; k < 3; k++)
        domino[k] =
            (struct dom_domino){.height = pow(1.3, (double)k), .thickness = 0.1, .gap = 0.1, .mass = 1};
    struct dom_row row = {.domino = domino, .count = 3, .g = 1, .push = 1, .engine = &engine};
    assert_status(dom_row_run(&row, NULL, true, NULL, NULL, &verdict), DOM_OK);
    assert_int_equal(verdict.end, DOM_ROW_MISSES);
    const struct dom_placement placement = {
        .error = {[DOM_ERROR_gap].size = 0, [DOM_ERROR_height].size = 0.1}, .seed = 1, .rows = 200};
    assert_status(dom_placement_study(&row, NULL, &placement, &study, NULL), DOM_OK);
    /* whether a row falls depends on the random ratio of its first two heights */
    assert_true(study.fall > 20 && study.fall < 180 && runs == 201);
}
