/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The csv files that commands name. */
#ifndef SHELL_OPEN_CSV_H
#define SHELL_OPEN_CSV_H

#include "language/csv_table.h"
#include "session/query.h"

/*
 * Reads a csv file and the first line of its table.  The file is looked for beside the script that names it,
 * then where the program runs; '-' is standard input where that is allowed.  Returns NULL with a problem.
 */
struct csv_table *csv_named(const struct scene *scene, const struct means *means, const char *name,
                            bool standard, const struct csv_kind *kind, struct problem *problem);

/* Closes a table, which may be NULL.  Returns true if nothing was wrong with it; else describes the problem.
 */
bool csv_end(struct csv_table *csv, struct problem *problem);

#endif
