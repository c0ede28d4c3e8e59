/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tables/csv_table.h"
#include "io/escape.h"
#include "language/expression.h"
#include "language/names.h"
#include "language/quad.h"
#include "language/text.h"
#include "tables/csv_names.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

struct csv_cell csv_cell(const struct csv_table *csv, int k)
{
    int i = csv->column[k] - 1;
    return i >= 0 && i < csv->row.cells ? csv->row.cell[i] : (struct csv_cell){.text = "", .at = csv->row.at};
}

/* A dash may stand for an empty cell: "-", an en dash, an em dash or a minus sign. */
static bool is_empty(const char *text)
{
    return names_index("|-|\u2013|\u2014|\u2212", '|', text) >= 0;
}

/* ---- Units ---- */

static bool unit_read(struct csv_table *csv, int k, const char *text, struct csv_place at)
{
    char unit[CSV_UNIT];
    const struct csv_column *c = &csv->kind->column[k];
    if (strstr(c->name, " %") && strchr(text, '%')) {
        csv->unit[k] = (domq_real)1 / 100;
        return true;
    }
    bool known = csv_unit_copy(text, unit) && c->unit && *c->unit;
    struct quantity q = expression_unit(unit);
    const char *shown = names_shown(text);
    if (!known || !quantity_alike(q, expression_unit(c->unit)))
        return csv_wrong(&csv->file, at, "'%s' is not a unit of %s; its units are: %s", shown, c->name,
                         c->units);
    if (csv->unit[k] > 0 && csv->unit[k] != q.value)
        return csv_wrong(
            &csv->file, at, "'%s' differs from the unit of %s in the first line; %s", shown, c->name,
            c->traits & CSV_REPEATED ? "use one unit in all its columns" : "delete one of the two units");
    csv->unit[k] = q.value;
    return true;
}

/* Returns the column of a kind that may occur several times. */
static int repeated_find(const struct csv_kind *kind)
{
    int k = 0;
    while (k + 1 < kind->columns && !(kind->column[k].traits & CSV_REPEATED))
        k++;
    return k;
}

/* Reads the second line. If the line does not give units, it is the first row. */
static bool units_read(struct csv_table *csv)
{
    char unit[CSV_UNIT];
    bool units = false, good = true;
    if (!csv_read(&csv->file, &csv->row))
        return !*csv->file.problem.text;
    for (int k = 0; k < csv->kind->columns; k++)
        units = units || csv_unit_copy(csv_cell(csv, k).text, unit);
    for (int k = 0; k < csv->kind->columns && units && good; k++)
        good =
            is_empty(csv_cell(csv, k).text) || unit_read(csv, k, csv_cell(csv, k).text, csv_cell(csv, k).at);
    for (int i = 0; i < csv->row.cells && units && good; i++)
        good = !csv->repeats[i] || is_empty(csv->row.cell[i].text) ||
               unit_read(csv, repeated_find(csv->kind), csv->row.cell[i].text, csv->row.cell[i].at);
    if (units)
        csv->units = csv->row;
    csv->is_read_ahead = !units;
    return good;
}

/* ---- The first line ---- */

static const char *column_names(const void *context, int k)
{
    const struct csv_kind *kind = context;
    return k < kind->columns ? kind->column[k].name : NULL;
}

/* Returns true if the first line names all columns that a file of this kind must have. */
static bool kind_fits(const struct csv_table *csv, const struct csv_kind *kind)
{
    bool found[CSV_COLUMNS_MOST + 1] = {false}, fits = true;
    char name[NAMES_SHOWN];
    bool one_of = false;
    for (int i = 0; i < csv->head.cells; i++) {
        const char *unit = csv_name_split(csv->head.cell[i].text, name);
        const int k = csv_column_find(kind, name, unit);
        found[k] = true;
        one_of = one_of || (k < kind->columns && kind->column[k].traits & CSV_ONE_OF);
    }
    for (int k = 0; k < kind->columns; k++)
        fits = fits && (found[k] || !(kind->column[k].traits & CSV_REQUIRED) ||
                        (one_of && kind->column[k].traits & CSV_ONE_OF));
    return fits;
}

