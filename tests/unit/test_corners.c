/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: parallel */
/* Needs: chance */
/* Rare situations: an interrupted pool, and memory that runs out. */
#include "parallel/workers.h"
#include "support.h"
#include <errno.h>
#include <pthread.h>

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
    assert_string_equal(domq_effect(DOM_EFFECT_release)->name, "release");
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
