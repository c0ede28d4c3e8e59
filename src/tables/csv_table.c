/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/escape.h"
#include "language/expression.h"
#include "language/quad.h"
#include "language/text.h"
#include "language/units.h"
#include "tables/csv.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Headings ---- */

enum { UNIT = 32 };

/* Extracts the unit from a string such as "mm", "(mm)" or "[mm]". Returns false if the string is not a
 * unit. */
static bool unit_copy(const char *text, char unit[UNIT])
{
    const char *begin = text + strspn(text, " \t(["), *end = begin + strcspn(begin, " \t)]");
    struct quantity q = {.value = 1};
    bool one = name_copy(begin, (size_t)(end - begin), unit, UNIT) && end[strspn(end, " \t)]")] == '\0';
    char *cube = strstr(unit, "\u00b3");
    if (cube) { /* "³" and "^3" both take two bytes in UTF-8 */
        cube[0] = '^';
        cube[1] = '3';
    }
    const char *stop = one && *unit ? unit_scan(unit, &q) : NULL;
    return stop && *stop == '\0';
}

/* What files call their columns: first the name of the column, then its other names in English, German, Dutch
 * and French, without accents. */
static const char *const column_words[] = {
    "height,length,hohe,hoehe,lange,laenge,hoogte,lengte,hauteur,longueur,hauteurs",
    "thickness,depth,thick,dicke,starke,staerke,tiefe,dikte,diepte,epaisseur,profondeur",
    "gap,spacing,distance,separation,abstand,lucke,luecke,afstand,tussenruimte,ecart,espacement,intervalle",
    "pitch,period,centre to centre,center to center,teilung,raster,rastermass,steek,pas,entraxe",
    ("position,positions,pos,front,front face,position of the front face,position of front face,"
     "lage,ort,positie,plaats,emplacement"),
    "dominoes,dominos,n,count,number of dominoes,no. of dominoes,anzahl,anzahl steine,aantal,nombre",
    "mass,weight,masse,gewicht,massa,poids",
    "density,dichte,dichtheid,densite",
    "width,breite,breedte,largeur",
    "radius,rounding,rayon,straal",
    "lean,plumb,tilt,neigung,helling,inclinaison",
    "relative,relativ,relatief,relatif",
    "domino,#,nr,nr.,no,no.,number,domino #,domino nr,domino no,domino no.,nummer,stein,steen,numero",
    ("time,t,times,hit,zeit,tijd,temps,total time,total,gesamtzeit,totale tijd,temps total,"
     "duration,dauer,duur,duree"),
    "speed,velocity,v,geschwindigkeit,durchschnittsgeschwindigkeit,snelheid,vitesse",
    "frame,frames,frame number,step,bild,beeld,image",
    "rate,frame rate,framerate,fps",
    "run,trial,video,versuch,proef,essai",
    "error %,relative error,relativer fehler",
    "error,errors,sigma,uncertainty,time error,speed error,fehler,fout,erreur",
};
enum { COLUMN_WORDS = sizeof column_words / sizeof *column_words };

/* Words of headings that number a trial, or that say that a value is the mean of several trials. */
static const char trial_words[] = "trial,run,test,try,no,nr,versuch,messung,proef,meting,essai,mesure",
                  average_words[] = "average,avg,mean,mittlere,durchschnittliche,mittel,gemiddelde,moyenne,"
                                    "moyen,durchschnittsgeschwindigkeit";

/* Copies a name in lower case, without accents, and with one blank between words. */
static void name_fold(const char *text, size_t length, char name[NAMES_SHOWN])
{
    /* the letters from U+00C0 to U+00FF without their accents */
    static const char plain[] = "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo/ouuuuyty";
    size_t n = 0;
    for (const char *c = text; c < text + length && n + 1 < NAMES_SHOWN; c++) {
        const unsigned char next = (unsigned char)c[1];
        const bool is_accent = (*c == '\xcc' && next >= 0x80) || (*c == '\xcd' && next < 0xb0);
        const bool is_letter = *c == '\xc3' && next >= 0x80 && next < 0xc0;
        const bool is_blank = isspace((unsigned char)*c) || *c == '_';
        if (!is_accent && !(is_blank && (n == 0 || name[n - 1] == ' ')))
            name[n++] = (char)(is_letter ? plain[next - 0x80] : is_blank ? ' ' : tolower((unsigned char)*c));
        c += is_accent || is_letter;
    }
    while (n > 0 && strchr(" /", name[n - 1]))
        n--;
    name[n] = '\0';
}

