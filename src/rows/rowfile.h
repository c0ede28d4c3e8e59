/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads rows of dominoes from csv files. */
#ifndef ROWS_ROWFILE_H
#define ROWS_ROWFILE_H

#include "session/query.h"
#include "tables/csv.h"

/*
 * A csv file that describes a measured row of dominoes looks like this:
 *
 *     # the hall, first try
 *     height (mm), thickness (mm), gap (mm), mass (g)
 *     48, 7.5, -, 10
 *     5.2 cm, 52/6, 22, 12.5
 *
 * - A column "pitch" or "position" may take the place of "gap". The pitch is the distance from the front face
 * of the domino before to the front face of this domino, so the gap is the pitch minus this domino's
 * thickness. The position is that of the front face, measured from anywhere in the direction of the fall. The
 * front face is the one in this direction.
 * - If there is no column "width", 'set width' gives the width. Until scene_row_fill sets it, it is 0, and
 *   the mass is that of a domino which is half as wide as it is tall.
 * - If there is no column "mass", the mass of a domino is density * height * thickness * width. In a box,
 *   only the walls count.
 * - If there is no column "density" either, the column "relative" may give the ratios of the masses. If it is
 *   missing, too, all dominoes have the density 1.
 * - A lean is the distance of the top from plumb. If a domino leans backwards, its lean is negative.
 * - The column "domino" is ignored. Unknown columns are kept as text.
 */
/* The columns of the file. The first columns are the measurements of enum row_measure, in the same order. */
extern const struct csv_kind rowfile_kind;

/* Checks the measurements of a domino. They must fit together, and the lean must not make the domino fall
 * over by itself on a slope of `slope` radians. If a measurement is wrong, writes a message and returns the
 * measurement. Otherwise returns ROW_MEASURES. */
enum { MISFIT_MESSAGE = LEAN_MESSAGE };
enum row_measure domino_misfit(const struct domq_domino *domino, domq_real slope,
                               char message[MISFIT_MESSAGE]);

/* Reads all dominoes of a table. On failure, stores the problem in the table, leaves *rows empty and returns
 * false. Free *rows with listed_free. */
bool rowfile_read(struct csv_table *csv, domq_real slope, struct listed_row *rows);

/* Turns on the effect 'row' with the dominoes of a file. It is an error if a leaning domino would fall over
 * by itself on the slope of the scene. On failure, sets *problem, changes nothing and returns false. */
bool rowfile_load(struct scene *scene, const char *name, const struct run_context *run_context,
                  struct problem *problem);

/* A names_list (see names.h) of the measurements that can change. */
const char *row_measure_names(const void *context, int k);

/* Stores the unknown columns of the row's dominoes, in the form of row->others, in *others. The caller frees
 * them. They are NULL if there are no such columns. Returns false if memory runs out. */
bool rowfile_others(const struct listed_row *row, char **others);

#endif
