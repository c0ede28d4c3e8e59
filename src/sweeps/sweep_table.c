/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command table that contains 'sweep'. It is not in sweep.c, because it also refers to plot_sweep.c,
 * which uses sweep.c. */
#include "commands/tables.h"
#include "pictures/plots/plots.h"
#include "sweeps/sweep.h"

/* The list is empty, because the columns depend on the arguments. */
static const struct column sweep_answers[] = {{NULL, NULL, NULL, 0}};

const struct command sweep_commands[] = {
    {.name = "sweep",
     .synonyms = "loop batch table scan grid",
     .argument =
         {{.name = "GRID", .kind = ARGUMENT_GRID, .parse = sweep_parse_grid},
          {.name = ": ANSWER", .kind = ARGUMENT_COMMAND, .parse = sweep_parse_answers, .bind = sweep_bind}},
     .summary = "the answers of a command over a grid of parameter values",
     .help = "GRID names parameters or effects, each followed by its values. NAME FROM TO N stands for N "
             "values in equal steps, and NAME FROM TO N log for N values with equal ratios. NAME VALUE, "
             "VALUE, ... lists the values. The first parameter changes slowest. ANSWER is a command or an "
             "expression, evaluated at each point, as in 'sweep s 0.1 0.9 9 : count 112 0.9*rmax'. Several "
             "answers, separated by commas, have a column each: 'sweep r 1 2 9 : barrier.margin, fuel, rmax "
             "with q hollow'. Every line of the output begins with the values of the parameters, even if the "
             "answer at a point has several lines. If a point has no answer, csv and json give the reason. "
             "The parameters of the session do not change. Points are computed on all cores, unless 'set "
             "threads' gives another number of threads. The output does not depend on this number. 'domino "
             "--shard 2/7' computes only the second of seven parts.",
     .example = "sweep s 0.1 0.5 3 q hollow, solid : rmax",
     .see = "curve set effects",
     .columns = sweep_answers,
     .sweep.refusal = "name all parameters in one grid, as in 'sweep s 0.1 0.5 3 q hollow, solid : rmax'",
     .rows = true,
     .run = run_sweep,
     .picture = plot_sweep},
    {.name = NULL},
};
