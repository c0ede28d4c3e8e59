/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'change', 'place', 'remove' and 'insert'. */
#include "interpreter/question.h"
#include "language/quad.h"
#include "rows/rows.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- change and place: parsing ---- */

struct change_parsed {
    struct row_change *change; /* the selected dominoes */
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

bool change_parse_dominoes(struct reader *r, struct question *q)
{
    size_t most = 1;
    for (const char *at = r->at; *at; at++)
        most += *at == ',';
    struct change_parsed *parsed = q->parsed = reader_memory(r, sizeof *parsed);
    struct row_change *c = parsed ? reader_memory(r, sizeof *c + most * sizeof *c->range) : NULL;
    if (!c)
        return false;
    parsed->change = c;
    if (reader_takes(r, "all"))
        return true;
    for (;; r->at = skip_blanks(r->at + 1)) {
        struct row_range *range = &c->range[c->ranges++];
        reader_place(r, r->at);
        if (!range_read(r, range))
            return problem_error(r->problem, "this is no domino; write numbers as in 4,5 or 3-7, or 'all'");
        if (range->first > range->last)
            return problem_error(r->problem, "'%zu-%zu' names no dominoes; write the smaller number first",
                                 range->first, range->last);
        const char *next = skip_blanks(r->at);
        if (*next != ',')
            return true;
        r->at = next;
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
    const struct row_change *selected = ((const struct change_parsed *)q->parsed)->change;
    const size_t size = sizeof *selected + (size_t)selected->ranges * sizeof *selected->range;
    struct row_change *c = arguments_take(given, size, query, problem);
    if (c)
        memcpy(c, selected, size);
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
