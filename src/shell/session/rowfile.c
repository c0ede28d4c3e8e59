/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/rowfile.h"
#include "answer/measure.h"
#include "io/io.h"
#include "language/names.h"
#include "language/quad.h"
#include "language/text.h"
#include "session/stands.h"
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* ---- Columns ---- */

enum { HEIGHT, THICKNESS, GAP, MASS, DENSITY, WIDTH, RADIUS, LEAN, RELATIVE, DOMINO, KINDS };

#define COLUMNS "height, thickness, gap, and, if known, mass or density, width, radius, lean"
#define LENGTHS "m, mm, cm, km, in, ft, yd"
#define LENGTH  "write a length such as 48 mm or 5*4.8 cm, or a number in the unit of the first line"
#define WEIGHT  "write a number in the unit of the first line, as in "

static const struct kind {
    const char *name, *unit;
    bool required, zero, negative;     /* zero: 0 is in the range; negative: what is below 0, too */
    double lowest, highest;            /* for masses: the range of single precision */
    const char *range, *write, *units; /* texts for messages: the range; what a cell may be; all units */
    const char *usual;                 /* the unit that messages propose */
} kinds[KINDS] = {
    {"height", "m", true, false, false, 1e-9, 1e9, "1e-9 .. 1e9 m", LENGTH, LENGTHS, "mm"},
    {"thickness", "m", true, false, false, 0, 1e11, "more than 0, up to 1e11 m", LENGTH, LENGTHS, "mm"},
    {"gap", "m", true, true, false, 0, 1e9, "0 or more, up to 1e9 m", LENGTH, LENGTHS, "mm"},
    {"mass", "kg", false, false, false, 1e-40, 1e38, "1e-40 .. 1e38 kg", WEIGHT "'mass (g)'",
     "kg, g, t, lb, oz", "g"},
    {"density", "kg/m^3", false, false, false, 0, 1e9, "more than 0, up to 1e9 kg/m^3",
     WEIGHT "'density (g/cm^3)'", "kg/m^3, g/cm^3, lb/ft^3", "g/cm^3"},
    {"width", "m", false, false, false, 0, 1e9, "more than 0, up to 1e9 m", LENGTH, LENGTHS, "mm"},
    {"radius", "m", false, true, false, 0, 1e9, "0 or more, up to 1e9 m", LENGTH, LENGTHS, "mm"},
    {"lean", "m", false, true, true, 0, 1e9, "what its top is off plumb, up to 1e9 m", LENGTH, LENGTHS, "mm"},
    {"relative", "", false, false, false, 1e-40, 1e38, "1e-40 .. 1e38",
     "write a plain number: the mass over that of the first domino", "none", ""},
    {"domino", "", false, false, false, 1, 1e6, "1 .. 1e6",
     "write a plain number; the program does not use it", "none", ""},
};

enum { CELLS = 64, LINE_MOST = 65536, FILE_MOST = 64 << 20, DOMINOES_MOST = 100000 };

struct reader {
    const struct scene *scene;
    const struct means *means;
    struct problem *problem;
    const char *path;
    FILE *in;
    long line;
    size_t bytes; /* read so far */
    bool end;     /* no line is left */
    struct text text;
    const char *separator, *between, *blanks; /* between: the separator in messages */
    int columns;                              /* 0 before the first line is read */
    int column[KINDS];                        /* the column of each kind, from 1; 0 for none */
    domq_real unit[KINDS];                    /* the unit of each kind in SI; 0 if the first line has none */
    const char *then;                         /* appended to messages: the consequence of the error, or "" */
    int cells;                                /* the number of cells of this line; at most CELLS are kept */
    char *cell[CELLS];
    char unused[200]; /* names of columns that are not used, for a note */
    char *buffer;     /* LINE_MOST bytes, too many for some stacks */
};

/* Other names that people give to columns; those of no kind are for the reader. */
static const struct synonym {
    const char *name;
    int kind;
} synonyms[] = {
    {"nr", DOMINO},      {"no", DOMINO},     {"no.", DOMINO},      {"number", DOMINO},   {"spacing", GAP},
    {"distance", GAP},   {"length", HEIGHT}, {"depth", THICKNESS}, {"thick", THICKNESS}, {"weight", MASS},
    {"plumb", LEAN},     {"tilt", LEAN},     {"note", KINDS},      {"notes", KINDS},     {"comment", KINDS},
    {"comments", KINDS}, {"remark", KINDS},  {"", KINDS},          {NULL, KINDS},
};

