/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot fit: measurements, plotted against the values that the model gives with the fitted parameters. */
#include "commands/fit/fit.h"
#include "commands/plots/plots.h"

bool plot_fit_parse(struct reader *r, struct question *q)
{
    struct question *fit = q->parsed = arena_take(r->arena, sizeof *fit);
    if (!fit)
        return problem_error(r->problem, "out of memory");
    *fit = (struct question){.key = -1, .command = command_find("fit")};
    return question_parse(r, fit);
}

bool plot_fit(const struct query *query, struct answer *a, struct chart *chart, struct problem *problem)
{
    const struct question *fit = query->given->bound;
    struct call call;
    if (!fit)
        return problem_error(
            problem,
            "'plot fit' needs a parameter and a file of measurements, as in 'plot fit friction FILE'");
    const bool done = question_bind(fit, query, &call, problem) &&
                      (chart ? fit_chart(&call.query, a, chart, problem) : run_fit(&call.query, a, problem));
    arena_free(&call.given.memory);
    return done;
}
