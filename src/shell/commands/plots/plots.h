/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pictures of 'plot': each gives its data where programs read, and draws it where people do. */
#ifndef SHELL_PLOTS_H
#define SHELL_PLOTS_H

#include "interpreter/question.h"
#include "picture/show.h"

/* A picture draws for people, and answers its data to programs; false: an error was reported. */
typedef bool plot_run(const struct query *query, struct answer *a, struct problem *problem);
plot_run plot_energy, plot_omega, plot_inertia, plot_chain; /* over a cycle */
plot_run plot_growth, plot_marginal;                        /* limits over s */
plot_run plot_cost;
plot_run plot_fall, plot_speed, plot_gaps; /* along a row */
plot_run plot_placement;
plot_run plot_sweep; /* of the arguments that sweep_arguments has read */

/* Parse and bind the grid and the answers of a sweep: after 'sweep' itself, and after 'plot sweep'. */
bool sweep_parse_grid(struct reader *reader, struct question *question);
bool sweep_parse_answers(struct reader *reader, struct question *question);
bool sweep_bind(const struct question *question, const struct query *query, struct arguments *given,
                struct problem *problem);

/* A sweep as its picture sees it. */
struct sweep_axis {
    const char *name, *unit;
    const struct parameter *parameter;
    size_t count;
    bool logarithmic;
};
enum { SWEEP_AXES = 2 };
struct sweep_shape {
    int axes;
    struct sweep_axis axis[SWEEP_AXES]; /* of the first two */
    const struct command *command;      /* the first, or only one */
    int several;                        /* answers of a point, of which each is a column; 0: one */
    char asked[96];                     /* the command with its arguments, or the expression, as typed */
    bool expression;                    /* the command is 'print' */
};
struct sweep_shape sweep_shape(const struct arguments *given);
bool run_sweep(const struct query *query, struct answer *a, struct problem *problem);

/* Returns the angle unit of the session's answers, and a tilt in it. */
double plot_angle(const struct query *query, domq_real theta);

#endif
