/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A row of dominoes in a csv file (language/csv_table.h), as it was measured:
 *
 *     # the hall, first try
 *     height (mm), thickness (mm), gap (mm), mass (g)
 *     48, 7.5, -, 10
 *     5.2 cm, 52/6, 22, 12.5
 *
 * The columns are height, thickness, gap and, if known, mass, or density and width.  A solid block weighs
 * density * height * thickness * width.  The default width is half the height, the default density 1; or a
 * column gives relative masses.  A column lean says how far the top of a domino is off plumb when it is set
 * up, backwards if negative.  A column domino, with numbers, is not used.  Other columns are kept as text.
 */
#ifndef SHELL_ROWFILE_H
#define SHELL_ROWFILE_H

#include "language/csv_table.h"
#include "session/scene.h"

extern const struct csv_kind rowfile_kind;

/*
 * Reads the dominoes in the order of the file; the gap of the first is 0.  Masses that are not known are
 * relative, as for solid blocks of density 1.  The slope of the floor, in radians, limits leans.  Returns
 * false if the table has a problem, and keeps nothing then.  Free the rows with listed_free.
 */
bool rowfile_read(struct csv_table *csv, domq_real slope, struct listed_row *rows);

#endif
