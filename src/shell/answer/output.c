/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/output.h"
#include "answer/fitted.h"
#include "io/escape.h"
#include "io/terminal.h"
#include "language/quad.h"
#include <errno.h>
#include <stdarg.h>
#include <string.h>

/* What a number needs beside its digits: "-0." and "e-300". */
enum {
    NUMBER_MARGIN = 6,
    TEXT_LINE = 512,
    BOUND_MARGIN = 12, /* " +/- 1.2e-15" */
    WORDS_ROOM = 30,
    WORDS_SHORT = 12, /* a column of these needs no more room than it takes */
    WORDS_INDENT = 8
};

domq_real style_angle(const struct output_style *style, domq_real radians)
{
    return style->angle == ANGLE_DEG ? radians * (180 / QUAD_PI) : radians;
}

const char *style_angle_unit(const struct output_style *style)
{
    return style->angle == ANGLE_DEG ? "deg" : "rad";
}

static bool column_angle(const struct column *c)
{
    return strncmp(c->unit, "rad", 3) == 0;
}

void column_fit(struct column *c, const char *word)
{
    int wide = terminal_columns(word);
    c->width = wide > c->width ? wide : c->width;
}

/* The unit that people see. */
static const char *column_unit(const struct answer *a, const struct column *c, char text[CELL_TEXT])
{
    if (!column_angle(c))
        return c->unit;
    snprintf(text, CELL_TEXT, "%s%s", style_angle_unit(&a->style), c->unit + strlen("rad"));
    return text;
}

/* ---- Text ---- */

/* Has this column one of its own for bounds behind it?  Where the first row has numbers. */
static bool column_bounded(const struct answer *a, int i)
{
    return (a->bounded >> i & 1) != 0;
}

static void bounds_prepare(struct answer *a, const struct cell *cells)
{
    for (int i = 0; a->columns[i].key && !a->begun && !a->planned && a->style.errors; i++)
        if (a->columns[i].width == 0 && (cells[i].kind == CELL_REAL || cells[i].kind == CELL_NONE))
            a->bounded |= 1u << i;
}

/* What a number takes in a table. */
static int number_width(const struct answer *a, int digits)
{
    return digits + NUMBER_MARGIN + (a->style.errors ? BOUND_MARGIN : 0);
}

/* Digits that a table has room for: with bounds, up to what they leave. */
static int table_digits(const struct answer *a)
{
    return a->style.errors ? a->style.all_digits : (int)a->style.digits;
}

/* What has a bound shows the digits that it leaves, all else those of the style, or of the tolerance. */
static const char *table_text(const struct answer *a, struct cell cell, int digits, char text[CELL_TEXT])
{
    int most = (int)a->style.digits;
    if (cell.computed && most > a->style.tol_digits)
        most = a->style.tol_digits;
    bool bounded = a->style.errors && cell.error != 0 && isfinite(cell.error);
    return cell_text(cell, !bounded && digits > most ? most : digits, a->style.errors, text);
}

/* On a terminal with UTF-8 the field's letters are written as such. */
static const char *pretty(const struct answer *a, const char *text, char line[TEXT_LINE])
{
    enum { LETTER = 4 }; /* bytes of one with its end: ">=" becomes longer */
    static const char *const letters[][2] = {{"theta", "θ"}, {"omega", "ω"}, {"tau", "τ"}, {"sqrt", "√"},
                                             {">=", "≥"},    {"<=", "≤"},    {"+/-", "±"}};
    if (!a->letters || strlen(text) >= TEXT_LINE)
        return text;
    size_t n = 0;
    while (*text && n + LETTER < TEXT_LINE) {
        const char *with = NULL;
        for (size_t k = 0; k < sizeof letters / sizeof *letters && !with; k++) {
            size_t length = strlen(letters[k][0]);
            if (strncmp(text, letters[k][0], length) == 0) {
                with = letters[k][1];
                text += length;
            }
        }
        if (with)
            n += (size_t)snprintf(line + n, LETTER, "%s", with);
        else
            line[n++] = *text++;
    }
    line[n] = '\0';
    return line;
}

/* Rows come by the ten thousand: nobody else writes to the stream, and nothing is formatted twice. */
static void put(FILE *out, const char *text)
{
    fputs_unlocked(text, out);
}

