/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands help, apropos, complete and version. */
#include "answer/wrap.h"
#include "commands/topics.h"
#include "interpreter/feature.h"
#include "interpreter/interpret.h"
#include "language/quad.h"
#include "language/text.h"
#include "prompt/input.h"
#include "session/session.h"
#include <gsl/gsl_version.h>
#include <readline/readline.h>
#include <string.h>
#include <sys/utsname.h>

/* The introduction of 'help': lines to type, in this order, and what they do. */
static const struct first_line {
    const char *line, *does;
} first_lines[] = {
    {"count 112 m", "the quiz: how many dominoes topple a tower of 112 m"},
    {"rmax", "how much larger each domino can be than the one before it"},
    {"set s 0.3", "dominoes closer together: gaps of 0.3 times the height"},
    {"rmax", "the answer for these gaps; 'details' has the rest of it"},
    {"draw", "a picture of the train; 'draw > train.svg' writes a file"},
    {"set row 12", "a row of 12 dominoes; 'set row FILE' reads your own"},
    {"set r 1.2", "each domino is 1.2 times as large as the one before it"},
    {"fall", "how each domino falls, and whether all do"},
    {"lesson", "a tour in ten steps, from the tower to a row of your own"},
    {"help rmax", "explains a command; 'apropos tower' finds commands"},
    {"quit", "ends the session; ^C stops a computation"},
};

/* Returns true if this build has the command of a line, and the parameter that it sets. */
static bool line_runs(const char *line)
{
    char command[16] = "", parameter[16] = "";
    sscanf(line, "%15s %15s", command, parameter);
    return command_find(command) && (strcmp(command, "set") != 0 || parameter_find(parameter));
}

static void screen_line(FILE *out, const char *text, int left, int width)
{
    write_wrapped(out, text, left, width);
    putc('\n', out);
}

/* Prints one screen: the lines to type, and the names of all commands, in groups. */
static void help_screen(FILE *out)
{
    enum { WORD = 10, LINE = 79 };
    const int width = help_width(out) < LINE ? help_width(out) : LINE;
    help_say(out, "The first five minutes: type what follows the '>'");
    for (size_t i = 0; i < sizeof first_lines / sizeof *first_lines; i++)
        if (line_runs(first_lines[i].line))
            screen_line(out, first_lines[i].does, fprintf(out, "> %-14s ", first_lines[i].line), width);
    const char *word = "";
    for (const struct command_group *g = command_groups(); g->title; g++)
        if (strcmp(g->word, word) != 0) {
            char names[512] = "";
            word = g->word;
            for (const struct command_group *of = g; of->title && strcmp(of->word, word) == 0; of++)
                for (const struct command *c = of->commands; c->name; c++)
                    if (!c->typed.is_hidden && !c->typed.phrase)
                        text_add(names, sizeof names, " %s", c->name);
            screen_line(out, names + 1, fprintf(out, "%-*s", WORD, word), width);
        }
    help_say(out, "'help GROUP' or 'help NAME' explains more; 'help all' lists every command.");
}

/* Prints a line for each command of the groups with this word or, if it is "all", of all groups. */
static void help_groups(FILE *out, const char *word)
{
    bool all = strcmp(word, "all") == 0, is_first = true;
    for (const struct command_group *g = command_groups(); g->title; g++) {
        if (!all && strcmp(g->word, word) != 0)
            continue;
        fprintf(out, "%s%s\n", is_first ? "" : "\n", g->title);
        is_first = false;
        for (const struct command *c = g->commands; c->name; c++)
            if (!c->typed.is_hidden)
                topic_entry(out, "  ", command_usage(c), c->summary);
    }
    if (!all)
        return;
    char names[256] = "Parameters:";
    putc('\n', out);
    for (const struct parameter *p = session_parameters; p->name; p++) {
        if (p->effect && !p[-1].effect) {
            help_say(out, "%s", names);
            snprintf(names, sizeof names, "Effects:");
        }
        text_add(names, sizeof names, " %s", p->name);
    }
    help_say(out, "%s", names);
    help_say(out, "'help NAME' explains one of these; 'apropos WORD' finds one.");
}

/* ---- A parameter or an effect ---- */