/* Returns the column of a kind of which there may be only one that the file has, or -1. */
static int one_of_find(const struct csv_table *csv)
{
    int found = -1;
    for (int k = 0; k < csv->kind->columns && found < 0; k++)
        found = csv->column[k] > 0 && csv->kind->column[k].traits & CSV_ONE_OF ? k : -1;
    return found;
}

/* Returns true if the file lacks column k and needs it. */
static bool is_missing(const struct csv_table *csv, int k)
{
    const unsigned traits = csv->kind->column[k].traits;
    return traits & CSV_REQUIRED && csv->column[k] == 0 && !(traits & CSV_ONE_OF && one_of_find(csv) >= 0);
}

/* Reports that a required column is missing. */
static bool column_missing(struct csv_table *csv, const char *missing)
{
    const struct csv_kind *kind = csv->kind;
    char found[320] = "";
    bool is_utf8 = true;
    for (int i = 0; i < csv->head.cells; i++) {
        is_utf8 = is_utf8 && escape_is_utf8(csv->head.cell[i].text);
        text_add(found, sizeof found, "%s'%.24s'", i ? ", " : "", names_shown(csv->head.cell[i].text));
    }
    if (!is_utf8)
        return csv_wrong(&csv->file, csv->head.at,
                         "the column '%s' is missing, and the names are not in UTF-8; save the file as 'CSV "
                         "UTF-8'; found: %s",
                         missing, found);
    return csv_wrong(&csv->file, csv->head.at,
                     "the column '%s' is missing; the first line must name %s (delete a title above it, or "
                     "begin the title with '#'); found: %s",
                     missing, kind->names, found);
}

/* Returns true if the file has single trials of a measurement, so that their average is not used. */
static bool has_trials(const struct csv_table *csv)
{
    bool found = false;
    char name[NAMES_SHOWN];
    for (int i = 0; i < csv->head.cells && !found; i++) {
        const int k = csv_column_find(csv->kind, name, csv_name_split(csv->head.cell[i].text, name));
        found = k < csv->kind->columns && csv->kind->column[k].traits & CSV_REPEATED && !csv_is_average(name);
    }
    return found;
}

static bool name_read(struct csv_table *csv, int i, const char *text)
{
    const struct csv_kind *kind = csv->kind;
    const struct csv_place at = csv->head.cell[i].at;
    char name[NAMES_SHOWN];
    const char *unit = csv_name_split(text, name), *close = NULL;
    bool note =
        names_index(",note,notes,comment,comments,remark,notiz,bemerkung,opmerking,remarque", ',', name) >= 0;
    const int k = csv_column_find(kind, name, unit);
    const bool repeated = k < kind->columns && kind->column[k].traits & CSV_REPEATED;
    csv->other[i] = k == kind->columns;
    if (isdigit((unsigned char)*text) || *text == '.')
        return csv_wrong(&csv->file, at,
                         "the first line has a number, but must name the columns: write '%s' above it",
                         kind->example);
    if (csv->other[i] && !note && (close = names_closest(column_names, kind, name)) != NULL)
        return csv_wrong(&csv->file, at, "unknown column '%s'; did you mean '%s'?", name, close);
    if (csv->other[i] && !note)
        text_add(csv->unused, sizeof csv->unused, "%s'%.40s'", *csv->unused ? ", " : "", names_shown(text));
    csv->other[i] = csv->other[i] || (repeated && csv_is_average(name) && has_trials(csv));
    if (csv->other[i])
        return true;
    const int other = kind->column[k].traits & CSV_ONE_OF ? one_of_find(csv) : -1;
    if (other >= 0 && other != k)
        return csv_wrong(&csv->file, at, "both %s and %s are given; leave one of these columns out",
                         kind->column[other].name, kind->column[k].name);
    if (repeated && csv->column[k] > 0) {
        csv->repeats[csv->column[k] - 1] = csv->repeats[i] = true;
        return *unit == '\0' || unit_read(csv, k, unit, at);
    }
    if (csv->column[k] > 0)
        return csv_wrong(&csv->file, at,
                         "column name '%s' stands for the %s, but so does column %d; rename one of the two",
                         name, kind->column[k].name, csv->column[k]);
    csv->column[k] = i + 1;
    return *unit == '\0' || unit_read(csv, k, unit, at);
}

