/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The csv files that commands read, and among them rows of dominoes. */
#ifndef SHELL_ROWFILE_H
#define SHELL_ROWFILE_H

#include "language/csv_table.h"
#include "session/query.h"

/*
 * Opens a csv file, and reads the first line of its table. The file is looked for in the folder of the script
 * that names it, and then in the current folder. If `standard` is true, '-' is standard input. Returns NULL
 * with a problem.
 */
struct csv_table *csv_named(const struct scene *scene, const struct means *means, const char *name,
                            bool standard, const struct csv_kind *kind, struct problem *problem);

/* Closes a table, which may be NULL. Returns true if it has no problem. Otherwise describes the problem. */
bool csv_end(struct csv_table *csv, struct problem *problem);

/*
 * A row of dominoes as it was measured:
 *
 *     # the hall, first try
 *     height (mm), thickness (mm), gap (mm), mass (g)
 *     48, 7.5, -, 10
 *     5.2 cm, 52/6, 22, 12.5
 *
 * Masses may be missing, or be given by densities and widths: a block weighs density * height * thickness *
 * width. The default width is half the height, and the default density is 1. A column of relative masses is
 * used if there is neither mass nor density. A lean says how far the top of a domino is off plumb when it is
 * set up; it is negative backwards. The column "domino" is ignored, and all other columns are kept as text.
 */
extern const struct csv_kind rowfile_kind;

/*
 * Reads all dominoes of a table. The gap of the first is 0. Without masses in kg, the masses are relative,
 * those of solid blocks of density 1. The slope of the floor, in radians, limits leans. Returns false with a
 * problem in the table, and then keeps nothing. Free the row with listed_free.
 */
bool rowfile_read(struct csv_table *csv, domq_real slope, struct listed_row *rows);

#endif
