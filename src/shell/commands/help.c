/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands help, apropos, complete and details. */
#define _GNU_SOURCE /* strcasestr */
#include "interpreter/question.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "language/text.h"
#include "prompt/input.h"
#include "session/session.h"
#include <stdarg.h>
#include <string.h>

/* ---- Topics: commands, parameters and effects ---- */

/* A help topic. A text that the topic does not have is NULL. */
struct topic {
    const struct command *command;     /* NULL for a parameter or an effect */
    const struct parameter *parameter; /* NULL for a command */
    const char *name, *kind, *summary, *equation, *text, *example, *synonyms;
    char usage[96], keys[ANSWER_HEADER];
    char see[128]; /* the related topics that this build has; may be "" */
};

/* Fills in topic number k, or returns false if there is none. Commands come first, in the order of 'help',
 * then parameters and effects. */
static bool topic_at(int k, struct topic *t)
{
    const struct command *c = command_at(k);
    const struct parameter *p = c ? NULL : session_parameters + (k - command_count());
    if (!c && !p->name)
        return false;
    *t = (struct topic){.command = c, .parameter = p};
    t->name = c ? c->name : p->name;
    t->kind = c ? "command" : p->effect ? "effect" : "parameter";
    t->summary = c ? c->summary : p->meaning;
    t->equation = c ? c->equation : p->effect ? p->effect->source : NULL;
    t->text = c ? c->help : p->help;
    t->example = c ? c->example : p->example;
    t->synonyms = c ? c->synonyms : p->synonyms;
    if (c)
        command_usage_write(c, t->usage);
    else
        snprintf(t->usage, sizeof t->usage, "set %s", parameter_usage(p));
    for (const struct column *key = c ? c->columns : NULL; key && key->key; key++)
        text_add(t->keys, sizeof t->keys, "%s%s", *t->keys ? " " : "", key->key);
    for (const char *word = c ? c->see : NULL; word && *word; word += strspn(word, " ")) {
        char name[32];
        name_copy(word, strcspn(word, " "), name, sizeof name);
        if (command_find(name) || parameter_find(name))
            text_add(t->see, sizeof t->see, "%s%s", *t->see ? " " : "", name);
        word += strcspn(word, " ");
    }
    return true;
}

static bool mentions(const char *text, const char *word)
{
    return text && strcasestr(text, word);
}

/* How closely a topic is related to a word: MENTIONED if its text, its equations or its columns contain the
 * word, ABOUT if its name, its summary, its synonyms or the words for its values do. */
enum relation { UNRELATED, MENTIONED, ABOUT };

static enum relation topic_relation(const struct topic *t, const char *word)
{
    const struct parameter *p = t->parameter;
    const char *value;
    if (mentions(t->name, word) || mentions(t->summary, word) || mentions(t->synonyms, word))
        return ABOUT;
    for (int k = 0; p && !p->effect && (value = parameter_words(p, k)) != NULL; k++)
        if (mentions(value, word))
            return ABOUT;
    bool found = mentions(t->text, word) || (t->command && mentions(t->equation, word));
    for (const struct column *k = t->command ? t->command->columns : NULL; k && k->key; k++)
        found = found || mentions(k->key, word) || mentions(k->meaning, word);
    return found ? MENTIONED : UNRELATED;
}

static const struct column topic_columns[] = {
    {"name", "", "the name of the topic", 0},
    {"kind", "", "command, parameter or effect", 0},
    {"usage", "", "how to type the command, parameter or effect", 0},
    {"summary", "", "a one-line summary", 0},
    {"equation", "", "equations of the paper, or the source of an effect", 0},
    {"text", "", "the help text", 0},
    {"keys", "", "keys of the answer's columns, separated by blanks", 0},
    {"example", "", "example commands", 0},
    {"see", "", "related commands, separated by blanks", 0},
    {NULL, NULL, NULL, 0},
};

/* Adds a row for a topic to an answer in csv or json. */
static void topic_row(struct answer *answer, const struct topic *t)
{
    answer->columns = topic_columns;
    answer_cells(answer, cell_word(t->name), cell_word(t->kind), cell_word(t->usage), cell_word(t->summary),
                 cell_word(t->equation), cell_word(t->text), cell_word(*t->keys ? t->keys : NULL),
                 cell_word(t->example), cell_word(*t->see ? t->see : NULL));
}

/* ---- Paragraphs ---- */