static bool head_read(struct csv_table *csv)
{
    const struct csv_kind *kind = csv->kind;
    struct text text;
    int others = 0;
    bool good = true;
    if (!csv_read(&csv->file, &csv->head))
        return !*csv->file.problem.text; /* csv_next reports an empty file */
    while (kind && !kind_fits(csv, kind))
        kind = kind->otherwise;
    kind = csv->kind = kind ? kind : csv->kind;
    if (csv->head.cells == 1 && strncmp(csv->head.cell[0].text, "set ", strlen("set ")) == 0)
        return csv_wrong(&csv->file, csv->head.at, "this is not a table but a session; 'source %s' runs it",
                         names_shown(csv->path));
    if (csv->head.cells == 1 && !kind_fits(csv, kind))
        return csv_wrong(&csv->file, csv->head.at,
                         "there is only one column; %sthe first line must name %s, separated by ',', ';' or "
                         "tabs; delete a "
                         "title above it, or begin the title with '#'",
                         csv_single_advice(kind, (char[CSV_ADVICE]){""}), kind->names);
    for (int i = 0; i < csv->head.cells && good; i++) {
        const char *name = csv->head.cell[i].text;
        if (!text_make(&text, name, strlen(name)))
            return csv_wrong(&csv->file, csv->head.at, "out of memory");
        good = name_read(csv, i, text.line);
        others += csv->other[i];
        text_free(&text);
    }
    /* if this file were saved with more columns, it could not be read again */
    if (good && others > CSV_OTHERS_MOST)
        return csv_wrong(
            &csv->file, csv->head.at,
            "the file has %d columns that are not used, but the limit is %d; delete some of them", others,
            CSV_OTHERS_MOST);
    for (int k = 0; k < kind->columns && good; k++)
        if (is_missing(csv, k))
            return column_missing(csv, kind->column[k].name);
    return good && (csv->is_read_ahead || units_read(csv));
}

struct csv_table *csv_open(FILE *in, char *path, const struct csv_kind *kind)
{
    struct csv_table *csv = malloc(sizeof *csv);
    if (csv) {
        *csv = (struct csv_table){.file = {.at = {1, 1}}, .path = path, .kind = kind};
        (void)(csv_load(&csv->file, in) && head_read(csv)); /* after an error, csv->file holds the problem */
    }
    return csv;
}

void csv_close(struct csv_table *csv)
{
    if (csv) {
        free(csv->path);
        free(csv->file.text);
    }
    free(csv);
}

/* ---- Numbers ---- */

/* Reports that a number has no unit. The number cannot be read as if it were in m, because a file with
 * heights of 48 is probably in mm. Returns false. */
static bool unit_missing(struct csv_table *csv, int k, const char *text)
{
    const struct csv_column *c = &csv->kind->column[k];
    char here[64] = "";
    const char *shown = names_shown(text);
    if (*c->unit == 'm')
        snprintf(here, sizeof here, ", or '%.40s %s' in the cell", shown, c->usual);
    return csv_wrong(&csv->file, csv_cell(csv, k).at,
                     "%s has no unit: '%s' would mean %s %s; write '%s (%s)' in the first line%s", c->name,
                     shown, shown, c->unit, c->name, c->usual, here);
}

/* Evaluates a string that must be a single expression without names. Returns false if there is an error, or
 * if more text follows the expression. In the second case, error->message is empty. */
