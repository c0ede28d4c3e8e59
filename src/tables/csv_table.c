/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf */
#include "interpreter/question.h"
#include "io/escape.h"
#include "io/io.h"
#include "language/quad.h"
#include "language/text.h"
#include "language/units.h"
#include "tables/csv.h"
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- Headings ---- */

enum { UNIT = 32 };

/* Copies the unit from a string such as "mm", "(mm)" or "[%]". Returns false if the string is not a unit. */
static bool unit_copy(const char *text, char unit[UNIT])
{
    const char *begin = text + strspn(text, " \t(["), *end = begin + strcspn(begin, " \t)]");
    struct quantity q = {.value = 1};
    if (!name_copy(begin, (size_t)(end - begin), unit, UNIT) || end[strspn(end, " \t)]")] != '\0')
        return false;
    char *cube = strstr(unit, "\u00b3");
    if (cube) { /* "³" and "^3" both take two bytes in UTF-8 */
        cube[0] = '^';
        cube[1] = '3';
    }
    const char *stop = *unit ? unit_scan(unit, &q) : NULL;
    return strcmp(unit, "%") == 0 || (stop && *stop == '\0');
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
    "domino,#,nr,nr.,no,no.,number,domino #,domino nr,domino no,domino no.,nummer,stein,steen,numero",
    ("time,t,times,hit,zeit,tijd,temps,total time,total,gesamtzeit,totale tijd,temps total,"
     "duration,dauer,duur,duree,average time,mean time,mittlere zeit,gemiddelde tijd,temps moyen"),
    ("speed,velocity,v,geschwindigkeit,snelheid,vitesse,average speed,mean speed,average velocity,"
     "mean velocity,durchschnittsgeschwindigkeit,mittlere geschwindigkeit,gemiddelde snelheid,"
     "vitesse moyenne"),
    "frame,frames,frame number,step,bild,beeld,image",
    "rate,frame rate,framerate,fps",
    "run,trial,video,versuch,proef,essai",
    ("error %,relative error,relativer fehler,errors %,sigma %,uncertainty %,time error %,speed error %,"
     "fehler %,fout %,erreur %"),
    "error,errors,sigma,uncertainty,time error,speed error,fehler,fout,erreur",
};

/* What a heading may call a trial of the repeated column, before its number. */
static const char trial_words[] = "trial,run,test,try,versuch,messung,proef,meting,essai,mesure";

/* Copies a name in lower case, without accents, and with one blank between words. */
static void name_fold(const char *text, size_t length, char name[NAMES_SHOWN])
{
    /* the letters from U+00C0 to U+00FF without their accents */
    static const char plain[] = "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo/ouuuuyty";
    size_t n = 0;
    for (const char *c = text; c < text + length && n + 1 < NAMES_SHOWN; c++) {
        const bool is_letter = *c == '\xc3' && ((unsigned char)c[1] & 0xc0) == 0x80;
        const char folded = (char)(is_letter ? plain[(unsigned char)*++c - 0x80]
                                   : isspace((unsigned char)*c) || *c == '_' ? ' '
                                                                             : tolower((unsigned char)*c));
        if (folded != ' ' || (n > 0 && name[n - 1] != ' '))
            name[n++] = folded;
    }
    n -= n > 0 && name[n - 1] == ' ';
    name[n] = '\0';
}

/* The heading of a column. */
struct heading {
    char name[NAMES_SHOWN + 2]; /* folded; " %" is appended if the unit is "%" */
    const char *unit;           /* "" if there is none */
    int column;                 /* the column of the kind, or -1 if there is no such column */
    bool is_trial;              /* the heading has a number, as in "speed 2", "v2" or "trial 2" */
};

/* Returns the column of a kind that a file may call by this folded name, or -1. */
static int column_named(const struct csv_kind *kind, const char *name)
{
    for (int k = 0; k < kind->columns; k++) {
        const char *known = kind->column[k].name;
        bool found = strcmp(known, name) == 0;
        for (size_t i = 0; i < sizeof column_words / sizeof *column_words && !found; i++)
            found =
                names_index(column_words[i], ',', known) == 0 && names_index(column_words[i], ',', name) > 0;
        if (found)
            return k;
    }
    return -1;
}