/* Prints a text and a newline. Lines are no longer than the terminal or 100 characters, because longer ones
 * are hard to read. Those after the first begin at column `left`. */
static void wrapped(FILE *out, const char *text, int left)
{
    const int width = terminal_width(out);
    write_wrapped(out, text, left, width && width < 100 ? width : 100);
    putc('\n', out);
}

/* Like `wrapped` with `left` = 0, but takes a format and its arguments, as printf does. */
static void __attribute__((format(printf, 2, 3))) say(FILE *out, const char *format, ...)
{
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    wrapped(out, text, 0);
}

/* Prints an entry such as "  rmax [S]   the largest growth". */
static void entry_write(FILE *out, int indent, const char *usage, const char *summary)
{
    enum { SUMMARY = 22 }; /* where summaries begin: two columns after the longest usage of a command */
    wrapped(out, summary, fprintf(out, "%*s%-*s", indent, "", SUMMARY, usage));
}

/* ---- Lists ---- */

/* Prints one screen: the lines to type, and the names of all commands, in groups. */
static void help_screen(FILE *out)
{
    enum { LINE = 79 };
    int width = terminal_width(out);
    width = width && width < LINE ? width : LINE;
    say(out, "The first five minutes: type what follows the '>'");
    const struct first_line *first;
    for (int place = 1; (first = first_line_at(place)) != NULL; place = first->place + 1) {
        write_wrapped(out, first->does, fprintf(out, "> %-14s ", first->line), width);
        putc('\n', out);
    }
    const struct command_group *g = command_groups();
    for (const char *word = g->word; g->title; word = g->word) {
        char names[512] = "";
        const int left = fprintf(out, "%-10s", word);
        for (; g->title && strcmp(g->word, word) == 0; g++)
            for (const struct command *c = g->commands; c->name; c++)
                if (!c->typed.is_hidden && !c->typed.phrase)
                    text_add(names, sizeof names, " %s", c->name);
        write_wrapped(out, names, left, width);
        putc('\n', out);
    }
    say(out, "'help GROUP' or 'help NAME' explains more; 'help all' lists every command.");
}

/* Prints a line for each command of the groups with this word or, if it is "all", of all groups. Returns
 * false if no group has the word. In csv and json, only returns whether there is one. */
static bool help_groups(const struct answer *a, const char *word)
{
    const bool all = strcmp(word, "all") == 0, people = answer_for_people(a);
    bool found = false;
    for (const struct command_group *g = command_groups(); g->title; g++) {
        if (!all && strcmp(g->word, word) != 0)
            continue;
        if (people)
            fprintf(a->out, "%s%s\n", found ? "\n" : "", g->title);
        found = true;
        for (const struct command *c = g->commands; people && c->name; c++)
            if (!c->typed.is_hidden)
                entry_write(a->out, 2, command_usage(c), c->summary);
    }
    char names[2][256] = {"Parameters:", "Effects:"};
    for (const struct parameter *p = session_parameters; p->name; p++)
        text_add(names[p->effect != NULL], sizeof names[0], " %s", p->name);
    if (all && people)
        say(a->out, "\n%s\n%s\n'help NAME' explains one of these; 'apropos WORD' finds one.", names[0],
            names[1]);
    return found;
}

static bool needs_effect_of(const struct parameter *p, const struct feature *f)
{
    const struct parameter *const *of = f->parameters;
    while (of && *of && !(p->needs && (*of)->effect && strcmp(p->needs, (*of)->effect->name) == 0))
        of++;
    return of && *of;
}

/* Writes the names of the commands, parameters and values of a feature. A parameter that needs an effect of
 * another feature belongs to both. */
static void feature_names_write(const struct feature *f, char *names, size_t size)
{
    const struct feature *other;
    const char *name;
    for (const struct command_group *g = f->groups; g && g->title; g++)
        for (const struct command *c = g->commands; c->name; c++)
            if (!c->typed.phrase)
                text_add(names, size, " %s", c->name);
    for (int k = 0; (other = feature_at(k)) != NULL; k++)
        for (const struct parameter *const *p = other->parameters; p && *p; p++) {
            name = (*p)->effect ? (*p)->effect->name : (*p)->name;
            if ((other == f || needs_effect_of(*p, f)) && parameter_find(name) && !command_find(name))
                text_add(names, size, " %s", name);
        }
    for (int k = 0; f->names && (name = f->names(NULL, k)) != NULL; k++)
        if (!command_find(name))
            text_add(names, size, " %s", name);
    if (f->aggregates)
        text_add(names, size, " %s", f->aggregates->name);
}

