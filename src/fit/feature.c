/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'fit'. */
#include "interpreter/feature.h"
#include "fit/fit.h"

static const struct command fit_commands[] = {
    {.name = "fit",
     .synonyms = "measured camera video tracker regression estimate calibrate",
     .argument = {{.name = "NAME", .kind = ARGUMENT_GRID, .parse = fit_parse, .choices = fit_names},
                  {.name = "FILE", .kind = ARGUMENT_FILE},
                  {.name = "FPS", .kind = ARGUMENT_NUMBER, .optional = true}},
     .summary = "the parameters that explain measurements best",
     .help = "NAME is a parameter or an effect, or up to four of them with commas between them, as in "
             "'friction, push'. FILE is a csv file of one of three kinds. The columns 'domino' and 'time "
             "(s)' (or 'frame') say when each domino of the row is hit, as a camera shows it. The columns "
             "'time (s)' (or 'frame') and 'angle (deg)' say how domino 1 turns; a column 'domino' can name "
             "another domino. In a file with 'gap (mm)' and 'speed (m/s)', each line has the speed of one "
             "row of equal dominoes. FPS is the number of frames per second; a column 'rate' can give this "
             "number instead. A column 'run' numbers several runs, each with its own clock. A column 'gap "
             "(mm)' gives the gap of each run, and a column 'error' gives the standard errors. 'set row' "
             "sets the dominoes; without this effect, their growth is r. Each residual is divided by "
             "its error, and 'fit' finds the values with the smallest sum of squares. It also finds their "
             "standard deviations and correlations. 'fit ... > fit.svg' (or .png, .pdf) draws "
             "the measurements against the fitted values.",
     .see = "plot solve duration fall sensitivity",
     .access.files = true,
     .rows = true,
     ANSWER(fit)},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"What measurements say", "planning", fit_commands},
    {NULL, NULL, NULL},
};

const struct feature fit_feature = {.name = "fit", .groups = groups};
