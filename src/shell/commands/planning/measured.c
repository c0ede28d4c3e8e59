/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/planning/measured.h"
#include "io/io.h"
#include "language/names.h"
#include "language/text.h"
#include "session/effects.h"
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { GAP, SPEED, ERROR, KINDS, CELLS = 32, LINE_MOST = 4096, ROWS_MOST = 10000 };

static const struct kind {
    const char *name, *unit, *example;
    int time; /* exponent of the second; that of the metre is 1 */
} kinds[KINDS] = {{"gap", "a length", "gap (mm)", 0},
                  {"speed", "a speed", "speed (m/s)", -1},
                  {"error", "a speed", "error (m/s)", -1}};

/* Other names that people give to columns. */
static const struct synonym {
    const char *name;
    int kind;
} synonyms[] = {
    {"spacing", GAP}, {"distance", GAP}, {"separation", GAP},    {"velocity", SPEED},    {"v", SPEED},
    {"sigma", ERROR}, {"errors", ERROR}, {"uncertainty", ERROR}, {"speed error", ERROR},
};

struct reader {
    const struct query *query;
    struct problem *problem;
    const char *path;
    long line;
    int column[KINDS]; /* of a kind, from 1; 0: none */
    domq_real unit[KINDS];
    bool head;
    char separator;
};

static bool __attribute__((format(printf, 2, 3))) wrong(const struct reader *r, const char *format, ...)
{
    char message[256], shown[NAMES_SHOWN];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    if (r->line == 0) /* the file is empty */
        return problem_error(r->problem, "%s: %s", names_shown(r->path, shown), message);
    return problem_error(r->problem, "%s:%ld: %s", names_shown(r->path, shown), r->line, message);
}

/* Cuts the line into cells without quotes and blanks around them; returns their number. */
static int cells_cut(char *line, char separator, char *cell[CELLS])
{
    int n = 0;
    for (char *at = line; at && n < CELLS;) {
        at += strspn(at, separator == '\t' ? " \r" : " \t\r");
        char *quote = *at == '"' ? strchr(at + 1, '"') : NULL, *end;
        char *next = strchr(quote ? quote : at, separator);
        if (next)
            *next++ = '\0';
        if (quote) {
            *quote = '\0';
            at++;
        }
        for (end = at + strlen(at); end > at && isspace((unsigned char)end[-1]);)
            *--end = '\0';
        cell[n++] = at;
        at = next;
    }
    return n;
}

static bool of_kind(struct quantity q, const struct kind *k)
{
    return q.length == 1 && q.time == k->time && q.angle == 0 && q.mass == 0;
}

/* Returns the kind of a column's name of this length; KINDS for one that is not used. */
static int kind_find(const char *name, size_t length)
{
    for (int k = 0; k < KINDS; k++)
        if (strlen(kinds[k].name) == length && strncasecmp(kinds[k].name, name, length) == 0)
            return k;
    for (size_t s = 0; s < sizeof synonyms / sizeof *synonyms; s++)
        if (strlen(synonyms[s].name) == length && strncasecmp(synonyms[s].name, name, length) == 0)
            return synonyms[s].kind;
    return KINDS;
}

/* Reads a name of the first line, such as "gap (mm)", "gap, mm" or "gap mm". */
static bool name_read(struct reader *r, char *name, int column)
{
    size_t length = strcspn(name, "([,"), end = length;
    while (length > 0 && isspace((unsigned char)name[length - 1]))
        length--;
    int k = kind_find(name, length);
    if (k == KINDS && name[end] == '\0') {
        while (end > 0 && name[end - 1] != ' ' && name[end - 1] != '_')
            end--;
        k = end > 0 ? kind_find(name, end - 1) : KINDS;
    }
    if (k == KINDS)
        return true;
    if (r->column[k])
        return wrong(r, "two columns are the %s; one is right", kinds[k].name);
    r->column[k] = column;
    char *unit = name + end + strspn(name + end, " ([,");
    if (*unit == '\0')
        return true;
    unit[strcspn(unit, ")]")] = '\0';
    struct quantity q = expression_unit(unit);
    r->unit[k] = q.value;
    return of_kind(q, &kinds[k]) ||
           wrong(r, "'%.20s' is not the unit of %s; write '%s'", unit, kinds[k].unit, kinds[k].example);
}

static bool head_read(struct reader *r, char *line)
{
    char *cell[CELLS];
    char named = text_separator(line);
    if (named && !r->separator) {
        r->separator = named;
        return true;
    }
    bool tabs = strchr(line, '\t') && !strchr(line, ',');
    if (!r->separator)
        r->separator = *(strchr(line, ';') ? ";" : tabs ? "\t" : ",");
    int n = cells_cut(line, r->separator, cell);
    r->head = true;
    for (int i = 0; i < n; i++)
        if (!name_read(r, cell[i], i + 1))
            return false;
    return (r->column[GAP] && r->column[SPEED]) ||
           wrong(
               r,
               "the column '%s' is missing; the first line is 'gap (mm), speed (m/s)', and 'error (m/s)' if "
               "it is known",
               kinds[r->column[GAP] ? SPEED : GAP].name);
}

