/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: parallel */
/* Needs: chance */
/* Rare situations: methods that cannot answer, an interrupted pool, and memory that runs out. */
#include "parallel/workers.h"
#include "support.h"
#include <errno.h>
#include <pthread.h>

/* Checks that the methods agree on the barrier and the duration. */
TEST(methods_agree)
{
    struct setup t = setup_default();
    struct domq_barrier ours, other;
    domq_real duration, by_method;
    t.tol = 1e-5;
    assert_status(ask_barrier_find(&t, &ours), DOM_OK);
    assert_status(ask_cycle_duration(&t, &duration), DOM_OK);
    for (int method = DOM_METHOD_GSL; method <= DOM_METHOD_PAPER; method++) {
        t.method = (enum dom_method)method;
        assert_status(ask_barrier_find(&t, &other), DOM_OK);
        assert_near("barrier", (double)other.barrier, (double)ours.barrier, 1e-3);
        assert_near("kinetic", (double)other.kinetic, (double)ours.kinetic, 1e-3);
        assert_status(ask_cycle_duration(&t, &by_method), DOM_OK);
        assert_near("duration", (double)by_method, (double)duration, 1e-3);
    }
}

/* Checks that the methods agree if even equal dominoes stop, and if the growth is limited by 1/s. */
TEST(methods_at_the_ends)
{
    struct setup t = setup_default();
    struct domq_limit limit;
    t.method = DOM_METHOD_GSL;
    t.d = 0.8;
    t.s = 0.9;
    struct setup ours = t;
    ours.method = DOM_METHOD_OURS;
    assert_status(ask_limit_rmax(&ours, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
    enum dom_status expected = limit.why;
    assert_status(ask_limit_rmax(&t, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
    assert_status(limit.why, expected);
    struct domq_barrier barrier;
    t.r = 1;
    assert_status(ask_barrier_find(&t, &barrier), DOM_NO_FUEL);
    assert_true(isnan((double)barrier.kinetic) && barrier.barrier > 0);
    t = setup_default();
    t.s = 0.95;
    t.tol = 1e-4;
    for (int method = DOM_METHOD_OURS; method <= DOM_METHOD_PAPER; method++) {
        t.method = (enum dom_method)method;
        assert_status(ask_limit_rmax(&t, &limit), DOM_OK);
        assert_int_equal(limit.ends, DOM_END_REACH);
        assert_near("r_max", (double)limit.r_max, 1 / 0.95, 1e-15);
    }
    /* The sums of the paper are infinite at r = 1. */
    t.r = 1;
    t.s = 0.4;
    assert_status(ask_barrier_find(&t, &barrier), DOM_TOO_LONG);
}

/* Checks that a number outside an enumeration has a text or NULL, and that no table is read beyond its
 * end. */
TEST(numbers_without_a_text)
{
    static const int number[] = {-1, 100, 12345678};
    for (size_t i = 0; i < sizeof number / sizeof *number; i++) {
        assert_string_equal(dom_end_text((enum dom_end)number[i]), "unknown");
        assert_string_equal(dom_event_text((enum dom_event_kind)number[i]), "unknown");
        assert_string_equal(dom_row_end_text((enum dom_row_end)number[i]), "unknown");
        assert_null(domq_effect((enum dom_effect_name)number[i]));
    }
    assert_string_equal(dom_end_text(DOM_END_REACH), "reach");
    assert_string_equal(dom_event_text(DOM_EVENT_HIT), "hit");
    assert_string_equal(dom_row_end_text(DOM_ROW_FALLS), "all fall");
    assert_string_equal(domq_effect(DOM_EFFECT_floor)->name, "floor");
}

/* Checks that the flag of the pool alone interrupts a study, and that nothing is written. */
TEST(an_interrupted_pool)
{
    const volatile sig_atomic_t now = 1;
    struct setup t = setup_default();
    struct domq_scale scale = domq_scale_default();
    struct domq_domino domino[5];
    struct row_setup row = row_setup_default(domino, 5, DOMQ_NAN);
    struct task_pool pool = {.threads = 2, .interrupt = &now};
    const struct dom_placement p = {
        .error[DOM_ERROR_gap].size = 0.001, .seed = 1, .rows = 40, .parallel = workers_tasks, .pool = &pool};
    struct dom_study study = {.low = -1};
    ask_row_of_train(&t, &scale, 1, domino, 5);
    assert_status(ask_placement_study(&row, &p, &study, NULL), DOM_INTERRUPTED);
    assert_true(study.low == -1);
}

/* ---- Failing allocations and threads: the linker redirects the library's calls to these functions ---- */

static long calls_left = -1; /* number of allocations until one fails; negative if none fails */
static bool no_threads;

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
int __real_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                          void *context);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                          void *context);

void *__wrap_malloc(size_t size)
{
    return calls_left >= 0 && calls_left-- == 0 ? NULL : __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    return calls_left >= 0 && calls_left-- == 0 ? NULL : __real_calloc(count, size);
}

int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                          void *context)
{
    return no_threads ? EAGAIN : __real_pthread_create(thread, attributes, run, context);
}

/* Makes each memory allocation of a computation fail in turn. Checks that each failure is reported, and that
 * all memory is freed. */
TEST(memory_runs_out)
{
    struct setup t = setup_default();
    struct domq_scale scale = domq_scale_default();
    struct domq_domino domino[5];
    struct row_setup row = row_setup_default(domino, 5, DOMQ_NAN);
    struct task_pool pool = {.threads = 2};
    struct dom_placement p = {
        .error[DOM_ERROR_gap].size = 0.001, .seed = 1, .rows = 40, .parallel = workers_tasks, .pool = &pool};
    struct domq_verdict verdict;
    struct dom_study study, alone;
    struct dom_budget budget;
    size_t stops[5];
    ask_row_of_train(&t, &scale, 1, domino, 5);
    enum { RUN, STUDY, BUDGET, QUESTIONS };
    for (int question = RUN; question < QUESTIONS; question++) {
        long failed = 0;
        no_threads = question == STUDY; /* without threads, the order of allocations is always the same */
        for (enum dom_status status = DOM_NO_MEMORY; status != DOM_OK; failed++) {
            calls_left = failed;
            status = question == RUN     ? ask_row_run(&row, true, NULL, NULL, &verdict)
                     : question == STUDY ? ask_placement_study(&row, &p, &study, stops)
                                         : ask_placement_budget(&row, &p, DOM_ERROR_gap, 0.9, &budget);
            calls_left = -1;
            assert_status(status, failed < 2000 && status != DOM_OK ? DOM_NO_MEMORY : DOM_OK);
            if (question == BUDGET && failed > 8)
                break; /* on several threads, the number of memory allocations varies */
        }
        assert_true(failed > 1);
    }
    /* The study above ran on a single thread. It must have the same result on several threads (i = 0) and
     * without a pool (i = 1). */
    no_threads = false;
    for (int i = 0; i < 2; i++) {
        assert_status(ask_placement_study(&row, &p, &alone, NULL), DOM_OK);
        assert_int_equal(alone.fall, study.fall);
        p.parallel = NULL;
    }
}
