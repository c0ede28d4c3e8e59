/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/reference.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

void reference_add(struct reference *r, size_t at, const struct cell *cells, int count)
{
    r->first = r->rows ? r->first : at;
    if (r->rows == r->room && !r->is_void) {
        const size_t room = r->room ? 2 * r->room : 4;
        void *row = realloc(r->row, room * sizeof *r->row);
        r->is_void = !row;
        r->row = row ? row : r->row;
        r->room = row ? room : r->room;
    }
    if (r->is_void)
        return;
    struct cell *row = r->row[r->rows++];
    memset(row, 0, sizeof *r->row);
    memcpy(row, cells, (size_t)count * sizeof *cells);
    for (int i = 0; i < ANSWER_COLUMNS; i++)
        if (row[i].kind == CELL_WORD) { /* the word may be gone when it is compared */
            row[i].word = strdup(row[i].word);
            r->is_void = r->is_void || !row[i].word;
        }
}

void reference_free(struct reference *r)
{
    for (size_t k = 0; k < r->rows; k++)
        for (int i = 0; i < ANSWER_COLUMNS; i++)
            if (r->row[k][i].kind == CELL_WORD)
                free((char *)r->row[k][i].word);
    free(r->row);
}

/* Returns true if the two rows come to the same conclusions. */
static bool rows_agree(const struct cell *a, const struct cell *b, int count)
{
    for (int i = 0; i < count; i++) {
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
    return (domq_real)domq_arithmetic(style->precision)->epsilon;
}

void reference_compare(const struct answer *a, struct cell *cells, int count)
{
    const struct reference *r = a->reference;
    const size_t k = a->row - r->first;
    const struct cell *exact = !r->is_void && a->row >= r->first && k < r->rows ? r->row[k] : NULL;
    if (exact && !rows_agree(cells, exact, count))
        exact = NULL;
    for (int i = 0; i < count; i++) {
        struct cell *cell = &cells[i];
        const bool is_open = !exact || exact[i].kind != CELL_REAL;
        const domq_real difference = is_open ? DOMQ_NAN : quad(fabs)(cell->number - exact[i].number);
        const bool has_none = !cell->computed && (isnan(cell->error) || !(difference > 0));
        if (cell->kind != CELL_REAL || has_none)
            continue;
        const domq_real uncertainty = isnan(cell->error) ? 0 : cell->error;
        cell->error = difference + rounding(&a->style) * quad(fabs)(cell->number) + uncertainty;
    }
}
