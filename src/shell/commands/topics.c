/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* strcasestr */
#include "commands/topics.h"
#include "answer/wrap.h"
#include "io/terminal.h"
#include "language/text.h"
#include <stdarg.h>
#include <string.h>

/* Writes the related commands and parameters that this build has. */
static const char *see_known(const char *see, char known[TOPIC_SEE])
{
    *known = '\0';
    for (const char *word = see; word && *word; word += strspn(word, " ")) {
        char name[32] = "";
        const size_t length = strcspn(word, " ");
        snprintf(name, sizeof name, "%.*s", (int)length, word);
        if (command_find(name) || parameter_find(name))
            text_add(known, TOPIC_SEE, "%s%s", *known ? " " : "", name);
        word += length;
    }
    return *known ? known : NULL;
}

static void topic_of_command(const struct command *c, struct topic *t)
{
    *t = (struct topic){.command = c,
                        .name = c->name,
                        .kind = "command",
                        .summary = c->summary,
                        .equation = c->equation,
                        .text = c->help,
                        .example = c->example,
                        .synonyms = c->synonyms};
    t->see = see_known(c->see, t->seen);
    command_usage_write(c, t->usage);
    for (const struct column *k = c->columns; k && k->key; k++)
        text_add(t->keys, sizeof t->keys, "%s%s", *t->keys ? " " : "", k->key);
}

static void topic_of_parameter(const struct parameter *p, struct topic *t)
{
    *t = (struct topic){.parameter = p,
                        .name = p->name,
                        .kind = p->effect ? "effect" : "parameter",
                        .summary = p->meaning,
                        .equation = p->effect ? p->effect->source : NULL,
                        .text = p->help,
                        .synonyms = p->synonyms};
    snprintf(t->usage, sizeof t->usage, "set %s", parameter_usage(p));
    t->example = p->example;
}

void topic_of_variable(const struct variable *v, struct topic *t)
{
    *t = (struct topic){.name = v->name, .kind = v->body ? "function" : "variable", .see = "let"};
    t->summary = v->body ? v->body : variable_value(v, t->value);
    snprintf(t->usage, sizeof t->usage, "let %s = VALUE", variable_head(v));
}

bool topic_at(int k, struct topic *topic)
{
    for (const struct command_group *g = command_groups(); g->title; g++)
        for (const struct command *c = g->commands; c->name; c++)
            if (k-- == 0) {
                topic_of_command(c, topic);
                return true;
            }
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (k-- == 0) {
            topic_of_parameter(p, topic);
            return true;
        }
    return false;
}

static bool mentions(const char *text, const char *word)
{
    return text && strcasestr(text, word);
}

enum topic_match topic_match(const struct topic *t, const char *word)
{
    bool is_about = mentions(t->name, word) || mentions(t->summary, word) || mentions(t->synonyms, word);
    bool in_details = mentions(t->text, word) || (t->command && mentions(t->equation, word));
    const struct word *w = t->parameter && !t->parameter->effect ? t->parameter->words : NULL;
    const char *const *e = t->parameter && t->parameter->effect ? t->parameter->effect->equations : NULL;
    const struct column *k = t->command ? t->command->columns : NULL;
    for (; w && w->name; w++)
        is_about = is_about || mentions(w->name, word);
    for (; e && *e; e++)
        in_details = in_details || mentions(*e, word);
    for (; k && k->key; k++)
        in_details = in_details || mentions(k->key, word) || mentions(k->meaning, word);
    return is_about ? MATCH_TOPIC : in_details ? MATCH_DETAILS : MATCH_NONE;
}

/* ---- For programs ---- */

static const struct column topic_columns[] = {
    {"name", "", "the name of the topic", 0},
    {"kind", "", "command, parameter, effect, variable or function", 0},
    {"usage", "", "how to type the command, parameter or effect", 0},
    {"summary", "", "a one-line summary", 0},
    {"equation", "", "equations of the paper, or the source of an effect", 0},
    {"text", "", "the help text", 0},
    {"keys", "", "keys of the answer's columns, separated by blanks", 0},
    {"example", "", "example commands", 0},
    {"see", "", "related commands, separated by blanks", 0},
    {NULL, NULL, NULL, 0},
};

void topic_row(struct answer *answer, const struct topic *t)
{
    answer->columns = topic_columns;
    answer_cells(answer, cell_word(t->name), cell_word(t->kind), cell_word(t->usage), cell_word(t->summary),
                 cell_word(t->equation), cell_word(t->text), cell_word(*t->keys ? t->keys : NULL),
                 cell_word(t->example), cell_word(t->see));
}

/* ---- For people ---- */

int help_width(FILE *out)
{
    int width = terminal_width(out);
    return width && width < 100 ? width : 100;
}

void help_wrapped(FILE *out, const char *text, int left)
{
    write_wrapped(out, text, left, help_width(out));
    putc('\n', out);
}

void help_say(FILE *out, const char *format, ...)
{
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    help_wrapped(out, text, 0);
}

/* Returns the column in which summaries begin: two columns after the longest usage of a command. */
static int summary_column(void)
{
    struct topic topic;
    size_t widest = 0;
    for (int k = 0; topic_at(k, &topic) && topic.command; k++)
        if (!topic.command->typed.is_hidden && strlen(topic.usage) > widest)
            widest = strlen(topic.usage);
    return (int)widest + 2;
}

void topic_entry(FILE *out, const char *prefix, const char *usage, const char *summary)
{
    enum {
        SUMMARY_LEAST = 30, /* the minimum width of a summary beside the usage */
        INDENT = 6          /* the indentation of a summary below the usage */
    };
    int column = summary_column() + (int)strlen(prefix);
    bool below = help_width(out) < column + SUMMARY_LEAST;
    if (below)
        fprintf(out, "%s%s\n%*s", prefix, usage, INDENT, "");
    else
        fprintf(out, "%s%-*s", prefix, column - (int)strlen(prefix), usage);
    help_wrapped(out, summary, below ? INDENT : column);
}
