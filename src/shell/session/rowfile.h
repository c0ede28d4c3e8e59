/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A row of dominoes in a csv file, as it was measured:
 *
 *     # the hall, first try
 *     height (mm), thickness (mm), gap (mm), mass (g)
 *     48, 7.5, -, 10
 *     5.2 cm, 52/6, 22, 12.5     # cells are expressions; a unit in one overrides that in the head
 *
 * The first line names the columns in any order: height, thickness, gap, and if they are known mass, or
 * density, and width.  Each has a unit, in the head or in the cell: a number without one is an error.  A
 * solid block weighs density * height * thickness * width; without a width it is half as wide as tall,
 * without a density that is 1; or a column gives relative masses.  A column domino, with numbers, is not
 * used.  Between cells stands what stands between the names: ',' or ';' or a tab.  Decimals have a point in
 * any case: in a decimal comma nobody can see whether it parts thousands.  A file means the same in every
 * session: it knows none of the names of one, and a bare angle is in radians.
 */
#ifndef SHELL_ROWFILE_H
#define SHELL_ROWFILE_H

#include "session/session.h"

/*
 * Reads the dominoes in the order of the file; the gap of the first is 0.  Masses that are not known are
 * relative, as for solid blocks of density 1.  False: an error of the session was reported, with the file's
 * name, the line, the column (character, from 1), the reason, and `then`, what the error leads to; nothing is
 * kept.  Free with listed_free.
 */
bool rowfile_read(struct session *session, const char *path, const char *then, struct listed_row *rows);

#endif
