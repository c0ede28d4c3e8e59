/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures rows of 20 dominoes with random gaps: the number of rows per second on one core and on all cores,
 * and the cost of friction. */
#include "bench.h"

enum { DOMINOES = 20, ROWS = 2000, REPEATS = 3 };

/* Returns the number of rows per second, or 0 after a failure. */
static double rows_a_second(double growth, double mu, unsigned threads)
{
    struct setup train = setup_default();
    struct domq_scale scale = domq_scale_default();
    struct domq_domino domino[DOMINOES];
    struct dom_study study;
    train.r = growth;
    ask_row_of_train(&train, &scale, 1, domino, DOMINOES);
    struct row_setup row = {.domino = domino,
                            .count = DOMINOES,
                            .g = scale.g,
                            .push = 6,
                            .mu = mu,
                            .tol = train.tol,
                            .precision = IN_DOUBLE};
    struct dom_placement placement = {.error[DOM_ERROR_gap].size = 1e-4,
                                      .seed = 1,
                                      .rows = ROWS,
                                      .parallel = threads_tasks,
                                      .pool = &threads};
    double begun = seconds_now();
    if (ask_placement_study(&row, &placement, &study, NULL) != DOM_OK || study.fall != study.rows)
        return 0; /* a row that stops early takes less time than one that falls */
    return ROWS / (seconds_now() - begun);
}

struct rows_goals rows_print(void)
{
    struct rows_goals goals = {NONE, NONE};
    static const struct {
        const char *name;
        double growth, mu;
    } kinds[] = {{"equal", 1, 0},
                 {"equal, friction 0.2", 1, 0.2},
                 {"r = 1.3", 1.3, 0},
                 {"r = 1.3, friction 0.2", 1.3, 0.2}};
    printf("\nA study of placement: rows of %d dominoes to their verdict, all fall, %d rows\n", DOMINOES,
           ROWS);
    printf("  %-22s %16s %12s\n", "", "rows a second", "on all cores");
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        double one = 0, all = 0;
        for (int k = 0; k < REPEATS; k++) {
            one = fmax(one, rows_a_second(kinds[i].growth, kinds[i].mu, 1));
            all = fmax(all, rows_a_second(kinds[i].growth, kinds[i].mu, cores()));
        }
        printf("  %-22s %16.0f %9.2f x\n", kinds[i].name, one, all / one);
        if (kinds[i].growth > 1)
            *(kinds[i].mu > 0 ? &goals.friction : &goals.plain) = one > 0 ? 1 / one : NONE;
    }
    fflush(stdout);
    return goals;
}
