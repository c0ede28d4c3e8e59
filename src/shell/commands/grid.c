/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/grid.h"
#include "language/quad.h"
#include "session/effects.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#define POINTS_MAX ((size_t)1000000000000)

static const char form[] = "a grid is NAME FROM TO N, or NAME VALUE, VALUE, ..., for each parameter";

static const struct domq_effect_argument *of_effect(const struct axis *axis)
{
    return &domq_effect(axis->effect)->argument[0];
}

/* Parameters of the model; the others say how the calculator works. */
static const struct parameter *grid_parameter(int k)
{
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (!p->setting && k-- == 0)
            return p;
    return NULL;
}

static int grid_parameters(void)
{
    int n = 0;
    while (grid_parameter(n))
        n++;
    return n;
}

const char *grid_names(const void *context, int k)
{
    const struct parameter *p = grid_parameter(k);
    return p ? p->name : effect_names(context, k - grid_parameters());
}

const char *axis_name(const struct axis *axis)
{
    return axis->parameter ? axis->parameter->name : domq_effect(axis->effect)->name;
}

const char *axis_unit(const struct axis *axis)
{
    return axis->parameter ? axis->parameter->unit : of_effect(axis)->unit;
}

static bool axis_whole(const struct axis *axis)
{
    return axis->parameter ? axis->parameter->whole : of_effect(axis)->whole;
}

/* ---- Reading ---- */

/* At the end of what a grid has? */
static bool grid_ends(const char *c)
{
    return command_ends(c) || *c == '>' || *c == ':';
}

static bool read_name(struct reader *r, const struct grid *grid, struct axis *axis)
{
    struct session *session = r->session;
    char message[NAMES_MESSAGE], shown[NAMES_SHOWN];
    session->column = reader_column(r, r->at);
    char *word = read_word(r, false);
    if (!word)
        return session_status(session, DOM_NO_MEMORY);
    const struct parameter *setting = parameter_find(word);
    int k = names_find(grid_names, NULL, "parameter", word, message), parameters = grid_parameters();
    names_shown(word, shown);
    free(word);
    if (setting && setting->setting)
        return session_error(session,
                             "'%s' is a setting of the calculator; a grid has parameters of the model "
                             "and effects",
                             shown);
    if (k < 0 && isalpha((unsigned char)*shown))
        return session_error(session, "%s", message);
    if (k < 0)
        return session_error(session, "'%s' stands where the name of a parameter belongs; %s", shown, form);
    *axis = (struct axis){.parameter = k < parameters ? grid_parameter(k) : NULL,
                          .effect = (enum dom_effect_name)(k < parameters ? 0 : k - parameters)};
    for (int i = 0; i < grid->axes; i++)
        if (strcmp(axis_name(&grid->axis[i]), axis_name(axis)) == 0)
            return session_error(session, "'%s' stands twice in the grid", axis_name(axis));
    return grid->axes < AXES_MAX ||
           session_error(session, "more than %d parameters; the others can be set before", AXES_MAX);
}

static bool read_one(struct reader *r, const struct axis *axis, const char *what, domq_real *value)
{
    struct quantity q;
    struct session *session = r->session;
    r->at = skip_blanks(r->at);
    session->column = reader_column(r, r->at);
    if (grid_ends(r->at))
        return session_error(session, "%s: %s is missing; %s", axis_name(axis), what, form);
    if (axis->parameter)
        return read_value(r, axis->parameter, axis->parameter->name, value);
    const struct argument a = {
        .name = of_effect(axis)->name, .kind = ARGUMENT_EFFECT, .effect = of_effect(axis)};
    return read_quantity(r, &a, &q, value);
}

/* The comma has been seen: values up to the one that has none behind it. */
static bool read_list(struct reader *r, struct axis *axis, domq_real first)
{
    size_t room = 0;
    domq_real value = first;
    for (;;) {
        if (axis->count == room) {
            room = 2 * room + 8;
            domq_real *more = realloc(axis->list, room * sizeof *more);
            if (!more)
                return session_status(r->session, DOM_NO_MEMORY);
            axis->list = more;
        }
        axis->list[axis->count++] = value;
        r->at = skip_blanks(r->at);
        if (*r->at != ',')
            return true;
        r->at++;
        if (!read_one(r, axis, "a value behind ','", &value))
            return false;
    }
}

