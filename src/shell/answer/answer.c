/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/answer.h"
#include "io/escape.h"
#include "io/terminal.h"
#include "language/quad.h"
#include <errno.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

domq_real style_angle(const struct answer_style *style, domq_real radians)
{
    return style->angle == ANGLE_DEG ? radians * (180 / QUAD_PI) : radians;
}

const char *style_angle_unit(const struct answer_style *style)
{
    return style->angle == ANGLE_DEG ? "deg" : "rad";
}

bool column_is_angle(const struct column *c)
{
    return strncmp(c->unit, "rad", 3) == 0;
}

struct column *answer_columns(struct answer *a, const struct column *columns)
{
    int n = 0;
    do
        a->own[n] = columns[n];
    while (columns[n++].key);
    a->columns = a->own;
    return a->own;
}

void answer_leave_out(struct answer *a, const char *key)
{
    struct column *c = answer_columns(a, a->columns);
    int i = 0; /* the cell of this column */
    for (; a->left_out >> i & 1 || strcmp(c->key, key) != 0; i++)
        c += !(a->left_out >> i & 1);
    a->left_out |= 1u << i;
    for (; c->key; c++)
        c[0] = c[1];
}

void answer_means(struct answer *a, const char *key, const char *meaning)
{
    for (struct column *c = answer_columns(a, a->columns); c->key; c++)
        if (strcmp(c->key, key) == 0)
            c->meaning = meaning;
}

void answer_largest(struct answer *a, const char *key, domq_real number)
{
    for (int i = 0; a->columns[i].key && isfinite(number); i++)
        if (strcmp(a->columns[i].key, key) == 0)
            a->largest[i] = fmax(a->largest[i], fabs((double)number));
}

void column_fit(struct column *c, const char *word)
{
    int wide = terminal_columns(word);
    c->width = wide > c->width ? wide : c->width;
}

/* ---- Before the first row ---- */

/* Adds a column for bounds after each column for which the first row has a number with a bound. */
static void bounds_prepare(struct answer *a, const struct cell *cells)
{
    for (int i = 0; a->columns[i].key && !a->begun && !a->planned && a->style.errors; i++)
        if (a->columns[i].width == 0 && (cells[i].kind == CELL_REAL || cells[i].kind == CELL_NONE))
            a->bounded |= 1u << i;
}

/* Chooses one unit a column for a table of rows, the largest where nothing is known of a column. */
static void measures_prepare(struct answer *a, const struct cell *cells)
{
    if (a->begun || a->planned)
        return;
    for (int i = 0; a->columns[i].key; i++) {
        bool number = cells && cells[i].kind == CELL_REAL;
        domq_real first = number ? quad(fabs)(cells[i].number) : 0, most = (domq_real)a->largest[i];
        bool known = number || most > 0;
        a->measure[i] = measure_of(a->columns[i].unit, known ? quad_larger(first, most) : (domq_real)DBL_MAX);
    }
}

/* Finds the width and the letters of the terminal. */
static void answer_ask(struct answer *a)
{
    a->on_terminal = terminal_shows(a->out);
    a->width = terminal_width(a->out);
    a->letters = a->width && terminal_utf8();
    a->bold = terminal_colour(a->out);
    errno = 0; /* asking what is no terminal sets it */
}

/* Prepares the first line: writes the blank line between answers. */
static void answer_prepare(struct answer *a)
{
    if (a->prepared)
        return;
    a->prepared = true;
    if (!a->planned)
        answer_ask(a);
    if (a->on_terminal)
        progress_end();
    if (a->gap && a->style.format->for_people)
        putc('\n', a->out);
}

void answer_plan(struct answer *a, const struct cell *like)
{
    if (!a->out || a->point) /* the rows of a point are as those of the sweep */
        return;
    answer_ask(a);
    if (like)
        bounds_prepare(a, like);
    measures_prepare(a, like);
    a->planned = true;
}

struct answer answer_part(const struct answer *a, FILE *out, bool first)
{
    struct answer part = *a;
    part.out = out;
    part.kept = NULL;
    part.begun = part.begun || !first;
    part.prepared = part.prepared || !first;
    return part;
}

/* ---- Rows ---- */

