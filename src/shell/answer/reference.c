/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/reference.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

void reference_add(struct reference *r, size_t at, const struct cell *cells, size_t columns)
{
    if (r->rows == 0) {
        r->first = at;
        r->columns = columns;
    }
    if (r->rows == r->room && !r->is_void) {
        const size_t room = r->room ? 2 * r->room : 4;
        void *all = realloc(r->cell, room * r->columns * sizeof *r->cell);
        r->cell = all ? all : r->cell;
        r->room = all ? room : r->room;
        r->is_void = !all;
    }
    if (r->is_void || columns != r->columns) {
        r->is_void = true;
        return;
    }
    struct cell *row = r->cell + r->columns * r->rows++;
    memcpy(row, cells, columns * sizeof *cells);
    for (size_t i = 0; i < columns; i++)
        if (row[i].kind == CELL_WORD) { /* the word may be gone when it is compared */
            row[i].word = strdup(row[i].word);
            r->is_void = r->is_void || !row[i].word;
        }
}

void reference_free(struct reference *r)
{
    for (size_t i = 0; i < r->rows * r->columns; i++)
        if (r->cell[i].kind == CELL_WORD)
            free((char *)r->cell[i].word);
    free(r->cell);
}

/* Returns true if the two rows come to the same conclusions. */
static bool rows_agree(const struct cell *a, const struct cell *b, size_t columns)
{
    for (size_t i = 0; i < columns; i++) {
        if (a[i].kind == CELL_WORD && b[i].kind == CELL_WORD && strcmp(a[i].word, b[i].word) != 0)
            return false;
        const bool is_conclusion = a[i].kind == CELL_COUNT || a[i].kind == CELL_FLAG;
        if (is_conclusion && a[i].kind == b[i].kind && a[i].number != b[i].number)
            return false;
    }
    return true;
}

/* Returns the relative distance between neighbouring numbers of the style's precision. */
static domq_real rounding(const struct answer_style *style)
{
    return (domq_real)any_arithmetic(style->precision).epsilon;
}

void reference_compare(const struct reference *r, size_t at, const struct answer_style *style,
                       struct cell *cells, size_t columns)
{
    const bool has_row = !r->is_void && at >= r->first && at - r->first < r->rows && columns == r->columns;
    const struct cell *exact = has_row ? r->cell + r->columns * (at - r->first) : NULL;
    if (exact && !rows_agree(cells, exact, columns))
        exact = NULL;
    for (size_t i = 0; i < columns; i++) {
        struct cell *cell = &cells[i];
        const bool is_open = !exact || exact[i].kind != CELL_REAL;
        const domq_real difference = is_open ? DOMQ_NAN : quad(fabs)(cell->number - exact[i].number);
        const bool has_none = !cell->computed && (isnan(cell->error) || !(difference > 0));
        if (cell->kind != CELL_REAL || has_none)
            continue;
        const domq_real uncertainty = isnan(cell->error) ? 0 : cell->error;
        cell->error = difference + rounding(style) * quad(fabs)(cell->number) + uncertainty;
    }
}