static void put_blanks(FILE *out, int count)
{
    static const char blanks[] = "                                ";
    for (int n; count > 0; count -= n) {
        n = count < (int)sizeof blanks - 1 ? count : (int)sizeof blanks - 1;
        fwrite_unlocked(blanks, 1, (size_t)n, out);
    }
}

/* Text in a field, by columns rather than bytes; negative widths set it to the left. */
static void field(FILE *out, const char *text, int width)
{
    int blanks = (width < 0 ? -width : width) - terminal_columns(text);
    put_blanks(out, width > 0 ? blanks : 0);
    put(out, text);
    put_blanks(out, width < 0 ? blanks : 0);
}

/* Text whose lines end before the column `right`, and begin at `left`; 0 for no end. */
void output_wrapped(FILE *out, const char *text, int left, int right)
{
    int at = left;
    while (*text) {
        size_t length = strcspn(text, " ");
        int columns = 0;
        for (size_t i = 0; i < length; i++)
            columns += ((unsigned char)text[i] & 0xc0) != 0x80;
        if (at > left && right > left + 12 && at + 1 + columns > right) {
            fprintf(out, "\n%*s", left, "");
            at = left;
        }
        if (at > left)
            putc(' ', out);
        at += columns + (at > left);
        fwrite(text, 1, length, out);
        text += length + (text[length] == ' ');
    }
}

/* A cell of csv in quotes. */
static void quoted(FILE *out, const char *text)
{
    putc('"', out);
    for (const char *c = text; *c; c++)
        fputs(*c == '"' ? "\"\"" : (char[]){*c, '\0'}, out);
    putc('"', out);
}

/* ---- json and csv ---- */

static void cell_json(const struct answer *a, struct cell cell)
{
    FILE *out = a->out;
    char text[CELL_TEXT];
    if (cell.kind == CELL_NONE)
        put(out, "null");
    else if (cell.kind == CELL_FLAG)
        put(out, cell.number != 0 ? "true" : "false");
    else if (cell.kind == CELL_WORD)
        escape_json(out, cell.word);
    else
        put(out, cell_plain(&a->style, cell, text));
}

static void row_json(struct answer *a, const struct cell *cells, const char *reason)
{
    char text[CELL_TEXT];
    for (int i = 0; a->columns[i].key; i++) {
        put(a->out, i ? ",\"" : "{\"");
        put(a->out, a->columns[i].key);
        put(a->out, "\":");
        cell_json(a, cells[i]);
        if (column_bounded(a, i))
            fprintf(a->out, ",\"%s_error\":%s", a->columns[i].key,
                    cell_plain_bound(&a->style, cells[i], "null", text));
    }
    if (reason) {
        put(a->out, ",\"reason\":");
        if (*reason)
            escape_json(a->out, reason);
        else
            put(a->out, "null");
    }
    put(a->out, "}\n");
}

static void cell_csv(const struct answer *a, struct cell cell)
{
    FILE *out = a->out;
    char text[CELL_TEXT];
    if (cell.kind == CELL_FLAG)
        put(out, cell.number != 0 ? "true" : "false");
    else if (cell.kind == CELL_WORD && strpbrk(cell.word, ",\""))
        quoted(out, cell.word);
    else if (cell.kind != CELL_NONE)
        put(out, cell_plain(&a->style, cell, text));
}

static void row_csv(struct answer *a, const struct cell *cells, const char *reason)
{
    char text[CELL_TEXT];
    if (!a->begun) {
        for (int i = 0; a->columns[i].key; i++) {
            const struct column *c = &a->columns[i];
            fprintf(a->out, a->units && *c->unit ? "%s%s (%s)" : "%s%s", i ? "," : "", c->key, c->unit);
            if (column_bounded(a, i))
                fprintf(a->out, ",%s_error", c->key);
        }
        fputs(reason ? ",reason\n" : "\n", a->out);
    }
    for (int i = 0; a->columns[i].key; i++) {
        if (i)
            putc_unlocked(',', a->out);
        cell_csv(a, cells[i]);
        if (column_bounded(a, i))
            fprintf(a->out, ",%s", cell_plain_bound(&a->style, cells[i], "", text));
    }
    if (reason) {
        putc_unlocked(',', a->out);
        cell_csv(a, cell_word(reason));
    }
    putc_unlocked('\n', a->out);
}