/*
 * Makes cells empty whose numbers the precision cannot hold: the one place where that is found.  Returns the
 * reason of the row, or that one in its place; people read it below the table, once.
 */
static const char *row_finite(struct answer *a, struct cell *shown, const char *reason,
                              char lost[ANSWER_REASON])
{
    const enum dom_precision precision = a->style.precision;
    const char *key = NULL;
    for (int i = 0; a->columns[i].key; i++)
        if (!cell_finite(&a->style, shown[i])) {
            shown[i].kind = CELL_NONE;
            key = key ? key : a->columns[i].key;
        }
    if (!key)
        return reason;
    bool people = a->style.format->for_people;
    snprintf(people && !*a->unsaid ? a->unsaid : lost, ANSWER_REASON,
             "%s is beyond what %s precision can hold%s", key, domq_arithmetic(precision)->name,
             precision == DOM_QUAD ? "" : "; 'set precision quad' holds more");
    return people || (reason && *reason) ? reason : lost;
}

/* Returns the text as it may be shown; *own is what the caller frees. */
static const char *shown_text(const char *text, char **own)
{
    if (!text || !escape_needed(text))
        return text;
    *own = escape_copy(text);
    return *own ? *own : "?";
}

static void answer_write(struct answer *a, const struct cell *cells, const char *reason)
{
    const struct format *format = a->style.format;
    struct cell shown[ANSWER_COLUMNS];
    char *own[ANSWER_COLUMNS] = {NULL}, lost[ANSWER_REASON]; /* own: of words, and of the reason after them */
    int count = 0;
    for (; a->columns[count].key; count++) {
        struct cell *cell = &shown[count];
        *cell = cells[count];
        cell->error = a->style.errors ? cell->error : 0;
        if (column_is_angle(&a->columns[count])) {
            cell->number = style_angle(&a->style, cell->number);
            cell->error = style_angle(&a->style, cell->error);
        }
        if (cell->kind == CELL_WORD && !format->escapes)
            cell->word = shown_text(cell->word, &own[count]);
    }
    reason = row_finite(a, shown, reason, lost);
    if (!format->escapes)
        reason = shown_text(reason, &own[count]);
    answer_prepare(a);
    bounds_prepare(a, cells);
    measures_prepare(a, cells);
    errno = 0;
    if (!a->begun && format->begin)
        format->begin(a, shown, reason);
    format->row(a, shown, reason);
    a->begun = true;
    if (ferror(a->out) && !a->lost)
        a->lost = errno;
    for (int i = 0; i <= count; i++)
        free(own[i]);
}

void answer_keep(struct answer *a, const struct cell *cells)
{
    for (int i = 0, n = 0; a->columns[n].key && a->kept; i++) {
        a->kept[i] = cells[i];
        n += !(a->left_out >> i & 1);
    }
}

bool answer_row(struct answer *a, const struct cell *cells, const char *reason)
{
    struct cell shown[ANSWER_COLUMNS];
    answer_keep(a, cells);
    for (int i = 0, n = 0; a->left_out && a->columns[n].key; i++)
        if (!(a->left_out >> i & 1))
            shown[n++] = cells[i];
    cells = a->left_out ? shown : cells;
    if (a->point) {
        a->point(a, cells, reason);
    } else if (a->out) {
        answer_write(a, cells, reason);
        if (reason)
            answer_say(a, "%s", reason);
    }
    return true;
}

bool answer_lost(const struct answer *a)
{
    return a->out && ferror(a->out) != 0;
}

bool answer_for_people(const struct answer *a)
{
    return a->out && a->style.format->for_people && !a->point;
}

void answer_say(struct answer *a, const char *format, ...)
{
    if (!answer_for_people(a))
        return;
    answer_prepare(a);
    va_list arguments;
    va_start(arguments, format);
    a->style.format->note(a, format, arguments);
    va_end(arguments);
}

void answer_line(struct answer *a, const char *text)
{
    if (!answer_for_people(a))
        return;
    answer_prepare(a);
    a->style.format->line(a, text);
}

const char *answer_end(struct answer *a)
{
    return a->style.format->end ? a->style.format->end(a) : NULL;
}
