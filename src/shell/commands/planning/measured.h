/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Measured speeds of rows of equal dominoes in a csv file (language/csv_table.h):
 *
 *     # a hard floor
 *     gap (mm), speed (m/s), error (m/s)
 *     9.38, 1.295, 0.02
 *
 * The error may be missing, and other columns are not read.
 */
#ifndef SHELL_MEASURED_H
#define SHELL_MEASURED_H

#include "session/query.h"

struct measured_row {
    domq_real gap, speed, error; /* m, m/s; the error is 0 where none is known */
};

struct measured_rows {
    struct measured_row *row; /* free() them */
    size_t count;
    bool errors; /* every speed has an error */
};

/* Reads a file.  Returns false with a problem, and keeps nothing then. */
bool measured_read(const struct query *query, struct problem *problem, const char *path,
                   struct measured_rows *rows);

#endif