static void help_effect_values(const struct session *session, const struct parameter *p)
{
    char text[512];
    const struct domq_effect_argument *a;
    for (int i = 0; (a = parameter_argument(p, i)) != NULL; i++) {
        snprintf(text, sizeof text, "%s, %s%s%s%s%s%s", a->meaning, parameter_range(&session->state, p, i),
                 *a->unit ? " " : "", a->unit, a->or_file ? "; or " : "", a->or_file ? a->or_file : "",
                 a->optional ? "; may be left out" : "");
        int left = fprintf(session->output->out, "  %-8s ", a->name);
        help_wrapped(session->output->out, text, left);
    }
}

static void help_parameter(struct session *session, const struct topic *t)
{
    const struct parameter *p = t->parameter;
    const struct effect_state *effect = &session->state.scene.effect[p->which];
    char text[WIDE_TEXT];
    const char *name, *values = t->usage + strcspn(t->usage, " ") + 1; /* skips "set" or "effect" */
    FILE *out = session->output->out;
    help_say(out, "%s: %s", p->effect ? t->usage : p->name, t->summary);
    putc('\n', out);
    if (t->text) {
        help_wrapped(out, t->text, 0);
        putc('\n', out);
    }
    for (const char *const *e = p->effect ? p->effect->equations : NULL; e && *e; e++)
        fprintf(out, "    %s\n", *e);
    if (p->effect && p->effect->equations)
        putc('\n', out);
    if (p->effect)
        help_effect_values(session, p);
    else {
        fprintf(out, "  value    %s%s%s\n",
                parameter_text(p, parameter_get(&session->state, p), state_style(&session->state).all_digits,
                               text),
                *p->value->unit ? " " : "", p->value->unit);
        fprintf(out, "  range    %s\n", parameter_range(&session->state, p, 0));
    }
    fprintf(out, "  default  %s\n", parameter_text(p, parameter_fallback(&session->state, p), 6, text));
    for (int k = 0; parameter_is_number(p) && (name = parameter_offered(p, k)) != NULL; k++)
        fprintf(out, "  %-8s %g\n", name, (double)p->words[names_exact(parameter_words, p, name)].value);
    putc('\n', out);
    if (p->effect) {
        help_say(out, "Source: %s", p->effect->source);
        help_say(out,
                 effect->on ? "The effect is on: %s\n" : "The effect is off, and costs no computing time.\n",
                 names_shown(effect_setting(&session->state.scene, p->which)));
    }
    help_say(out, "'set %s' changes it, 'reset %s' restores the default.", values, p->name);
}

/* ---- A command ---- */

/* Runs an example in a new session, so that its output does not depend on the user's changes. */
static void help_example(struct session *session, const char *example)
{
    struct session fresh;
    session_init(&fresh, session->output->out);
    fresh.state.scene.compute.interrupt = session->state.scene.compute.interrupt;
    fresh.source.name = "help";
    fresh.run_context.safe = fresh.bail = true;
    putc('\n', session->output->out);
    help_say(session->output->out, "Example: %s", example);
    putc('\n', session->output->out);
    command_run_text(&fresh, example);
    session->errors += fresh.errors;
    session_close(&fresh);
}

static void columns_write(FILE *out, const struct column *columns)
{
    int key = 12, unit = 6; /* minimum widths, so that most help pages look alike */
    for (const struct column *k = columns; k->key; k++) {
        key = (int)strlen(k->key) > key ? (int)strlen(k->key) : key;
        unit = (int)strlen(k->unit) > unit ? (int)strlen(k->unit) : unit;
    }
    for (const struct column *k = columns; k->key; k++) {
        int left = fprintf(out, "  %-*s %-*s ", key, k->key, unit, k->unit);
        help_wrapped(out, k->meaning, left);
    }
}

/* Explains the columns of a command's answer, or names an earlier command with the same columns. */
static void help_columns(FILE *out, const struct command *c)
{
    struct topic first;
    for (int k = 0; topic_at(k, &first) && first.command->columns != c->columns; k++)
        continue;
    if (first.command != c) {
        fprintf(out, "\nIts answer has the columns of '%s'; 'help %s' explains them.\n", first.name,
                first.name);
        return;
    }
    fprintf(out, "\n%s:\n", c->rows ? "Each row of the answer has" : "The answer has");
    columns_write(out, c->columns);
}

/* Explains the columns of an answer whose columns depend on the first argument. */
static void help_parts(FILE *out, const struct command *c)
{
    const char *name, *summary;
    const struct column *columns;
    for (int k = 0; (columns = c->parts(k, &name, &summary)) != NULL; k++) {
        putc('\n', out);
        help_say(out, "%s %s: %s", c->name, name, summary);
        columns_write(out, columns);
    }
}

