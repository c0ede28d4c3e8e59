/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plots 'fall' and 'speed': energies and speeds along the row. */
#include "interpreter/command.h"
#include "pictures/drawing/falling_row.h"
#include "pictures/plots/plots.h"
#include "train/train.h"

/* Runs the row for a plot. After a failure nothing needs to be freed. */
static bool plotted_run(const struct query *query, bool timed, struct falling_row *row,
                        struct problem *problem)
{
    *row = (struct falling_row){.end = (double)NAN};
    if (!row_run(query, problem, timed, &row->run))
        return false;
    row->dominoes = row->stage.count = row->run.scene.row.count;
    return true;
}

static bool plot_fall(const struct query *query, struct answer *a, struct chart *chart,
                      struct problem *problem)
{
    struct falling_row row;
    const struct row_run *run = &row.run;
    double least = HUGE_VAL, most = 0, spare = (double)NAN;
    if (scene_engine(query->scene))
        return problem_no_answer(
            problem,
            "the rigid-body engine runs this row because %s, and the engine does not compute the energy that "
            "a domino needs; 'plot speed' shows how the row falls",
            scene_engine(query->scene));
    if (!plotted_run(query, false, &row, problem))
        return false;
    if (scene_has_masses(query->scene))
        columns_in_joules(a);
    for (size_t i = 0; i < run->hits; i++) {
        const struct domq_fall *f = &run->fall[i];
        const bool known = isfinite(f->barrier);
        /* There is none for a domino that needs no energy, that friction locks whatever its energy, or that
         * was tilted until it tipped over. */
        spare = row_run_tipped(run, i) || !(f->barrier > 0) ? (double)NAN : (double)(f->margin / f->barrier);
        least = spare > 0 ? fmin(least, spare) : least;
        most = isfinite(spare) ? fmax(most, spare) : most;
        answer_cells(a, cell_count((domq_real)f->domino), cell_real(f->kinetic),
                     cell_real(known ? f->barrier : DOMQ_NAN), cell_real(known ? f->margin : DOMQ_NAN),
                     cell_real((domq_real)spare));
    }
    const bool idle = chart && run->scene.row.count == 1 && isnan(spare);
    if (idle)
        problem_no_answer(problem, "the only domino of this row starts past its tipping point, so it needs "
                                   "no energy to fall; 'set row 5' sets up five dominoes");
    else if (chart) {
        const struct domq_verdict *v = &run->verdict;
        falling_row_verdict(&row, chart->note);
        chart->x.whole = chart->y.logarithmic = true;
        chart->x.low = 0.4;
        chart->x.high = (double)run->scene.row.count + 0.6;
        chart->y.low = least < HUGE_VAL ? pow(10, floor(log10(least / 2))) : 0.01;
        chart->y.high = fmax(1.6 * most, 100 * chart->y.low);
        if (v->weakest && v->weakest <= run->hits && v->spare >= 0 && isfinite(v->spare))
            chart_point(chart,
                        chart_curve(chart, CHART_POINTS, INK_RED, 0, "the weakest, domino %zu", v->weakest),
                        (double)v->weakest, fmax((double)v->spare, chart->y.low));
    }
    row_run_free(&row.run);
    return !idle;
}

static bool plot_speed(const struct query *query, struct answer *a, struct chart *chart,
                       struct problem *problem)
{
    struct falling_row row;
    const struct row_run *run = &row.run;
    if (!plotted_run(query, true, &row, problem))
        return false;
    domq_real place = 0;
    size_t at = 1;
    bool runs = false;
    for (size_t i = 0; i < run->hits && !run->timeless; i++) {
        const size_t next = run->fall[i].domino; /* the index, counted from 0, of the next domino */
        const struct domq_domino *d = &run->scene.domino[next < run->scene.row.count ? next : 0];
        const bool has_speed = next < run->scene.row.count && i + 1 < run->hits;
        const domq_real speed = has_speed ? (d->gap + d->thickness) / run->fall[i].duration : DOMQ_NAN;
        for (; at < next; at++)
            place += run->scene.domino[at].gap + run->scene.domino[at].thickness;
        runs = runs || !isnan(speed);
        answer_cells(a, cell_count((domq_real)run->fall[i].domino), cell_real(place), cell_real(speed));
    }
    bool done = !run->timeless && (!chart || runs);
    if (run->timeless)
        row_status(query, problem, DOM_NO_MARGIN);
    else if (!done)
        problem_no_answer(problem, run->scene.row.count == 1
                                       ? "this plot needs at least two dominoes; 'set row 5' sets up five"
                                       : "the front has no speed, because the fall ends before domino 2 is "
                                         "hit; 'mend' looks for a change that saves the row");
    else if (chart) {
        row.end = (double)run->verdict.seconds;
        falling_row_verdict(&row, chart->note);
        chart->x.low = chart->y.low = 0;
    }
    row_run_free(&row.run);
    return done;
}

static const struct column plot_fall_columns[] = {
    {"domino", "", "number of the domino, from 1", 6},
    {"kinetic", "mgh/2", "kinetic energy of all moving dominoes just after the hit", 0},
    {"barrier", "mgh/2", "energy that is needed to tip this domino over", 0},
    {"margin", "mgh/2", "kinetic - barrier", 0},
    {"spare", "",
     "margin / barrier; empty for a domino that needs no energy, and for domino 1 without a push", 0},
    {NULL, NULL, NULL, 0},
};
static const struct column speed_columns[] = {
    {"domino", "", "number of the domino, from 1", 6},
    {"place", "m", "distance of this domino from domino 1, front foot to front foot", 0},
    {"speed", "m/s", "speed of the front from this domino to the next one", 0},
    {NULL, NULL, NULL, 0},
};
static const struct plot row_plots[] = {
    {"fall", plot_fall, "how much energy each domino of the row has to spare", plot_fall_columns,
     .title = "Energy to spare, domino by domino", .x = {"domino", "domino"},
     .y = {NULL, "spare energy / energy needed,", .percent = true},
     .curve = {{"spare", "", CHART_POINTS, INK_BLUE}}},
    {"speed", plot_speed, "how fast the fall runs along the row", speed_columns,
     .title = "Speed of the front along the row", .x = {"place", "distance from the first domino"},
     .y = {"speed", "speed"}, .curve = {{"speed", "", CHART_STEPS, INK_BLUE}}},
    {.name = NULL},
};

static const struct plot *const plots[] = {row_plots, NULL};

extern const struct command film_commands[];

static const struct command_group groups[] = {
    {"Films", "pictures", film_commands},
    {NULL, NULL, NULL},
};

const struct feature rows_pictures_feature = {.name = "rows_pictures", .groups = groups, .plots = plots};
