/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, all of it from the tables of commands and parameters. */
#include "commands/tables.h"
#include "interpreter/command.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "prompt/complete.h"
#include "session/effects.h"
#include <ctype.h>
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
    for (const struct parameter *p = session_parameters; p->name; p++) {
        size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, " %s", p->name);
    }
    putc('\n', out);
    output_wrapped(out, names, 0, 80);
    fputs("\nEffects:", out);
    for (int e = 0; e < DOM_EFFECT_COUNT; e++)
        fprintf(out, " %s", effect_names(NULL, e));
    fputs("\n'help NAME' explains one of these, 'apropos WORD' finds one.\n", out);
}

static void help_parameter(const struct session *session, const struct parameter *p)
{
    char range[64], value[WIDE_TEXT], fallback[WIDE_TEXT];
    FILE *out = session->out;
    parameter_range(session, p, range, sizeof range);
    parameter_text(p, parameter_get(session, p), session_style(session).all_digits, value, sizeof value);
    parameter_text(p, parameter_fallback(session, p), 6, fallback, sizeof fallback);
    fprintf(out, "%s: %s\n\n  value    %s%s%s\n  range    %s\n  default  %s\n", p->name, p->meaning, value,
            *p->unit ? " " : "", p->unit, range, fallback);
    for (const struct word *w = p->words; !p->words_only && w && w->name; w++)
        fprintf(out, "  %-8s %g\n", w->name, (double)w->value);
    if (p->help) {
        putc('\n', out);
        output_wrapped(out, p->help, 0, help_width(out));
        putc('\n', out);
    }
    fprintf(out, "\n'set %s VALUE' changes it, 'reset %s' takes it back.\n", p->name, p->name);
}

/* The example runs in a session of its own, with the defaults: its output is true, or ends at its first
 * error. */
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
    answer.style.output = OUTPUT_TABLE;
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
    if (c->help) {
        putc('\n', out);
        output_wrapped(out, c->help, 0, help_width(out));
        putc('\n', out);
    }
    if (c->columns && c->columns->key)
        fprintf(out, "\nIt answers%s:\n", c->rows ? " in rows of" : "");
    help_columns(out, c->columns);
    int fewest;
    if (command_values(c, &fewest) >= 0)
        fprintf(out, "In an expression '%s' stands for its %s.\n", c->name, c->principal);
    if (strcmp(c->name, "set") == 0) {
        fputs("\nThe parameters now:\n", out);
        run_topic(session, "show");
    }
    if (c->example)
        help_example(session, c->example);
    if (c->see)
        fprintf(out, "\nSee also: %s\n", c->see);
}

/* Examples of effects. */
static const char *const effect_examples[DOM_EFFECT_COUNT] = {
    [DOM_EFFECT_friction] = "set q hollow; effect friction 0.2; rmax 0.4; effect friction off",
    [DOM_EFFECT_row] = "effect row 13; fall; effect row off",
    [DOM_EFFECT_push] = "effect row 5; effect push 3; fall; effect push off; effect row off",
    [DOM_EFFECT_placement] =
        "effect row 13; effect placement 2 mm; placement 500; effect placement off; effect row off",
    [DOM_EFFECT_floor] = "effect row 5; effect floor 0.4; fall; effect floor off; effect row off",
};

static void help_effect(struct session *session, enum dom_effect_name name, bool example)
{
    const struct domq_effect *e = domq_effect(name);
    char usage[EFFECT_USAGE], setting[EFFECT_SETTING], shown[NAMES_SHOWN];
    FILE *out = session->out;
    fprintf(out, "effect %s: %s\n\n", effect_usage(name, usage), e->adds);
    output_wrapped(out, e->help, 0, help_width(out));
    fputs("\n\n", out);
    for (const struct domq_effect_argument *a = e->argument;
         a < e->argument + DOM_EFFECT_ARGUMENTS && a->name; a++) {
        fprintf(out, "  %-8s %s, %g .. %g%s%s", a->name, a->meaning, (double)a->lowest, (double)a->highest,
                *a->unit ? " " : "", a->unit);
        fprintf(out, "%s%s%s\n", a->or_file ? "; or " : "", a->or_file ? a->or_file : "",
                a->optional ? "; may be left out" : "");
    }
    fprintf(out, "\nSource: %s\n", e->source);
    if (session->effect[name].on)
        fprintf(out, "It is on: %s\n", names_shown(effect_setting(session, name, setting), shown));
    else
        fputs("It is off, and nothing of it is computed.\n", out);
    if (example)
        help_example(session, effect_examples[name]);
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
    int effect = names_exact(effect_names, NULL, topic);
    if (effect >= 0 && c)
        fputs("\nThe effect of this name:\n\n", session->out);
    if (effect >= 0)
        help_effect(session, (enum dom_effect_name)effect, !c);
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
        bool hit = mentions(p->name, word) || mentions(p->meaning, word);
        for (const struct word *w = p->words; w && w->name && !hit; w++)
            hit = mentions(w->name, word);
        found += hit;
        if (hit)
            fprintf(session->out, "set %-*s %s\n", column - (int)strlen("set "), p->name, p->meaning);
    }
    for (int k = 0; k < DOM_EFFECT_COUNT; k++) {
        const struct domq_effect *e = domq_effect((enum dom_effect_name)k);
        bool hit = mentions(e->name, word) || mentions(e->adds, word) || mentions(e->help, word);
        found += hit;
        if (hit)
            fprintf(session->out, "effect %-*s %s\n", column - (int)strlen("effect "), e->name, e->adds);
    }
    return found > 0 || session_error(session, "nothing is said about '%s'; 'help' lists everything",
                                      names_shown(word, usage));
}

