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
     .help =
         "NAME is a parameter or an effect, or up to four of them with commas between them, as in "
         "'friction, push'. FILE is a csv file of one of five kinds. In a file with 'gap (mm)' and 'speed "
         "(m/s)', each line has the speed of one row of equal dominoes. With 'gap (mm)', 'dominoes' and "
         "'time (s)', each line has the time that a row of that many equal dominoes takes to fall: from the "
         "push or the release or, without these, from the first hit, until the last one lies on the floor. "
         "The "
         "columns 'domino' and 'time (s)' (or 'frame') say when each domino of the row is hit, as a camera "
         "shows it. A file with only 'time (s)' has the hits of a sound, some of which may be missing: the "
         "first is that of domino 2, and the others are numbered by a run of the session's row. The "
         "columns "
         "'time (s)' (or 'frame') and 'angle (deg)' say how domino 1 turns; a column 'domino' can name "
         "another domino.\n\n"
         "A 'pitch', from front face to front face, can take the place of the gap. FPS is the number of "
         "frames per second; a column 'rate' can give this number instead. A column 'run' numbers several "
         "runs, each with its own clock. A column 'gap (mm)' gives the gap of each run. A column 'error' "
         "gives the standard errors, for speeds and rows also 'error (%)'. Columns 'speed 1', 'speed 2', or "
         "'trial 1 (s)', 'trial 2 (s)', have repeated measurements, whose spread is their error.\n\n"
         "Hits and angles are those of the row of 'set row' or, without it, of a row with the growth r. Each "
         "residual is divided by its error, and 'fit' finds the values with the smallest sum of squares. It "
         "also finds their standard deviations and correlations. 'fit ... > fit.svg' (or .png, .pdf) draws "
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
