/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/quad.h"
#include "sweeps/sweeps.h"

static const char form[] = "for each parameter, enter NAME FROM TO N or NAME VALUE, VALUE, ...";

/* ---- Parsing ---- */

/* Parses one value. If the value is missing, the message calls it `name`. */
static bool value_parse(struct reader *r, const struct parameter *p, const char *name, struct item *item)
{
    bool ends = reader_ends(r);
    reader_place(r, r->at);
    return ends ? problem_error(r->problem, "%s: %s is missing; %s", p->name, name, form)
                : item_parse_listed(r, p, item);
}

/* Parses the remaining values of a list, after the first one. */
static bool list_parse(struct reader *r, struct axis_parsed *axis)
{
    struct value_parsed **last = &axis->first->next;
    for (axis->count = 1; *r->at == ','; axis->count++) {
        struct value_parsed *value = *last = reader_memory(r, sizeof *value);
        if (!value)
            return false;
        r->at++;
        if (!value_parse(r, axis->parameter, "a value after ','", &value->item))
            return false;
        last = &value->next;
        r->at = skip_blanks(r->at);
    }
    return true;
}

/* Parses "FROM TO N", "FROM TO N log" or a list. */
static bool axis_parse(struct reader *r, struct axis_parsed *axis)
{
    static const struct argument count = {.name = "N", .kind = ARGUMENT_COUNT};
    const struct parameter *p = axis->parameter;
    axis->first = reader_memory(r, sizeof *axis->first);
    if (!axis->first || !value_parse(r, p, p->words_only ? "a value" : "FROM", &axis->first->item))
        return false;
    r->at = skip_blanks(r->at);
    if (*r->at == ',')
        return list_parse(r, axis);
    if (!p->words_only && !value_parse(r, p, "TO", &axis->to))
        return false;
    const struct item *from = &axis->first->item, *to = &axis->to;
    if (p->words_only || (!from->value && from->number == EFFECT_OFF) ||
        (!to->value && to->number == EFFECT_OFF))
        return problem_error(r->problem,
                             "the values of %s are words; list them, as in 'sweep %s %s, %s : rmax'", p->name,
                             p->name, p->words[0].name, p->words[1].name);
    bool ends = reader_ends(r);
    reader_place(r, r->at);
    if (ends)
        return problem_error(r->problem, "%s: N, the number of values, is missing; %s", p->name, form);
    if (!item_parse(r, &count, &axis->steps))
        return false;
    const char *behind = skip_blanks(r->at);
    r->at = behind;
    axis->log_at = reader_takes(r, "log") ? behind : NULL;
    return true;
}

static bool axes_parse(struct reader *r, struct grid_parsed *grid)
{
    *grid = (struct grid_parsed){.axes = 0};
    while (!reader_ends(r) || *r->at == ',') {
        const struct parameter *p = parameter_parse(r, form);
        if (!p)
            return false;
        for (int i = 0; i < grid->axes; i++)
            if (grid->axis[i].parameter == p)
                return problem_error(r->problem, "'%s' is in the grid twice; name each parameter once",
                                     p->name);
        if (grid->axes == ASSIGNED_MAX)
            return problem_error(r->problem,
                                 "the grid has more than %d parameters; set the others before the sweep",
                                 ASSIGNED_MAX);
        struct axis_parsed *axis = &grid->axis[grid->axes++];
        axis->parameter = p;
        if (!axis_parse(r, axis))
            return false;
        grid->listed += axis->count;
    }
    reader_place(r, r->at);
    if (grid->axes == 0)
        return problem_error(r->problem, "the grid is missing; %s", form);
    return *r->at == ':' ||
           problem_error(r->problem, "':' and a command are missing after the grid; enter, for "
                                     "example, 'sweep s 0.1 0.9 9 : rmax'");
}

