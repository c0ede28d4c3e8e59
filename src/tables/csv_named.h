/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opens the csv files that commands name. */
#ifndef TABLES_CSV_NAMED_H
#define TABLES_CSV_NAMED_H

#include "session/query.h"
#include "tables/csv_table.h"

/* Opens a csv file and reads the first line of its table. The file may be beside the running script, or else
 * in the current directory. If `standard` is true, the name '-' means standard input. On failure, sets
 * *problem and returns NULL. */
struct csv_table *csv_named(const struct scene *scene, const struct run_context *run_context,
                            const char *name, bool standard, const struct csv_kind *kind,
                            struct problem *problem);

/* Closes a table after it has been read. Returns true if there was no error. Otherwise copies the error from
 * the table to *problem and returns false. If `csv` is NULL, only returns false. */
bool csv_end(struct csv_table *csv, struct problem *problem);

#endif
