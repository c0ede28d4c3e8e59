/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands change and place, which change measures of dominoes. 'place' changes gaps. */
#include "commands/rows/change.h"
#include "commands/rows/rows.h"
#include "language/quad.h"
#include "session/rowfile.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Parsing ---- */

/* Dominoes with successive numbers, or a single domino whose number is an expression, as an element of a
 * linked list. */
struct selected {
    struct row_range range;
    struct item item; /* the expression; item.argument is NULL if there is none */
    struct selected *next;
};

struct change_parsed {
    struct selected *first; /* NULL stands for all dominoes */
    int count;
    struct item value;
    bool is_set;   /* a '=' precedes the value */
    bool has_sign; /* the value begins with a sign */
    bool is_share; /* the value ends with '%' */
};

/* Reads "4" or "3-7". Returns false, and reads nothing, if the text is another expression. */
static bool range_read(struct reader *r, struct row_range *range)
{
    char *end;
    if (!isdigit((unsigned char)*r->at))
        return false;
    range->first = range->last = strtoul(r->at, &end, 10);
    if (*end == '-' && isdigit((unsigned char)end[1]))
        range->last = strtoul(end + 1, &end, 10);
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

bool change_parse_dominoes(struct reader *r, struct question *q)
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

bool change_parse_value(struct reader *r, struct question *q)
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

/* ---- Binding ---- */

/* A bound change. */
struct changing {
    struct row_change change;
    int ranges; /* 0 stands for all dominoes */
    struct row_range range[];
};

/* Checks the unit of the value, and finds from the value how the measure changes. On failure, sets *problem
 * and returns false. */
static bool value_bind(const struct change_parsed *parsed, const struct quantity *value,
                       struct row_change *change, struct problem *problem)
{
    const char *name = row_measure_names(NULL, (int)change->measure),
               *unit = rowfile_kind.column[change->measure].unit;
    const struct quantity wanted = expression_unit(unit);
    const bool is_relative = parsed->has_sign && !parsed->is_set, is_bare = quantity_bare(*value);
    change->value = value->value;
    change->is_angle =
        change->measure == MEASURE_LEAN && quantity_alike(*value, (struct quantity){.angle = 1});
    if (parsed->is_share && is_bare) {
        change->how = CHANGE_TIMES;
        change->value += is_relative;
        return true;
    }
    if (!is_bare && !change->is_angle && !quantity_alike(*value, wanted))
        return problem_error(problem, "the %s is %s, not %s; enter one such as '%s'", name,
                             expression_kind(wanted), expression_kind(*value), expression_example(wanted));
    if (is_relative && is_bare)
        return problem_error(
            problem,
            "a change of the %s by %s needs a unit, as in '%+.4g %s'; with '%%' it is a share "
            "of the %s, as in '+10 %%'",
            name, quad_shown(value->value).text, (double)value->value, unit, name);
    change->how = is_relative ? CHANGE_BY : CHANGE_TO;
    change->is_bare = is_bare;
    return true;
}

bool change_bind(const struct question *q, const struct query *query, struct arguments *given,
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

/* ---- The answer ---- */

enum { LINES = 12 /* the maximum number of dominoes whose changes are printed */ };

static void change_say(const struct query *query, struct answer *a, const struct row_change *change, size_t k,
                       const struct domq_domino *before, const struct domq_domino *after)
{
    const enum row_measure measure = change->measure;
    const char *name = row_measure_names(NULL, (int)measure);
    const domq_real from = scene_row_measure(query->scene, before, measure),
                    to = scene_row_measure(query->scene, after, measure);
    const struct measure unit =
        measure_of(rowfile_kind.column[measure].unit, quad_larger(quad(fabs)(from), quad(fabs)(to)));
    char one[WIDE_TEXT], other[WIDE_TEXT];
    quad_text(measure_number(unit, from), 6, one);
    quad_text(measure_number(unit, to), 6, other);
    if (measure == MEASURE_MASS && !scene_has_masses(query->scene))
        answer_say(a, "domino %zu: mass %s times as large as before", k, quad_text(change->value, 6, other));
    else if (strcmp(one, other) == 0)
        answer_say(a, "domino %zu: %s stays %s %s", k, name, other, unit.unit);
    else
        answer_say(a, "domino %zu: %s %s to %s %s", k, name, one, other, unit.unit);
}

static void changes_say(const struct query *query, struct answer *a, const struct row_change *change,
                        const struct row_range *range, int ranges, const struct domq_domino *before,
                        const struct domq_domino *after)
{
    size_t lines = 0, more = 0;
    for (int i = 0; i < ranges; i++)
        for (size_t k = range[i].first; k <= range[i].last; k++)
            if (lines < LINES) {
                change_say(query, a, change, k, &before[k - 1], &after[k - 1]);
                lines++;
            } else
                more++;
    if (more > 0)
        answer_say(a, "and %zu more; 'row' lists the row", more);
    a->wrote_text = true;
}

bool run_change(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct changing *c = query->given->bound;
    struct scene_row before, after;
    if (!query->next)
        return true;
    if (!scene_row_list(query->scene, &before, problem))
        return false;
    struct row_range all = {c->change.measure == MEASURE_GAP ? 2 : 1, before.row.count};
    const struct row_range *range = c->ranges ? c->range : &all;
    const int ranges = c->ranges ? c->ranges : 1;
    bool good = scene_row_change(&query->next->scene, &c->change, range, ranges, problem);
    if (good && answer_for_people(a) && !query->means->sourced) {
        good = scene_row_list(&query->next->scene, &after, problem);
        if (good) {
            changes_say(query, a, &c->change, range, ranges, before.domino, after.domino);
            free(after.domino);
        }
    }
    free(before.domino);
    return good;
}
