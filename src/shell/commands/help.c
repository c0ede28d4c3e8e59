/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, all of it from the tables of commands and parameters. */
#include "answer/format.h"
#include "commands/tables.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "prompt/input.h"
#include "session/parameters.h"
#include <string.h>

enum { KEY_WIDTH = 12, UNIT_WIDTH = 6 }; /* at least, so that most pages are alike */

/* Of the terminal, but not wider than reads well. */
static int help_width(FILE *out)
{
    int width = terminal_width(out);
    return width && width < 100 ? width : 100;
}

/* Returns the column in which summaries begin: behind the longest usage of a command. */
static int summary_column(void)
{
    char usage[USAGE_SIZE];
    int widest = 0;
    for (const struct command_group *g = command_groups(); g->title; g++)
        for (const struct command *c = g->commands; c->name; c++) {
            int quad = (int)strlen(command_usage(c, usage));
            widest = quad > widest ? quad : widest;
        }
    return widest + 1;
}

static void help_list(FILE *out)
{
    char usage[USAGE_SIZE];
    int column = summary_column();
    for (const struct command_group *g = command_groups(); g->title; g++) {
        fprintf(out, "%s%s\n", g == command_groups() ? "" : "\n", g->title);
        for (const struct command *c = g->commands; c->name; c++)
            fprintf(out, "  %-*s %s\n", column, command_usage(c, usage), c->summary);
    }
    char names[256] = "Parameters:";
    for (const struct parameter *p = session_parameters; !p->effect; p++) {
        size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, " %s", p->name);
    }
    putc('\n', out);
    output_wrapped(out, names, 0, 80);
    fputs("\nEffects:", out);
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (p->effect)
            fprintf(out, " %s", p->name);
    fputs("\n'help NAME' explains one of these, 'apropos WORD' finds one.\n", out);
}

static void help_text(FILE *out, const char *text)
{
    putc('\n', out);
    output_wrapped(out, text, 0, help_width(out));
    putc('\n', out);
}

/* Writes what the i-th value of an effect is, and in which range. */
static void help_value(FILE *out, const struct domq_effect_argument *a, const char *range)
{
    fprintf(out, "  %-8s %s, %s%s%s%s%s%s\n", a->name, a->meaning, range, *a->unit ? " " : "", a->unit,
            a->or_file ? "; or " : "", a->or_file ? a->or_file : "", a->optional ? "; may be left out" : "");
}

static void help_effect_state(const struct session *session, const struct parameter *p)
{
    char setting[EFFECT_SETTING], shown[NAMES_SHOWN];
    fprintf(session->out, "\nSource: %s\n", p->effect->source);
    if (session->effect[p->which].on)
        fprintf(session->out, "It is on: %s\n",
                names_shown(effect_setting(session, p->which, setting), shown));
    else
        fputs("It is off, and nothing of it is computed.\n", session->out);
}

static void help_parameter(struct session *session, const struct parameter *p)
{
    char range[64], text[WIDE_TEXT], usage[USAGE_SIZE];
    FILE *out = session->out;
    if (p->effect)
        effect_usage(p->which, usage);
    else
        snprintf(usage, sizeof usage, "%s VALUE", p->name);
    fprintf(out, "%s%s: %s\n\n", p->effect ? "effect " : "", p->effect ? usage : p->name,
            parameter_meaning(p));
    parameter_text(p, parameter_get(session, p), session_style(session).all_digits, text, sizeof text);
    if (!p->effect)
        fprintf(out, "  value    %s%s%s\n", text, *p->value->unit ? " " : "", p->value->unit);
    for (int i = 0; parameter_value(p, i); i++) {
        parameter_range(session, p, i, range, sizeof range);
        if (p->effect)
            help_value(out, parameter_value(p, i), range);
        else
            fprintf(out, "  range    %s\n", range);
    }
    parameter_text(p, parameter_fallback(session, p), 6, text, sizeof text);
    fprintf(out, "  default  %s\n", text);
    for (const struct word *w = p->words; parameter_is_number(p) && w && w->name; w++)
        fprintf(out, "  %-8s %g\n", w->name, (double)w->value);
    if (parameter_help(p))
        help_text(out, parameter_help(p));
    if (p->effect)
        help_effect_state(session, p);
    fprintf(out, "\n'set %s' changes it, 'reset %s' takes it back.\n", usage, p->name);
}

/* Runs the example in a session of its own, with the defaults: the output is true, or ends at an error. */
static void help_example(struct session *session, const char *example)
{
    struct session fresh;
    session_init(&fresh, session->out);
    fresh.compute.interrupt = session->compute.interrupt;
    fresh.source = "help";
    fresh.safe = fresh.bail = true;
    fprintf(session->out, "\nExample: %s\n\n", example);
    command_run_text(&fresh, example);
    session->errors += fresh.errors;
    session_close(&fresh);
}

/* Runs another command for its answer to people. */
static void run_topic(struct session *session, const char *name)
{
    const struct command *c = command_find(name);
    struct answer answer = {
        .out = session->out, .style = session->style, .columns = c->columns, .rows = c->rows};
    answer.style.format = &format_table;
    c->run(session, &(struct call){.answer = &answer});
}

