/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/answer.h"
#include "io/escape.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/names.h"
#include "language/quad.h"
#include <float.h>
#include <stdlib.h>
#include <string.h>

int style_tol_digits(const struct answer_style *style, int most)
{
    return (int)fmin(fmax(floor(-log10(style->tol) + 1e-6), 1), most);
}

domq_real style_angle(const struct answer_style *style, domq_real radians)
{
    return style->angle == ANGLE_DEG ? radians * (180 / QUAD_PI) : radians;
}

const char *style_angle_unit(const struct answer_style *style)
{
    return style->angle == ANGLE_DEG ? "deg" : "rad";
}

/* ---- Columns ---- */

void column_fit(struct column *c, const char *word)
{
    int width = utf8_columns(word);
    c->width = width > c->width ? width : c->width;
}

struct column *answer_columns(struct answer *a, const struct column *columns)
{
    int n = 0;
    do
        a->copy[n] = columns[n];
    while (columns[n++].key);
    a->columns = a->copy;
    return a->copy;
}

/* Leaves out the columns that a list has or, if `listed` is false, those that it does not have. */
static void columns_leave_out(struct answer *a, const char *keys, bool listed)
{
    struct column *c = answer_columns(a, a->columns);
    int from = 0, to = 0;
    for (int cell = 0; c[from].key; cell++) {
        if (a->left_out >> cell & 1)
            continue;
        if ((names_index(keys, ' ', c[from].key) >= 0) == listed)
            a->left_out |= 1u << cell;
        else {
            c[to] = c[from];
            a->layout.largest[to] = a->layout.largest[from];
            a->layout.measure[to++] = a->layout.measure[from];
        }
        from++;
    }
    c[to].key = NULL;
}

void answer_leave_out(struct answer *a, const char *keys)
{
    columns_leave_out(a, keys, true);
}

void answer_describe(struct answer *a, const char *key, const char *unit, const char *meaning)
{
    for (struct column *c = answer_columns(a, a->columns); c->key; c++)
        if (strcmp(c->key, key) == 0) {
            c->unit = unit ? unit : c->unit;
            c->meaning = meaning ? meaning : c->meaning;
        }
}

void answer_announce(struct answer *a, const char *key, domq_real number)
{
    for (int i = 0; a->columns[i].key && isfinite(number); i++)
        if (strcmp(a->columns[i].key, key) == 0)
            a->layout.largest[i] = fmax(a->layout.largest[i], fabs((double)number));
}

/* ---- The layout, before the first row ---- */

static void terminal_look(struct answer *a)
{
    a->layout.on_terminal = terminal_shows(a->out);
    if (a->layout.on_terminal) { /* otherwise the rest of an answer keeps the width of the answer */
        a->layout.width = terminal_width(a->out);
        a->layout.letters = a->layout.width && terminal_utf8();
    }
}

void answer_plan(struct answer *a, const struct cell *sample)
{
    /* with a sink, the sweep plans one layout for the rows of all its points */
    if (a->layout.is_planned || !a->out || a->sink.take)
        return;
    a->layout.is_planned = true;
    terminal_look(a);
    for (int i = 0; a->columns[i].key; i++) {
        const bool is_real = sample && sample[i].kind == CELL_REAL,
                   has_room = a->columns[i].width == 0 || !a->style.format->for_people;
        if (a->style.errors && sample && has_room && (is_real || sample[i].kind == CELL_NONE))
            a->layout.errors |= 1u << i;
        a->errors.has_no_room = a->errors.has_no_room || (a->errors.see && is_real && !has_room);
        /* If the numbers of a column are not known yet, the column gets its largest unit. */
        domq_real most = (domq_real)a->layout.largest[i];
        most = is_real    ? quad_larger(most, quad(fabs)(sample[i].number))
               : most > 0 ? most
                          : (domq_real)DBL_MAX;
        a->layout.measure[i] = measure_of(a->columns[i].unit, most);
    }
}

/* Prepares the output for the first line of the answer. */
static void answer_open(struct answer *a)
{
    if (a->progress.is_open)
        return;
    a->progress.is_open = true;
    if (!a->layout.is_planned)
        terminal_look(a);
    if (a->layout.on_terminal)
        progress_end();
    if (a->progress.blank_above && a->style.format->for_people)
        putc('\n', a->out);
}

/* ---- Rows ---- */

/* Returns the text with escaped control characters. If the function sets *copy, the caller frees *copy. */
static const char *escaped(const char *text, char **copy)
{
    if (!text || !escape_needed(text))
        return text;
    *copy = escape_copy(text);
    return *copy ? *copy : "?";
}

