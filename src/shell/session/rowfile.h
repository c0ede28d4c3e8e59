/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the csv files that commands name, in particular rows of dominoes. */
#ifndef SHELL_ROWFILE_H
#define SHELL_ROWFILE_H

#include "language/csv_table.h"
#include "session/query.h"

/* Opens a csv file, and reads the first line of its table. Looks beside the running script first, and then in
 * the current directory. If `standard` is true, '-' is standard input. On failure, sets *problem and returns
 * NULL. */
struct csv_table *csv_named(const struct scene *scene, const struct run_context *run_context,
                            const char *name, bool standard, const struct csv_kind *kind,
                            struct problem *problem);

/* Closes a table. Returns true if the table was read without a problem. Otherwise copies the table's problem
 * to *problem and returns false. If `csv` is NULL, just returns false. */
bool csv_end(struct csv_table *csv, struct problem *problem);

/*
 * A csv file that describes a measured row of dominoes looks like this:
 *
 *     # the hall, first try
 *     height (mm), thickness (mm), gap (mm), mass (g)
 *     48, 7.5, -, 10
 *     5.2 cm, 52/6, 22, 12.5
 *
 * - Without the column "mass", a mass is density * height * thickness * width.
 * - The default width is half the height, and the default density is 1.
 * - The column "relative", the ratios of the masses, is used if there is neither mass nor density.
 * - A lean is the distance of the top from plumb. A backward lean is negative.
 * - The column "domino" is ignored. Unknown columns are kept as text.
 */
/* The columns of the file. The first columns are the measurements of enum row_measure, in the same order. */
extern const struct csv_kind rowfile_kind;

/* Returns ROW_MEASURES if the measurements of a domino fit together, and its lean does not make it fall over
 * on a slope of `slope` radians. Otherwise returns the measurement that is wrong, and writes a message. */
enum { MISFIT_MESSAGE = LEAN_MESSAGE };
enum row_measure domino_misfit(const struct domq_domino *domino, domq_real slope,
                               char message[MISFIT_MESSAGE]);

/* Reads all dominoes of a table. A domino that would fall over by itself on a slope of `slope` radians is an
 * error. On failure, stores the problem in the table, leaves *rows empty and returns false. Free *rows with
 * listed_free. */
bool rowfile_read(struct csv_table *csv, domq_real slope, struct listed_row *rows);

#endif
