/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, all of it from the tables of commands and parameters. */
#include "answer/format.h"
#include "answer/wrap.h"
#include "commands/help_page.h"
#include "commands/help_rows.h"
#include "commands/tables.h"
#include "language/quad.h"
#include "prompt/input.h"
#include "session/parameters.h"
#include "session/session.h"
#include <string.h>

enum { KEY_WIDTH = 12, UNIT_WIDTH = 6 }; /* at least, so that most pages are alike */

/* What 'help' begins with: lines to type, in this order, and what they do. */
static const struct first_line {
    const char *line, *does;
} first_lines[] = {
    {"count 112 m", "the quiz: how many dominoes topple a tower of 112 m"},
    {"rmax", "how much larger each domino can be than the one before it"},
    {"set s 0.3", "dominoes closer to each other: gaps of 0.3 of the height"},
    {"rmax", "the answer for these gaps; 'show' lists the parameters"},
    {"draw", "a picture of the train; 'draw > train.svg' writes a file"},
    {"effect row 12", "a row of 12 dominoes; 'effect row FILE' reads your own"},
    {"set r 1.2", "each domino is 1.2 times as large as the one before it"},
    {"fall", "how each domino falls, and whether all do"},
    {"help rmax", "explains a command; 'apropos tower' finds commands"},
    {"quit", "ends the session; ^C stops a computation"},
};

/* Returns the column in which summaries begin: after the longest usage of a command. */
static int summary_column(void)
{
    char usage[USAGE_SIZE];
    int widest = 0;
    for (const struct command_group *g = command_groups(); g->title; g++)
        for (const struct command *c = g->commands; c->name; c++) {
            int wide = (int)strlen(command_usage(c, usage));
            widest = wide > widest ? wide : widest;
        }
    return widest + 2;
}

static void help_list(FILE *out)
{
    char usage[USAGE_SIZE], typed[USAGE_SIZE + 2], names[256] = "Parameters:";
    int column = summary_column();
    help_say(out, "The first five minutes: type what follows the '>'");
    for (size_t i = 0; i < sizeof first_lines / sizeof *first_lines; i++) {
        snprintf(typed, sizeof typed, "> %s", first_lines[i].line);
        help_entry(out, typed, column + 2, first_lines[i].does);
    }
    for (const struct command_group *g = command_groups(); g->title; g++) {
        fprintf(out, "\n%s\n", g->title);
        for (const struct command *c = g->commands; c->name; c++) {
            snprintf(typed, sizeof typed, "  %s", command_usage(c, usage));
            help_entry(out, typed, column + 2, c->summary);
        }
    }
    putc('\n', out);
    for (const struct parameter *p = session_parameters; p->name; p++) {
        if (p->effect && p[-1].effect == NULL) {
            help_say(out, "%s", names);
            snprintf(names, sizeof names, "Effects:");
        }
        size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, " %s", p->name);
    }
    help_say(out, "%s", names);
    help_say(out, "'help NAME' explains one of these, 'apropos WORD' finds one.");
}

/* Prints what a value of an effect is, and its range. */
static void help_value(FILE *out, const struct domq_effect_argument *a, const char *range)
{
    char text[512];
    snprintf(text, sizeof text, "%s, %s%s%s%s%s%s", a->meaning, range, *a->unit ? " " : "", a->unit,
             a->or_file ? "; or " : "", a->or_file ? a->or_file : "", a->optional ? "; may be left out" : "");
    int left = fprintf(out, "  %-8s ", a->name);
    write_wrapped(out, text, left, help_width(out));
    putc('\n', out);
}

static void help_effect_state(const struct session *session, const struct parameter *p)
{
    char setting[EFFECT_SETTING], shown[NAMES_SHOWN];
    putc('\n', session->out);
    help_say(session->out, "Source: %s", p->effect->source);
    if (session->state.scene.effect[p->which].on)
        help_say(session->out, "The effect is on: %s",
                 names_shown(effect_setting(&session->state.scene, p->which, setting), shown));
    else
        help_say(session->out, "The effect is off, and takes no time.");
}