/* N and, behind it, the word log. */
static bool read_steps(struct reader *r, struct axis *axis)
{
    struct session *session = r->session;
    struct quantity q;
    domq_real n;
    const char *name = axis_name(axis);
    r->at = skip_blanks(r->at);
    session->column = reader_column(r, r->at);
    if (grid_ends(r->at))
        return session_error(session, "%s: N, the number of values, is missing; %s", name, form);
    if (!read_quantity(r, &(struct argument){.name = "N", .kind = ARGUMENT_COUNT}, &q, &n))
        return false;
    axis->count = (size_t)n;
    if (n == 1 && axis->from != axis->to)
        return session_error(session, "%s: one value cannot cover %s to %s; N is at least 2", name,
                             quad_shown(axis->from).text, quad_shown(axis->to).text);
    const char *word = skip_blanks(r->at);
    size_t length = strspn(word, "abcdefghijklmnopqrstuvwxyz");
    axis->logarithmic = length == 3 && strncmp(word, "log", length) == 0;
    if (axis->logarithmic) {
        r->at = word + length;
        session->column = reader_column(r, word);
        return (axis->from > 0 && axis->to > 0) ||
               session_error(session, "%s: steps of equal ratio need FROM and TO above 0", name);
    }
    domq_real step = n > 1 ? (axis->to - axis->from) / (n - 1) : 0;
    return !axis_whole(axis) || quad(fabs)(step - quad(round)(step)) < (domq_real)1e-9 ||
           session_error(session, "%s has whole numbers only, and %s to %s in %zu values are not", name,
                         quad_shown(axis->from).text, quad_shown(axis->to).text, axis->count);
}

static bool read_values(struct reader *r, struct axis *axis)
{
    domq_real first = 0;
    bool words = axis->parameter && axis->parameter->words_only;
    if (!read_one(r, axis, words ? "a value" : "FROM", &first))
        return false;
    r->at = skip_blanks(r->at);
    if (*r->at == ',')
        return read_list(r, axis, first);
    axis->from = first;
    if (words)
        return session_error(r->session, "%s has words: 'sweep %s %s, %s : ...' lists them", axis_name(axis),
                             axis_name(axis), axis->parameter->words[0].name, axis->parameter->words[1].name);
    return read_one(r, axis, "TO", &axis->to) && read_steps(r, axis);
}

bool grid_read(struct reader *r, struct grid *grid)
{
    struct session *session = r->session;
    *grid = (struct grid){.points = 1};
    for (r->at = skip_blanks(r->at); !grid_ends(r->at); r->at = skip_blanks(r->at)) {
        struct axis *axis = &grid->axis[grid->axes];
        struct axis read;
        if (!read_name(r, grid, &read))
            return false;
        *axis = read;
        grid->axes++; /* what it holds is given back, whatever comes */
        if (!read_values(r, axis))
            return false;
        if (axis->count > POINTS_MAX / grid->points)
            return session_error(session, "the grid has more than %zu points", POINTS_MAX);
        grid->points *= axis->count;
    }
    session->column = reader_column(r, r->at);
    return grid->axes > 0 || session_error(session, "the grid is missing; %s", form);
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
    bool end = k == 0 || k == axis->count - 1; /* these are what was typed */
    domq_real value = axis->logarithmic && !end
                          ? quad(exp)((1 - f) * quad(log)(axis->from) + f * quad(log)(axis->to))
                          : (1 - f) * axis->from + f * axis->to;
    return axis_whole(axis) ? quad(round)(value) : value;
}

struct cell axis_cell(const struct axis *axis, domq_real value)
{
    if (axis->parameter && axis->parameter->words_only)
        return cell_word(parameter_word(axis->parameter, value));
    return axis_whole(axis) ? cell_count(value) : cell_real(value);
}

/* Words first: the precision has its own default of tol. */
void grid_put(const struct grid *grid, const domq_real *value, struct session *session)
{
    for (int words = 1; words >= 0; words--) {
        for (int i = 0; i < grid->axes; i++) {
            const struct axis *axis = &grid->axis[i];
            const struct parameter *p = axis->parameter;
            if (!p && words)
                effect_put(session, axis->effect, value[i]);
            if (!p || p->words_only != (words == 1))
                continue;
            if (strcmp(p->name, "precision") == 0)
                session_precision(session, (enum dom_precision)value[i]);
            else
                parameter_put(session, p, value[i]);
        }
    }
}

bool grid_check(const struct grid *grid, struct session *session)
{
    for (int i = 0; i < grid->axes; i++)
        if (!grid->axis[i].parameter && !effect_needs(session, grid->axis[i].effect))
            return false;
    return true;
}