/* Returns true for a unit such as "%", "(percent)" or "[per cent]". */
static bool is_percent(const char *text)
{
    char unit[NAMES_SHOWN];
    const char *inside = text + strspn(text, " ([");
    name_fold(inside, strcspn(inside, ")]"), unit);
    return names_index("%,percent,per cent,pct,prozent", ',', unit) >= 0;
}

/* Splits the heading of a column into a name, which is folded, and a unit, which is returned. The unit
 * follows a bracket or a comma, as in "height (mm)", or it is the last word, as in "height in mm", or it
 * follows a
 * '/', as in "height/mm". */
static const char *heading_split(const char *text, char name[NAMES_SHOWN])
{
    char unit[UNIT];
    size_t length = strcspn(text, "([,"), word = strlen(text);
    while (word > 0 && !isspace((unsigned char)text[word - 1]) && text[word - 1] != '_')
        word--;
    const char *slash = strchr(text, '/');
    if (text[length] == '\0' && word > 0 && (unit_copy(text + word, unit) || is_percent(text + word)))
        length = word;
    else if (text[length] == '\0' && slash && unit_copy(slash + 1, unit))
        length = (size_t)(slash - text);
    name_fold(text, length, name);
    size_t n = strlen(name);
    if (n > 3 && strcmp(name + n - 3, " in") == 0)
        name[n - 3] = '\0';
    text += length + strspn(text + length, " \t\n,/");
    if (is_percent(text) && names_index(column_words[COLUMN_WORDS - 1], ',', name) >= 0)
        snprintf(name, NAMES_SHOWN, "error %%");
    return text;
}

/* Returns true if a file may call the column by this folded name. */
static bool column_has(const struct csv_column *column, const char *name)
{
    bool found = strcmp(column->name, name) == 0;
    for (int i = 0; i < COLUMN_WORDS && !found; i++)
        found = names_index(column_words[i], ',', column->name) == 0 &&
                names_index(column_words[i], ',', name) > 0;
    return found;
}

/* The heading of a column. */
struct heading {
    char name[NAMES_SHOWN]; /* folded */
    const char *unit;       /* "" if there is none */
    int column;             /* the column of the kind, or kind->columns if there is no such column */
    bool is_several;        /* true if this column may occur several times */
    bool is_average;        /* true if the heading says so, as in "mean speed" */
};

/* Reads the heading of a column. The headings of trials are such as "speed 2", "v2", "speed trial 2" or, if
 * the unit is one of those of the column, "trial 2 (m/s)". */
static struct heading heading_of(const struct csv_kind *kind, const char *text)
{
    char rest[NAMES_SHOWN] = "", unit[UNIT];
    struct heading h = {.column = 0};
    bool found = false, is_trial = false;
    h.unit = heading_split(text, h.name);
    for (const char *word = h.name; *word; word += strspn(word, " ")) {
        char copy[NAMES_SHOWN];
        const size_t all = strcspn(word, " ");
        size_t length = all;
        while (length > 0 && strchr("#0123456789", word[length - 1]))
            length--;
        snprintf(copy, sizeof copy, "%.*s", (int)length, word);
        const bool trial = names_index(trial_words, ',', copy) >= 0,
                   average = names_index(average_words, ',', copy) >= 0;
        is_trial = is_trial || trial || length < all;
        h.is_average = h.is_average || average;
        if (*copy && !trial && !average)
            text_add(rest, sizeof rest, "%s%s", *rest ? " " : "", copy);
        word += all;
    }
    for (; h.column < kind->columns && !found; h.column += !found) {
        const struct csv_column *c = &kind->column[h.column];
        h.is_several = c->traits & CSV_REPEATED;
        found = column_has(c, h.name);
        if (!found && h.is_several && (is_trial || h.is_average))
            found = *rest ? column_has(c, rest)
                          : unit_copy(h.unit, unit) &&
                                quantity_alike(expression_unit(unit), expression_unit(c->unit));
    }
    h.is_several = found && h.is_several;
    return h;
}

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

/* ---- The first line ---- */

