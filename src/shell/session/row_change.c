/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/row_change.h"
#include "language/quad.h"
#include "session/rowfile.h"
#include <stddef.h>
#include <stdlib.h>

const char *row_measure_names(const void *context, int k)
{
    (void)context;
    return k < ROW_MEASURES ? rowfile_kind.column[k].name : NULL;
}

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

/* Returns the stored change of a measurement, or NaN if the measurement has not been changed. */
static domq_real changed(const struct listed_row *row, size_t k, enum row_measure measure)
{
    return k < row->changes ? *row_measure_at(&row->change[k], measure) : DOMQ_NAN;
}

void row_changes_apply(const struct scene *scene, size_t k, struct domq_domino *d)
{
    for (enum row_measure m = 0; m < ROW_MEASURES; m++) {
        domq_real value = changed(&scene->listed, k, m), *member = row_measure_at(d, m);
        if (isnan(value))
            continue;
        if (row_measure_is_size(m)) {
            /* Dominoes above a certain height can be boxes. With its new size, a solid domino may become a
             * box, or a box may become a solid domino. */
            d->mass *= value / *member / scene_filled(scene, d);
            *member = value;
            d->mass *= scene_filled(scene, d);
        } else
            *member = m == MEASURE_MASS ? *member * value : value;
    }
}

bool row_changes_open(struct listed_row *row, size_t count)
{
    if (row->change)
        return true;
    row->change = malloc(count * sizeof *row->change);
    row->changes = row->change ? count : 0;
    for (size_t k = 0; k < row->changes; k++)
        for (enum row_measure m = 0; m < ROW_MEASURES; m++)
            *row_measure_at(&row->change[k], m) = DOMQ_NAN;
    return row->change;
}

size_t row_changes_count(const struct listed_row *row)
{
    size_t count = 0;
    for (size_t k = 0; k < row->changes; k++)
        for (enum row_measure m = 0; m < ROW_MEASURES; m++)
            count += isnan(changed(row, k, m)) ? 0 : 1;
    return count;
}

bool row_changes_equal(const struct listed_row *a, const struct listed_row *b)
{
    const size_t count = a->changes > b->changes ? a->changes : b->changes;
    bool equal = true;
    for (size_t k = 0; k < count && equal; k++)
        for (enum row_measure m = 0; m < ROW_MEASURES; m++) {
            domq_real one = changed(a, k, m), other = changed(b, k, m);
            equal = equal && (one == other || (isnan(one) && isnan(other)));
        }
    return equal;
}

void row_changes_save(const struct listed_row *row, FILE *out)
{
    char number[WIDE_TEXT];
    for (size_t k = 0; k < row->changes; k++)
        for (enum row_measure m = 0; m < ROW_MEASURES; m++) {
            domq_real value = changed(row, k, m);
            if (isnan(value))
                continue;
            /* A lean needs the '=', because it can be negative. Without the '=', 'change' would add a
             * negative value to the current lean. */
            fprintf(out, "change %zu %s %s%s %s\n", k + 1, row_measure_names(NULL, (int)m),
                    m == MEASURE_LEAN ? "= " : "",
                    quad_exact(m == MEASURE_MASS ? 100 * value : value, WIDE_DIGITS, number),
                    m == MEASURE_LEAN   ? "rad"
                    : m == MEASURE_MASS ? "%"
                                        : "m");
        }
}