/* ---- The manual of effects, as mdoc(7) ---- */

/* A sentence begins a line, and no line begins with what is a request there. */
static void mdoc_text(FILE *out, const char *text)
{
    int at = 0;
    while (*text) {
        size_t length = strcspn(text, " ");
        if (at > 0 && at + (int)length > 76)
            at = (putc('\n', out), 0);
        at += fprintf(out, at > 0 ? " " : "");
        for (size_t i = 0; i < length; i++)
            at += text[i] == '\'' ? fprintf(out, "\\(aq") : fprintf(out, "%c", text[i]);
        bool ends = length > 1 && text[length] != '\0' && text[length - 1] == '.' &&
                    isupper((unsigned char)text[length + 1]) && !isupper((unsigned char)text[length - 2]);
        if (ends)
            at = (putc('\n', out), 0);
        text += length + (text[length] == ' ');
    }
    if (at > 0)
        putc('\n', out);
}

static void mdoc_effect(FILE *out, const struct domq_effect *e, const char *example)
{
    fprintf(out, ".Ss %s\n.Bd -ragged -compact\n.Nm effect %s\n", e->name, e->name);
    for (const struct domq_effect_argument *a = e->argument;
         a < e->argument + DOM_EFFECT_ARGUMENTS && a->name; a++)
        fprintf(out, a->optional ? ".Op Ar %s\n" : ".Ar %s\n", a->or_file ? "N | FILE" : a->name);
    fputs(".Ed\n.Pp\nAdds\n", out);
    mdoc_text(out, e->adds);
    fputs(".Pp\n", out);
    mdoc_text(out, e->help);
    fputs(".Bl -tag -width HEIGHTS\n", out);
    for (const struct domq_effect_argument *a = e->argument;
         a < e->argument + DOM_EFFECT_ARGUMENTS && a->name; a++) {
        fprintf(out, ".It Ar %s\n%s, %g .. %g%s%s%s%s%s\n", a->name, a->meaning, (double)a->lowest,
                (double)a->highest, *a->unit ? " " : "", a->unit, a->or_file ? "; or " : "",
                a->or_file ? a->or_file : "", a->optional ? "; may be left out" : "");
    }
    fputs(".El\n.Pp\nComputed:\n", out);
    mdoc_text(out, e->plan);
    fputs(".Pp\nSource:\n", out);
    mdoc_text(out, e->source);
    fputs(".Pp\nExample:\n.Dl ", out);
    fprintf(out, "%s\n", example);
}

static bool run_manual(struct session *session, const struct call *call)
{
    FILE *out = session->out;
    (void)call;
    fputs(".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n.\\\" Made by the command manual of domino.\n"
          ".Dd November 21, 2026\n.Dt DOMINO-EFFECTS 7\n.Os\n.Sh NAME\n.Nm domino-effects\n"
          ".Nd effects beyond the paper in scenes of domino\n.Sh DESCRIPTION\n"
          "A scene is the parameters of\n.Xr domino 1\nand the effects that it asks for.\n"
          "An effect that is off is not computed.\n",
          out);
    for (int k = 0; k < DOM_EFFECT_COUNT; k++)
        mdoc_effect(out, domq_effect((enum dom_effect_name)k), effect_examples[k]);
    fputs(".Sh SEE ALSO\n.Xr domino 1\n", out);
    return true;
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
     .run = run_help},
    {.name = "apropos",
     .argument = {{.name = "WORD", .kind = ARGUMENT_WORD}},
     .summary = "commands and parameters that mention WORD",
     .example = "apropos barrier",
     .see = "help",
     .run = run_apropos},
    {.name = "manual",
     .summary = "the manual page of the effects, for man(1)",
     .help = "domino-effects(7), made from what each effect tells of itself; 'make install' installs it.",
     .see = "help effects",
     .run = run_manual},
    {.name = "complete",
     .argument = {{.name = "LINE", .kind = ARGUMENT_REST, .optional = true}},
     .summary = "how LINE may go on, a line each, as <TAB> does",
     .example = "complete set output j",
     .run = run_complete},
    {.name = NULL},
};