static bool constant_read(const char *text, struct quantity *q, struct expression_error *error)
{
    struct arena arena = {.block = NULL};
    struct evaluation e = {.error = error, .angle = 1};
    struct parse p = {.text = text, .error = error, .arena = &arena};
    const struct tree *t = expression_parse(&p);
    bool good = t && expression_evaluate(&e, t, q);
    arena_free(&arena);
    if (good)
        error->at = skip_blanks(p.end);
    return good && *error->at == '\0';
}

/* Reads the number in column k of the current row without checking its range. */
static bool number_read(struct csv_table *csv, int k, const struct text *text)
{
    const struct csv_column *c = &csv->kind->column[k];
    struct quantity q = {.value = 0};
    struct expression_error error;
    bool good = constant_read(text->line, &q, &error);
    struct csv_place cell = csv_cell(csv, k).at, at = cell;
    if (error.at > text->line)
        at.column += text_column(text, error.at) - 1;
    const char *shown = names_shown(error.at);
    if (!good && *error.message)
        return csv_wrong(&csv->file, at, *error.at ? "%s at '%s': %s; %s" : "%s%s: %s; %s", c->name, shown,
                         error.message, c->advice);
    if (!good)
        return csv_wrong(&csv->file, at, "unexpected '%s' after the value of %s; %s", shown, c->name,
                         c->advice);
    bool bare = quantity_is_number(q);
    if (!bare && !quantity_alike(q, expression_unit(c->unit)))
        return csv_wrong(&csv->file, cell, "%s: this is %s; %s", c->name, expression_kind(q), c->advice);
    const bool percent = strchr(text->line, '%');
    if (percent && *c->unit)
        return csv_wrong(&csv->file, cell, "%s: this is a percentage; %s", c->name, c->advice);
    domq_real unit = csv->unit[k] > 0 && !percent ? csv->unit[k] : *c->unit == '\0' || (c->traits & CSV_BARE);
    if (bare && unit == 0 && q.value != 0)
        return unit_missing(csv, k, text->line);
    csv->value[k] = bare ? q.value * unit : q.value;
    return true;
}

bool csv_fits(const struct csv_column *c, domq_real value, char message[CSV_MESSAGE])
{
    /* The bounds are doubles. If the value were not rounded to double, too, a value of 1e-9 could be outside
     * a range that ends at 1e-9. */
    double near = (double)value;
    bool whole = !(c->traits & CSV_WHOLE) || value == quad(floor)(value);
    const char *is = !whole              ? "not a whole number"
                     : near > c->highest ? "too large"
                     : near >= c->lowest ? NULL
                     : near < 0          ? "negative"
                                         : "too small";
    if (is)
        snprintf(message, CSV_MESSAGE, "%s = %s%s%s is %s; the range of %s is %s", c->name,
                 quad_text(value, 10), *c->unit ? " " : "", c->unit, is, c->name, c->range);
    return !is;
}

bool csv_check(struct csv_table *csv, int k, domq_real value)
{
    char message[CSV_MESSAGE];
    return csv_fits(&csv->kind->column[k], value, message) ||
           csv_wrong(&csv->file, csv_cell(csv, k).at, "%s", message);
}

/* ---- Rows ---- */

static bool single_read(struct csv_table *csv, int k)
{
    const struct csv_column *c = &csv->kind->column[k];
    const char *typed = csv_cell(csv, k).text;
    struct text text;
    bool unused = csv->rows == 0 && c->traits & CSV_NOT_FIRST;
    csv->value[k] = DOMQ_NAN;
    if (csv->column[k] == 0 || !c->unit || (is_empty(typed) && (unused || c->traits & CSV_EMPTY)))
        return true;
    if (csv->column[k] > csv->row.cells)
        return csv_wrong(&csv->file, csv->row.at,
                         "too few cells: %d, but the first line has %d; the separator is %s", csv->row.cells,
                         csv->head.cells, csv_separator_name(&csv->file));
    if (is_empty(typed))
        return csv_wrong(&csv->file, csv_cell(csv, k).at, "%s is missing; %s", c->name, c->advice);
    if (!text_make(&text, typed, strlen(typed)))
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    bool good = csv_marks_read(&csv->file, csv_cell(csv, k).at, text.line) && number_read(csv, k, &text) &&
                (unused || csv_check(csv, k, csv->value[k]));
    text_free(&text);
    return good;
}

