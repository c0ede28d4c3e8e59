/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'row', 'rowmax', 'change' and 'place', and the table of all commands about a row. */
#include "interpreter/feature.h"
#include "interpreter/question.h"
#include "language/quad.h"
#include "rows/rows.h"
#include "session/rowfile.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- row ---- */

static const struct column row_columns[] = {
    {"domino", "", "number of the domino, from 1", 6},
    {"height", "m", "height of the domino", 0},
    {"thickness", "m", "thickness of the domino", 0},
    {"gap", "m", "clear distance to the domino before it", 0},
    {"mass", "kg", "mass of the domino, if masses are known", 0},
    {"relative", "", "mass relative to domino 1, if only ratios of masses are known", 0},
    {"radius", "m", "radius of the edges, if any domino has its own radius; used only with 'set edges'", 0},
    {"lean", "m", "how far the top is off plumb, if any domino leans (negative: backwards)", 0},
    {"width", "m", "width of the domino (left out if every domino is half as wide as it is tall)", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_row(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    bool has_radii = false, has_leans = false, has_widths = false;
    if (!scene_row_list(query->scene, &scene, problem))
        return false;
    for (size_t k = 0; k < scene.row.count; k++) {
        has_radii = has_radii || scene.domino[k].radius > 0;
        has_leans = has_leans || scene.domino[k].lean != 0;
        has_widths = has_widths || scene.domino[k].width != scene.domino[k].height / 2;
    }
    answer_leave_out(a, scene_has_masses(query->scene) ? "relative" : "mass");
    if (!has_radii)
        answer_leave_out(a, "radius");
    if (!has_leans)
        answer_leave_out(a, "lean");
    if (!has_widths)
        answer_leave_out(a, "width");
    a->csv.units = true;
    a->style.errors = false; /* 'set row FILE' cannot read columns with errors */
    a->csv.extra = a->path ? query->scene->listed.others : NULL;
    for (int writes = 0; writes < 2; writes++) /* the first pass only chooses the units of the columns */
        for (size_t k = 0; k < scene.row.count && !answer_lost(a); k++) {
            const struct domq_domino *d = &scene.domino[k];
            const struct cell cells[] = {
                cell_count((domq_real)k + 1), cell_real(d->height),
                cell_real(d->thickness),      cell_real(d->gap),
                cell_real(d->mass),           cell_real(d->mass / scene.domino[0].mass),
                cell_real(d->radius),         cell_real(lean_offset(d)),
                cell_real(d->width)};
            for (int i = 1; i < 9 && !writes; i++)
                answer_announce(a, row_columns[i].key, cells[i].number);
            if (writes)
                answer_row(a, cells, NULL);
        }
    free(scene.domino);
    if (query->next && a->path)
        query->next->scene.listed.saved = true;
    return true;
}

/* ---- rowmax ---- */

static const struct column rowmax_columns[] = {
    {"s", "h", "the separation", 0},
    {"count", "", "the number of dominoes in the row", 0},
    {"r_max", "", "the largest growth at which all dominoes fall", 0},
    {"r_train", "", "the largest growth of the endless train", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_rowmax(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_row_growth growth;
    struct domq_limit limit;
    struct scene_row scene;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    free(scene.domino);
    if (query->scene->listed.domino)
        return problem_error(problem, "a row from a file has no growth r; first enter 'set row N'");
    const domq_real reach = domq_train_reach(&query->scene->train);
    char reason[96];
    enum dom_status status =
        domq_row_rmax(&scene.row, &scene.compute, reach, row_grow, (void *)query->scene, &growth);
    if (status == DOM_OK)
        status = domq_limit_rmax(&query->scene->train, &query->scene->compute, &limit);
    if (status != DOM_OK)
        return row_status(query, problem, status);
    snprintf(reason, sizeof reason,
             "there is no growth from 1 to %.6g at which all dominoes fall; 'set r 1; fall' shows why",
             (double)reach);
    bool more = answer_row(a,
                           ROW(cell_real(query->scene->train.s), cell_count((domq_real)scene.row.count),
                               cell_computed(growth.r_max), cell_computed(limit.r_max)),
                           isnan(growth.r_max) ? reason : NULL);
    if (growth.r_min > 1)
        answer_say(a,
                   "All dominoes fall if r is between %.6g and r_max, but not if r is smaller, as 'set r 1; "
                   "fall' shows.",
                   (double)growth.r_min);
    return more;
}

/* ---- change and place: parsing ---- */

/* An element of the linked list of selected dominoes. */
struct selected {
    struct row_range range;
    /* An expression for the number of one domino. If numbers were typed, such as 4 or 3-7, `range` holds
     * them, and item.argument is NULL. */
    struct item item;
    struct selected *next;
};

struct change_parsed {
    struct selected *first; /* NULL selects all dominoes */
    int count;
    struct item value;
    bool is_set;   /* an '=' precedes the value */
    bool has_sign; /* the value begins with a sign */
    bool is_share; /* the value ends with '%' */
};

/* Reads a number or a range, such as "4", "3-7", "3:7" or "3..7". If the text is anything else, returns false
 * and reads nothing. */
static bool range_read(struct reader *r, struct row_range *range)
{
    char *end;
    if (!isdigit((unsigned char)*r->at))
        return false;
    range->first = range->last = strtoul(r->at, &end, 10);
    const char *after = end + (strncmp(end, "..", 2) == 0 ? 2 : *end == '-' || *end == ':');
    if (after > end && isdigit((unsigned char)*after))
        range->last = strtoul(after, &end, 10);
    if (!isspace((unsigned char)*end) && *end != ',' && !command_ends(end))
        return false;
    r->at = end;
    return true;
}

static bool selected_parse(struct reader *r, struct selected *s)
{
    static const struct argument number = {.name = "K", .kind = ARGUMENT_COUNT};
    const char *begin = r->at, *stops = r->stops;
    reader_place(r, begin);
    if (!r->offer && range_read(r, &s->range))
        return s->range.first <= s->range.last ||
               problem_error(r->problem, "'%zu-%zu' names no dominoes; write the smaller number first",
                             s->range.first, s->range.last);
    r->stops = ",";
    bool good = item_parse(r, &number, &s->item);
    r->stops = stops;
    return good;
}

static bool change_parse_dominoes(struct reader *r, struct question *q)
{
    struct change_parsed *c = q->parsed = reader_memory(r, sizeof *c);
    if (!c)
        return false;
    r->last = false;
    if (reader_takes(r, "all"))
        return true;
    for (struct selected **last = &c->first;; last = &(*last)->next) {
        *last = reader_memory(r, sizeof **last);
        if (!*last || !selected_parse(r, *last))
            return false;
        c->count++;
        const char *next = skip_blanks(r->at);
        if (*next != ',')
            return true;
        r->at = skip_blanks(next + 1);
    }
}

static bool change_parse_value(struct reader *r, struct question *q)
{
    static const struct argument value = {.name = "X", .kind = ARGUMENT_ANY};
    struct change_parsed *c = q->parsed;
    c->is_set = *r->at == '=';
    r->at = skip_blanks(r->at + c->is_set);
    const char *begin = r->at;
    reader_place(r, begin);
    c->has_sign = *begin == '+' || *begin == '-';
    r->last = true;
    if (!item_parse(r, &value, &c->value))
        return false;
    c->is_share = r->at > begin && r->at[-1] == '%';
    return true;
}

/* ---- change and place: binding ---- */

/* A bound change. */
struct changing {
    struct row_change change;
    int ranges; /* the number of ranges; 0 stands for all dominoes */
    struct row_range range[];
};

/* Checks the unit of the typed value X. Decides whether X replaces the old value, is added to it or
 * multiplies it. */
static bool value_bind(const struct change_parsed *parsed, const struct quantity *value,
                       struct row_change *change, struct problem *problem)
{
    const char *name = row_measure_names(NULL, (int)change->measure),
               *unit = rowfile_kind.column[change->measure].unit;
    const struct quantity wanted = expression_unit(unit);
    const bool is_relative = parsed->has_sign && !parsed->is_set, is_bare = quantity_is_number(*value);
    change->value = value->value;
    change->is_angle =
        change->measure == MEASURE_LEAN && quantity_alike(*value, (struct quantity){.angle = 1});
    if (parsed->is_share && is_bare) {
        change->how = CHANGE_TIMES;
        change->value += is_relative;
        return true;
    }
    if (!is_bare && !change->is_angle && !quantity_alike(*value, wanted))
        return problem_error(problem, "the %s is %s, not %s; enter a value such as '%s'", name,
                             expression_kind(wanted), expression_kind(*value), expression_example(wanted));
    if (is_relative && is_bare)
        return problem_error(problem,
                             "a change of the %s by %s needs a unit, as in '%+.4g %s'; to change the %s by a "
                             "percentage, write a percent sign, as in '+10 %%'",
                             name, quad_text(value->value, 10), (double)value->value, unit, name);
    change->how = is_relative ? CHANGE_BY : CHANGE_TO;
    change->is_bare = is_bare;
    return true;
}

static bool change_bind(const struct question *q, const struct query *query, struct arguments *given,
                        struct problem *problem)
{
    const struct change_parsed *parsed = q->parsed;
    const size_t size = sizeof(struct changing) + (size_t)parsed->count * sizeof(struct row_range);
    struct quantity value;
    domq_real number;
    struct changing *c = arguments_take(given, size, query, problem);
    if (!c)
        return false;
    c->change.measure = q->count > 2 ? (enum row_measure)(int)given->number[1] : MEASURE_GAP;
    for (const struct selected *s = parsed->first; s; s = s->next) {
        struct row_range *range = &c->range[c->ranges++];
        *range = s->range;
        if (!s->item.argument)
            continue;
        if (!item_bind(&s->item, q->text, query, NULL, &number, problem))
            return false;
        range->first = range->last = (size_t)number;
    }
    return item_bind(&parsed->value, q->text, query, &value, &number, problem) &&
           value_bind(parsed, &value, &c->change, problem);
}

/* ---- change and place: the answer ---- */

enum { LINES = 12 /* the maximum number of dominoes whose changes are printed */ };

/* Prints the old and the new measurement of domino k, counted from 1. If masses are not known, prints the
 * factor by which the mass changes. */
static void change_say(const struct query *query, struct answer *a, const struct row_change *change, size_t k,
                       domq_real from, domq_real to)
{
    const enum row_measure measure = change->measure;
    const char *name = row_measure_names(NULL, (int)measure);
    const struct measure unit =
        measure_of(rowfile_kind.column[measure].unit, quad_larger(quad(fabs)(from), quad(fabs)(to)));
    const char *one = quad_text(measure_number(unit, from), 6),
               *other = quad_text(measure_number(unit, to), 6);
    if (measure == MEASURE_MASS && !scene_has_masses(query->scene))
        answer_say(a, "domino %zu: mass %s times as large as before", k, quad_text(change->value, 6));
    else if (strcmp(one, other) == 0)
        answer_say(a, "domino %zu: %s stays %s %s", k, name, other, unit.unit);
    else
        answer_say(a, "domino %zu: %s %s to %s %s", k, name, one, other, unit.unit);
}

static bool is_selected(const struct row_range *range, int ranges, size_t k)
{
    bool is_in = false;
    for (int i = 0; i < ranges; i++)
        is_in = is_in || (range[i].first <= k && k <= range[i].last);
    return is_in;
}

static void changes_say(const struct query *query, struct answer *a, const struct row_change *change,
                        const struct row_range *range, int ranges, size_t count, const domq_real *before,
                        const domq_real *after)
{
    size_t changed = 0;
    for (size_t k = 1; k <= count; k++)
        if (is_selected(range, ranges, k) && changed++ < LINES)
            change_say(query, a, change, k, before[k - 1], after[k - 1]);
    if (changed > LINES)
        answer_say(a, "and %zu more; 'row' lists all dominoes", changed - LINES);
    a->wrote_text = true;
}

/* Returns one measurement of each domino, such as its height. The caller frees the array. */
static domq_real *measures_list(const struct scene *scene, enum row_measure measure, size_t *count,
                                struct problem *problem)
{
    struct scene_row row;
    if (!scene_row_list(scene, &row, problem))
        return NULL;
    *count = row.row.count;
    domq_real *list = calloc(*count, sizeof *list);
    for (size_t k = 0; list && k < *count; k++)
        list[k] = scene_row_measure(scene, &row.domino[k], measure);
    free(row.domino);
    if (!list)
        problem_status(problem, scene, DOM_NO_MEMORY);
    return list;
}

static bool run_change(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct changing *c = query->given->bound;
    const enum row_measure measure = c->change.measure;
    size_t count;
    if (!query->next)
        return true;
    domq_real *before = measures_list(query->scene, measure, &count, problem), *after = NULL;
    if (!before)
        return false;
    struct row_range all = {measure == MEASURE_GAP ? 2 : 1, count};
    const struct row_range *range = c->ranges ? c->range : &all;
    const int ranges = c->ranges ? c->ranges : 1;
    bool good = scene_row_change(&query->next->scene, &c->change, range, ranges, problem);
    if (good && answer_for_people(a) && !query->run_context->sourced) {
        after = measures_list(&query->next->scene, measure, &count, problem);
        good = after;
        if (good)
            changes_say(query, a, &c->change, range, ranges, count, before, after);
    }
    free(before);
    free(after);
    return good;
}

const struct command row_commands[] = {
    {.name = "fall",
     .in_joules = scene_has_masses,
     .has_errors = true,
     .synonyms = "simulate simulation run topple time speed",
     .summary = "run the row, domino by domino",
     .help = "Shows for each domino when it is hit, when it hits the next one, and how fast it starts. Also "
             "compares the energy of each domino with the energy that it needs to tip over. 'set row' "
             "enters a row.",
     .example = "set row 5; fall",
     .see = "verdict mend row effects",
     .rows = true,
     .holds = "all dominoes fall",
     .brief = "*",
     ANSWER(fall)},
    {.name = "verdict",
     .in_joules = scene_has_masses,
     .has_errors = true,
     .typed.shortest = "v",
     .synonyms = "result success topple stop",
     .summary = "whether the whole row falls, and which domino is weakest",
     .example = "set row 5; verdict",
     .see = "fall mend",
     .principal = "seconds",
     .holds = "all dominoes fall",
     .brief = "",
     ANSWER(verdict)},
    {.name = "mend",
     .synonyms = "repair fix spacing rescue",
     .summary = "the smallest change of one gap that saves a row",
     .help =
         "Tries the gap at which the row stops, and up to 30 gaps before it. If the row stops at a gap that "
         "is "
         "too wide to reach across, only this gap is tried. For each gap, 'mend' finds the nearest value "
         "at which all dominoes fall, and lists the smallest change first. If the row needs a push, the "
         "answer says so. The search tries up to 40 smaller and 40 larger values of each gap (10 in the "
         "rigid-body engine), and then bisects. It can miss a range of gaps that is narrower than one step.",
     .see = "fall tolerance change budget",
     .rows = true,
     .brief = "",
     ANSWER(mend)},
    {.name = "tolerance",
     .synonyms = "window precision error plumb measure tape spacing height",
     .summary = "how inaccurate each domino may be before the row stops",
     .help = "A window is a range of values, for example of the height of a domino. All dominoes fall with "
             "any value in this range, as long as nothing else in the row changes. Each domino has windows "
             "for its place, the gap before it, its height, its thickness and its lean. The friction "
             "between dominoes has one window. A place is measured along a tape from the back of domino 1. "
             "When a place changes, only that domino moves. When a gap changes, all dominoes after it move, "
             "and the other gaps stay the same. A domino whose height changes keeps its density and the "
             "angle of its lean. A domino that is not set up plumb leans about its front edge. The window "
             "for its lean says how far its top may be off plumb, backwards or forwards. With rounded "
             "edges, and in the engine, the program does not compute how far a domino may lean. The "
             "answer names the dominoes with the tightest limits. If the row does not fall, the windows show "
             "which single changes save it. The search takes the same steps as 'mend'.",
     .example = "set row 5; tolerance",
     .see = "mend change budget",
     .rows = true,
     .brief = "",
     ANSWER(tolerance)},
    {.name = "change",
     .synonyms = "modify edit adjust alter thickness height width mass radius lean",
     .argument =
         {{.name = "K", .kind = ARGUMENT_WORDS, .parse = change_parse_dominoes},
          {.name = "MEASURE", .kind = ARGUMENT_CHOICE, .noun = "measure", .choices = row_measure_names},
          {.name = "X", .kind = ARGUMENT_WORDS, .parse = change_parse_value, .bind = change_bind}},
     .summary = "change the height, gap, mass or another property of dominoes",
     .help = "K is the number of a domino, several numbers as in 4,5 or 3-7 (also 3:7 and 3..7), or 'all'. "
             "MEASURE is height, "
             "thickness, width, gap (before the domino), mass, radius (of the edges) or lean. A lean is an "
             "angle, or the distance of the top from plumb. A negative lean is backwards. X is the new "
             "value. An X with a sign is added to the old value, as in 'change 4 gap +1 cm'. A percentage "
             "with a sign changes the old value by this much, as in 'change 4,5 thickness +10 %'. 'change 4 "
             "lean = -2 mm' sets a negative value. A domino that becomes taller, thicker or wider becomes "
             "heavier, because it keeps its density. The gaps beside it and its other sizes stay the same. "
             "The change lasts until another row is entered; 'save FILE' and 'row > FILE.csv' keep it.",
     .example = "set row 5; change 2,3 thickness +10 %; change 3-5 gap 25 mm; verdict",
     .see = "row place mend tolerance",
     .access.changes = true,
     .run = run_change},
    {.name = "place",
     .synonyms = "move spacing distance gap",
     .argument = {{.name = "K", .kind = ARGUMENT_WORDS, .parse = change_parse_dominoes},
                  {.name = "GAP", .kind = ARGUMENT_WORDS, .parse = change_parse_value, .bind = change_bind}},
     .summary = "change the gap before domino K of the row",
     .help = "'place 3 25 mm' is short for 'change 3 gap 25 mm'. All dominoes after the gap move, and the "
             "other gaps stay the same. 'place 3 +1 cm' widens the gap by 1 cm.",
     .example = "set row 5; place 3 25 mm; fall",
     .see = "change row mend",
     .access.changes = true,
     .run = run_change},
    {.name = "row",
     .synonyms = "list export csv spacing",
     .summary = "the dominoes of the row",
     .help = "'row > hall.csv' writes a file that 'set row hall.csv' can read. The first line of the file "
             "has the units.",
     .example = "set row 3; row",
     .see = "effects fall",
     .rows = true,
     ANSWER(row)},
    {.name = "rowmax",
     .has_errors = true,
     .synonyms = "maximum ratio factor",
     .summary = "the largest growth r at which the whole row falls",
     .help = "The row is the one that 'set row N' makes from s, d, q and h, and 'set push' starts it. "
             "If the first domino is tipped over without a push, or with a weak one, the row can stop at the "
             "second domino. Otherwise, the longer the row, the closer the answer comes to 'rmax', the "
             "largest growth of the endless train.",
     .example = "set q hollow; set row 8; rowmax",
     .see = "rmax effects",
     .sweep.echo = "s",
     .principal = "r_max",
     ANSWER(rowmax)},
    {.name = NULL},
};