bool grid_parse(struct reader *r, struct grid_parsed *grid)
{
    const char *no_unit = r->no_unit;
    r->no_unit = "sg"; /* after N, 's' and 'g' are parameters, not seconds and grams */
    r->stops = ":,";
    bool is_good = axes_parse(r, grid);
    r->stops = NULL;
    r->no_unit = no_unit;
    return is_good;
}

/* ---- Binding ---- */

static bool axis_bind(const struct axis_parsed *parsed, const struct text *text, const struct query *query,
                      domq_real *list, struct axis *axis, struct problem *problem)
{
    domq_real n;
    const char *name = parsed->parameter->name;
    const struct value_parsed *value = parsed->first;
    *axis = (struct axis){.parameter = parsed->parameter,
                          .count = parsed->count,
                          .logarithmic = parsed->log_at != NULL,
                          .list = parsed->count > 0 ? list : NULL};
    for (size_t k = 0; k < parsed->count; k++, value = value->next)
        if (!item_bind(&value->item, text, query, NULL, &list[k], problem))
            return false;
    if (parsed->count > 0)
        return true;
    if (!item_bind(&parsed->first->item, text, query, NULL, &axis->from, problem) ||
        !item_bind(&parsed->to, text, query, NULL, &axis->to, problem) ||
        !item_bind(&parsed->steps, text, query, NULL, &n, problem))
        return false;
    axis->count = (size_t)n;
    if (n == 1 && axis->from != axis->to)
        return problem_error(problem, "%s: one value cannot cover %s to %s; enter an N of at least 2", name,
                             quad_text(axis->from, 10), quad_text(axis->to, 10));
    if (axis->logarithmic) {
        problem->place = text_column(text, parsed->log_at);
        return (axis->from > 0 && axis->to > 0) ||
               problem_error(problem, "%s: with 'log', FROM and TO must be above 0", name);
    }
    domq_real step = n > 1 ? (axis->to - axis->from) / (n - 1) : 0;
    return !axis->parameter->value->whole || quad(fabs)(step - quad(round)(step)) < (domq_real)1e-9 ||
           problem_error(problem,
                         "%s takes whole numbers, but %zu values from %s to %s are not all whole; "
                         "enter another N",
                         name, axis->count, quad_text(axis->from, 10), quad_text(axis->to, 10));
}

bool grid_bind(const struct grid_parsed *parsed, const struct text *text, const struct query *query,
               domq_real *listed, struct grid *grid, struct problem *problem)
{
    const size_t most = 1000000000000;
    *grid = (struct grid){.points = 1};
    for (int i = 0; i < parsed->axes; i++) {
        struct axis *axis = &grid->axis[grid->axes++];
        if (!axis_bind(&parsed->axis[i], text, query, listed, axis, problem))
            return false;
        listed += parsed->axis[i].count;
        if (axis->count > most / grid->points)
            return problem_error(problem, "the grid has more than %zu points; enter a smaller N", most);
        grid->points *= axis->count;
    }
    return true;
}

/* ---- Values ---- */

domq_real axis_value(const struct axis *axis, size_t k)
{
    if (axis->list)
        return axis->list[k];
    domq_real f = axis->count > 1 ? (domq_real)k / (domq_real)(axis->count - 1) : 0;
    bool is_end = k == 0 || k == axis->count - 1; /* the first and the last value must be exactly as typed */
    domq_real value = axis->logarithmic && !is_end
                          ? quad(exp)((1 - f) * quad(log)(axis->from) + f * quad(log)(axis->to))
                          : (1 - f) * axis->from + f * axis->to;
    return axis->parameter->value->whole ? quad(round)(value) : value;
}

struct cell axis_cell(const struct axis *axis, domq_real value)
{
    const char *word = parameter_is_number(axis->parameter) ? NULL : parameter_word(axis->parameter, value);
    if (word)
        return cell_word(word);
    return axis->parameter->value->whole ? cell_count(value) : cell_real(value);
}