/* Reads column k. If the file has it several times, some of its cells may be empty, and the value is the mean
 * of the others. */
static bool value_read(struct csv_table *csv, int k)
{
    const int first = csv->column[k];
    domq_real value[CSV_CELLS_MOST], mean = 0;
    int count = 0;
    bool good = true;
    if (!(csv->kind->column[k].traits & CSV_REPEATED) || first == 0 || !csv->repeats[first - 1])
        return single_read(csv, k);
    for (int i = 0; i < csv->row.cells && good; i++) {
        csv->column[k] = i + 1; /* the cell that is read now */
        if (csv->repeats[i] && !is_empty(csv->row.cell[i].text)) {
            good = single_read(csv, k);
            value[count++] = csv->value[k];
        }
    }
    csv->column[k] = first;
    for (int i = 0; i < count; i++)
        mean += value[i] / count;
    csv->squares = 0;
    for (int i = 0; i < count; i++)
        csv->squares += (value[i] - mean) * (value[i] - mean);
    csv->repeated = count;
    if (count == 0)
        return single_read(csv, k); /* reports that the value is missing */
    csv->value[k] = mean;
    return good;
}

/* Reads the next row. Skips copies of the first line, which occur in concatenated files. */
static bool row_read(struct csv_table *csv)
{
    const struct csv_record *row = &csv->row;
    for (bool again = true; again; csv->is_read_ahead = false) {
        if (!csv->is_read_ahead && !csv_read(&csv->file, &csv->row))
            return false;
        again = row->cells == csv->head.cells;
        for (int i = 0; i < row->cells && again; i++)
            again = strcmp(row->cell[i].text, csv->head.cell[i].text) == 0;
    }
    return true;
}

bool csv_next(struct csv_table *csv)
{
    const struct csv_kind *kind = csv->kind;
    if (!row_read(csv)) {
        if (!*csv->file.problem.text && csv->rows == 0)
            csv_wrong(
                &csv->file, csv->file.at,
                "the file has no %s; each line after the first must describe one %s, and the first line must "
                "name %s",
                kind->items, kind->item, kind->names);
        return false;
    }
    if (dom_raised(csv->interrupt))
        return csv_wrong(&csv->file, csv->row.at, "%s", dom_status_text(DOM_INTERRUPTED));
    if (csv->rows == kind->rows_most)
        return csv_wrong(&csv->file, csv->row.at, "there are more than %zu %s, which is the maximum",
                         kind->rows_most, kind->items);
    int cells = csv->row.cells;
    while (cells > csv->head.cells && !*csv->row.cell[cells - 1].text) /* spreadsheets append empty cells */
        cells--;
    bool good = cells <= csv->head.cells ||
                csv_wrong(&csv->file, csv->row.cell[csv->head.cells].at,
                          "too many cells: %d, but the first line has %d; the separator is %s", cells,
                          csv->head.cells, csv_separator_name(&csv->file));
    for (int k = 0; k < kind->columns && good; k++)
        good = value_read(csv, k);
    csv->rows += good;
    return good;
}

void csv_write_others(const struct csv_table *csv, bool names, FILE *out)
{
    for (int i = 0; i < csv->head.cells; i++) {
        const struct csv_record *record = names ? &csv->head : &csv->row;
        const char *text = i < record->cells ? record->cell[i].text : "";
        const char *unit = names && *text && i < csv->units.cells ? csv->units.cell[i].text : "";
        char name[256];
        snprintf(name, sizeof name, "%s (%s)", text, unit);
        if (csv->other[i]) {
            putc(',', out);
            csv_write(out, *unit ? name : text, ",;\t\"\n#");
        }
    }
}