/* Lists what each feature of this build adds. The Makefile reads this list in domino(1): a build then knows
 * which feature has a name that the build lacks. */
static void help_features(FILE *out)
{
    const struct feature *f;
    say(out, "Features of this build, with their commands, parameters and names:");
    for (int k = 0; (f = feature_at(k)) != NULL; k++) {
        char names[1024] = "";
        feature_names_write(f, names, sizeof names);
        if (!feature_is_always(f) && *names) {
            write_wrapped(out, names, fprintf(out, "%-15s ", f->name), 79);
            putc('\n', out);
        }
    }
}

/* ---- One topic ---- */

static void help_parameter(const struct session *session, const struct topic *t)
{
    const struct state *state = &session->state;
    const struct parameter *p = t->parameter;
    char text[512], usual[PARAMETER_TEXT];
    const char *name;
    const struct domq_effect_argument *a;
    FILE *out = session->output->out;
    say(out, "%s: %s\n", t->usage, t->summary);
    if (t->text) {
        wrapped(out, t->text, 0);
        putc('\n', out);
    }
    for (const char *const *e = p->effect ? p->effect->equations : NULL; e && *e; e++)
        fprintf(out, "    %s\n%s", *e, e[1] ? "" : "\n");
    for (int i = 0; (a = parameter_argument(p, i)) != NULL; i++) {
        snprintf(text, sizeof text, "%s%s%s%s%s%s%s%s", p->effect ? a->meaning : "", p->effect ? ", " : "",
                 parameter_range(state, p, i), *a->unit ? " " : "", a->unit, a->or_file ? "; or " : "",
                 a->or_file ? a->or_file : "", a->optional ? "; may be left out" : "");
        wrapped(out, text, fprintf(out, "  %-8s ", p->effect ? a->name : "VALUE"));
    }
    for (int k = 0; parameter_is_number(p) && (name = parameter_offered(p, k)) != NULL; k++)
        fprintf(out, "  %-8s %g\n", name, (double)p->words[names_exact(parameter_words, p, name)].value);
    fprintf(out, "  now      %s\n  default  %s\n\n", names_shown(parameter_setting(state, p, 15)),
            parameter_text(p, 0, parameter_fallback(state, p), 6, usual));
    if (p->effect)
        say(out, "Source: %s", p->effect->source);
    say(out, "'reset %s' restores the default.", p->name);
}

static void columns_write(FILE *out, const struct column *columns)
{
    for (const struct column *k = columns; k->key; k++)
        wrapped(out, k->meaning, fprintf(out, "  %-14s %-6s ", k->key, k->unit));
}

static void help_command(FILE *out, const struct topic *t)
{
    const struct command *c = t->command;
    const struct column *columns;
    const char *name, *summary;
    int fewest;
    say(out, "%s: %s", t->usage, t->summary);
    if (t->equation)
        say(out, "Equation: %s", t->equation);
    if (t->text) {
        putc('\n', out);
        wrapped(out, t->text, 0);
    }
    if (c->is_print && aggregates)
        wrapped(out, aggregates->help, 0);
    if (c->columns && c->columns->key) {
        fprintf(out, "\n%s:\n", c->rows ? "Each row of the answer has" : "The answer has");
        columns_write(out, c->columns);
    }
    /* the columns of an answer whose columns depend on the first argument */
    for (int k = 0; c->parts && (columns = c->parts(k, &name, &summary)) != NULL; k++) {
        say(out, "\n%s %s: %s", c->name, name, summary);
        columns_write(out, columns);
    }
    if (command_arity(c, &fewest) >= 0)
        say(out, "In an expression, '%s' stands for the value %s.", c->name, c->principal);
}

/* Runs an example in a new session, so that its output does not depend on the user's changes. */
static void help_example(struct session *session, const char *example)
{
    struct session fresh;
    session_init(&fresh, session->output->out);
    fresh.state.scene.compute.interrupt = session->state.scene.compute.interrupt;
    fresh.source.name = "help";
    fresh.run_context.safe = fresh.bail = true;
    say(session->output->out, "\nExample: %s\n", example);
    command_run_text(&fresh, example);
    session->errors += fresh.errors;
    session_close(&fresh);
}