/* ---- Tables ---- */

/* Returns the width of a column in a table of rows; with few digits the head may be the widest. */
static int column_width(const struct answer *a, const struct column *c, int digits)
{
    int number = number_width(a, digits), head = terminal_columns(c->key);
    return c->width ? c->width : number > head ? number : head;
}

/* Digits that leave room for every column of a table of rows in the width of the terminal. */
static int row_digits(const struct answer *a)
{
    int width = a->width, digits = table_digits(a), fixed = 0, numbers = 0;
    for (const struct column *c = a->columns; c->key; c++) {
        fixed += c->width + (c > a->columns ? 2 : 0);
        numbers += c->width == 0;
    }
    int room = numbers ? (width - fixed) / numbers - number_width(a, 0) : digits;
    return width == 0 || room >= digits ? digits : room < 3 ? 3 : room;
}

/* Where the last column of words begins, or -1 if it finds too little room and stands below its row. */
static int row_words(const struct answer *a, int digits)
{
    int at = 0;
    const struct column *c = a->columns;
    for (; c[1].key; c++)
        at += column_width(a, c, digits) + 2;
    int room = c->width && c->width <= WORDS_SHORT ? c->width : WORDS_ROOM;
    return a->width && a->width - at < room ? -1 : at;
}

/* One line of a table; said gives the text of a column. */
static void row_line(struct answer *a, const struct cell *cells, int digits, const char *const *said,
                     bool head)
{
    int words = row_words(a, digits), end = 0;
    for (int i = 0; a->columns[i].key; i++)
        end = *said[i] ? i + 1 : end; /* no blanks behind the last unit */
    for (int i = 0; i < end; i++) {
        const struct column *c = &a->columns[i];
        bool left = cells[i].kind == CELL_WORD, last = !a->columns[i + 1].key;
        int wide = column_width(a, c, digits);
        if (left && last && words >= 0) {
            fputs("  ", a->out);
            output_wrapped(a->out, said[i], words, a->width);
        } else if (left && last) {
            if (!head) {
                fprintf(a->out, "\n%*s", WORDS_INDENT, "");
                output_wrapped(a->out, said[i], WORDS_INDENT, a->width);
            }
        } else {
            bool open = left && !a->columns[i + 2].key && words < 0; /* no blanks at the end of the line */
            put(a->out, i ? "  " : "");
            field(a->out, said[i], open ? 0 : left ? -wide : wide);
        }
    }
    putc('\n', a->out);
}

static void row_table(struct answer *a, const struct cell *cells)
{
    char text[ANSWER_COLUMNS][CELL_TEXT], line[ANSWER_COLUMNS][TEXT_LINE];
    const char *said[ANSWER_COLUMNS];
    int digits = row_digits(a);
    bool units = false;
    for (int i = 0; i < ANSWER_COLUMNS; i++)
        said[i] = "";
    for (const struct column *c = a->columns; c->key; c++)
        units = units || *c->unit;
    for (int head = a->begun ? 0 : 2; head >= 0; head--) {
        /* The head: keys, then units, if there are any. */
        if (head == 1 && !units)
            continue;
        for (int i = 0; a->columns[i].key; i++)
            said[i] = head == 2   ? pretty(a, a->columns[i].key, line[i])
                      : head == 1 ? column_unit(a, &a->columns[i], text[i])
                                  : pretty(a, table_text(a, cells[i], digits, text[i]), line[i]);
        row_line(a, head > 0 && a->like ? a->like : cells, digits, said, head > 0);
    }
}

/* One line a column: key, value, unit, what it is. */
static void row_lines(struct answer *a, const struct cell *cells)
{
    char text[CELL_TEXT], line[TEXT_LINE], unit[CELL_TEXT];
    int key_width = 0, unit_width = 0, digits = table_digits(a);
    const char *bold = a->bold ? "\033[1m" : "", *end = *bold ? "\033[m" : "";
    for (const struct column *c = a->columns; c->key; c++) {
        int key = terminal_columns(pretty(a, c->key, line)), wide = (int)strlen(c->unit);
        key_width = key > key_width ? key : key_width;
        unit_width = wide > unit_width ? wide : unit_width;
    }
    for (int i = 0; a->columns[i].key; i++) {
        const struct column *c = &a->columns[i];
        field(a->out, pretty(a, c->key, line), -key_width);
        fprintf(a->out, "  %s", bold);
        field(a->out, pretty(a, table_text(a, cells[i], digits, text), line), number_width(a, digits));
        fprintf(a->out, "%s %-*s  ", end, unit_width,
                cells[i].kind == CELL_NONE ? "" : column_unit(a, c, unit));
        output_wrapped(a->out, pretty(a, c->meaning, line),
                       key_width + number_width(a, digits) + unit_width + 5, a->width);
        putc('\n', a->out);
    }
}