static const char *kind_names(const void *context, int k)
{
    (void)context;
    return k < KINDS ? kinds[k].name : NULL;
}

/* Returns the kind of a column's name; KINDS for one that is for the reader, -1 for an unknown one. */
static int kind_find(const char *name)
{
    int k = names_exact(kind_names, NULL, name);
    for (const struct synonym *s = synonyms; k < 0 && s->name; s++)
        if (strcmp(s->name, name) == 0)
            return s->kind;
    return k;
}

/* Returns the value of a unit in SI; 0 if the kind does not have this unit. */
static domq_real unit_value(const struct kind *k, const char *name)
{
    struct quantity q = expression_unit(name);
    return *k->unit && quantity_alike(q, expression_unit(k->unit)) ? q.value : 0;
}

/* Reports an error at a place in the line; NULL is its beginning. */
static void __attribute__((format(printf, 3, 4)))
report(const struct reader *r, const char *at, const char *format, ...)
{
    char message[640];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    problem_error(r->problem, "%s:%ld:%d: %s%s", r->path, r->line, at ? text_column(&r->text, at) : 1,
                  message, r->then);
}

/* Reports an error, and has the value false. */
#define wrong(...) (report(__VA_ARGS__), false)

/* ---- Lines and their cells ---- */

/* Reads the next line into r->text, or sets r->end. */
static bool line_read(struct reader *r)
{
    size_t n = 0;
    int c;
    while (n < LINE_MOST && (c = getc_unlocked(r->in)) != EOF && c != '\n' && c != '\0')
        r->buffer[n++] = (char)c;
    r->bytes += n + 1;
    r->line++;
    r->end = c == EOF && n == 0;
    if (ferror(r->in))
        return wrong(r, NULL, "cannot read any further: %s", strerror(errno));
    size_t mark = r->line == 1 && n >= 3 && memcmp(r->buffer, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    text_free(&r->text);
    if (!text_make(&r->text, r->buffer + mark, n - mark)) {
        r->text = (struct text){.line = NULL};
        return wrong(r, NULL, "out of memory");
    }
    if (n == LINE_MOST)
        return wrong(r, NULL, "the line is longer than %d bytes; write one domino on each line",
                     LINE_MOST - 1);
    if (c == '\0')
        return wrong(r, r->text.line + strlen(r->text.line),
                     "the line has a NUL byte; a csv file is text in UTF-8");
    return r->bytes <= FILE_MOST || wrong(r, NULL, "the file is larger than %d MB", FILE_MOST >> 20);
}

/* Keeps the cell at *place, and moves *place to the next cell, or to NULL. */
static bool cell_cut(struct reader *r, char **place)
{
    char *begin = *place + strspn(*place, r->blanks);
    char *end = begin + strcspn(begin, r->separator), *next = end;
    if (*begin == '"') {
        end = strchr(++begin, '"');
        if (!end)
            return wrong(r, begin - 1,
                         "this '\"' is never closed; write another '\"' at the end of the cell");
        next = end + 1 + strspn(end + 1, r->blanks);
        if (*next && *next != *r->separator)
            return wrong(r, next, "a %s is missing after the closing '\"'", r->between);
        begin += strspn(begin, " \t");
    }
    while (end > begin && isspace((unsigned char)end[-1]))
        end--;
    if (end == begin + 1 && *begin == '-') /* '-' is an empty cell */
        end--;
    *place = *next ? next + 1 : NULL;
    *end = '\0';
    if (r->cells < CELLS)
        r->cell[r->cells] = begin;
    r->cells++;
    return true;
}

/* Cuts the line into cells, each ended by a NUL. */
static bool cells_cut(struct reader *r)
{
    char *place = r->text.line;
    for (r->cells = 0; place && cell_cut(r, &place);)
        ;
    return !place;
}

/* ---- The first line ---- */

/* Reads the unit after the name of a column: "(mm)", "[mm]", "mm" or nothing. */
static bool unit_read(struct reader *r, int kind, const char *at)
{
    const struct kind *k = &kinds[kind];
    const char *begin = at + strspn(at, " \t(["), *end = begin + strcspn(begin, " \t)]");
    char name[32], shown[NAMES_SHOWN];
    bool one = end - begin < (ptrdiff_t)sizeof name && end[strspn(end, " \t)]")] == '\0';
    snprintf(name, sizeof name, "%.*s", (int)(end - begin), begin);
    char *cube = strstr(name, "\u00b3");
    if (cube)
        memcpy(cube, "^3", 2);
    if (*at == '\0') { /* then each cell needs a unit, unless it is a plain number */
        r->unit[kind] = *k->unit ? 0 : 1;
        return true;
    }
    r->unit[kind] = one ? unit_value(k, name) : 0;
    return r->unit[kind] > 0 || wrong(r, begin, "'%s' is not a unit of %s; its units are: %s",
                                      names_shown(at, shown), k->name, k->units);
}

/* Keeps the name of a column that is not used, for one note about all of them. */
static void unused_keep(struct reader *r, const char *name)
{
    char shown[NAMES_SHOWN];
    size_t used = strlen(r->unused);
    snprintf(r->unused + used, sizeof r->unused - used, "%s'%.40s'", used ? ", " : "",
             names_shown(name, shown));
}

/* Reads the name and the unit of the next column. */
static bool name_read(struct reader *r, const char *cell)
{
    char name[32];
    size_t length = strcspn(cell, " \t([_,");
    snprintf(name, sizeof name, "%.*s", (int)length, cell);
    for (char *c = name; *c; c++)
        *c = (char)tolower((unsigned char)*c);
    int k = kind_find(name);
    const char *close = k < 0 ? names_closest(kind_names, NULL, name) : NULL;
    r->columns++;
    if (isdigit((unsigned char)*cell) || *cell == '.')
        return wrong(r, cell,
                     "the first line has a number, but it names the columns: write "
                     "'height (mm), thickness (mm), gap (mm)' above");
    if (close)
        return wrong(r, cell, "unknown column '%s'; did you mean '%s'?", name, close);
    if (k < 0)
        unused_keep(r, cell);
    if (k < 0 || k == KINDS)
        return true;
    if (r->column[k] > 0)
        return wrong(r, cell, "'%s' is the %s, as column %d is; name one of them otherwise", name,
                     kinds[k].name, r->column[k]);
    r->column[k] = r->columns;
    if (r->column[MASS] > 0 && r->column[DENSITY] > 0)
        return wrong(r, cell, "both mass and density are given; leave one of these columns out");
    return unit_read(r, k, cell + length + strspn(cell + length, " \t_,"));
}

static bool head_read(struct reader *r)
{
    char named = text_separator(r->text.line);
    if (named && !r->separator) {
        r->separator = named == ';' ? ";" : named == ',' ? "," : "\t";
        return true;
    }
    if (!r->separator)
        r->separator = strchr(r->text.line, ';') ? ";" : strchr(r->text.line, ',') ? "," : "\t";
    r->between = *r->separator == ';' ? "';'" : *r->separator == ',' ? "','" : "tab";
    r->blanks = *r->separator == '\t' ? " \r\f\v" : " \t\r\f\v";
    if (!strstr(r->text.line, r->separator))
        return wrong(r, NULL,
                     "there is only one column; the first line names " COLUMNS
                     ", separated by ',', ';' or tabs");
    if (!cells_cut(r))
        return false;
    if (r->cells > CELLS)
        return wrong(r, NULL, "there are %d columns; at most %d can be read", r->cells, CELLS);
    for (int i = 0; i < r->cells; i++)
        if (!name_read(r, r->cell[i]))
            return false;
    for (int k = 0; k < KINDS; k++)
        if (kinds[k].required && r->column[k] == 0)
            return wrong(r, NULL, "the column '%s' is missing; the first line names " COLUMNS, kinds[k].name);
    if (r->column[RADIUS] > 0 && !r->scene->effect[DOM_EFFECT_edges].on)
        means_note(r->means, "%s:%ld: the radii are used while the effect edges is on: 'effect edges on'",
                   r->path, r->line);
    if (*r->unused)
        means_note(r->means, "%s:%ld: not used: the columns %s; those that are: " COLUMNS, r->path, r->line,
                   r->unused);
    return true;
}

/* ---- The dominoes ---- */

static bool no_names(struct expression *e, const char *name, const char *key,
                     const struct quantity *arguments, int count, struct quantity *result)
{
    (void)key, (void)arguments, (void)count, (void)result;
    return expression_fail(e, "'%s' has no value in a file", name);
}

static bool value_check(const struct reader *r, int kind, domq_real value, const char *at)
{
    const struct kind *k = &kinds[kind];
    double near = (double)value; /* bounds are decimals, and these in double: they are inside */
    if (k->negative && near < 0)
        near = -near;
    if (near > 0 ? near >= k->lowest && near <= k->highest : near == 0 && k->zero)
        return true;
    const char *is = near < 0 ? "negative" : near < 1 ? "too small" : "too large";
    return wrong(r, at, "%s = %s %s is %s; a %s is %s", k->name, quad_shown(value).text, k->unit, is, k->name,
                 k->range);
}

/* Reports that a unit is missing. None is guessed: metres in a file of millimetres would be a row of towers.
 */
static bool no_unit(const struct reader *r, int kind, const char *cell)
{
    const struct kind *k = &kinds[kind];
    char shown[NAMES_SHOWN], here[64] = "";
    if (*k->unit == 'm')
        snprintf(here, sizeof here, ", or '%.40s %s' in the cell", names_shown(cell, shown), k->usual);
    return wrong(r, cell, "%s has no unit: '%s' would be %s %s; write '%s (%s)' in the first line%s", k->name,
                 names_shown(cell, shown), names_shown(cell, shown), k->unit, k->name, k->usual, here);
}

/* Evaluates a cell, in SI, without a check of its range. */
static bool cell_value(const struct reader *r, int kind, const char *cell, domq_real *value)
{
    const struct kind *k = &kinds[kind];
    char shown[NAMES_SHOWN], text[48];
    struct quantity q = {.value = 0};
    struct expression e = {.text = cell, .lookup = no_names, .angle = 1};
    if (*cell == '\0')
        return wrong(r, cell, "%s is missing; only the gap of the first domino may be left out", k->name);
    if (!expression_evaluate(&e, &q))
        return wrong(r, e.end, *e.end ? "%s at '%s': %s; %s" : "%s%s: %s; %s", k->name,
                     names_shown(e.end, shown), e.message, k->write);
    const char *rest = skip_blanks(e.end);
    if (*rest)
        return wrong(r, rest, "%s ends before '%s'; %s", k->name, names_shown(rest, shown),
                     *rest == ',' ? "write decimals with a point, not with a comma" : k->write);
    bool bare = quantity_bare(q);
    if (!bare && !quantity_alike(q, expression_unit(k->unit)))
        return wrong(r, cell, "%s: this is %s; %s", k->name, expression_kind(q, text, sizeof text), k->write);
    if (bare && r->unit[kind] == 0 && q.value != 0)
        return no_unit(r, kind, cell);
    *value = bare ? q.value * r->unit[kind] : q.value;
    return true;
}

static bool row_keep(struct reader *r, struct listed_row *rows, const domq_real value[KINDS])
{
    domq_real ratio = value[THICKNESS] / value[HEIGHT];
    domq_real width = r->column[WIDTH] ? value[WIDTH] : value[HEIGHT] / 2;
    domq_real mass = r->column[MASS] ? value[MASS]
                     : r->column[RELATIVE] && !r->column[DENSITY]
                         ? value[RELATIVE]
                         : value[DENSITY] * value[HEIGHT] * value[THICKNESS] * width;
    if (!((double)ratio >= 1e-12 && (double)ratio <= 100))
        return wrong(r, r->cell[r->column[THICKNESS] - 1],
                     "thickness / height = %s is out of range; it is 1e-12 .. 100", quad_shown(ratio).text);
    if (2 * value[RADIUS] > value[THICKNESS])
        return wrong(r, r->cell[r->column[RADIUS] - 1],
                     "radius = %s m is more than half of the thickness, %s m", quad_shown(value[RADIUS]).text,
                     quad_shown(value[THICKNESS] / 2).text);
    struct domq_domino domino = {.height = value[HEIGHT],
                                 .thickness = value[THICKNESS],
                                 .gap = rows->count > 0 ? value[GAP] : 0,
                                 .mass = mass,
                                 .radius = value[RADIUS],
                                 .lean = quad(asin)(value[LEAN] / value[HEIGHT])};
    char message[LEAN_MESSAGE];
    if (value[LEAN] != 0 && !lean_stands(&domino, r->scene->train.alpha, message))
        return wrong(r, r->cell[r->column[LEAN] - 1], "%s", message);
    if (!value_check(r, MASS, mass, NULL))
        return false;
    if ((rows->count & (rows->count - 1)) == 0) { /* the arrays are full at 0, 1, 2, 4, ... */
        struct domq_domino *more = realloc(rows->domino, 2 * (rows->count + 1) * sizeof *more);
        if (!more)
            return wrong(r, NULL, "out of memory");
        rows->domino = more;
        domq_real *wider = realloc(rows->width, 2 * (rows->count + 1) * sizeof *wider);
        if (!wider)
            return wrong(r, NULL, "out of memory");
        rows->width = wider;
    }
    rows->width[rows->count] = width;
    rows->domino[rows->count++] = domino;
    return true;
}

static bool row_read(struct reader *r, struct listed_row *rows)
{
    domq_real value[KINDS] = {[DENSITY] = 1};
    if (!cells_cut(r))
        return false;
    int filled = r->cells; /* spreadsheets write empty cells at the end */
    while (filled > r->columns && filled <= CELLS && *r->cell[filled - 1] == '\0')
        filled--;
    r->cells = filled == r->columns ? filled : r->cells;
    if (r->cells != r->columns)
        return wrong(r, r->cells > r->columns ? r->cell[r->columns] : NULL,
                     "too %s cells: %d, but the first line has %d; a %s separates them%s",
                     r->cells > r->columns ? "many" : "few", r->cells, r->columns, r->between,
                     r->cells > r->columns && *r->separator == ','
                         ? ", so decimals have a point: 48.5, not 48,5"
                         : "");
    if (rows->count == DOMINOES_MOST)
        return wrong(r, NULL, "too many dominoes; a row has at most %d", DOMINOES_MOST);
    for (int k = 0; k < KINDS; k++) {
        const char *cell = r->column[k] ? r->cell[r->column[k] - 1] : NULL;
        bool none = k == GAP && rows->count == 0; /* the first domino has no gap */
        if (!cell || (none && *cell == '\0'))
            continue;
        if (!cell_value(r, k, cell, &value[k]) || (!none && !value_check(r, k, value[k], cell)))
            return false;
    }
    return row_keep(r, rows, value);
}

static bool lines_read(struct reader *r, struct listed_row *rows)
{
    for (;;) {
        if (!line_read(r))
            return false;
        if (r->end)
            return rows->count > 0 || wrong(r, NULL,
                                            "the file has no dominoes; the first line names " COLUMNS
                                            ", and each line after it is one domino");
        /* The blank before a comment is a part of it: a tab there does not separate cells. */
        char *comment = r->text.line + (text_end(r->text.line, "") - r->text.line);
        comment[*comment && comment > r->text.line ? -1 : 0] = '\0';
        if (*skip_blanks(r->text.line) != '\0' && !(r->columns ? row_read(r, rows) : head_read(r)))
            return false;
    }
}

bool rowfile_read(const struct scene *scene, const char *path, const char *then, struct listed_row *rows,
                  const struct means *means, struct problem *problem)
{
    char shown[NAMES_SHOWN];
    struct reader r = {.scene = scene,
                       .means = means,
                       .problem = problem,
                       .then = then,
                       .in = io_read(path, scene->compute.interrupt)};
    *rows = (struct listed_row){.domino = NULL};
    if (r.in && !(r.buffer = malloc(LINE_MOST))) {
        fclose(r.in);
        r.in = NULL;
    }
    if (!r.in)
        return problem_error(problem, "cannot read '%s': %s%s", names_shown(path, shown), strerror(errno),
                             then);
    /* A name must not hide the rest of a message, nor break its line. */
    r.path = strlen(path) > 255 || strpbrk(path, "\n\r\t\033") ? names_shown(path, shown) : path;
    bool good = lines_read(&r, rows);
    rows->weighed = r.column[MASS] > 0 || r.column[DENSITY] > 0;
    if (r.column[MASS] > 0 || (r.column[RELATIVE] > 0 && r.column[DENSITY] == 0)) {
        free(rows->width);
        rows->width = NULL;
    }
    text_free(&r.text);
    free(r.buffer);
    fclose(r.in);
    if (!good)
        listed_free(rows);
    return good;
}
