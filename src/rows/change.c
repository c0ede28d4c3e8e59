/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'change', 'place', 'remove' and 'insert'. */
#include "interpreter/question.h"
#include "language/quad.h"
#include "rows/rows.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

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

/* ---- change and place: binding ---- */

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
    return true;
}

/* Stores the selected dominoes in given->bound. */
static struct row_change *dominoes_bind(const struct question *q, const struct query *query,
                                        struct arguments *given, struct problem *problem)
{
    const struct change_parsed *parsed = q->parsed;
    const size_t size = sizeof(struct row_change) + (size_t)parsed->count * sizeof(struct row_range);
    domq_real number;
    struct row_change *c = arguments_take(given, size, query, problem);
    for (const struct selected *s = parsed->first; s && c; s = s->next) {
        struct row_range *range = &c->range[c->ranges++];
        *range = s->range;
        if (!s->item.argument)
            continue;
        if (!item_bind(&s->item, q->text, query, NULL, &number, problem))
            return NULL;
        range->first = range->last = (size_t)number;
    }
    return c;
}

bool change_bind(const struct question *q, const struct query *query, struct arguments *given,
                 struct problem *problem)
{
    const struct change_parsed *parsed = q->parsed;
    struct quantity value;
    domq_real number;
    struct row_change *c = dominoes_bind(q, query, given, problem);
    if (!c)
        return false;
    c->measure = q->count > 2 ? (enum row_measure)(int)given->number[1] : MEASURE_GAP;
    return item_bind(&parsed->value, q->text, query, &value, &number, problem) &&
           value_bind(parsed, &value, c, problem);
}

bool remove_bind(const struct question *q, const struct query *query, struct arguments *given,
                 struct problem *problem)
{
    return dominoes_bind(q, query, given, problem) != NULL;
}