static void help_command(struct session *session, const struct topic *t)
{
    const struct command *c = t->command;
    FILE *out = session->output->out;
    int fewest;
    help_say(out, "%s: %s", t->usage, t->summary);
    if (t->equation)
        help_say(out, "Equation: %s", t->equation);
    if (t->text) {
        putc('\n', out);
        help_wrapped(out, t->text, 0);
    }
    if (c->columns && c->columns->key)
        help_columns(out, c);
    if (c->parts)
        help_parts(out, c);
    if (command_arity(c, &fewest) >= 0)
        help_say(out, "In an expression, '%s' stands for the value %s.", c->name, c->principal);
    if (t->example)
        help_example(session, t->example);
    if (t->see) {
        putc('\n', out);
        help_say(out, "See also: %s", t->see);
    }
}

/* ---- help ---- */

/* Explains all topics with this name. If a command and a parameter have the same name, explains the command
 * first. If the name is NULL, explains all topics (only in csv and json). */
static void help_name(struct session *session, struct answer *a, const char *name)
{
    struct topic topic;
    bool is_second = false, people = answer_for_people(a);
    for (int k = 0; topic_at(k, &topic); k++) {
        if (name && strcmp(topic.name, name) != 0)
            continue;
        if (!people) {
            topic_row(a, &topic);
            continue;
        }
        if (is_second)
            fprintf(session->output->out, "\nThe %s with the same name:\n\n", topic.kind);
        (topic.command ? help_command : help_parameter)(session, &topic);
        if (!topic.command && !is_second && topic.example)
            help_example(session, topic.example);
        is_second = true;
    }
}

static void help_variable(const struct session *session, const struct arguments *given, struct answer *a)
{
    const struct variable *v = given->variable;
    struct topic topic;
    topic_of_variable(v, &topic);
    if (!answer_for_people(a)) {
        topic_row(a, &topic);
        return;
    }
    const char *head = variable_head(v);
    fprintf(session->output->out, "%s = %s\n\n", head, topic.summary);
    help_say(session->output->out,
             "This %s was defined with 'let'. '%s = VALUE' changes it, and 'reset %s' removes it.",
             topic.kind, head, v->name);
}

/* Lists the topics that have this word as a synonym. */
static void help_several(FILE *out, const char *word)
{
    const char *name;
    help_say(out, "'%s' can mean any of these; 'help NAME' explains each:", word);
    for (int k = 0; (name = topic_by_synonym(word, k)) != NULL; k++) {
        const struct command *c = command_find(name);
        topic_entry(out, "", name, c ? c->summary : parameter_find(name)->meaning);
    }
}

static bool run_help(struct session *session, const struct arguments *given, struct answer *a,
                     struct problem *problem)
{
    (void)problem;
    bool people = answer_for_people(a), has_name = given->count && given->number[0] >= 0;
    const char *word = given->count && !has_name ? given->word[0] : NULL, *name;
    if (given->variable)
        help_variable(session, given, a);
    else if (people && !given->count)
        help_screen(session->output->out);
    else if (people && word && group_named(word))
        help_groups(session->output->out, word);
    else if (people && word && topic_by_synonym(word, 1))
        help_several(session->output->out, word);
    else if (!word || group_named(word))
        help_name(session, a, has_name ? topic_names(NULL, (int)given->number[0]) : NULL);
    else
        for (int k = 0; (name = topic_by_synonym(word, k)) != NULL; k++)
            help_name(session, a, name);
    return true;
}

/* ---- details ---- */

static bool run_details(struct session *session, const struct arguments *given, struct answer *a,
                        struct problem *problem)
{
    (void)given;
    if (!answer_for_people(a))
        return problem_error(problem, "answers in csv and json have all their values; 'details' follows an "
                                      "answer after 'set output table'");
    if (!session->details)
        return problem_no_answer(problem, "the last answer has no more details");
    fputs(session->details, a->out);
    a->progress.wrote_text = true;
    return true;
}

/* ---- apropos and complete ---- */

