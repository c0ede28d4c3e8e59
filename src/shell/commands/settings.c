/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands that set and reset the parameters of the session, undo changes, or end the session. */
#include "answer/answer.h"
#include "interpreter/question.h"
#include "language/quad.h"
#include "language/text.h"
#include "session/session.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- show ---- */

static const struct column show_columns[] = {
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
    char range[PARAMETER_RANGE], value[PARAMETER_SETTING], fallback[PARAMETER_TEXT];
    struct cell cell[SHOW_COLUMNS];
};

static void shown_make(const struct query *query, const struct parameter *p, bool people, struct shown *shown)
{
    const struct state *state = query->state;
    const domq_real value = parameter_get(state, p), fallback = parameter_fallback(state, p);
    const bool as_number = parameter_is_number(p) && !people,
               is_on = p->effect && value != EFFECT_OFF && !effect_slot(state, p),
               is_length = people && state->scene.length[p->share].m > 0 && value != EFFECT_OFF;
    const char *unit = is_length || (people && p->effect) ? "" : p->value->unit;
    char text[PARAMETER_TEXT];
    parameter_range_write(state, p, 0, shown->range);
    if (is_length)
        text_add(shown->range, sizeof shown->range, " %s", p->value->unit);
    parameter_setting_write(state, p, p->effect ? 10 : (int)state->settings.style.digits, shown->value);
    snprintf(shown->fallback, sizeof shown->fallback, "%s", parameter_text(p, 0, fallback, 6, text));
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

static const char *show_names(const void *context, int k)
{
    int count = 0;
    while (parameter_names(context, count))
        count++;
    return k == count ? "all" : k < count ? parameter_names(context, k) : NULL;
}

/* Without a name, the answer for people has what differs from the defaults. In csv and json, it is for
 * programs and always has the same rows. */
static bool run_show(const struct query *query, struct answer *a, struct problem *problem)
{
    (void)problem;
    const struct arguments *given = query->given;
    const struct variables *variables = &query->state->variables;
    const bool people = answer_for_people(a),
               is_named = given->question->parameter || given->question->variable,
               is_short = people && !given->count;
    struct column *columns = answer_columns(a, show_columns);
    struct shown shown;
    bool is_empty = !is_named && variables->count == 0;
    /* If the answer is for people, the first of two passes only finds the widths of the columns. */
    for (int pass = people ? 0 : 1; pass < 2; pass++)
        for (const struct parameter *p = session_parameters; p->name; p++) {
            const bool is_changed = parameter_get(query->state, p) != parameter_fallback(query->state, p) ||
                                    (query->scene->length[p->share].m > 0 && parameter_is_number(p));
            if (is_named        ? p != given->question->parameter
                : is_short      ? !is_changed
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
    if (given->question->variable)
        variable_row(a, given->question->variable);
    for (size_t i = 0; !is_named && i < variables->count; i++)
        variable_row(a, &variables->list[i]);
    if (is_empty)
        answer_say(a, "All parameters have their defaults, and no effect is on. 'show all' lists them.");
    return true;
}

/* ---- set ---- */

/* Returns the length that was typed for a share of the height, with its unit. */
static struct typed_length length_typed(const struct arguments *given)
{
    struct typed_length length = share_length(given->question->parameter, &given->quantity[1]);
    char *end;
    if (length.m > 0) {
        quad_read(given->question->item[1].at, &end);
        const char *unit = skip_blanks(end), *stop = unit_scan(unit, &(struct quantity){.value = 1});
        if (stop && (isspace((unsigned char)*stop) || !*stop || *stop == ';'))
            name_copy(unit, (size_t)(stop - unit), length.unit, sizeof length.unit);
    }
    if (length.m > 0 && !*length.unit && given->question->parameter->share == SHARE_push)
        name_copy("m/s", strlen("m/s"), length.unit, sizeof length.unit);
    return length;
}

static bool run_set(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct arguments *given = query->given;
    struct state *next = query->next;
    const struct parameter *p = given->question->parameter,
                           *moved = p->moves ? parameter_find(p->moves) : NULL;
    const domq_real was = moved ? parameter_get(next, moved) : 0;
    const struct typed_length length = length_typed(given);
    if (!(given->word[1] ? p->load(&next->scene, given->word[1], query->run_context, problem)
                         : parameter_set(next, p, &given->number[1], given->count - 1, &length, problem)))
        return false;
    /* In a script, the next line may set the parameter `moved` too, so no message is printed. */
    if (moved && parameter_get(next, moved) != was && !query->run_context->sourced)
        answer_say(a, "%s is now %g", moved->name, (double)parameter_get(next, moved));
    /* The user may not know the value that 'on' has given, or what the change leaves as it was. */
    char said[PROBLEM_TEXT] = "";
    if (p->effect && given->count > 1 && given->number[1] == EFFECT_ON)
        snprintf(said, sizeof said, "%s is on: %s. 'set %s' sets another value.", p->name,
                 parameter_setting(next, p, 10), parameter_usage(p));
    else if (next->scene.slot && !query->run_context->sourced)
        next->scene.slot->kind->kept(&next->scene, p, said);
    a->progress.wrote_text = *said && answer_for_people(a);
    if (a->progress.wrote_text)
        answer_say(a, "%s", said);
    else if (*said)
        run_context_note(query->run_context, "%s", said);
    return true;
}

static const struct column step_columns[] = {
    {"change", "", "the command whose change was undone or redone", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_undo_or_redo(struct session *session, const struct arguments *given, struct answer *a,
                             struct problem *problem)
{
    const bool back = strcmp(session->command, "undo") == 0;
    const char *text = undo_step(session->undo, &session->state, back);
    (void)given;
    if (!text)
        return problem_error(problem, back ? "there is no change to undo"
                                           : "there is nothing to redo; 'redo' works after 'undo'");
    if (!answer_for_people(a))
        return answer_cells(a, cell_word(text));
    answer_say(a, "%s: %s", back ? "undone" : "done again", text);
    return true;
}

static bool run_reset(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct question *q = query->given->question;
    struct state *next = query->next;
    (void)a;
    if (q->variable)
        variable_drop(&next->variables, query->given->word[0]);
    else if (!q->parameter)
        scene_reset(&next->scene);
    else
        return parameter_set(next, q->parameter, &(domq_real){parameter_fallback(next, q->parameter)}, 1,
                             NULL, problem);
    return true;
}

static bool run_quit(struct session *session, const struct arguments *given, struct answer *a,
                     struct problem *problem)
{
    (void)given, (void)a, (void)problem;
    session->quit = true;
    return true;
}

#define A_PARAMETER                                                                                          \
    .name = "NAME", .kind = ARGUMENT_PARAMETER, .noun = "parameter", .choices = parameter_names

#define A_VALUE .kind = ARGUMENT_VALUE
/* The arguments of 'set' and 'effect'. */
#define A_SETTING                                                                                            \
    {                                                                                                        \
        {A_PARAMETER}, {.name = "VALUE", A_VALUE}, {.name = "Y", A_VALUE, .optional = true},                 \
        {                                                                                                    \
            .name = "Z", A_VALUE, .optional = true                                                           \
        }                                                                                                    \
    }

const struct command session_commands[] = {
    {.name = "set",
     .synonyms = "change assign parameter",
     .argument = A_SETTING,
     .summary = "give a parameter or an effect a value",
     .help = "VALUE is one of the words of the parameter, such as hollow or json, or an expression: 7/48, "
             "4.8 cm, 0.9*s, rmax. 'set s = 0.3', 'set s to 0.3' and 's = 0.3' mean the same. Only the range "
             "of VALUE is checked here; commands check combinations, such as r s <= 1. NAME may also be an "
             "effect: 'set friction 0.2', 'set friction off'.",
     .example = "set d 7 mm / 48 mm; set r 0.99*rmax; show r",
     .see = "show reset",
     .access.changes = true,
     .run = run_set},
    {.name = "effect",
     .typed.is_hidden = true,
     .synonyms = "switch turn",
     .argument = A_SETTING,
     .summary = "the same as set",
     .see = "effects",
     .access.changes = true,
     .run = run_set},
    {.name = "show",
     .synonyms = "list settings values parameter diff changes changed compare default",
     .argument = {{.name = "NAME",
                   .kind = ARGUMENT_PARAMETER,
                   .noun = "parameter",
                   .choices = show_names,
                   .optional = true}},
     .summary = "what differs from the defaults, or the parameter NAME",
     .help = "The list has the row and the effects that are on, and what 'let' has defined. 'show all' lists "
             "all parameters and effects, 'show NAME' one. In csv and json, 'show' lists all parameters.",
     .example = "set s 0.3; set friction 0.2; show",
     .see = "set reset undo",
     .rows = true,
     ANSWER(show)},
    {.name = "reset",
     .synonyms = "undo default clear restore variable delete unset forget del kill",
     .argument = {{A_PARAMETER, .optional = true}},
     .summary = "set the parameter NAME, or the whole model, to the default",
     .help = "Without NAME, 'reset' also turns off all effects. It does not change the settings of the "
             "session, such as output and digits, or the variables. 'reset x' removes the variable x.",
     .example = "set s 0.3; reset s; print s",
     .see = "set show",
     .access.changes = true,
     .run = run_reset},
    {.name = "undo",
     .synonyms = "back revert restore previous",
     .summary = "undo the last change",
     .help = "A change is a command that changed a parameter, an effect, the row or a variable. A file that "
             "was sourced counts as one change. The last 100 changes can be undone, one after the other.",
     .example = "set s 0.3; undo; print s",
     .see = "redo show reset",
     .sweep.refusal = "it computes nothing",
     .columns = step_columns,
     .act = run_undo_or_redo},
    {.name = "redo",
     .synonyms = "again forward repeat",
     .summary = "redo the change that 'undo' has taken back",
     .example = "set s 0.3; undo; redo; print s",
     .see = "undo",
     .sweep.refusal = "it computes nothing",
     .columns = step_columns,
     .act = run_undo_or_redo},
    {.name = "exit",
     .synonyms = "leave end close bye stop",
     .summary = "the same as quit",
     .see = "quit",
     .act = run_quit},
    {.name = "quit",
     .synonyms = "exit end close bye stop",
     .summary = "leave the program; the end of the input (^D) has the same effect",
     .act = run_quit},
    {.name = NULL},
};