static bool unit_read(struct csv_table *csv, int k, const char *text, struct csv_place at)
{
    char unit[UNIT];
    const struct csv_column *c = &csv->kind->column[k];
    if (strchr(c->name, '%') && is_percent(text)) {
        csv->unit[k] = (domq_real)1 / 100;
        return true;
    }
    const bool known = unit_copy(text, unit) && *c->unit;
    const struct quantity q = expression_unit(unit);
    const char *shown = names_shown(text);
    if (!known || !quantity_alike(q, expression_unit(c->unit)))
        return csv_wrong(&csv->file, at, "'%s' is not a unit of %s; its units are: %s", shown, c->name,
                         c->units);
    if (csv->unit[k] > 0 && csv->unit[k] != q.value)
        return csv_wrong(&csv->file, at,
                         "'%s' differs from the unit of %s before; use one unit in all its columns", shown,
                         c->name);
    csv->unit[k] = q.value;
    return true;
}

static const char *column_names(const void *context, int k)
{
    const struct csv_kind *kind = context;
    return k < kind->columns ? kind->column[k].name : NULL;
}

/* Finds the columns of a kind in the first line. Returns the name of a required column that is missing, or
 * NULL. */
static const char *columns_find(struct csv_table *csv, const struct csv_kind *kind)
{
    const char *missing = NULL;
    unsigned found = 0;
    memset(csv->column, 0, sizeof csv->column);
    csv->trials = 0;
    for (int i = 0; i < csv->head.cells; i++) {
        const struct heading h = heading_of(kind, csv->head.cell[i].text);
        csv->trials += h.is_several && !h.is_average;
    }
    for (int i = csv->head.cells - 1; i >= 0; i--) {
        const struct heading h = heading_of(kind, csv->head.cell[i].text);
        csv->other[i] = h.column == kind->columns || (h.is_several && h.is_average && csv->trials > 0);
        csv->is_trial[i] = !csv->other[i] && h.is_several && !h.is_average;
        if (!csv->other[i]) {
            csv->column[h.column] = i + 1;
            found |= kind->column[h.column].traits & CSV_GROUPS;
        }
    }
    for (int k = kind->columns - 1; k >= 0; k--) {
        const unsigned traits = kind->column[k].traits;
        if (traits & CSV_REQUIRED && csv->column[k] == 0 && !(traits & found))
            missing = kind->column[k].name;
    }
    return missing;
}

/* Reports that a required column is missing. */
static bool column_missing(struct csv_table *csv, const char *missing)
{
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
                     missing, csv->kind->names, found);
}

/* Checks heading i, whose column has been found, and reads its unit. */
static bool heading_read(struct csv_table *csv, int i)
{
    const struct csv_kind *kind = csv->kind;
    const char *text = csv->head.cell[i].text, *close;
    const struct csv_place at = csv->head.cell[i].at;
    const struct heading h = heading_of(kind, text);
    const char *name = h.name;
    const int k = h.column;
    if (isdigit((unsigned char)*text) || *text == '.')
        return csv_wrong(&csv->file, at,
                         "the first line has a number, but must name the columns: write '%s' above it",
                         kind->example);
    if (csv->other[i]) {
        if (k < kind->columns ||
            names_index(",note,notes,comment,comments,remark,notiz,bemerkung,opmerking,remarque", ',',
                        name) >= 0)
            return true;
        if ((close = names_closest(column_names, kind, name)) != NULL)
            return csv_wrong(&csv->file, at, "unknown column '%s'; did you mean '%s'?", name, close);
        text_add(csv->unused, sizeof csv->unused, "%s'%.40s'", *csv->unused ? ", " : "", names_shown(text));
        return true;
    }
    for (int other = 0; other < k; other++)
        if (kind->column[other].traits & kind->column[k].traits & CSV_GROUPS && csv->column[other] > 0)
            return csv_wrong(&csv->file, at, "both %s and %s are given; leave one of these columns out",
                             kind->column[other].name, kind->column[k].name);
    if (csv->trials == 1 && csv->is_trial[i] && strpbrk(name, "#0123456789"))
        return csv_wrong(&csv->file, at,
                         "'%s' is the only trial; add the column of another one, or call this one '%s'", name,
                         kind->column[k].name);
    if (csv->column[k] != i + 1 && !csv->is_trial[i])
        return csv_wrong(&csv->file, at,
                         "column name '%s' stands for the %s, but so does column %d; rename one of the two",
                         name, kind->column[k].name, csv->column[k]);
    return *h.unit == '\0' || unit_read(csv, k, h.unit, at);
}

