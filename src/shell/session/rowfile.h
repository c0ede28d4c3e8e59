/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the csv files that commands name, in particular rows of dominoes. */
#ifndef SHELL_ROWFILE_H
#define SHELL_ROWFILE_H

#include "language/csv_table.h"
#include "session/query.h"

/*
 * Opens a csv file, and reads the first line of its table. Looks for the file first in the directory of the
 * running script, and then in the current directory. If `standard` is true, the name '-' means standard
 * input. On failure, sets *problem and returns NULL.
 */
struct csv_table *csv_named(const struct scene *scene, const struct means *means, const char *name,
                            bool standard, const struct csv_kind *kind, struct problem *problem);

/* Closes a table. Returns true if the table was read without a problem. Otherwise copies the problem of the
 * table to *problem and returns false. If the table is NULL, only returns false. */
bool csv_end(struct csv_table *csv, struct problem *problem);

/*
 * A csv file that describes a measured row of dominoes looks like this:
 *
 *     # the hall, first try
 *     height (mm), thickness (mm), gap (mm), mass (g)
 *     48, 7.5, -, 10
 *     5.2 cm, 52/6, 22, 12.5
 *
 * Masses may be missing, or may be given by densities and widths: the mass of a block is the product of its
 * density, height, thickness and width. The default width is half the height, and the default density is 1.
 * The column "relative" gives relative masses, and is used if there is neither mass nor density. A lean is
 * the distance by which the top of a standing domino is off plumb; a backward lean is negative. The column
 * "domino" is ignored, and all other columns are kept as text.
 */
/* The columns that the file of a row may have. The first columns are those of enum row_measure, in the same
 * order. */
extern const struct csv_kind rowfile_kind;

/* Checks whether a domino can have all its measurements at once, and does not fall over by itself on a slope
 * of `slope` radians. If so, returns ROW_MEASURES. Otherwise returns the measurement that is wrong, and
 * writes a message. */
enum { MISFIT_MESSAGE = LEAN_MESSAGE };
enum row_measure domino_misfit(const struct domq_domino *domino, domq_real slope,
                               char message[MISFIT_MESSAGE]);

/*
 * Reads all dominoes of a table. The gap of the first domino is 0. If the table gives neither masses nor
 * densities, only the ratios of the masses are known: they are the values of the column "relative" or,
 * without this column, the ratios of the volumes. No domino may lean so far that it falls over by itself on a
 * slope of `slope` radians. On failure, stores the problem in the table, leaves *rows empty and returns
 * false. Free *rows with listed_free.
 */
bool rowfile_read(struct csv_table *csv, domq_real slope, struct listed_row *rows);

#endif
