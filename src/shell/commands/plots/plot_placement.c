/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot placement: the probability that the whole row falls, against the errors of its gaps. */
#include "answer/measure.h"
#include "commands/plots/plots.h"
#include "commands/rows/falling.h"
#include "io/terminal.h"
#include "parallel/workers.h"
#include <stdlib.h>

enum { SIGMAS = 13, ROWS_USUAL = 400, ROWS_ROUGH = 100 };

struct likely {
    struct scene_row scene;
    struct domq_placement placement;
    struct domq_study study[SIGMAS];
    domq_real sigma[SIGMAS];
    domq_real now; /* of the session; NaN: the effect is off */
};

/*
 * Chooses the errors: from none up to well beyond where half of the rows fall, and to those of the session.
 * Few rows are enough to find that place roughly.
 */
static enum dom_status sigmas_choose(struct likely *l)
{
    struct domq_budget half;
    struct domq_placement rough = l->placement;
    rough.rows = ROWS_ROUGH;
    enum dom_status status = domq_placement_budget(&l->scene.row, &l->scene.compute, &rough, 0.5, &half);
    if (status != DOM_OK)
        return status;
    domq_real top = 0;
    for (size_t k = 1; k < l->scene.row.count; k++)
        top = l->scene.domino[k].gap > top ? l->scene.domino[k].gap : top;
    if (isfinite(half.sigma))
        top = (domq_real)(2.4 * half.sigma);
    if (l->now * (domq_real)1.2 > top)
        top = l->now * (domq_real)1.2;
    for (int k = 0; k < SIGMAS; k++)
        l->sigma[k] = top * k / (SIGMAS - 1);
    return DOM_OK;
}

static enum dom_status studies_make(struct likely *l)
{
    struct progress progress = {0, 0};
    enum dom_status status = sigmas_choose(l);
    for (int k = 0; k < SIGMAS && status == DOM_OK; k++) {
        l->placement.sigma = l->sigma[k];
        status = domq_placement_study(&l->scene.row, &l->scene.compute, &l->placement, &l->study[k], NULL);
        progress_show(&progress, status == DOM_OK ? (k + 1.0) / SIGMAS : 1);
    }
    return status;
}

static double share(const struct domq_study *s)
{
    return (double)s->fall / (double)s->rows;
}

static bool likely_chart(const struct query *query, struct answer *a, struct problem *problem,
                         const struct likely *l)
{
    struct chart chart = chart_make();
    const struct axis_unit unit = measure_axis((double)l->sigma[SIGMAS - 1]);
    snprintf(chart.title, sizeof chart.title, "How likely the whole row of %zu falls", l->scene.row.count);
    snprintf(chart.x.label, sizeof chart.x.label, "standard deviation of every gap in %s", unit.name);
    snprintf(chart.y.label, sizeof chart.y.label, "rows that fall, in %%");
    chart.x.low = chart.y.low = 0;
    chart.y.high = 104;
    struct chart_curve *curve = chart_curve(
        &chart, CHART_BOTH, INK_BLUE, 0, "%zu rows at each error, with the 95 %% interval", l->study[0].rows);
    bool unknown = false;
    for (int k = 0; k < SIGMAS; k++)
        unknown = unknown || l->study[k].unknown > 0;
    for (int k = 0; k < SIGMAS; k++)
        chart_range(&chart, curve, (double)l->sigma[k] / unit.size, 100 * share(&l->study[k]),
                    100 * l->study[k].low, 100 * l->study[k].high);
    struct chart_curve *most = chart_curve(&chart, CHART_LINE, INK_GREY, 2, "95 %%");
    chart_point(&chart, most, 0, 95);
    chart_point(&chart, most, (double)l->sigma[SIGMAS - 1] / unit.size, 95);
    if (unknown)
        snprintf(chart.note, sizeof chart.note,
                 "Rows that the model cannot decide widen the intervals upwards.");
    if (l->now > 0)
        chart_event(&chart, (double)l->now / unit.size, "now");
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

static bool likely_make(const struct query *query, struct problem *problem, struct task_pool *pool,
                        struct likely *l)
{
    const struct effect_state *errors = &query->scene->effect[DOM_EFFECT_placement];
    if (!scene_row_make(query->scene, &l->scene, problem))
        return false;
    *pool = (struct task_pool){.threads = query->state->settings.threads,
                               .interrupt = query->scene->compute.interrupt};
    l->now = errors->on ? errors->value[0] : DOMQ_NAN;
    l->placement = (struct domq_placement){.heights = errors->on ? errors->value[1] : 0,
                                           .seed = (unsigned long)query->scene->seed,
                                           .rows = query->given->count > 1 ? (size_t)query->given->number[1]
                                                                           : ROWS_USUAL,
                                           .parallel = workers_tasks,
                                           .pool = pool};
    enum dom_status status = studies_make(l);
    if (status == DOM_OK)
        return true;
    free(l->scene.domino);
    if (status == DOM_STOPS)
        problem_no_answer(problem,
                          "fewer than half of the rows fall, even without random errors: 'fall' shows where "
                          "the row stops, and 'mend' finds what saves it");
    else
        row_status(query, problem, status);
    return false;
}

bool plot_placement(const struct query *query, struct answer *a, struct problem *problem)
{
    struct likely l;
    struct task_pool pool;
    bool people = answer_for_people(a);
    if ((people && !picture_ready(a, problem)) || !likely_make(query, problem, &pool, &l))
        return false;
    for (int k = 0; k < SIGMAS && !people; k++)
        answer_cells(a, cell_real(l.sigma[k]), cell_real((domq_real)share(&l.study[k])),
                     cell_real((domq_real)l.study[k].low), cell_real((domq_real)l.study[k].high),
                     cell_count((domq_real)l.study[k].rows));
    bool shown = !people || likely_chart(query, a, problem, &l);
    free(l.scene.domino);
    return shown;
}