static bool head_read(struct csv_table *csv)
{
    const struct csv_kind *const first = csv->kind;
    const char *missing = NULL;
    int others = 0;
    bool good = true;
    if (!csv_read(&csv->file, &csv->head))
        return !*csv->file.problem.text; /* csv_next reports an empty file */
    for (; csv->kind && (missing = columns_find(csv, csv->kind)) != NULL; csv->kind = csv->kind->otherwise) {
    }
    if (!csv->kind) {
        csv->kind = first;
        missing = columns_find(csv, first);
    }
    if (csv->head.cells == 1 && strncmp(csv->head.cell[0].text, "set ", strlen("set ")) == 0)
        return csv_wrong(&csv->file, csv->head.at, "this is not a table but a session; 'source %s' runs it",
                         names_shown(csv->path));
    if (csv->head.cells == 1 && missing)
        return csv_wrong(&csv->file, csv->head.at,
                         "there is only one column; the first line must name %s, separated by ',', ';' or "
                         "tabs; delete a title above it, or begin the title with '#'",
                         csv->kind->names);
    for (int i = 0; i < csv->head.cells && good; i++) {
        good = heading_read(csv, i);
        others += csv->other[i];
    }
    /* if this file were saved with more columns, it could not be read again */
    if (good && others > CSV_OTHERS_MOST)
        return csv_wrong(
            &csv->file, csv->head.at,
            "the file has %d columns that are not used, but the limit is %d; delete some of them", others,
            CSV_OTHERS_MOST);
    if (good && missing)
        return column_missing(csv, missing);
    return good;
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
    if (*c->unit && percent)
        return csv_wrong(&csv->file, cell, "%s: this is a percentage; %s", c->name, c->advice);
    const domq_real unit =
        csv->unit[k] > 0 && !percent ? csv->unit[k] : *c->unit == '\0' || (c->traits & CSV_BARE);
    /* The number cannot be read as if it were in m, because a file with heights of 48 is probably in mm. */
    char here[64] = "";
    shown = names_shown(text->line);
    if (*c->unit == 'm')
        snprintf(here, sizeof here, ", or '%.40s %s' in the cell", shown, c->usual);
    if (bare && unit == 0 && q.value != 0)
        return csv_wrong(&csv->file, cell,
                         "%s has no unit: '%s' would mean %s %s; write '%s (%s)' in the first line%s",
                         c->name, shown, shown, c->unit, c->name, c->usual, here);
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

/* Reads the cell of column k. */
static bool cell_read(struct csv_table *csv, int k)
{
    const struct csv_column *c = &csv->kind->column[k];
    const char *typed = csv_cell(csv, k).text;
    struct text text;
    bool unused = csv->rows == 0 && c->traits & CSV_NOT_FIRST;
    csv->value[k] = DOMQ_NAN;
    if (csv->column[k] == 0 || (is_empty(typed) && (unused || c->traits & CSV_EMPTY)))
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

/* Reads column k. If it has several trials, some of them may be empty, and the value is the mean of the
 * others. */
static bool value_read(struct csv_table *csv, int k)
{
    const int first = csv->column[k];
    domq_real mean = 0, squares = 0;
    bool good = true;
    if (!(csv->kind->column[k].traits & CSV_REPEATED) || csv->trials < 2)
        return cell_read(csv, k);
    csv->repeated = 0;
    for (int i = 0; i < csv->row.cells && good; i++)
        if (csv->is_trial[i] && !is_empty(csv->row.cell[i].text)) {
            csv->column[k] = i + 1; /* the cell that is read now */
            good = cell_read(csv, k);
            const domq_real away = csv->value[k] - mean;
            mean += away / ++csv->repeated;
            squares += away * (csv->value[k] - mean);
        }
    csv->column[k] = first;
    if (csv->repeated == 0)
        return cell_read(csv, k);
    csv->value[k] = mean;
    csv->squares += squares / (mean * mean);
    csv->freedom += csv->repeated - 1;
    return good;
}

bool csv_next(struct csv_table *csv)
{
    const struct csv_kind *kind = csv->kind;
    if (!csv_read(&csv->file, &csv->row)) {
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
    const struct csv_record *record = names ? &csv->head : &csv->row;
    for (int i = 0; i < csv->head.cells; i++)
        if (csv->other[i]) {
            putc(',', out);
            csv_write(out, i < record->cells ? record->cell[i].text : "", ",;\t\"\n#");
        }
}
