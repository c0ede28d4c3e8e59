/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, all of it from the tables of commands and parameters. */
#include "command.h"
#include "complete.h"
#include "terminal.h"
#include "wide.h"
#include <string.h>

/* Of the terminal, but not wider than reads well. */
static int help_width(FILE *out)
{
    int width = terminal_width(out);
    return width && width < 100 ? width : 100;
}

static void help_list(FILE *out)
{
    char usage[USAGE_SIZE];
    for (const struct command_group *g = command_groups; g->title; g++) {
        fprintf(out, "%s%s\n", g == command_groups ? "" : "\n", g->title);
        for (const struct command *c = g->commands; c->name; c++)
            fprintf(out, "  %-18s %s\n", command_usage(c, usage), c->summary);
    }
    char names[256] = "Parameters:";
    for (const struct parameter *p = session_parameters; p->name; p++) {
        size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, " %s", p->name);
    }
    putc('\n', out);
    output_wrapped(out, names, 0, 80);
    fputs("\n'help NAME' explains a command or a parameter, 'apropos WORD' finds one.\n", out);
}

static void help_parameter(const struct session *session, const struct parameter *p)
{
    char range[64], value[WIDE_TEXT], fallback[WIDE_TEXT];
    FILE *out = session->out;
    parameter_range(session, p, range, sizeof range);
    parameter_text(p, parameter_get(session, p), session_style(session).all_digits, value, sizeof value);
    parameter_text(p, parameter_fallback(session, p), 6, fallback, sizeof fallback);
    fprintf(out, "%s: %s\n\n  value    %s %s\n  range    %s\n  default  %s\n", p->name, p->meaning, value,
            p->unit, range, fallback);
    for (const struct word *w = p->words; !p->words_only && w && w->name; w++)
        fprintf(out, "  %-8s %g\n", w->name, (double)w->value);
    if (p->help) {
        putc('\n', out);
        output_wrapped(out, p->help, 0, help_width(out));
        putc('\n', out);
    }
    fprintf(out, "\n'set %s VALUE' changes it, 'reset %s' takes it back.\n", p->name, p->name);
}

/* The example runs in a session of its own, with the defaults: its output is true. */
static void help_example(const struct session *session, const struct command *c)
{
    struct session fresh;
    session_init(&fresh, session->out);
    fresh.train.interrupt = session->train.interrupt;
    fresh.source = "help";
    fresh.safe = true;
    fprintf(session->out, "\nExample: %s\n\n", c->example);
    command_run_text(&fresh, c->example);
    session_close(&fresh);
}

/* Runs another command for its answer to people. */
static void run_topic(struct session *session, const char *name)
{
    const struct command *c = command_find(name);
    struct answer answer = {
        .out = session->out, .style = session->style, .columns = c->columns, .rows = c->rows};
    answer.style.output = OUTPUT_TABLE;
    c->run(session, &(struct call){.answer = &answer});
}

static void help_command(struct session *session, const struct command *c)
{
    char usage[USAGE_SIZE];
    FILE *out = session->out;
    fprintf(out, "%s: %s\n", command_usage(c, usage), c->summary);
    if (c->equation)
        fprintf(out, "Equation: %s\n", c->equation);
    if (c->help) {
        putc('\n', out);
        output_wrapped(out, c->help, 0, help_width(out));
        putc('\n', out);
    }
    if (c->columns)
        fprintf(out, "\nIt answers%s:\n", c->rows ? " in rows of" : "");
    for (const struct column *k = c->columns; k && k->key; k++) {
        output_wrapped(out, k->meaning, fprintf(out, "  %-12s %-6s ", k->key, k->unit), help_width(out));
        putc('\n', out);
    }
    if (c->columns && c->principal >= 0)
        fprintf(out, "In an expression '%s' stands for its %s.\n", c->name, c->columns[c->principal].key);
    if (strcmp(c->name, "set") == 0) {
        fputs("\nThe parameters now:\n", out);
        run_topic(session, "show");
    }
    if (c->example)
        help_example(session, c);
    if (c->see)
        fprintf(out, "\nSee also: %s\n", c->see);
}

static bool run_help(struct session *session, const struct call *call)
{
    if (call->count == 0) {
        help_list(session->out);
        return true;
    }
    const char *topic = topic_names(NULL, (int)call->number[0]);
    const struct command *c = command_find(topic);
    const struct parameter *p = parameter_find(topic);
    if (c)
        help_command(session, c);
    if (c && p)
        fputs("\nThe parameter of this name:\n\n", session->out);
    if (p)
        help_parameter(session, p);
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
    int found = 0;
    for (const struct command_group *g = command_groups; g->title; g++) {
        for (const struct command *c = g->commands; c->name; c++) {
            bool hit = mentions(c->name, word) || mentions(c->summary, word) || mentions(c->help, word) ||
                       mentions(c->equation, word);
            for (const struct column *k = c->columns; k && k->key && !hit; k++)
                hit = mentions(k->key, word) || mentions(k->meaning, word);
            found += hit;
            if (hit)
                fprintf(session->out, "%-18s %s\n", command_usage(c, usage), c->summary);
        }
    }
    for (const struct parameter *p = session_parameters; p->name; p++) {
        bool hit = mentions(p->name, word) || mentions(p->meaning, word);
        for (const struct word *w = p->words; w && w->name && !hit; w++)
            hit = mentions(w->name, word);
        found += hit;
        if (hit)
            fprintf(session->out, "set %-14s %s\n", p->name, p->meaning);
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
     .argument = {{.name = "NAME", .kind = ARGUMENT_TOPIC, .optional = true}},
     .summary = "the commands, or one command or parameter",
     .example = "help tol",
     .see = "apropos show",
     .principal = -1,
     .run = run_help},
    {.name = "apropos",
     .argument = {{.name = "WORD", .kind = ARGUMENT_WORD}},
     .summary = "commands and parameters that mention WORD",
     .example = "apropos barrier",
     .see = "help",
     .principal = -1,
     .run = run_apropos},
    {.name = "complete",
     .argument = {{.name = "LINE", .kind = ARGUMENT_REST, .optional = true}},
     .summary = "how LINE may go on, a line each, as <TAB> does",
     .example = "complete set output j",
     .principal = -1,
     .run = run_complete},
    {.name = NULL},
};