/* What the terminal can do. */
static void answer_ask(struct answer *a)
{
    a->width = terminal_width(a->out);
    a->letters = a->width && terminal_utf8();
    a->bold = terminal_colour(a->out);
    errno = 0; /* asking what is no terminal sets it */
}

/* Before the first line: the blank line between answers. */
static void answer_prepare(struct answer *a)
{
    if (a->prepared)
        return;
    a->prepared = true;
    ticker_stop(); /* before it mixes with the answer */
    if (!a->planned)
        answer_ask(a);
    if (a->gap && a->style.output == OUTPUT_TABLE)
        putc('\n', a->out);
}

void answer_plan(struct answer *a, const struct cell *like)
{
    if (!a->out || a->point) /* the rows of a point are as those of the sweep */
        return;
    answer_ask(a);
    if (like)
        bounds_prepare(a, like);
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

void answer_write(struct answer *a, const struct cell *cells, const char *reason)
{
    struct cell shown[ANSWER_COLUMNS];
    struct fitted fitted;
    for (int n = 0; a->columns[n].key; n++) {
        shown[n] = cells[n];
        shown[n].error = a->style.errors ? shown[n].error : 0;
        if (column_angle(&a->columns[n])) {
            shown[n].number = style_angle(&a->style, cells[n].number);
            shown[n].error = style_angle(&a->style, shown[n].error);
        }
    }
    reason = row_fit(a, shown, reason, &fitted);
    answer_prepare(a);
    bounds_prepare(a, cells);
    errno = 0;
    if (a->style.output == OUTPUT_JSON)
        row_json(a, shown, reason);
    else if (a->style.output == OUTPUT_CSV)
        row_csv(a, shown, reason);
    else if (a->rows)
        row_table(a, shown);
    else
        row_lines(a, shown);
    a->begun = true;
    if (ferror(a->out) && !a->lost)
        a->lost = errno;
    fitted_free(&fitted);
}

void answer_row(struct answer *a, const struct cell *cells, const char *reason)
{
    for (int n = 0; a->columns[n].key && a->kept; n++)
        a->kept[n] = cells[n];
    if (a->point) {
        a->point(a, cells, reason);
    } else if (a->out) {
        answer_write(a, cells, reason);
        if (reason)
            answer_say(a, "%s", reason);
    }
}

bool answer_lost(const struct answer *a)
{
    return a->out && ferror(a->out) != 0;
}

bool answer_for_people(const struct answer *a)
{
    return a->out && a->style.output == OUTPUT_TABLE && !a->point;
}

void answer_say(struct answer *a, const char *format, ...)
{
    char said[TEXT_LINE], text[TEXT_LINE], line[TEXT_LINE];
    if (!answer_for_people(a))
        return;
    answer_prepare(a);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(said, sizeof said, format, arguments);
    va_end(arguments);
    /* The blank lines that the format asks for, above and below; a name has no new lines. */
    size_t length = strlen(said);
    bool above = *format == '\n',
         below = length > 1 && format[strlen(format) - 1] == '\n' && said[length - 1] == '\n';
    said[length - below] = '\0';
    escape_text(said + above, text, sizeof text);
    fputs(above ? "\n" : "", a->out);
    int indent = (int)strspn(text, " ");
    fprintf(a->out, "%*s", indent, "");
    output_wrapped(a->out, pretty(a, text + indent, line), indent, a->width);
    fputs(below ? "\n\n" : "\n", a->out);
}

const char *answer_unsaid(struct answer *a)
{
    if (*a->unsaid && a->style.output == OUTPUT_TABLE)
        answer_say(a, "%s", a->unsaid);
    else if (*a->unsaid)
        return a->unsaid;
    return NULL;
}