static void help_parameter(struct session *session, const struct parameter *p)
{
    char range[64], text[WIDE_TEXT], usage[USAGE_SIZE];
    FILE *out = session->out;
    if (p->effect)
        effect_usage(p->which, usage);
    else
        snprintf(usage, sizeof usage, "%s VALUE", p->name);
    help_say(out, "%s%s: %s", p->effect ? "effect " : "", p->effect ? usage : p->name, parameter_meaning(p));
    if (parameter_help(p))
        help_text(out, parameter_help(p));
    putc('\n', out);
    parameter_text(p, parameter_get(&session->state, p), state_style(&session->state).all_digits, text,
                   sizeof text);
    if (!p->effect)
        fprintf(out, "  value    %s%s%s\n", text, *p->value->unit ? " " : "", p->value->unit);
    for (int i = 0; parameter_value(p, i); i++) {
        parameter_range(&session->state, p, i, range, sizeof range);
        if (p->effect)
            help_value(out, parameter_value(p, i), range);
        else
            fprintf(out, "  range    %s\n", range);
    }
    parameter_text(p, parameter_fallback(&session->state, p), 6, text, sizeof text);
    fprintf(out, "  default  %s\n", text);
    const char *name;
    for (int k = 0; parameter_is_number(p) && (name = parameter_offered(p, k)) != NULL; k++)
        fprintf(out, "  %-8s %g\n", name, (double)p->words[names_exact(parameter_words, p, name)].value);
    if (p->effect)
        help_effect_state(session, p);
    putc('\n', out);
    help_say(out, "'set %s' changes it, 'reset %s' sets the default.", usage, p->name);
}

/* Runs the example in a session of its own, with the defaults, so that its output is what the reader gets. */
static void help_example(struct session *session, const char *example)
{
    struct session fresh;
    session_init(&fresh, session->out);
    fresh.standard.messages = session->output->messages;
    fresh.state.scene.compute.interrupt = session->state.scene.compute.interrupt;
    fresh.source = "help";
    fresh.means.safe = fresh.bail = true;
    putc('\n', session->out);
    help_say(session->out, "Example: %s", example);
    putc('\n', session->out);
    command_run_text(&fresh, example);
    session->errors += fresh.errors;
    session_close(&fresh);
}

/* Runs another command for its answer to people. */
static void run_topic(struct session *session, const char *name)
{
    const struct command *c = command_find(name);
    const struct arguments none = {.count = 0};
    struct problem unheard = {.kind = PROBLEM_NONE};
    struct query query = session_query(session);
    struct answer answer = {
        .out = session->out, .style = session->state.settings.style, .columns = c->columns, .rows = c->rows};
    answer.style.format = &format_table;
    query.given = &none;
    c->run(&query, &answer, &unheard);
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
        write_wrapped(out, c->meaning, left, help_width(out));
        putc('\n', out);
    }
}

/* Returns the first command whose answer has these columns. */
static const struct command *first_with(const struct column *columns)
{
    for (const struct command_group *g = command_groups(); g->title; g++)
        for (const struct command *c = g->commands; c->name; c++)
            if (c->columns == columns)
                return c;
    return NULL;
}

static void help_command(struct session *session, const struct command *c)
{
    char usage[USAGE_SIZE];
    FILE *out = session->out;
    help_say(out, "%s: %s", command_usage(c, usage), c->summary);
    if (c->equation)
        help_say(out, "Equation: %s", c->equation);
    if (c->help)
        help_text(out, c->help);
    const struct command *first = c->columns ? first_with(c->columns) : NULL;
    if (first && first != c)
        fprintf(out, "\nIt answers as '%s' does; 'help %s' explains each number.\n", first->name,
                first->name);
    else if (c->columns && c->columns->key)
        fprintf(out, "\nIt answers%s:\n", c->rows ? " in rows of" : "");
    if (first == c)
        help_columns(out, c->columns);
    int fewest;
    if (command_values(c, &fewest) >= 0)
        help_say(out, "In an expression '%s' stands for its %s.", c->name, c->principal);
    if (c->argument[0].kind == ARGUMENT_PARAMETER && c->argument[1].kind == ARGUMENT_VALUE) {
        fputs("\nThe parameters now:\n", out);
        run_topic(session, "show");
    }
    if (c->example)
        help_example(session, c->example);
    if (c->see) {
        putc('\n', out);
        help_say(out, "See also: %s", c->see);
    }
}

