/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/sweeps/grid.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

#define POINTS_MAX ((size_t)1000000000000)

static const char form[] = "a grid is NAME FROM TO N, or NAME VALUE, VALUE, ..., for each parameter";

/* ---- Parsing ---- */

static const struct argument count_argument = {.name = "N", .kind = ARGUMENT_COUNT};

/* Parses one value; what: the value that may be missing. */
static bool value_parse(struct reader *r, const struct parameter *p, const char *what, struct item *item)
{
    r->at = skip_blanks(r->at);
    reader_place(r, r->at);
    if (command_ends(r->at) || *r->at == '>' || *r->at == ':')
        return problem_error(r->problem, "%s: %s is missing; %s", p->name, what, form);
    return item_parse_listed(r, p, item);
}

/* Parses the rest of a list, up to a value without a comma after it. */
static bool list_parse(struct reader *r, struct axis_parsed *axis)
{
    struct value_parsed **last = &axis->first->next;
    for (axis->count = 1; *r->at == ','; axis->count++) {
        struct value_parsed *value = arena_take(r->arena, sizeof *value);
        if (!value)
            return problem_error(r->problem, "out of memory");
        r->at++;
        if (!value_parse(r, axis->parameter, "a value after ','", &value->item))
            return false;
        *last = value;
        last = &value->next;
        r->at = skip_blanks(r->at);
    }
    return true;
}

/* Parses FROM, TO, N and, after it, the word log; or a list. */
static bool axis_parse(struct reader *r, struct axis_parsed *axis)
{
    const struct parameter *p = axis->parameter;
    if (!(axis->first = arena_take(r->arena, sizeof *axis->first)))
        return problem_error(r->problem, "out of memory");
    if (!value_parse(r, p, p->words_only ? "a value" : "FROM", &axis->first->item))
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
    r->at = skip_blanks(r->at);
    reader_place(r, r->at);
    if (command_ends(r->at) || *r->at == '>' || *r->at == ':')
        return problem_error(r->problem, "%s: N, the number of values, is missing; %s", p->name, form);
    if (!item_parse(r, &count_argument, &axis->steps))
        return false;
    r->at = skip_blanks(r->at);
    axis->log_at = r->at;
    axis->logarithmic = reader_takes(r, "log");
    return true;
}

bool grid_parse(struct reader *r, struct grid_parsed *grid)
{
    const char *no_unit = r->no_unit;
    r->no_unit = "sg"; /* the next name, and no unit, may follow N */
    *grid = (struct grid_parsed){.axes = 0};
    for (r->at = skip_blanks(r->at); !command_ends(r->at) && *r->at != '>' && *r->at != ':';
         r->at = skip_blanks(r->at)) {
        const struct parameter *p = parameter_parse(r, form);
        if (!p)
            return false;
        for (int i = 0; i < grid->axes; i++)
            if (grid->axis[i].parameter == p)
                return problem_error(r->problem, "'%s' is in the grid twice; name each parameter once",
                                     p->name);
        if (grid->axes == ASSIGNED_MAX)
            return problem_error(r->problem, "the grid has more than %d parameters; set the others before",
                                 ASSIGNED_MAX);
        struct axis_parsed *axis = &grid->axis[grid->axes++];
        axis->parameter = p;
        if (!axis_parse(r, axis))
            return false;
    }
    r->no_unit = no_unit;
    reader_place(r, r->at);
    return grid->axes > 0 || problem_error(r->problem, "the grid is missing; %s", form);
}

/* ---- Binding ---- */

static bool list_bind(const struct axis_parsed *from, const struct text *text, const struct query *query,
                      struct axis *axis, struct problem *problem)
{
    const struct value_parsed *value = from->first;
    axis->count = from->count;
    axis->list = malloc(axis->count * sizeof *axis->list);
    if (!axis->list)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    for (size_t k = 0; k < axis->count; k++, value = value->next)
        if (!item_bind(&value->item, text, query, NULL, &axis->list[k], problem))
            return false;
    return true;
}

static bool axis_bind(const struct axis_parsed *from, const struct text *text, const struct query *query,
                      struct axis *axis, struct problem *problem)
{
    domq_real n;
    const char *name = from->parameter->name;
    *axis = (struct axis){.parameter = from->parameter, .logarithmic = from->logarithmic};
    if (from->count > 0)
        return list_bind(from, text, query, axis, problem);
    if (!item_bind(&from->first->item, text, query, NULL, &axis->from, problem) ||
        !item_bind(&from->to, text, query, NULL, &axis->to, problem) ||
        !item_bind(&from->steps, text, query, NULL, &n, problem))
        return false;
    axis->count = (size_t)n;
    if (n == 1 && axis->from != axis->to)
        return problem_error(problem, "%s: one value cannot cover %s to %s; enter an N of at least 2", name,
                             quad_shown(axis->from).text, quad_shown(axis->to).text);
    if (axis->logarithmic) {
        problem->place = text_column(text, from->log_at);
        return (axis->from > 0 && axis->to > 0) ||
               problem_error(problem, "%s: equal ratios need FROM and TO above 0", name);
    }
    domq_real step = n > 1 ? (axis->to - axis->from) / (n - 1) : 0;
    return !axis->parameter->value->whole || quad(fabs)(step - quad(round)(step)) < (domq_real)1e-9 ||
           problem_error(problem,
                         "%s takes whole numbers, which %s to %s in %zu values are not; enter another N",
                         name, quad_shown(axis->from).text, quad_shown(axis->to).text, axis->count);
}

bool grid_bind(const struct grid_parsed *from, const struct text *text, const struct query *query,
               struct grid *grid, struct problem *problem)
{
    *grid = (struct grid){.points = 1};
    for (int i = 0; i < from->axes; i++) {
        struct axis *axis = &grid->axis[grid->axes++]; /* grid_free frees its list also after a problem */
        if (!axis_bind(&from->axis[i], text, query, axis, problem))
            return false;
        if (axis->count > POINTS_MAX / grid->points)
            return problem_error(problem, "the grid has more than %zu points; enter smaller N", POINTS_MAX);
        grid->points *= axis->count;
    }
    return true;
}

void grid_free(struct grid *grid)
{
    for (int i = 0; i < grid->axes; i++)
        free(grid->axis[i].list);
}

/* ---- Values ---- */

domq_real axis_value(const struct axis *axis, size_t k)
{
    if (axis->list)
        return axis->list[k];
    domq_real f = axis->count > 1 ? (domq_real)k / (domq_real)(axis->count - 1) : 0;
    bool end = k == 0 || k == axis->count - 1; /* exactly as typed */
    domq_real value = axis->logarithmic && !end
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
