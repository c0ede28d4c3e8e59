/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/row_change.h"
#include "language/quad.h"
#include <stddef.h>
#include <stdlib.h>

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
    return k < row->changes ? *row_measure_at(&row->change[k].to, measure) : DOMQ_NAN;
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
    for (size_t k = 0; k < row->changes; k++) {
        row->change[k].origin = k;
        for (enum row_measure m = 0; m < ROW_MEASURES; m++)
            *row_measure_at(&row->change[k].to, m) = DOMQ_NAN;
    }
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

static size_t origin_of(const struct listed_row *row, size_t k)
{
    return row->changes > 0 ? row->change[k].origin : k;
}

bool row_changes_equal(const struct scene *a, const struct scene *b)
{
    const size_t count = scene_row_count(a);
    bool equal = count == scene_row_count(b);
    for (size_t k = 0; k < count && equal; k++) {
        equal = origin_of(&a->listed, k) == origin_of(&b->listed, k);
        for (enum row_measure m = 0; m < ROW_MEASURES; m++) {
            domq_real one = changed(&a->listed, k, m), other = changed(&b->listed, k, m);
            equal = equal && (one == other || (isnan(one) && isnan(other)));
        }
    }
    return equal;
}
