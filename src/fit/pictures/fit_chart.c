/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plot 'fit': measured values against fitted values. */
#include "fit/fit.h"
#include "interpreter/feature.h"
#include "language/text.h"
#include "pictures/plots/plots.h"
#include <string.h>

enum { RUNS_NAMED = CHART_CURVES - 1 };

/* Adds runs i to end - 1 as one curve. The times of hits are relative to the fitted time of the first hit of
 * their run. */
static void run_points(struct chart *chart, const struct fit *f, size_t i, size_t end, double *most)
{
    static const enum ink inks[RUNS_NAMED] = {INK_BLUE, INK_RED,    INK_GREEN, INK_PURPLE, INK_ORANGE,
                                              INK_SKY,  INK_PURPLE, INK_GREEN, INK_RED};
    struct chart_curve *points =
        f->data.runs == 1 ? chart_curve(chart, CHART_POINTS, INK_BLUE, 0, "measured")
        : end - i > 1
            ? chart_curve(chart, CHART_POINTS, inks[i], 0, "run %g and later ones", f->data.run[i].number)
            : chart_curve(chart, CHART_POINTS, inks[i], 0, "run %g", f->data.run[i].number);
    for (; i < end; i++) {
        const struct fit_run *run = &f->data.run[i];
        const double clock = f->data.kind == FIT_HITS ? f->computed[run->first] : 0;
        for (size_t k = run->first; k < run->first + run->count; k++) {
            const double x = f->computed[k] - clock, y = f->data.point[k].measured - clock;
            chart_point(chart, points, x, y);
            *most = fmax(*most, fmax(x, y));
        }
    }
}

/* Draws a point for each measurement, and the line on which measured and fitted values are equal. */
static void points_draw(struct chart *chart, const struct fit *f)
{
    const char *what = f->data.kind == FIT_SPEEDS ? "speed in m/s" : "time in s";
    double most = 0;
    snprintf(chart->title, sizeof chart->title, "Measured against fitted");
    snprintf(chart->x.label, sizeof chart->x.label, "fitted %s", what);
    snprintf(chart->y.label, sizeof chart->y.label, "measured %s", what);
    for (int i = 0; i < f->unknowns; i++) {
        const struct fit_unknown *u = &f->unknown[i];
        const char *of = strcmp(u->parameter->value->unit, "h") == 0 ? "" : u->parameter->value->unit;
        text_add(chart->note, sizeof chart->note, "%s%s %s", i ? ", " : "", u->parameter->name,
                 measured((domq_real)u->value, of, 4).text);
    }
    for (size_t i = 0; i < f->data.runs && i < RUNS_NAMED; i++)
        run_points(chart, f, i, i + 1 == RUNS_NAMED ? f->data.runs : i + 1, &most);
    struct chart_curve *line = chart_curve(chart, CHART_LINE, INK_GREY, 0, "measured = fitted");
    chart_point(chart, line, 0, 0);
    chart_point(chart, line, most, most);
}

/* Parses the arguments of 'fit' after 'plot fit' and stores them as a question in q->parsed. */
static bool plot_fit_parse(struct reader *r, struct question *q)
{
    struct question *fit = q->parsed = reader_memory(r, sizeof *fit);
    if (!fit)
        return false;
    *fit = (struct question){.key = -1, .command = command_find("fit")};
    return question_parse(r, fit);
}

static bool plot_fit(const struct query *query, struct answer *a, struct chart *chart,
                     struct problem *problem)
{
    const struct question *question = query->given->bound;
    struct call call;
    struct fit f;
    if (!question)
        return problem_error(
            problem,
            "'plot fit' needs a parameter and a file of measurements, as in 'plot fit friction FILE'");
    bool done = question_bind(question, query, &call, problem);
    if (done && !chart) {
        done = run_fit(&call.query, a, problem);
    } else if (done) {
        done = fit_make(&call.query, &f, problem);
        if (done)
            points_draw(chart, &f);
        fit_free(&f);
    }
    arena_free(&call.given.memory);
    return done;
}

static const struct column fit_plot_columns[] = {{NULL, NULL, NULL, 0}};
static const struct argument fit_argument = {
    .name = "NAME FILE", .kind = ARGUMENT_COMMAND, .parse = plot_fit_parse};

static const struct plot fit_plots[] = {
    {"fit", plot_fit,
     "measurements against the values that the model gives with the fitted parameter, as in 'plot fit "
     "friction FILE'; the columns are those of 'fit'",
     fit_plot_columns, .title = "", .argument = &fit_argument},
    {.name = NULL},
};

static const struct plot *const plots[] = {fit_plots, NULL};

const struct feature fit_pictures_feature = {.name = "fit_pictures", .plots = plots};
