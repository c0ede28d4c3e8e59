/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameters, effects and variables of the session as tables. */
#include "answer/format.h"
#include "commands/tables.h"
#include "io/terminal.h"
#include "language/quad.h"
#include <string.h>

const struct column show_columns[] = {
    {"name", "", "the name that 'set' takes; or that 'let' gave", 9},
    {"value", "", "the value now", 12},
    {"unit", "", "h: heights of the domino", 5},
    {"range", "", "the values that are allowed", 17},
    {"default", "", "the value at the start", 8},
    {"meaning", "", "what the parameter means", 24},
    {NULL, NULL, NULL, 0},
};

enum { SHOW_COLUMNS = sizeof show_columns / sizeof *show_columns };

/* Holds a parameter as it is shown: the cells of its row, and the words in them. */
struct shown {
    char range[64], value[EFFECT_SETTING], fallback[WIDE_TEXT];
    struct cell cell[SHOW_COLUMNS];
};

/* Adds the name that a number has: "4 (solid)". */
static void named(const struct parameter *p, domq_real value, char *text, size_t size)
{
    const char *name = parameter_word(p, value);
    size_t used = strlen(text);
    if (name)
        snprintf(text + used, size - used, " (%s)", name);
}

static void shown_make(const struct query *query, const struct parameter *p, bool people, struct shown *shown)
{
    domq_real value = parameter_get(query->state, p), fallback = parameter_fallback(query->state, p);
    bool number = !people && parameter_is_number(p);
    bool on = !people && p->effect && value != EFFECT_OFF && !effect_file(query->scene, p->which);
    parameter_range(query->state, p, 0, shown->range, sizeof shown->range);
    if (p->effect)
        effect_setting(query->scene, p->which, shown->value);
    else
        parameter_text(p, value, (int)query->state->settings.style.digits, shown->value, sizeof shown->value);
    parameter_text(p, fallback, 6, shown->fallback, sizeof shown->fallback);
    if (people && parameter_is_number(p)) {
        named(p, value, shown->value, sizeof shown->value);
        named(p, fallback, shown->fallback, sizeof shown->fallback);
    }
    const struct cell cells[] = {cell_word(p->name),
                                 number || on ? cell_real(value) : cell_word(shown->value),
                                 cell_word(people && p->effect ? "" : p->value->unit),
                                 cell_word(shown->range),
                                 number ? cell_real(fallback) : cell_word(shown->fallback),
                                 cell_word(parameter_meaning(p))};
    memcpy(shown->cell, cells, sizeof cells);
}

/* Returns the columns that a table of these has before the meaning, which is wrapped or below. */
static int shown_width(const struct column *columns)
{
    int width = 0;
    for (const struct column *c = columns; c[1].key; c++)
        width += c->width + 2;
    return width;
}

/* Leaves out the columns for which a narrow terminal has no room. */
static void show_fit(struct answer *a)
{
    static const char *const last[] = {"default", "range", "unit"};
    int width = terminal_width(a->out);
    for (size_t i = 0; width && i < sizeof last / sizeof *last && shown_width(a->columns) > width; i++)
        answer_leave_out(a, last[i]);
}

/* Adds what 'let' defined: a variable has a value and a unit, a function its text. */
static void variable_row(struct answer *a, const struct variable *v)
{
    char head[VARIABLE_HEAD], unit[48], value[WIDE_TEXT];
    struct cell number = cell_unbounded(v->value.value);
    if (answer_for_people(a))
        number = cell_word(quad_text(v->value.value, (int)a->style.digits, value));
    const struct cell cells[] = {cell_word(variable_head(v, head)),
                                 v->body ? cell_word(v->body) : number,
                                 cell_word(expression_unit_text(v->value, unit, sizeof unit)),
                                 cell_word(""),
                                 cell_word(""),
                                 cell_word(v->body ? "a function, from 'let'" : "a variable, from 'let'")};
    answer_row(a, cells, NULL);
}

/* Returns true if the parameter has not its default. */
static bool differs(const struct query *query, const struct parameter *p)
{
    return parameter_get(query->state, p) != parameter_fallback(query->state, p);
}

/* Shows the parameter of the call; without one all, or those that differ from their defaults. */
static bool show(const struct query *query, struct answer *a, bool differing)
{
    struct column *fitted = answer_columns(a, show_columns);
    struct shown shown;
    if (query->given->variable) {
        show_fit(a);
        variable_row(a, query->given->variable);
        return true;
    }
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 1 && a->style.format->for_people)
            show_fit(a);
        for (const struct parameter *p = session_parameters; p->name; p++) {
            if (differing                 ? !differs(query, p)
                : query->given->parameter ? p != query->given->parameter
                                          : p->effect != NULL)
                continue;
            shown_make(query, p, a->style.format->for_people, &shown);
            for (int i = 0; pass == 0 && fitted[i + 1].key; i++) /* the last one is wrapped */
                if (shown.cell[i].kind == CELL_WORD)
                    column_fit(&fitted[i], shown.cell[i].word);
            if (pass == 0)
                continue;
            answer_row(a, shown.cell, NULL);
        }
    }
    for (size_t i = 0; !query->given->parameter && i < query->state->variables.count; i++)
        variable_row(a, &query->state->variables.list[i]);
    return true;
}

bool run_show(const struct query *query, struct answer *a, struct problem *problem)
{
    (void)problem;
    return show(query, a, false);
}

bool show_variables(const struct query *query, struct answer *a)
{
    const struct variables *all = &query->state->variables;
    a->rows = true;
    if (query->given->variable)
        return show(query, a, false);
    if (all->count == 0) {
        answer_say(a, "No variable is defined; for example 'let x = 0.9*rmax'.");
        return true;
    }
    answer_columns(a, show_columns);
    show_fit(a);
    for (size_t i = 0; i < all->count; i++)
        variable_row(a, &all->list[i]);
    return true;
}

bool run_diff(const struct query *query, struct answer *a, struct problem *problem)
{
    (void)problem;
    const struct parameter *p = session_parameters;
    size_t gaps = query->scene->listed.changes;
    while (p->name && !differs(query, p))
        p++;
    if (!p->name && query->state->variables.count == 0)
        answer_say(a, "All parameters have their defaults, and no effect is on.");
    else if (!show(query, a, true))
        return false;
    if (gaps > 0)
        answer_say(a, "%zu gap%s of the row %s changed by 'place'; 'row' lists the row.", gaps,
                   gaps == 1 ? "" : "s", gaps == 1 ? "was" : "were");
    return true;
}
