/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/names.h"
#include "language/quad.h"
#include "rows/rows.h"
#include <stdlib.h>
#include <string.h>

enum { DENSITY = ROW_MEASURES, RELATIVE, DOMINO, PITCH, POSITION, KINDS };

#define LENGTH                                                                                               \
    CSV_LENGTH, "write a length such as 48 mm or 5*4.8 cm, or a number in the unit of the first line"
#define WEIGHT "write a number in the unit of the first line, as in "
#define PLAIN  "", "none", "", "write a plain number: "

/* The limits of a mass are close to those of float, the lowest precision. */
static const struct csv_column columns[KINDS] = {
    [MEASURE_HEIGHT] = {"height", CSV_REQUIRED, LENGTH, 1e-9, 1e9, "1e-9 .. 1e9 m"},
    [MEASURE_THICKNESS] = {"thickness", CSV_REQUIRED, LENGTH, CSV_ABOVE_0, 1e11, "more than 0, up to 1e11 m"},
    [MEASURE_GAP] = {"gap", CSV_REQUIRED | CSV_NOT_FIRST | CSV_ONE_OF, LENGTH, 0, 1e9, "0 .. 1e9 m"},
    [MEASURE_MASS] = {"mass", 0, "kg", "kg, g, t, lb, oz", "g", WEIGHT "'mass (g)'", 1e-40, 1e38,
                      "1e-40 .. 1e38 kg"},
    [MEASURE_RADIUS] = {"radius", 0, LENGTH, 0, 1e9, "0 .. 1e9 m"},
    [MEASURE_LEAN] = {"lean", 0, LENGTH, -1e9, 1e9, "-1e9 .. 1e9 m"},
    [MEASURE_WIDTH] = {"width", 0, LENGTH, CSV_ABOVE_0, 1e9, "more than 0, up to 1e9 m"},
    [DENSITY] = {"density", 0, "kg/m^3", "kg/m^3, g/cm^3, lb/ft^3", "g/cm^3", WEIGHT "'density (g/cm^3)'",
                 CSV_ABOVE_0, 1e9, "more than 0, up to 1e9 kg/m^3"},
    [RELATIVE] = {"relative", 0, PLAIN "the mass divided by the mass of the first domino", 1e-40, 1e38,
                  "1e-40 .. 1e38"},
    [DOMINO] = {"domino", 0, PLAIN "the number of the domino (the program ignores this column)", 1, 1e6,
                "1 .. 1e6"},
    [PITCH] = {"pitch", CSV_NOT_FIRST | CSV_ONE_OF, LENGTH, 0, 1e9, "0 .. 1e9 m"},
    [POSITION] = {"position", CSV_ONE_OF, LENGTH, -1e9, 1e9, "-1e9 .. 1e9 m"},
};

const struct csv_kind rowfile_kind = {
    .column = columns,
    .columns = KINDS,
    .rows_most = 100000,
    .names =
        "height, thickness, gap (or pitch, or position), and, if known, mass or density, width, radius, lean",
};

const char *row_measure_names(const void *context, int k)
{
    (void)context;
    return k < ROW_MEASURES ? rowfile_kind.column[k].name : NULL;
}

/* ---- Measurements ---- */

domq_real *row_measure_at(struct domq_domino *domino, enum row_measure measure)
{
    static const size_t member[ROW_MEASURES] = {
        [MEASURE_HEIGHT] = offsetof(struct domq_domino, height),
        [MEASURE_THICKNESS] = offsetof(struct domq_domino, thickness),
        [MEASURE_GAP] = offsetof(struct domq_domino, gap),
        [MEASURE_MASS] = offsetof(struct domq_domino, mass),
        [MEASURE_RADIUS] = offsetof(struct domq_domino, radius),
        [MEASURE_LEAN] = offsetof(struct domq_domino, lean),
        [MEASURE_WIDTH] = offsetof(struct domq_domino, width),
    };
    return (void *)((char *)domino + member[measure]);
}

domq_real lean_offset(const struct domq_domino *domino)
{
    return domino->height * quad(sin)(domino->lean);
}

bool lean_stands(const struct domq_domino *domino, domq_real alpha, char message[LEAN_MESSAGE])
{
    domq_real lean[2], limit;
    domq_lean_limits(domino, alpha, 0, lean);
    if (domino->lean > lean[0] && domino->lean < lean[1])
        return true;
    limit = domino->lean < 0 ? lean[0] : lean[1];
    snprintf(message, LEAN_MESSAGE,
             "with its top %s off plumb, this domino falls over by itself; the limit%s is %s",
             measured(lean_offset(domino), "m", 4).text, alpha != 0 ? " on this slope" : "",
             measured(domino->height * quad(sin)(limit), "m", 4).text);
    return false;
}

/* ---- The file ---- */

/* Makes room for one more domino. */
static bool rows_grow(struct row_file *rows)
{
    /* the array grows when the count is 0 or a power of 2 */
    if ((rows->count & (rows->count - 1)) != 0)
        return true;
    size_t room = 2 * (rows->count + 1);
    void *more = realloc(rows->domino, room * sizeof *rows->domino);
    rows->domino = more ? more : rows->domino;
    return more;
}

enum row_measure domino_misfit(const struct domq_domino *d, domq_real slope, char message[MISFIT_MESSAGE])
{
    const domq_real ratio = d->thickness / d->height;
    if (!((double)ratio >= 1e-12 && (double)ratio <= 100)) {
        snprintf(message, MISFIT_MESSAGE,
                 "thickness / height = %s is out of range; the range is 1e-12 .. 100", quad_text(ratio, 10));
        return MEASURE_THICKNESS;
    }
    if (2 * d->radius > d->thickness) {
        snprintf(message, MISFIT_MESSAGE, "radius = %s m is more than %s m, half of the thickness",
                 quad_text(d->radius, 10), quad_text(d->thickness / 2, 10));
        return MEASURE_RADIUS;
    }
    return d->lean == 0 || lean_stands(d, slope, message) ? ROW_MEASURES : MEASURE_LEAN;
}

