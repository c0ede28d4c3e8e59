/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/sweeps/grid.h"
#include "language/quad.h"
#include "session/meant.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#define POINTS_MAX ((size_t)1000000000000)

static const char form[] = "a grid is NAME FROM TO N, or NAME VALUE, VALUE, ..., for each parameter";

/* Returns the k-th parameter of the model, without settings of the calculator, or the end of the table. */
static const struct parameter *grid_parameter(int k)
{
    const struct parameter *p = session_parameters;
    while (p->name && (p->setting || k-- > 0))
        p++;
    return p;
}

const char *grid_names(const void *context, int k)
{
    (void)context;
    return grid_parameter(k)->name;
}

/* ---- Reading ---- */

/* Returns true at the end of the grid. */
static bool grid_ends(const char *c)
{
    return command_ends(c) || *c == '>' || *c == ':';
}

static bool read_name(struct reader *r, const struct grid *grid, struct axis *axis)
{
    char message[NAMES_MESSAGE], shown[NAMES_SHOWN];
    r->problem->place = reader_column(r, r->at);
    char *word = read_word(r, false);
    if (!word)
        return problem_status(r->problem, r->query->scene, DOM_NO_MEMORY);
    const struct parameter *setting = parameter_find(word);
    int k = names_find(grid_names, NULL, "parameter", word, message);
    bool usual;
    const struct parameter *meant = k == NAMES_UNKNOWN ? parameter_meant(word, &usual) : NULL;
    names_shown(word, shown);
    free(word);
    if (meant)
        return problem_error(r->problem, "unknown parameter '%s'; did you mean '%s'?", shown, meant->name);
    if (setting && setting->setting)
        return problem_error(
            r->problem, "'%s' is a setting of the calculator; sweep a parameter of the model or an effect",
            shown);
    if (k < 0 && isalpha((unsigned char)*shown))
        return problem_error(r->problem, "%s", message);
    if (k < 0)
        return problem_error(r->problem, "'%s' is not the name of a parameter; %s", shown, form);
    *axis = (struct axis){.parameter = grid_parameter(k)};
    for (int i = 0; i < grid->axes; i++)
        if (grid->axis[i].parameter == axis->parameter)
            return problem_error(r->problem, "'%s' is in the grid twice; name each parameter once",
                                 axis->parameter->name);
    return grid->axes < AXES_MAX ||
           problem_error(r->problem, "the grid has more than %d parameters; set the others before", AXES_MAX);
}

static bool read_one(struct reader *r, const struct axis *axis, const char *what, domq_real *value)
{
    const struct parameter *p = axis->parameter;
    r->at = skip_blanks(r->at);
    r->problem->place = reader_column(r, r->at);
    if (grid_ends(r->at))
        return problem_error(r->problem, "%s: %s is missing; %s", p->name, what, form);
    if (!read_value(r, p, 0, p->value->name, value))
        return false;
    if (p->effect && *value == EFFECT_ON)
        *value = p->value->usual;
    return true;
}

/* Reads the rest of a list, up to a value without a comma after it. */
static bool read_list(struct reader *r, struct axis *axis, domq_real first)
{
    size_t room = 0;
    domq_real value = first;
    for (;;) {
        if (axis->count == room) {
            room = 2 * room + 8;
            domq_real *more = realloc(axis->list, room * sizeof *more);
            if (!more)
                return problem_status(r->problem, r->query->scene, DOM_NO_MEMORY);
            axis->list = more;
        }
        axis->list[axis->count++] = value;
        r->at = skip_blanks(r->at);
        if (*r->at != ',')
            return true;
        r->at++;
        if (!read_one(r, axis, "a value after ','", &value))
            return false;
    }
}

/* Reads N and, after it, the word log. */
static bool read_steps(struct reader *r, struct axis *axis)
{
    struct quantity q;
    domq_real n;
    const char *name = axis->parameter->name;
    r->at = skip_blanks(r->at);
    r->problem->place = reader_column(r, r->at);
    if (grid_ends(r->at))
        return problem_error(r->problem, "%s: N, the number of values, is missing; %s", name, form);
    if (!read_quantity(r, &(struct argument){.name = "N", .kind = ARGUMENT_COUNT}, &q, &n))
        return false;
    axis->count = (size_t)n;
    if (n == 1 && axis->from != axis->to)
        return problem_error(r->problem, "%s: one value cannot cover %s to %s; enter an N of at least 2",
                             name, quad_shown(axis->from).text, quad_shown(axis->to).text);
    const char *word = skip_blanks(r->at);
    size_t length = strspn(word, "abcdefghijklmnopqrstuvwxyz");
    axis->logarithmic = length == 3 && strncmp(word, "log", length) == 0;
    if (axis->logarithmic) {
        r->at = word + length;
        r->problem->place = reader_column(r, word);
        return (axis->from > 0 && axis->to > 0) ||
               problem_error(r->problem, "%s: equal ratios need FROM and TO above 0", name);
    }
    domq_real step = n > 1 ? (axis->to - axis->from) / (n - 1) : 0;
    return !axis->parameter->value->whole || quad(fabs)(step - quad(round)(step)) < (domq_real)1e-9 ||
           problem_error(r->problem,
                         "%s takes whole numbers, which %s to %s in %zu values are not; enter another N",
                         name, quad_shown(axis->from).text, quad_shown(axis->to).text, axis->count);
}

static bool read_values(struct reader *r, struct axis *axis)
{
    domq_real first = 0;
    const struct parameter *p = axis->parameter;
    if (!read_one(r, axis, p->words_only ? "a value" : "FROM", &first))
        return false;
    r->at = skip_blanks(r->at);
    if (*r->at == ',')
        return read_list(r, axis, first);
    axis->from = first;
    if (!p->words_only && !read_one(r, axis, "TO", &axis->to))
        return false;
    if (p->words_only || axis->from == EFFECT_OFF || axis->to == EFFECT_OFF)
        return problem_error(r->problem,
                             "the values of %s are words; list them, as in 'sweep %s %s, %s : rmax'", p->name,
                             p->name, p->words[0].name, p->words[1].name);
    return read_steps(r, axis);
}

bool grid_read(struct reader *r, struct grid *grid)
{
    *grid = (struct grid){.points = 1};
    for (r->at = skip_blanks(r->at); !grid_ends(r->at); r->at = skip_blanks(r->at)) {
        struct axis *axis = &grid->axis[grid->axes];
        struct axis read;
        if (!read_name(r, grid, &read))
            return false;
        *axis = read;
        grid->axes++; /* grid_free frees its list also after an error */
        if (!read_values(r, axis))
            return false;
        if (axis->count > POINTS_MAX / grid->points)
            return problem_error(r->problem, "the grid has more than %zu points; enter smaller N",
                                 POINTS_MAX);
        grid->points *= axis->count;
    }
    r->problem->place = reader_column(r, r->at);
    return grid->axes > 0 || problem_error(r->problem, "the grid is missing; %s", form);
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

/* Sets words first, since the precision has its own default of tol. */
void grid_put(const struct grid *grid, const domq_real *value, struct state *state)
{
    for (int words = 1; words >= 0; words--)
        for (int i = 0; i < grid->axes; i++)
            if (grid->axis[i].parameter->words_only == (words == 1))
                parameter_put(state, grid->axis[i].parameter, value[i]);
}

bool grid_check(const struct grid *grid, const struct scene *scene, struct problem *problem)
{
    for (int i = 0; i < grid->axes; i++)
        if (grid->axis[i].parameter->effect && !effect_needs(scene, grid->axis[i].parameter->which, problem))
            return false;
    return true;
}
