/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'show', which prints the parameters, effects and variables of the session as a table. */
#include "commands/tables.h"
#include "language/quad.h"
#include "language/text.h"
#include <string.h>

const struct column show_columns[] = {
    {"name", "", "the name of the parameter, effect or variable", 9},
    {"value", "", "the present value", 12},
    {"unit", "", "the unit of the value; h is the height of the domino", 5},
    {"range", "", "the values that are allowed", 17},
    {"default", "", "the default value", 8},
    {"meaning", "", "what the parameter means", 24},
    {NULL, NULL, NULL, 0},
};

enum { SHOW_COLUMNS = sizeof show_columns / sizeof *show_columns };

/* The cells of a parameter's row in the table, and buffers for the texts that the cells point to. */
struct shown {
    char range[PARAMETER_RANGE], value[EFFECT_SETTING], fallback[WIDE_TEXT];
    char unit[8];
    struct cell cell[SHOW_COLUMNS];
};

/* If a parameter has a word for this number, appends the word, as in "4 (solid)". */
static void word_add(const struct parameter *p, domq_real value, char *text, size_t size)
{
    const char *word = parameter_word(p, value);
    if (word)
        text_add(text, size, " (%s)", word);
}

static void shown_make(const struct query *query, const struct parameter *p, bool people, struct shown *shown)
{
    char number[WIDE_TEXT];
    domq_real value = parameter_get(query->state, p), fallback = parameter_fallback(query->state, p);
    bool is_number = parameter_is_number(p), as_number = is_number && !people,
         is_on = p->effect && value != EFFECT_OFF && !effect_file(query->scene, p->which);
    parameter_range_write(query->state, p, 0, shown->range);
    if (p->effect)
        effect_setting_write(query->scene, p->which, shown->value);
    else
        snprintf(shown->value, sizeof shown->value, "%s",
                 parameter_text(p, value, (int)query->state->settings.style.digits, number));
    const struct typed_length *length = &query->scene->length[p->share];
    char typed[LENGTH_TEXT];
    const char *unit = people && p->effect ? "" : p->value->unit;
    const bool is_length = people && length->m > 0 && value != EFFECT_OFF;
    if (is_length) {
        char setting[EFFECT_SETTING];
        snprintf(setting, sizeof setting, "%s", shown->value);
        const char *others = p->effect ? strchr(setting, ',') : NULL; /* as in "18 mm, 0.3 m" */
        length_write(length->m, length->unit, typed);
        unit = strchr(typed, ' ') + 1;
        snprintf(shown->value, sizeof shown->value, "%.*s%s", others ? LENGTH_TEXT : (int)(unit - 1 - typed),
                 typed, others ? others : "");
        snprintf(shown->unit, sizeof shown->unit, "%.7s", others ? "" : unit);
        unit = shown->unit;
        text_add(shown->range, sizeof shown->range, " %s", p->value->unit);
    }
    snprintf(shown->fallback, sizeof shown->fallback, "%s", parameter_text(p, fallback, 6, number));
    if (people && is_number && !is_length) {
        word_add(p, value, shown->value, sizeof shown->value);
        word_add(p, fallback, shown->fallback, sizeof shown->fallback);
    }
    const struct cell cells[] = {cell_word(p->name),
                                 as_number || (is_on && !people) ? cell_real(value) : cell_word(shown->value),
                                 cell_word(unit),
                                 cell_word(shown->range),
                                 as_number ? cell_real(fallback) : cell_word(shown->fallback),
                                 cell_word(p->meaning)};
    memcpy(shown->cell, cells, sizeof cells);
}

static void variable_row(struct answer *a, const struct variable *v)
{
    char value[WIDE_TEXT];
    struct cell number = cell_without_error(v->value.value);
    if (answer_for_people(a))
        number = cell_word(quad_write(v->value.value, (int)a->style.digits, value));
    answer_cells(a, cell_word(variable_head(v)), v->body ? cell_word(v->body) : number,
                 cell_word(expression_unit_text(v->value)), cell_word(""), cell_word(""),
                 cell_word(v->body ? "a function, from 'let'" : "a variable, from 'let'"));
}

static bool is_changed(const struct query *query, const struct parameter *p)
{
    return parameter_get(query->state, p) != parameter_fallback(query->state, p) ||
           (query->scene->length[p->share].m > 0 && parameter_is_number(p));
}

const char *show_names(const void *context, int k)
{
    int count = 0;
    while (parameter_names(context, count))
        count++;
    return k == count ? "all" : k < count ? parameter_names(context, k) : NULL;
}

bool show_variables(const struct query *query, struct answer *a)
{
    const struct variables *variables = &query->state->variables;
    a->rows = true;
    answer_columns(a, show_columns);
    for (size_t i = 0; i < variables->count; i++)
        variable_row(a, &variables->list[i]);
    if (variables->count == 0)
        answer_say(a, "No variable is defined; 'let x = 0.9*rmax' defines one.");
    return true;
}

/* Without a name, the answer for people has what differs from the defaults. In csv and json, it is for
 * programs and always has the same rows. */
bool run_show(const struct query *query, struct answer *a, struct problem *problem)
{
    (void)problem;
    const struct arguments *given = query->given;
    const struct variables *variables = &query->state->variables;
    const bool people = answer_for_people(a), is_named = given->parameter || given->variable,
               is_short = people && !given->count;
    const size_t changes = is_short ? row_changes_count(&query->scene->listed) : 0;
    struct column *columns = answer_columns(a, show_columns);
    struct shown shown;
    bool is_empty = !is_named && variables->count == 0;
    /* If the answer is for people, the first of two passes only finds the widths of the columns. */
    for (int pass = people ? 0 : 1; pass < 2; pass++)
        for (const struct parameter *p = session_parameters; p->name; p++) {
            if (is_named        ? p != given->parameter
                : is_short      ? !is_changed(query, p)
                : !given->count ? p->effect != NULL
                                : false)
                continue;
            is_empty = false;
            shown_make(query, p, people, &shown);
            for (int i = 0; pass == 0 && columns[i + 1].key; i++)
                column_fit(&columns[i], shown.cell[i].word);
            if (pass == 1)
                answer_row(a, shown.cell, NULL);
        }
    if (given->variable)
        variable_row(a, given->variable);
    for (size_t i = 0; !is_named && i < variables->count; i++)
        variable_row(a, &variables->list[i]);
    if (is_empty)
        answer_say(a, "All parameters have their defaults, and no effect is on. 'show all' lists them.");
    if (changes > 0)
        answer_say(a, "%zu value%s of the row %s been changed; 'row' lists the row.", changes,
                   changes == 1 ? "" : "s", changes == 1 ? "has" : "have");
    return true;
}
