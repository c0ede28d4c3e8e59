/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A row of dominoes in a csv file, as it was measured:
 *
 *     # the hall, first try
 *     height (mm), thickness (mm), gap (mm), mass (g)
 *     48, 7.5, -, 10
 *     5.2 cm, 52/6, 22, 12.5     # cells are expressions; the unit of a cell replaces that of the first line
 *
 * The first line names the columns in any order: height, thickness, gap and, if known, mass, or density and
 * width.  Each needs a unit, in the first line or in the cell: a number without one is an error.  A solid
 * block weighs density * height * thickness * width.  The default width is half the height, the default
 * density 1; or a column gives relative masses.  A column domino, with numbers, is not used.
 * A column lean says how far the top of a domino is off plumb when it is set up, backwards if negative.
 * Names have synonyms, such as spacing for gap and weight for mass; other columns are named in a note and
 * ignored.  Cells are
 * separated as the names are: by ',', ';' or tabs.  Decimals have a point: a comma could also separate
 * thousands.  A file means the same in every session: names of a session have no value in it, and a bare
 * angle is in radians.
 */
#ifndef SHELL_ROWFILE_H
#define SHELL_ROWFILE_H

#include "session/query.h"

/*
 * Reads the dominoes in the order of the file; the gap of the first is 0.  Masses that are not known are
 * relative, as for solid blocks of density 1.  Returns false after an error, keeps nothing then, and reports
 * the file, the line, the column (character, from 1), the reason and `then`, the consequence of the error.
 * Free the rows with listed_free.
 */
bool rowfile_read(const struct scene *scene, const char *path, const char *then, struct listed_row *rows,
                  const struct means *means, struct problem *problem);

#endif
