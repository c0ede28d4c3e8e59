/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the design that falls with a given probability. It tries larger and larger numbers of dominoes. For
 * each number, it runs random rows and counts how many of them fall. */
#include "chance/chance.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "planning/designs.h"
#include "planning/planning.h"
#include <stdlib.h>

/* The search ends when it reaches DOMINOES_MOST dominoes, or when it has tested DESIGNS_MOST designs with
 * random rows. */
enum { DOMINOES_MOST = 200, DESIGNS_MOST = 40 };

/* The table also shows this many designs with more dominoes than necessary. */
enum { BEYOND = 2 };

/* The results for a given number of dominoes. */
struct tried {
    size_t count;
    domq_real length, mass;
    struct dom_study study;
};

/* Returns the number of random rows to run. If each row falls with this probability, at least 20 of them (10
 * in the engine) are then expected not to fall. With fewer failures, the measured probability would be too
 * uncertain. */
static size_t rows_for(domq_real probability, bool engine)
{
    const size_t rows = (size_t)(double)quad(ceil)((engine ? 10 : 20) / (1 - probability)),
                 least = engine ? 100 : 2000;
    return rows > least ? rows : least;
}

static void table_write(struct answer *a, const struct tried *tried, size_t count, bool has_masses)
{
    static const struct column columns[] = {
        {"dominoes", "", "", 8},   {"length", "m", "", 9},  {"mass", "kg", "", 9},
        {"relative", "", "", 9},   {"fail", "", "", 6},     {"rows", "", "", 7},
        {"falls", "share", "", 9}, {"low", "share", "", 9}, {NULL, NULL, NULL, 0},
    };
    struct answer list = {.out = answer_rest(a), .style = a->style, .columns = columns, .rows = true};
    list.style.errors = false;
    answer_leave_out(&list, has_masses ? "relative" : "mass");
    for (size_t i = 0; i < count; i++)
        answer_announce(&list, "mass", tried[i].mass);
    for (size_t i = 0; i < count && !answer_lost(&list); i++) {
        const struct tried *t = &tried[i];
        struct cell cells[] = {cell_count((domq_real)t->count),
                               cell_real(t->length),
                               cell_real(t->mass),
                               cell_real(t->mass),
                               cell_count((domq_real)(t->study.rows - t->study.fall)),
                               cell_count((domq_real)t->study.rows),
                               cell_real((domq_real)t->study.fall / (domq_real)t->study.rows),
                               cell_real((domq_real)t->study.low)};
        for (int k = 1; k < 8; k++)
            cells[k].digits = k < 4 ? 4 : 5;
        answer_row(&list, cells, NULL);
    }
}

/* Counts how many random rows of a design fall. Runs a small sample first, and a larger one only if the
 * design may reach the given probability. */
static bool design_count(const struct query *query, const struct dom_wish *wish,
                         const struct dom_limits *limits, const struct dom_design *d, domq_real probability,
                         struct tried *t, struct problem *problem)
{
    struct designed_row plan;
    struct scene scene;
    struct dom_random_error error[DOM_ERROR_COUNT];
    if (!designed_make(query, problem, wish, limits, d, &plan))
        return false;
    bool good = design_scene(query->scene, d, &plan, &scene, problem);
    struct query of_row = *query;
    of_row.scene = &scene;
    *t = (struct tried){.count = plan.count, .length = (domq_real)d->length, .mass = designed_mass(&plan)};
    const bool engine = good && scene_has_engine(&scene);
    good = good && study_run(&of_row, problem, rows_for(0, engine), &t->study, error);
    if (good && (domq_real)t->study.high >= probability && rows_for(probability, engine) > t->study.rows)
        good = study_run(&of_row, problem, rows_for(probability, engine), &t->study, error);
    listed_free(&scene.listed);
    free(plan.domino);
    return good;
}

/* Explains in `reason` why no design was found. Either no row falls, even without errors, or no number of
 * dominoes reaches the probability. In the second case, `reason` also says which number comes closest. */
static void none_write(const struct tried *tried, size_t count, const struct dom_wish *wish,
                       const struct dom_limits *limits, domq_real probability, char reason[REASON])
{
    size_t best = 0;
    for (size_t i = 1; i < count; i++)
        best = tried[i].study.fall > tried[best].study.fall ? i : best;
    if (count == 0)
        snprintf(reason, REASON,
                 "infeasible: no row of this height falls here, even without errors; %s may help",
                 limits                 ? "other boards, or a finer grid,"
                 : isfinite(wish->hall) ? "a longer hall"
                                        : "a smaller friction");
    else
        snprintf(reason, REASON,
                 "infeasible: no row falls with a probability of %s, however many dominoes it has; with "
                 "%zu dominoes, %zu of %zu rows fall; make the errors smaller%s",
                 measured(probability, "share", 6).text, tried[best].count, tried[best].study.fall,
                 tried[best].study.rows, isfinite(wish->hall) ? ", or the hall longer" : "");
}

bool design_falls(const struct query *query, struct answer *a, const struct dom_wish *wish,
                  const struct dom_limits *limits, domq_real probability, struct dom_design *design,
                  struct dom_study *study, char reason[REASON], struct problem *problem)
{
    struct tried tried[DESIGNS_MOST];
    struct dom_random_error error[DOM_ERROR_COUNT];
    const struct dom_train train = train_in_double(&query->scene->train);
    const struct dom_compute compute = compute_in_double(&query->scene->compute);
    size_t count = 0, beyond = 0;
    if (!errors_check(query->scene, problem))
        return false;
    if (!scene_errors(query->scene, error))
        return problem_no_errors(problem, "'falls'");
    design->limit = DOM_DESIGN_SAFETY;
    for (size_t steps = 1; steps < DOMINOES_MOST && count < DESIGNS_MOST && beyond <= BEYOND; steps++) {
        struct dom_design d;
        struct dom_wish w = *wish;
        w.engine = NULL;
        const enum dom_status status = dom_design_steps(&train, &w, limits, &compute, steps, &d);
        if (status != DOM_OK)
            return problem_status(problem, query->scene, status);
        if (design->limit != DOM_DESIGN_FITS && d.limit != DOM_DESIGN_FITS)
            *design = d;
        if (d.limit == DOM_DESIGN_HALL || (d.limit != DOM_DESIGN_FITS && count > 0))
            break; /* rows with more dominoes would not fit, or would not fall */
        if (d.limit != DOM_DESIGN_FITS)
            continue;
        if (!design_count(query, wish, limits, &d, probability, &tried[count], problem))
            return false;
        const struct tried *t = &tried[count++];
        if (beyond == 0 && (domq_real)t->study.low >= probability) {
            *design = d;
            *study = t->study;
        }
        beyond += design->limit == DOM_DESIGN_FITS;
    }
    if (answer_rest(a) && count > 0)
        table_write(a, tried, count, scene_mass(query->scene) > 0);
    if (design->limit != DOM_DESIGN_FITS)
        none_write(tried, count, wish, limits, probability, reason);
    return true;
}