/* Explains all topics with this name. If a command and a parameter have the same name, explains the command
 * first. If the name is NULL, explains all topics (only in csv and json). */
static void help_name(struct session *session, struct answer *a, const char *name)
{
    struct topic topic;
    bool is_second = false;
    for (int k = 0; topic_at(k, &topic); k++) {
        if (name && strcmp(topic.name, name) != 0)
            continue;
        if (!answer_for_people(a)) {
            topic_row(a, &topic);
            continue;
        }
        if (is_second)
            fprintf(a->out, "\nThe %s with the same name:\n\n", topic.kind);
        if (topic.command)
            help_command(a->out, &topic);
        else
            help_parameter(session, &topic);
        if (topic.example && !is_second)
            help_example(session, topic.example);
        if (*topic.see)
            say(a->out, "\nSee also: %s", topic.see);
        is_second = true;
    }
}

/* Lists the topics with this relation to a word. Returns false if there are none. */
static bool topics_write(struct answer *a, const char *word, enum relation relation)
{
    bool found = false;
    struct topic topic;
    for (int k = 0; topic_at(k, &topic); k++) {
        if (topic_relation(&topic, word) != relation)
            continue;
        found = true;
        if (topic.parameter)
            snprintf(topic.usage, sizeof topic.usage, "set %s", topic.name);
        if (answer_for_people(a))
            entry_write(a->out, 0, topic.usage, topic.summary);
        else
            topic_row(a, &topic);
    }
    return found;
}

static bool help_parse(struct reader *r, struct question *q)
{
    const char *outer = r->stops;
    offer_names(r, topic_names, NULL);
    r->stops = "?";
    q->item[0].word = read_word(r, WORD_QUOTED);
    r->stops = outer;
    r->at = skip_blanks(r->at);
    r->at += strspn(r->at, "?"); /* as in 'rmax?' */
    return q->item[0].word != NULL;
}

static bool run_help(struct session *session, const struct arguments *given, struct answer *a,
                     struct problem *problem)
{
    const char *word = given->count ? given->word[0] : "all", *name, *end;
    char message[NAMES_MESSAGE];
    struct quantity value;
    if (answer_for_people(a) && !given->count) {
        help_screen(a->out);
        return true;
    }
    if (answer_for_people(a) && strcmp(word, "features") == 0) {
        help_features(a->out);
        return true;
    }
    if (help_groups(a, word)) {
        if (!answer_for_people(a))
            help_name(session, a, NULL);
        return true;
    }
    const int k = parameter_search(topic_names, "topic", word, message);
    const struct feature *feature = k < 0 ? feature_value(word, &name, &end, &value) : NULL;
    if (k >= 0)
        help_name(session, a, topic_names(NULL, k));
    else if (feature && !*end)
        help_name(session, a, feature->name);
    else if (is_value_name(&session->state, word) || names_exact(expression_units, NULL, word) >= 0)
        help_name(session, a, "print"); /* such as sin or cm */
    else if (k == NAMES_SEVERAL || k == NAMES_ABSENT || !topics_write(a, word, ABOUT)) {
        problem->place = given->column[0];
        return problem_error(problem, k == NAMES_UNKNOWN ? "%s; 'apropos WORD' finds topics" : "%s", message);
    }
    return true;
}

/* ---- Other commands ---- */

static bool run_apropos(const struct query *query, struct answer *a, struct problem *problem)
{
    const char *word = query->given->word[0];
    const bool is_about = topics_write(a, word, ABOUT);
    return topics_write(a, word, MENTIONED) || is_about ||
           problem_error(
               problem,
               "nothing was found about '%s'; try another word, such as 'picture' or 'gap', or enter "
               "'help' for a list of all commands",
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

const struct command help_commands[] = {
    {.name = "help",
     .synonyms = "manual man list explain commands",
     .argument = {{.name = "NAME", .kind = ARGUMENT_WORDS, .parse = help_parse, .optional = true}},
     .summary = "the commands, one command or parameter, or a group of commands",
     .help = "'help' shows one screen: lines to type, and the names of all commands in groups. 'help limits' "
             "has a line for each command of the group 'limits', and 'help all' a line for every command. "
             "'help features' lists what each feature of this build adds.",
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
     .argument = {{.name = "WORD", .kind = ARGUMENT_WORDS, .parse = help_parse}},
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
    {.name = NULL},
};