/* What the file says about domino 1, which has no domino before it. */
struct first {
    domq_real gap; /* or pitch; 0 if there is none */
    struct csv_place at;
};

/* Returns false if domino 1 has a gap or a pitch and this line has a different one. The numbers may then be
 * measured from each domino to the next, instead of from the domino before. */
static bool first_check(struct csv_table *csv, const struct first *first, int k)
{
    const char *name = columns[k].name;
    return first->gap == 0 ||
           quad(fabs)(csv->value[k] - first->gap) <= (domq_real)1e-12 * quad(fabs)(first->gap) ||
           csv_wrong(&csv->file, first->at,
                     "domino 1 has no %s, because a %s is measured from the domino before; leave this cell "
                     "empty, or if your numbers are measured to the next domino, move all one line down",
                     name, name);
}

/* Finds the gap before the domino in the current row of the file. `before` is the number of dominoes before
 * it, and `position` is that of the last of them. Pitches and positions are those of front faces, the faces
 * in the direction of the fall. */
static bool gap_find(struct csv_table *csv, size_t before, domq_real position, struct first *first,
                     domq_real *gap)
{
    const bool is_position = csv->column[POSITION];
    const int k = csv->column[MEASURE_GAP] ? MEASURE_GAP : PITCH;
    const domq_real here = is_position ? csv->value[POSITION] : 0, thickness = csv->value[MEASURE_THICKNESS],
                    pitch = is_position ? here - position : csv->value[PITCH];
    if (before == 0) {
        *gap = 0;
        if (!is_position && !isnan(csv->value[k]))
            *first = (struct first){csv->value[k], csv_cell(csv, k).at};
        return true;
    }
    if (!is_position && !first_check(csv, first, k))
        return false;
    if (csv->column[MEASURE_GAP]) {
        *gap = csv->value[MEASURE_GAP];
        return true;
    }
    *gap = pitch - thickness;
    if (quad(fabs)(*gap) <
        (domq_real)1e-12 * (quad(fabs)(here) + pitch)) /* the dominoes touch, apart from rounding errors */
        *gap = 0;
    return *gap >= 0 ||
           csv_wrong(
               &csv->file, csv_cell(csv, is_position ? POSITION : PITCH).at,
               "the front face of domino %zu is %s m beyond that of domino %zu, but must be at least its "
               "thickness, %s m, beyond; list the dominoes in the order in which they fall; if these are "
               "gaps, call the column 'gap'",
               before + 1, quad_text(pitch, 6), before, quad_text(thickness, 6));
}

/* Adds the domino in the current row of the file. `position` is that of the domino before. */
static bool row_keep(struct csv_table *csv, domq_real slope, domq_real position, struct first *first,
                     struct row_file *rows)
{
    const domq_real *value = csv->value, height = value[MEASURE_HEIGHT], thickness = value[MEASURE_THICKNESS];
    const domq_real width = csv->column[MEASURE_WIDTH] ? value[MEASURE_WIDTH] : 0;
    domq_real density = csv->column[DENSITY] ? value[DENSITY] : 1;
    struct domq_domino domino = {
        .height = height,
        .thickness = thickness,
        .mass = csv->column[MEASURE_MASS] ? value[MEASURE_MASS]
                                          : density * height * thickness * (width > 0 ? width : height / 2),
        .radius = csv->column[MEASURE_RADIUS] ? value[MEASURE_RADIUS] : 0,
        .lean = csv->column[MEASURE_LEAN] ? quad(asin)(value[MEASURE_LEAN] / height) : 0,
        .width = width};
    char message[MISFIT_MESSAGE];
    if (!gap_find(csv, rows->count, position, first, &domino.gap))
        return false;
    if (csv->column[RELATIVE] && !rows->has_masses)
        domino.mass = value[RELATIVE];
    const enum row_measure misfit = domino_misfit(&domino, slope, message);
    if (misfit != ROW_MEASURES)
        return csv_wrong(&csv->file, csv_cell(csv, (int)misfit).at, "%s", message);
    if (!csv_check(csv, MEASURE_MASS, domino.mass))
        return false;
    if (!rows_grow(rows))
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    rows->domino[rows->count++] = domino;
    return true;
}

void rowfile_drop(struct row_file *file)
{
    if (file && --file->holders == 0) {
        free(file->domino);
        free(file->path);
        free(file);
    }
}

struct row_file *rowfile_read(struct csv_table *csv, domq_real slope)
{
    domq_real position = 0;
    struct first first = {.gap = 0};
    struct row_file *file = malloc(sizeof *file);
    if (!file) {
        csv_wrong(&csv->file, csv->file.at, "out of memory");
        return NULL;
    }
    const bool has_masses = csv->column[MEASURE_MASS] || csv->column[DENSITY];
    *file = (struct row_file){.holders = 1,
                              .has_masses = has_masses,
                              .from_volumes =
                                  !csv->column[MEASURE_MASS] && (has_masses || !csv->column[RELATIVE])};
    if (csv->column[MEASURE_MASS] && csv->column[DENSITY])
        csv_wrong(&csv->file, csv->head.cell[csv->column[DENSITY] - 1].at,
                  "both mass and density are given; leave one of these columns out");
    bool good = true;
    for (; good && !*csv->file.problem.text && csv_next(csv); position = csv->value[POSITION])
        good = row_keep(csv, slope, position, &first, file);
    if (!*csv->file.problem.text)
        return file;
    rowfile_drop(file);
    return NULL;
}