static bool run_apropos(const struct query *query, struct answer *a, struct problem *problem)
{
    const char *word = query->given->word[0];
    bool people = answer_for_people(a);
    int found = 0;
    struct topic topic;
    /* Topics about the word come before topics that only mention the word in their details. */
    for (int match = MATCH_TOPIC; match < MATCH_NONE; match++)
        for (int k = 0; topic_at(k, &topic); k++) {
            if ((int)topic_match(&topic, word) != match)
                continue;
            found++;
            if (!people) {
                topic_row(a, &topic);
                continue;
            }
            if (topic.parameter)
                snprintf(topic.usage, sizeof topic.usage, "set %s", topic.parameter->name);
            topic_entry(a->out, "", topic.usage, topic.summary);
        }
    return found > 0 || problem_error(problem,
                                      "nothing was found about '%s'; try another word, such as 'picture' or "
                                      "'gap', or enter 'help' for a list of all commands",
                                      names_shown(word));
}

static const struct column complete_columns[] = {
    {"line", "", "one way to continue the line", 0},
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
    complete_line(session, given->count ? given->word[0] : "", !session->run_context.safe, print_candidate,
                  a);
    return true;
}

/* ---- version ---- */

#if defined __clang__
#define COMPILER "clang " __clang_version__
#elif defined __GNUC__
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER ""
#endif

static const struct column version_columns[] = {
    {"version", "", "the version of this program and of its library", 0},
    {"system", "", "the operating system and the machine", 0},
    {"compiler", "", "the compiler that built this program", 0},
    {"quad", "", "the C type that quad precision uses", 0},
    {"quad_bits", "",
     "the number of bits in the significand of this type, or 0 if there is no quad precision", 0},
    {"gsl", "", "the version of the GNU Scientific Library", 0},
    {"readline", "", "the version of GNU Readline", 0},
    {"features", "", "what this build has besides the calculator of the paper, separated by blanks", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_version(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct domq_arithmetic quad = any_arithmetic(IN_QUAD);
    struct utsname name = {.sysname = ""};
    char system[sizeof name.sysname + sizeof name.machine], names[256] = "";
    const struct feature *f;
    for (int k = 0; (f = feature_at(k)) != NULL; k++)
        if (!strchr(f->name, '_') && strcmp(f->name, "shell") != 0 && strcmp(f->name, "train") != 0)
            text_add(names, sizeof names, "%s%s", *names ? " " : "", f->name);
    (void)query;
    (void)problem;
    (void)uname(&name);
    snprintf(system, sizeof system, "%s %s", name.sysname, name.machine);
    answer_say(a, "domino %s\n", dom_version());
    return answer_cells(a, cell_word(dom_version()), cell_word(system), cell_word(COMPILER),
                        cell_word(quad.type), cell_count(quad.bits), cell_word(gsl_version),
                        cell_word(rl_library_version), cell_word(names));
}

const struct command help_commands[] = {
    {.name = "help",
     .synonyms = "manual man list explain commands",
     .argument = {{.name = "NAME",
                   .kind = ARGUMENT_TOPIC,
                   .noun = "topic",
                   .choices = topic_names,
                   .optional = true}},
     .summary = "the commands, one command or parameter, or a group of commands",
     .help =
         "'help' shows one screen: lines to type, and the names of all commands in groups. 'help rows' has a "
         "line for each command of the group 'rows', and 'help all' a line for every command.",
     .example = "help tol",
     .see = "apropos show",
     .writes = WRITES_PAGES,
     .act = run_help},
    {.name = "details",
     .synonyms = "more long full columns meaning",
     .summary = "the rest of the last answer: all values, notes, comparisons",
     .help = "An answer is short. 'details' prints what it has left out, as it was when the answer was "
             "computed, even if the scene has changed since. The word can also end a command, as in 'count "
             "112 details'. Answers in csv and json are always complete.",
     .example = "barrier; details",
     .see = "help",
     .act = run_details},
    {.name = "apropos",
     .synonyms = "search find look",
     .argument = {{.name = "WORD", .kind = ARGUMENT_WORD, .choices = topic_names}},
     .summary = "commands and parameters that mention WORD",
     .example = "apropos barrier",
     .see = "help",
     .writes = WRITES_PAGES,
     .run = run_apropos},
    {.name = "complete",
     .synonyms = "tab completion",
     .argument = {{.name = "LINE", .kind = ARGUMENT_REST, .optional = true}},
     .summary = "list the ways to continue LINE, as <TAB> does",
     .example = "complete set output j",
     .act = run_complete},
    {.name = "version",
     .synonyms = "about build release compiler",
     .summary = "the version of this program, and what it was built with",
     ANSWER(version)},
    {.name = NULL},
};