/* Answers with a row for the topic, or for each one. */
static void help_rows(struct answer *a, const char *topic)
{
    for (const struct command_group *g = command_groups(); g->title; g++)
        for (const struct command *c = g->commands; c->name; c++)
            if (!topic || strcmp(c->name, topic) == 0)
                help_row_command(a, c);
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (!topic || strcmp(p->name, topic) == 0)
            help_row_parameter(a, p);
}

/* Explains what 'let' has defined. */
static void help_variable(struct session *session, const struct arguments *given, struct answer *a)
{
    const struct variable *v = given->variable;
    char head[VARIABLE_HEAD], value[VARIABLE_VALUE];
    if (!answer_for_people(a)) {
        help_rows_begin(a);
        help_row_variable(a, v);
        return;
    }
    fprintf(session->out, "%s = %s\n\n", variable_head(v, head),
            v->body ? v->body : variable_value(v, value));
    help_say(session->out, "'let' has defined this %s. '%s = VALUE' changes it, 'reset %s' forgets it.",
             v->body ? "function" : "variable", head, v->name);
}

static void help_topic(struct session *session, const char *topic)
{
    char example[EFFECT_EXAMPLE];
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
}

/* Lists what people know by a word that is no name here. */
static void help_meant(FILE *out, const char *word)
{
    const char *topic;
    char usage[USAGE_SIZE];
    help_say(out, "'%s' is about one of these; 'help NAME' explains it:", word);
    for (int k = 0; (topic = topic_meant(word, k)) != NULL; k++) {
        const struct command *c = command_find(topic);
        const struct parameter *p = parameter_find(topic);
        snprintf(usage, sizeof usage, "%s", topic);
        help_entry(out, usage, summary_column(), c ? c->summary : parameter_meaning(p));
    }
}

static bool run_help(struct session *session, const struct arguments *given, struct answer *a,
                     struct problem *problem)
{
    (void)problem;
    if (given->variable) {
        help_variable(session, given, a);
        return true;
    }
    const char *word = given->word[0], *topic = NULL;
    bool named = given->count && given->number[0] >= 0;
    if (given->count)
        topic = named ? topic_names(NULL, (int)given->number[0]) : topic_meant(word, 0);
    const char *other = given->count && !named ? topic_meant(word, 1) : NULL;
    if (!answer_for_people(a)) {
        help_rows_begin(a);
        help_rows(a, topic);
        for (int k = 1; other; other = topic_meant(word, ++k))
            help_rows(a, other);
    } else if (!topic) {
        help_list(session->out);
    } else if (other) {
        help_meant(session->out, word);
    } else {
        help_topic(session, topic);
    }
    return true;
}

/* Returns true if the word is in the text, in any case. */
static bool mentions(const char *text, const char *word)
{
    return text && strcasestr(text, word);
}

/* How a topic mentions a word: in its name, summary or synonyms; or only in its details. */
enum mention { MENTION_NONE, MENTION_DETAIL, MENTION_TOPIC };

static enum mention command_mentions(const struct command *c, const char *word)
{
    if (mentions(c->name, word) || mentions(c->summary, word) || mentions(c->synonyms, word))
        return MENTION_TOPIC;
    bool detail = mentions(c->help, word) || mentions(c->equation, word);
    for (const struct column *k = c->columns; k && k->key && !detail; k++)
        detail = mentions(k->key, word) || mentions(k->meaning, word);
    return detail ? MENTION_DETAIL : MENTION_NONE;
}

