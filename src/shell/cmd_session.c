/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands about the session itself. */
#include "command.h"
#include "value.h"
#include <string.h>

#define ROW(...) ((const struct cell[]){__VA_ARGS__})

/* The first argument as a parameter. */
static const struct parameter *parameter_named(struct session *session, const struct call *call)
{
    char shown[VALUE_SHOWN];
    const struct parameter *p = parameter_find(call->word[1]);
    if (!p)
        session_error(session, "unknown parameter '%s'; 'show' lists the parameters",
                      value_shown(call->word[1], shown));
    return p;
}

static bool run_set(struct session *session, const struct call *call)
{
    double value;
    const struct parameter *p = parameter_named(session, call);
    if (!p || !parameter_parse(session, p, call->word[2], &value))
        return false;
    parameter_put(session, p, value);
    return true;
}

static const struct column show_columns[] = {
    {"name", "", "what 'set' calls it", 6},
    {"value", "", "its value now", 14},
    {"unit", "", "h: heights of the domino", 5},
    {"range", "", "the values that it may have", 18},
    {"default", "", "its value at the start", 9},
    {"meaning", "", "what it stands for", 16},
    {NULL, NULL, NULL, 0},
};

static struct cell parameter_cell(const struct parameter *p, double value)
{
    return p->words_only ? cell_word(parameter_word(p, value)) : cell_real(value);
}

static void show_row(const struct session *session, const struct call *call, const struct parameter *p)
{
    char range[64];
    parameter_range(p, range, sizeof range);
    struct cell fallback = parameter_cell(p, p->fallback);
    char text[32];
    if (fallback.kind == CELL_REAL && session->output == OUTPUT_TABLE) {
        snprintf(text, sizeof text, "%.6g", p->fallback);
        fallback = cell_word(text);
    }
    answer_row(call->answer,
               ROW(cell_word(p->name), parameter_cell(p, parameter_get(session, p)), cell_word(p->unit),
                   cell_word(range), fallback, cell_word(p->meaning)),
               NULL);
}

static bool run_show(struct session *session, const struct call *call)
{
    if (call->count == 1) {
        const struct parameter *p = parameter_named(session, call);
        if (!p)
            return false;
        show_row(session, call, p);
        return true;
    }
    for (const struct parameter *p = session_parameters; p->name; p++)
        show_row(session, call, p);
    return true;
}

static bool run_reset(struct session *session, const struct call *call)
{
    if (call->count == 1) {
        const struct parameter *p = parameter_named(session, call);
        if (p)
            parameter_put(session, p, p->fallback);
        return p != NULL;
    }
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (!p->setting)
            parameter_put(session, p, p->fallback);
    return true;
}

static void help_list(FILE *out)
{
    for (const struct command_group *g = command_groups; g->title; g++) {
        fprintf(out, "%s%s\n", g == command_groups ? "" : "\n", g->title);
        for (const struct command *c = g->commands; c->name; c++)
            fprintf(out, "  %s %*s %s\n", c->name, (int)strlen(c->name) - 20, c->usage, c->summary);
    }
    fputs("\nParameters: ", out);
    for (const struct parameter *p = session_parameters; p->name; p++)
        fprintf(out, "%s%s", p == session_parameters ? "" : " ", p->name);
    fputs("\n'show' explains the parameters, 'help COMMAND' a command. Angles are in radians.\n", out);
}

static bool run_help(struct session *session, const struct call *call)
{
    char shown[VALUE_SHOWN];
    if (call->count == 0) {
        help_list(session->out);
        return true;
    }
    const struct command *c = command_find(call->word[1]);
    if (!c)
        return session_error(session, "unknown command '%s'; 'help' lists the commands",
                             value_shown(call->word[1], shown));
    fprintf(session->out, "%s%s%s: %s\n", c->name, *c->usage ? " " : "", c->usage, c->summary);
    if (c->help)
        fprintf(session->out, "\n%s\n", c->help);
    if (c->columns)
        fprintf(session->out, "\nIt answers%s:\n", c->rows ? " in rows of" : "");
    for (const struct column *k = c->columns; k && k->key; k++)
        fprintf(session->out, "  %-12s %-6s %s\n", k->key, k->unit, k->meaning);
    return true;
}

static bool run_quit(struct session *session, const struct call *call)
{
    (void)call;
    session->quit = true;
    return true;
}

const struct command session_commands[] = {
    {"set", "NAME VALUE", "give a parameter a value",
     "VALUE is a number or a quotient of two (7/48), or one of the parameter's words (hollow, json).\n"
     "Each value is judged alone; whether r s <= 1 holds is seen when a command needs it.",
     2, 2, ARGUMENT_PARAMETER, NULL, false, run_set},
    {"show", "[NAME]", "the parameters: value, unit, range, default, meaning", NULL, 0, 1, ARGUMENT_PARAMETER,
     show_columns, true, run_show},
    {"reset", "[NAME]", "the parameter NAME, or all of the model, to the defaults",
     "Without NAME, 'output' is kept: it belongs to the session and not to the model.", 0, 1,
     ARGUMENT_PARAMETER, NULL, false, run_reset},
    {"help", "[COMMAND]", "the commands, or one of them", NULL, 0, 1, ARGUMENT_COMMAND, NULL, false,
     run_help},
    {"quit", "", "leave; so does the end of the input (^D)", NULL, 0, 0, ARGUMENT_ANY, NULL, false, run_quit},
    {.name = NULL},
};
