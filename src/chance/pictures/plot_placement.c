/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plot 'placement': the probability that the whole row falls, plotted against the size of random errors
 * in its gaps. */
#include "chance/chance.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "parallel/workers.h"
#include "pictures/plots/plots.h"
#include "train/falling.h"
#include <stdlib.h>

enum { SIGMAS = 13, ROWS_USUAL = 400, ROWS_ROUGH = 100 };

/* Chooses the largest size of the errors in the chart. Most of the random rows must stop at this size, so it
 * is well above the size at which half of them fall. The chart also includes `now`, the size that 'effect
 * placement' has set. If this effect is off, `now` is NaN. */
static enum dom_status sigma_most(const struct double_row *made, const struct dom_placement *placement,
                                  double now, double *most)
{
    struct dom_budget half;
    struct dom_placement rough = *placement;
    rough.rows = ROWS_ROUGH;
    enum dom_status status =
        dom_placement_budget(&made->row, &made->compute, &rough, DOM_ERROR_gap, 0.5, &half);
    *most = 0;
    for (size_t k = 1; k < made->row.count; k++)
        *most = fmax(*most, made->domino[k].gap);
    if (status == DOM_OK && isfinite(half.sigma))
        *most = 2.4 * half.sigma;
    if (now > 0)
        *most = fmax(*most, 1.2 * now);
    return status;
}

static enum dom_status studies_write(const struct double_row *made, struct dom_placement *placement,
                                     double most, struct answer *a, bool *unknown)
{
    enum dom_status status = DOM_OK;
    for (int k = 0; k < SIGMAS && status == DOM_OK && !answer_lost(a); k++) {
        struct dom_study study;
        placement->error[DOM_ERROR_gap].size = most * k / (SIGMAS - 1);
        status = dom_placement_study(&made->row, &made->compute, placement, &study, NULL);
        if (status == DOM_OK)
            answer_cells(a, cell_real((domq_real)placement->error[DOM_ERROR_gap].size),
                         cell_real((domq_real)((double)study.fall / (double)study.rows)),
                         cell_real((domq_real)study.low), cell_real((domq_real)study.high),
                         cell_count((domq_real)study.rows));
        *unknown = *unknown || study.unknown > 0;
        progress_show((k + 1.0) / (SIGMAS + 1));
    }
    return status;
}

static void placement_chart(const struct scene_row *scene, size_t rows, double now, bool unknown,
                            struct chart *chart)
{
    snprintf(chart->title, sizeof chart->title, "How likely the whole row of %zu domino%s is to fall",
             scene->row.count, scene->row.count == 1 ? "" : "es");
    snprintf(chart->curve[0].title, sizeof chart->curve[0].title,
             "%zu rows for each point, with the 95 %% interval", rows);
    if (unknown)
        snprintf(chart->note, sizeof chart->note,
                 "For some rows, the model cannot decide whether they fall. The upper ends of the intervals "
                 "assume that all these rows fall.");
    chart->x.low = chart->y.low = 0;
    chart->y.high = 1.04;
    chart_level(chart, 0.95, "95 %");
    if (now > 0)
        chart_event(chart, now, "now");
}

static bool plot_placement(const struct query *query, struct answer *a, struct chart *chart,
                           struct problem *problem)
{
    struct scene_row scene;
    struct double_row made;
    struct task_pool pool = {.threads = query->state->settings.threads,
                             .interrupt = query->scene->compute.interrupt};
    struct dom_placement placement = {.seed = (unsigned long)query->scene->seed,
                                      .rows = ROWS_USUAL,
                                      .parallel = workers_tasks,
                                      .pool = &pool};
    bool unknown = false;
    a->in_double = true;
    scene_errors(query->scene, placement.error);
    const bool has_placement = query->scene->effect[DOM_EFFECT_placement].on;
    double most, now = has_placement ? placement.error[DOM_ERROR_gap].size : (double)NAN;
    if (!errors_check(query->scene, problem) || !scene_row_make(query->scene, &scene, problem))
        return false;
    if (query->given->count > 1)
        placement.rows = (size_t)query->given->number[1];
    enum dom_status status = scene_row_in_double(&scene, &made);
    if (status == DOM_OK)
        status = sigma_most(&made, &placement, now, &most);
    if (status == DOM_OK)
        status = studies_write(&made, &placement, most, a, &unknown);
    if (status == DOM_OK && chart)
        placement_chart(&scene, placement.rows, now, unknown, chart);
    free(scene.domino);
    free(made.domino);
    if (status == DOM_STOPS)
        return problem_no_answer(
            problem, "fewer than half of the rows fall, even without random errors in the gaps; 'fall' shows "
                     "where the row stops, and 'mend' looks for a change that saves it");
    return status == DOM_OK || row_status(query, problem, status);
}

static const struct column placement_points[] = {
    {"sigma", "m", "standard deviation of the errors in the gaps; for uniform errors, the largest error", 0},
    {"probability", "", "probability that the whole row falls", 0},
    {"low", "", "lower end of the 95 % interval of the probability", 0},
    {"high", "", "upper end of the 95 % interval of the probability", 0},
    {"rows", "", "number of rows that were set up at each sigma", 0},
    {NULL, NULL, NULL, 0},
};

static const struct argument rows_argument = {.name = "ROWS", .kind = ARGUMENT_COUNT};

const struct plot placement_plots[] = {
    {"placement", plot_placement,
     "how likely the whole row is to fall, for each size of the errors; 'plot placement 1000' tries 1000 "
     "random rows for each size, instead of 400",
     placement_points, .title = "", .x = {"sigma", "standard deviation (or limit) of the gap errors"},
     .y = {NULL, "rows that fall,", .percent = true}, .curve = {{"probability", "", CHART_BOTH, INK_BLUE}},
     .argument = &rows_argument},
    {.name = NULL},
};