/* Prints keys, units and meanings below each other, however long they are. */
static void help_columns(FILE *out, const struct column *columns)
{
    int key = KEY_WIDTH, unit = UNIT_WIDTH;
    for (const struct column *c = columns; c && c->key; c++) {
        int key_wide = (int)strlen(c->key), unit_wide = (int)strlen(c->unit);
        key = key_wide > key ? key_wide : key;
        unit = unit_wide > unit ? unit_wide : unit;
    }
    for (const struct column *c = columns; c && c->key; c++) {
        int left = fprintf(out, "  %-*s %-*s ", key, c->key, unit, c->unit);
        output_wrapped(out, c->meaning, left, help_width(out));
        putc('\n', out);
    }
}

static void help_command(struct session *session, const struct command *c)
{
    char usage[USAGE_SIZE];
    FILE *out = session->out;
    fprintf(out, "%s: %s\n", command_usage(c, usage), c->summary);
    if (c->equation)
        fprintf(out, "Equation: %s\n", c->equation);
    if (c->help)
        help_text(out, c->help);
    if (c->columns && c->columns->key)
        fprintf(out, "\nIt answers%s:\n", c->rows ? " in rows of" : "");
    help_columns(out, c->columns);
    int fewest;
    if (command_values(c, &fewest) >= 0)
        fprintf(out, "In an expression '%s' stands for its %s.\n", c->name, c->principal);
    if (c->argument[0].kind == ARGUMENT_PARAMETER && c->argument[1].kind == ARGUMENT_VALUE) {
        fputs("\nThe parameters now:\n", out);
        run_topic(session, "show");
    }
    if (c->example)
        help_example(session, c->example);
    if (c->see)
        fprintf(out, "\nSee also: %s\n", c->see);
}

static bool run_help(struct session *session, const struct call *call)
{
    if (call->count == 0) {
        help_list(session->out);
        return true;
    }
    char example[EFFECT_EXAMPLE];
    const char *topic = topic_names(NULL, (int)call->number[0]);
    const struct command *c = command_find(topic);
    const struct parameter *p = parameter_find(topic);
    if (c)
        help_command(session, c);
    if (c && p)
        fprintf(session->out, "\nThe %s of this name:\n\n", p->effect ? "effect" : "parameter");
    if (p)
        help_parameter(session, p);
    if (p && p->effect && !c)
        help_example(session, effect_example(p->which, example));
    return true;
}

/* Does the text have the word in it, whatever its case? */
static bool mentions(const char *text, const char *word)
{
    return text && strcasestr(text, word);
}

static bool run_apropos(struct session *session, const struct call *call)
{
    const char *word = call->word[0];
    char usage[USAGE_SIZE];
    int found = 0, column = summary_column();
    for (const struct command_group *g = command_groups(); g->title; g++) {
        for (const struct command *c = g->commands; c->name; c++) {
            bool hit = mentions(c->name, word) || mentions(c->summary, word) || mentions(c->help, word) ||
                       mentions(c->equation, word);
            for (const struct column *k = c->columns; k && k->key && !hit; k++)
                hit = mentions(k->key, word) || mentions(k->meaning, word);
            found += hit;
            if (hit)
                fprintf(session->out, "%-*s %s\n", column, command_usage(c, usage), c->summary);
        }
    }
    for (const struct parameter *p = session_parameters; p->name; p++) {
        bool hit = mentions(p->name, word) || mentions(parameter_meaning(p), word) ||
                   mentions(parameter_help(p), word);
        for (const struct word *w = p->words; !p->effect && w && w->name && !hit; w++)
            hit = mentions(w->name, word);
        const char *verb = p->effect ? "effect" : "set";
        found += hit;
        if (hit)
            fprintf(session->out, "%s %-*s %s\n", verb, column - (int)strlen(verb) - 1, p->name,
                    parameter_meaning(p));
    }
    return found > 0 || session_error(session, "nothing is said about '%s'; 'help' lists everything",
                                      names_shown(word, usage));
}

static void print_candidate(const char *candidate, void *out)
{
    fprintf(out, "%s\n", candidate);
}

static bool run_complete(struct session *session, const struct call *call)
{
    complete_line(call->count ? call->word[0] : "", !session->safe, print_candidate, session->out);
    return true;
}

const struct command help_commands[] = {
    {.name = "help",
     .argument =
         {{.name = "NAME", .kind = ARGUMENT_TOPIC, .of = "topic", .choices = topic_names, .optional = true}},
     .summary = "the commands, or one command or parameter",
     .example = "help tol",
     .see = "apropos show",
     .run = run_help},
    {.name = "apropos",
     .argument = {{.name = "WORD", .kind = ARGUMENT_WORD, .choices = topic_names}},
     .summary = "commands and parameters that mention WORD",
     .example = "apropos barrier",
     .see = "help",
     .run = run_apropos},
    {.name = "complete",
     .argument = {{.name = "LINE", .kind = ARGUMENT_REST, .optional = true}},
     .summary = "how LINE may go on, a line each, as <TAB> does",
     .example = "complete set output j",
     .run = run_complete},
    {.name = NULL},
};
