/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Measured speeds of rows of equal dominoes in a csv file:
 *
 *     # a hard floor
 *     gap (mm), speed (m/s), error (m/s)
 *     9.38, 1.295, 0.02
 *
 * The first line names the columns, in any order, with their units; the error may be missing. Other columns
 * are not read. A cell may have a unit of its own.
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

/* Reads a file. False: an error was reported, with the name of the file and the line; nothing is kept. */
bool measured_read(const struct query *query, struct problem *problem, const char *path,
                   struct measured_rows *rows);

#endif