/* Reads the heading of a column. Its unit follows a bracket or a comma, as in "height (mm)", or it is the
 * last word, as in "height mm", "height_mm" or "height in mm". */
static struct heading heading_of(const struct csv_kind *kind, const char *text)
{
    struct heading h = {.unit = ""};
    char unit[UNIT];
    size_t length = strcspn(text, "([,");
    if (text[length] == '\0') {
        while (length > 0 && !isspace((unsigned char)text[length - 1]) && text[length - 1] != '_')
            length--;
        length = length > 0 && unit_copy(text + length, unit) ? length : strlen(text);
    }
    name_fold(text, length, h.name);
    size_t n = strlen(h.name);
    if (n > 3 && strcmp(h.name + n - 3, " in") == 0)
        h.name[n -= 3] = '\0';
    h.unit = text + length + strspn(text + length, " \t\n,");
    if (unit_copy(h.unit, unit) && strcmp(unit, "%") == 0)
        snprintf(h.name + n, sizeof h.name - n, " %%");
    h.column = column_named(kind, h.name);
    while (n > 0 && strchr("#0123456789 ", h.name[n - 1]))
        n--;
    if (h.column >= 0 || h.name[n] == '\0')
        return h;
    char base[NAMES_SHOWN];
    snprintf(base, sizeof base, "%.*s", (int)n, h.name);
    const bool is_any = names_index(trial_words, ',', base) >= 0;
    for (int k = 0; k < kind->columns && !h.is_trial; k++)
        if (kind->column[k].traits & CSV_REPEATED &&
            (column_named(kind, base) == k ||
             (is_any && unit_copy(h.unit, unit) &&
              quantity_alike(expression_unit(unit), expression_unit(kind->column[k].unit))))) {
            h.is_trial = true;
            h.column = k;
        }
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

/* Reads the unit of column i of the file. */
static bool unit_read(struct csv_table *csv, int i, const char *text)
{
    char unit[UNIT];
    const struct csv_column *c = &csv->kind->column[csv->of[i]];
    const bool is_unit = unit_copy(text, unit), is_percent = strcmp(unit, "%") == 0;
    const struct quantity q =
        is_percent ? (struct quantity){.value = (domq_real)1 / 100} : expression_unit(unit);
    if (!is_unit ||
        (is_percent ? !strchr(c->name, '%') : !*c->unit || !quantity_alike(q, expression_unit(c->unit))))
        return csv_wrong(&csv->file, csv->head.cell[i].at, "'%s' is not a unit of %s; its units are: %s",
                         names_shown(text), c->name, c->units);
    csv->unit[i] = q.value;
    return true;
}

static const char *column_names(const void *context, int k)
{
    const struct csv_kind *kind = context;
    return k < kind->columns ? kind->column[k].name : NULL;
}

/* Finds the columns of a kind in the first line. Returns the name of a required column that is missing, or
 * NULL. Beside numbered trials, a column without a number has their mean, which is not used. */
static const char *columns_find(struct csv_table *csv, const struct csv_kind *kind)
{
    const char *missing = NULL;
    unsigned found = 0;
    memset(csv->column, 0, sizeof csv->column);
    csv->trials = 0;
    for (int i = 0; i < csv->head.cells; i++)
        csv->trials += heading_of(kind, csv->head.cell[i].text).is_trial;
    for (int i = csv->head.cells - 1; i >= 0; i--) {
        const struct heading h = heading_of(kind, csv->head.cell[i].text);
        const unsigned traits = h.column < 0 ? 0 : kind->column[h.column].traits;
        csv->of[i] = traits & CSV_REPEATED && csv->trials > 0 && !h.is_trial ? -1 : h.column;
        if (csv->of[i] >= 0) {
            csv->column[h.column] = i + 1;
            found |= traits & CSV_GROUPS;
        }
    }
    for (int k = kind->columns - 1; k >= 0; k--) {
        const unsigned traits = kind->column[k].traits;
        if (traits & CSV_REQUIRED && csv->column[k] == 0 && !(traits & found))
            missing = kind->column[k].name;
    }
    return missing;
}

/* Checks heading i, and reads its unit. */
static bool heading_read(struct csv_table *csv, int i)
{
    static const char notes[] = ",note,notes,comment,comments,remark,notiz,bemerkung,opmerking,remarque";
    const struct csv_kind *kind = csv->kind;
    const char *text = csv->head.cell[i].text, *close;
    const struct csv_place at = csv->head.cell[i].at;
    const struct heading h = heading_of(kind, text);
    const int k = csv->of[i];
    if (isdigit((unsigned char)*text) || *text == '.')
        return csv_wrong(&csv->file, at, "the first line has a number, but must name %s, with their units",
                         kind->names);
    if (k < 0) {
        if (h.column >= 0 || names_index(notes, ',', h.name) >= 0)
            return true;
        if ((close = names_closest(column_names, kind, h.name)) != NULL)
            return csv_wrong(&csv->file, at, "unknown column '%s'; did you mean '%s'?", h.name, close);
        text_add(csv->unused, sizeof csv->unused, "%s'%.40s'", *csv->unused ? ", " : "", names_shown(text));
        return true;
    }
    for (int other = 0; other < k; other++)
        if (kind->column[other].traits & kind->column[k].traits & CSV_GROUPS && csv->column[other] > 0)
            return csv_wrong(&csv->file, at, "both %s and %s are given; leave one of these columns out",
                             kind->column[other].name, kind->column[k].name);
    if (csv->column[k] != i + 1 && !h.is_trial)
        return csv_wrong(&csv->file, at,
                         "column name '%s' stands for the %s, but so does column %d; rename one of the two",
                         h.name, kind->column[k].name, csv->column[k]);
    return *h.unit == '\0' || unit_read(csv, i, h.unit);
}

static bool head_read(struct csv_table *csv)
{
    const struct csv_kind *const first = csv->kind;
    const char *missing = NULL;
    char found[320] = "";
    bool good = true, is_utf8 = true;
    if (!csv_read(&csv->file, &csv->head))
        return !*csv->file.problem.text; /* csv_next reports an empty file */
    for (; csv->kind && (missing = columns_find(csv, csv->kind)) != NULL; csv->kind = csv->kind->otherwise) {
    }
    if (!csv->kind) {
        csv->kind = first;
        missing = columns_find(csv, first);
    }
    for (int i = 0; i < csv->head.cells && good; i++) {
        const char *text = csv->head.cell[i].text;
        good = heading_read(csv, i);
        is_utf8 = is_utf8 && escape_is_utf8(text);
        text_add(found, sizeof found, "%s'%.24s'", i ? ", " : "", names_shown(text));
    }
    if (!good || !missing)
        return good;
    return csv_wrong(&csv->file, csv->head.at,
                     "the column '%s' is missing; the first line must name %s, separated by ',', ';' or tabs "
                     "(%s); found: %s",
                     missing, csv->kind->names,
                     is_utf8 ? "delete a title above it, or begin the title with '#'"
                             : "this file is not in UTF-8; save it as 'CSV UTF-8'",
                     found);
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
 * if more text follows the expression. In the second case, error->text is empty. */
static bool constant_read(const char *text, struct quantity *q, struct problem *error)
{
    struct arena arena = {.block = NULL};
    struct evaluation e = {.problem = error, .angle = 1};
    struct reader r = {.at = text, .problem = error, .arena = &arena};
    problem_begin(error, NULL);
    const struct tree *t = expression_parse(&r);
    bool good = t && expression_evaluate(&e, t, q);
    arena_free(&arena);
    if (good)
        error->at = skip_blanks(r.at);
    else if (!error->at) /* memory has run out, which has no place */
        error->at = text + strlen(text);
    return good && *error->at == '\0';
}

/* Reads the number in column k of the current row without checking its range. */
static bool number_read(struct csv_table *csv, int k, const struct text *text)
{
    const struct csv_column *c = &csv->kind->column[k];
    struct quantity q = {.value = 0};
    struct problem error;
    bool good = constant_read(text->line, &q, &error);
    struct csv_place cell = csv_cell(csv, k).at, at = cell;
    if (error.at > text->line)
        at.column += text_column(text, error.at) - 1;
    const char *shown = names_shown(error.at);
    if (!good && *error.text)
        return csv_wrong(&csv->file, at, *error.at ? "%s at '%s': %s; %s" : "%s%s: %s; %s", c->name, shown,
                         error.text, c->advice);
    if (!good)
        return csv_wrong(&csv->file, at, "unexpected '%s' after the value of %s; %s", shown, c->name,
                         c->advice);
    bool bare = quantity_is_number(q);
    if (!bare && !quantity_alike(q, expression_unit(c->unit)))
        return csv_wrong(&csv->file, cell, "%s: this is %s; %s", c->name, expression_kind(q), c->advice);
    const bool percent = strchr(text->line, '%');
    if (*c->unit && percent)
        return csv_wrong(&csv->file, cell, "%s: this is a percentage; %s", c->name, c->advice);
    const domq_real in_head = csv->unit[csv->column[k] - 1],
                    unit = in_head > 0 && !percent ? in_head : *c->unit == '\0' || (c->traits & CSV_BARE);
    /* The number cannot be read as if it were in m, because a file with heights of 48 is probably in mm. */
    shown = names_shown(text->line);
    if (bare && unit == 0 && q.value != 0)
        return csv_wrong(&csv->file, cell,
                         "%s has no unit: '%s' would mean %s %s; write '%s (%s)' in the first line", c->name,
                         shown, shown, c->unit, c->name, c->usual);
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
        if (csv->of[i] == k && !is_empty(csv->row.cell[i].text)) {
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
            csv_wrong(&csv->file, csv->file.at, "the file has no rows; its first line must name %s",
                      kind->names);
        return false;
    }
    if (dom_raised(io_interrupt))
        return csv_wrong(&csv->file, csv->row.at, "%s", dom_status_text(DOM_INTERRUPTED));
    if (csv->rows == kind->rows_most)
        return csv_wrong(&csv->file, csv->row.at, "there are more than %zu rows, which is the maximum",
                         kind->rows_most);
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

/* ---- Files ---- */

/* Finds a file that a script names. If there is such a file beside the running script, returns its path.
 * Otherwise returns a copy of `name`. The caller frees the path. */
static char *path_beside(const struct run_context *run_context, const char *name)
{
    const char *slash = run_context->script && *name != '/' ? strrchr(run_context->script, '/') : NULL;
    char *path = NULL;
    if (slash &&
        asprintf(&path, "%.*s%s", (int)(slash + 1 - run_context->script), run_context->script, name) < 0)
        return NULL;
    if (path && access(path, F_OK) == 0)
        return path;
    free(path);
    return strdup(name);
}

struct csv_table *csv_named(const struct run_context *run_context, const char *name,
                            const struct csv_kind *kind, struct problem *problem)
{
    char *path = path_beside(run_context, name);
    FILE *in = path ? io_open_read(path) : NULL;
    struct csv_table *csv = in ? csv_open(in, path, kind) : NULL;
    if (!csv)
        problem_error(problem, "cannot read '%s': %s", names_shown(name), strerror(errno));
    if (in)
        fclose(in);
    if (!csv)
        free(path);
    else if (*csv->file.problem.text && !csv_end(csv, problem))
        csv = NULL;
    return csv;
}

bool csv_end(struct csv_table *csv, struct problem *problem)
{
    bool good = csv && *csv->file.problem.text == '\0';
    if (csv && !good) {
        const char *path = strlen(csv->path) < 256 ? csv->path : names_shown(csv->path);
        problem_error(problem, "%s:%ld:%d: %s", path, csv->file.problem.at.line, csv->file.problem.at.column,
                      csv->file.problem.text);
    }
    csv_close(csv);
    return good;
}

/* Other features take rows and measurements from tables. */
const struct feature tables_feature = {.name = "tables"};