static void row_write(struct answer *a, const struct cell *cells, const char *reason)
{
    const struct format *format = a->style.format;
    const enum precision precision = a->style.precision;
    struct cell shown[ANSWER_COLUMNS];
    /* escaped copies of the words, followed by a copy of the reason */
    char *copies[ANSWER_COLUMNS] = {NULL}, too_large[ANSWER_REASON];
    const char *key = NULL; /* the first column whose number is too large for the precision */
    int count = 0;
    for (; a->columns[count].key; count++) {
        struct cell *cell = &shown[count];
        *cell = cells[count];
        cell->error = a->style.errors ? cell->error : 0;
        a->errors.has_unknown = a->errors.has_unknown || (cell->kind == CELL_REAL && cell->computed &&
                                                          cell->digits == 0 && isnan(cell->error));
        if (column_is_angle(&a->columns[count])) {
            cell->number = style_angle(&a->style, cell->number);
            cell->error = style_angle(&a->style, cell->error);
        }
        if (cell->kind == CELL_WORD && !format->escapes)
            cell->word = escaped(cell->word, &copies[count]);
        if (!cell_finite(&a->style, *cell)) {
            cell->kind = CELL_NONE;
            key = key ? key : a->columns[count].key;
        }
    }
    if (key) {
        /* In formats for people, the explanation comes at the end of the answer. */
        const bool is_late = format->for_people && !*a->late_reason;
        snprintf(is_late ? a->late_reason : too_large, ANSWER_REASON, "%s is too large for %s precision%s",
                 key, any_arithmetic(precision).name,
                 precision == IN_QUAD ? "" : "; quad precision has a wider range ('set precision quad')");
        reason = format->for_people || (reason && *reason) ? reason : too_large;
    }
    if (!format->escapes)
        reason = escaped(reason, &copies[count]);
    answer_plan(a, cells);
    answer_open(a);
    if (!a->progress.has_rows && format->begin)
        format->begin(a, shown, reason);
    format->row(a, shown, reason);
    a->progress.has_rows = true;
    for (int i = 0; i <= count; i++)
        free(copies[i]);
}

/* ---- The rest of an answer ---- */

/* Makes the rest a copy of the answer that shows all columns and writes into rest->out. */
static void rest_copy(const struct answer *a, struct rest *rest)
{
    struct answer *copy = &rest->answer;
    *copy = *a;
    copy->columns = a->columns == a->copy ? copy->copy : a->columns;
    copy->out = rest->out;
    copy->kept = NULL;
    copy->details.brief = NULL;
    copy->details.rest = NULL;
    copy->errors.see = NULL; /* it has seen the cells already */
    copy->progress.is_open = true;
    copy->layout.letters = false; /* 'details > FILE' is plain text */
    copy->progress.has_rows = false;
}

/* Returns the answer that writes into the rest. Returns NULL if no rest is kept, or if memory runs out. */
static struct answer *rest_answer(struct answer *a)
{
    struct rest *rest = answer_for_people(a) ? a->details.rest : NULL;
    if (rest && !rest->out && (rest->out = open_memstream(&rest->text, &rest->size)) != NULL) {
        terminal_look(a);
        rest_copy(a, rest);
    }
    return rest && rest->out ? &rest->answer : NULL;
}

FILE *answer_rest(struct answer *a)
{
    return rest_answer(a) ? a->details.rest->out : NULL;
}

char *rest_end(struct rest *rest)
{
    if (!rest->out)
        return NULL;
    if (*rest->answer.late_reason)
        answer_say(&rest->answer, "%s", rest->answer.late_reason);
    if (fclose(rest->out) == 0 && rest->size > 0)
        return rest->text;
    free(rest->text);
    return NULL;
}

bool answer_row(struct answer *a, const struct cell *cells, const char *reason)
{
    struct cell row[ANSWER_COLUMNS];
    int count = 0; /* of all cells, including those that are left out */
    for (unsigned left = a->left_out; left; left &= left - 1)
        count++;
    for (const struct column *c = a->columns; c->key; c++)
        count++;
    memcpy(row, cells, (size_t)count * sizeof *row);
    for (int i = 0; i < count && a->in_double; i++)
        row[i].in_double = true;
    if (a->kept)
        memcpy(a->kept, row, (size_t)count * sizeof *row);
    if (a->errors.see)
        a->errors.see(a, row, (size_t)count);
    const bool is_brief = a->details.brief && *a->details.brief != '*' && answer_for_people(a);
    if (is_brief && !a->details.has_rows) { /* the rest has all columns, and the answer those of `brief` */
        a->details.has_rows = true;
        if (rest_answer(a))
            rest_copy(a, a->details.rest);
        columns_leave_out(a, a->details.brief, false);
    }
    if (is_brief && rest_answer(a))
        answer_row(&a->details.rest->answer, row, NULL);
    for (int i = 0, n = 0; a->left_out && i < count; i++)
        if (!(a->left_out >> i & 1))
            row[n++] = row[i];
    if (a->sink.take) {
        a->sink.take(a, row, reason);
    } else if (a->out) {
        if (a->columns->key)
            row_write(a, row, reason);
        if (reason)
            answer_say(a, "%s", reason);
        io_row(a->out);
    } else if (reason)
        snprintf(a->late_reason, ANSWER_REASON, "%s", reason);
    return true;
}

bool answer_lost(const struct answer *a)
{
    return dom_raised(a->progress.interrupt) || (a->out && ferror(a->out) != 0);
}

/* ---- Sentences, and the end ---- */

void answer_say(struct answer *a, const char *format, ...)
{
    if (!answer_for_people(a))
        return;
    answer_open(a);
    va_list arguments;
    va_start(arguments, format);
    a->style.format->sentence(a, format, arguments);
    va_end(arguments);
}

void answer_detail(struct answer *a, const char *format, ...)
{
    struct answer *rest = rest_answer(a);
    va_list arguments;
    va_start(arguments, format);
    if (rest)
        rest->style.format->sentence(rest, format, arguments);
    va_end(arguments);
}

void answer_set_verdict(struct answer *a, bool yes)
{
    a->verdict = yes ? ANSWER_YES : ANSWER_NO;
}