static enum mention parameter_mentions(const struct parameter *p, const char *word)
{
    bool topic = mentions(p->name, word) || mentions(parameter_meaning(p), word) ||
                 mentions(parameter_synonyms(p), word);
    for (const struct word *w = p->words; !p->effect && w && w->name && !topic; w++)
        topic = mentions(w->name, word);
    return topic ? MENTION_TOPIC : mentions(parameter_help(p), word) ? MENTION_DETAIL : MENTION_NONE;
}

/* Lists the commands, parameters and effects that mention the word so; returns how many there are. */
static int apropos_list(struct session *session, struct answer *a, const char *word, enum mention how)
{
    FILE *out = session->out;
    bool people = answer_for_people(a);
    char typed[USAGE_SIZE];
    int found = 0, column = summary_column();
    for (const struct command_group *g = command_groups(); g->title; g++)
        for (const struct command *c = g->commands; c->name; c++)
            if (command_mentions(c, word) == how) {
                if (people)
                    help_entry(out, command_usage(c, typed), column, c->summary);
                else
                    help_row_command(a, c);
                found++;
            }
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (parameter_mentions(p, word) == how) {
            snprintf(typed, sizeof typed, "%s %s", p->effect ? "effect" : "set", p->name);
            if (people)
                help_entry(out, typed, column, parameter_meaning(p));
            else
                help_row_parameter(a, p);
            found++;
        }
    return found;
}

static bool run_apropos(struct session *session, const struct arguments *given, struct answer *a,
                        struct problem *problem)
{
    const char *word = given->word[0];
    char shown[NAMES_SHOWN];
    if (!answer_for_people(a))
        help_rows_begin(a);
    int found = apropos_list(session, a, word, MENTION_TOPIC);
    found += apropos_list(session, a, word, MENTION_DETAIL);
    return found > 0 || problem_error(problem,
                                      "nothing is about '%s'; try another word, such as 'picture' or 'gap', "
                                      "or 'help', which lists all commands",
                                      names_shown(word, shown));
}

static const struct column complete_columns[] = {
    {"line", "", "a way to go on", 0},
    {NULL, NULL, NULL, 0},
};

static void print_candidate(const char *candidate, void *answer)
{
    struct answer *a = answer;
    if (answer_for_people(a))
        fprintf(a->out, "%s\n", candidate);
    else
        answer_cells(a, cell_word(candidate));
}

static bool run_complete(struct session *session, const struct arguments *given, struct answer *a,
                         struct problem *problem)
{
    (void)problem;
    answer_columns(a, complete_columns);
    complete_line(session, given->count ? given->word[0] : "", !session->means.safe, print_candidate, a);
    return true;
}

const struct command help_commands[] = {
    {.name = "help",
     .synonyms = "manual man list explain commands",
     .argument =
         {{.name = "NAME", .kind = ARGUMENT_TOPIC, .of = "topic", .choices = topic_names, .optional = true}},
     .summary = "the commands, or one command or parameter",
     .example = "help tol",
     .see = "apropos show",
     .pages = true,
     .act = run_help},
    {.name = "apropos",
     .synonyms = "search find look",
     .argument = {{.name = "WORD", .kind = ARGUMENT_WORD, .choices = topic_names}},
     .summary = "commands and parameters that mention WORD",
     .example = "apropos barrier",
     .see = "help",
     .pages = true,
     .act = run_apropos},
    {.name = "lesson",
     .synonyms = "tutorial tour learn course introduction begin start",
     .summary = "a tour in ten steps, from the tower of the quiz to a row of your own",
     .help = "At a terminal the lesson waits until you type the line that it shows, or press Enter; any other "
             "command may come in between, and 'q' leaves. It runs in a session of its own, so that your "
             "parameters stay as they are. In a file, 'lesson' shows the rest of that file in the same way; "
             "examples/tutorial.dom is written so.",
     .see = "help",
     .runs = true,
     .act = run_lesson},
    {.name = "complete",
     .synonyms = "tab completion",
     .argument = {{.name = "LINE", .kind = ARGUMENT_REST, .optional = true}},
     .summary = "how LINE may go on, a line each, as <TAB> does",
     .example = "complete set output j",
     .act = run_complete},
    {.name = NULL},
};