/* Allows no names in the expressions of a file, so that the file means the same in every session. */
static bool no_name(struct expression *e, const char *name, const char *key, const struct quantity *arguments,
                    int count, struct quantity *result)
{
    (void)key, (void)arguments, (void)count, (void)result;
    return expression_fail(e, "'%s' has no value in a file", name);
}

static bool cell_read(struct reader *r, int k, const char *cell, domq_real *value)
{
    struct quantity q;
    struct expression e = {.text = cell, .angle = 1, .lookup = no_name};
    if (!expression_evaluate(&e, &q) || *skip_blanks(e.end) != '\0')
        return wrong(r, "'%.20s' is not %s; write %s", cell, kinds[k].unit,
                     strchr(cell, ',') ? "decimals with a point, not with a comma" : "a number");
    bool bare = quantity_bare(q);
    if (bare && r->unit[k] == 0)
        return wrong(r, "'%.20s' has no unit: it would be %.20s %s; write '%s' in the first line", cell, cell,
                     k == GAP ? "m" : "m/s", kinds[k].example);
    if (!bare && !of_kind(q, &kinds[k]))
        return wrong(r, "'%.20s' is not %s", cell, kinds[k].unit);
    *value = bare ? q.value * r->unit[k] : q.value;
    return (*value > 0 && isfinite(*value)) ||
           wrong(r, "'%.20s': %s is a number above 0", cell, kinds[k].name);
}

static bool row_read(struct reader *r, char *line, struct measured_rows *rows)
{
    char *cell[CELLS];
    int n = cells_cut(line, r->separator, cell);
    domq_real value[KINDS] = {0};
    for (int k = 0; k < KINDS; k++) {
        const char *c = r->column[k] > 0 && r->column[k] <= n ? cell[r->column[k] - 1] : "";
        bool empty = *c == '\0' || strcmp(c, "-") == 0;
        if (empty && k != ERROR)
            return wrong(r, "%s is missing; the first line has it in column %d", kinds[k].name, r->column[k]);
        if (!empty && !cell_read(r, k, c, &value[k]))
            return false;
    }
    if (rows->count > 0 && (value[ERROR] > 0) != rows->errors)
        return wrong(r, "some speeds have an error and some have none; give all of them one, or none");
    rows->errors = value[ERROR] > 0;
    if (rows->count == ROWS_MOST)
        return wrong(r, "more than %d speeds", ROWS_MOST);
    struct measured_row *more = realloc(rows->row, (rows->count + 1) * sizeof *more);
    if (!more)
        return problem_status(r->problem, r->query->scene, DOM_NO_MEMORY);
    rows->row = more;
    rows->row[rows->count++] =
        (struct measured_row){.gap = value[GAP], .speed = value[SPEED], .error = value[ERROR]};
    return true;
}

static bool lines_read(struct reader *r, FILE *in, struct measured_rows *rows)
{
    char *line = NULL;
    size_t size = 0;
    ssize_t length;
    bool good = true;
    while (good && (length = text_read(&line, &size, in)) != -1) {
        r->line++;
        char *at = line + (r->line == 1 && strncmp(line, "\xef\xbb\xbf", 3) == 0 ? 3 : 0);
        at[strcspn(at, "#\n")] = '\0';
        if (length >= LINE_MOST || strlen(line) > (size_t)length)
            good = wrong(r, "the line is not a line of a csv file");
        else if (*skip_blanks(at) != '\0')
            good = r->head ? row_read(r, at, rows) : head_read(r, at);
    }
    free(line);
    if (good && ferror(in))
        return wrong(r, "cannot read any further: %s", strerror(errno));
    return good && (rows->count > 0 ||
                    wrong(r, "no speeds; the first line is 'gap (mm), speed (m/s)', each line after "
                             "it a row that was measured"));
}

bool measured_read(const struct query *query, struct problem *problem, const char *path,
                   struct measured_rows *rows)
{
    char shown[NAMES_SHOWN];
    char *beside = means_beside(query->means, path);
    FILE *in = beside ? io_read(beside, query->scene->compute.interrupt) : NULL;
    int reason = errno;
    struct reader r = {.query = query, .problem = problem, .path = path};
    *rows = (struct measured_rows){.row = NULL};
    free(beside);
    if (!in)
        return problem_error(problem, "cannot read '%s': %s", names_shown(path, shown), strerror(reason));
    bool good = lines_read(&r, in, rows);
    fclose(in);
    if (!good) {
        free(rows->row);
        rows->row = NULL;
    }
    return good;
}
