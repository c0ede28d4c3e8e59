/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "command.h"
#include "value.h"
#include <stdlib.h>
#include <string.h>

const struct command_group command_groups[] = {
    {"One cycle of the train", cycle_commands},
    {"How far it can grow", limit_commands},
    {"The session", session_commands},
    {NULL, NULL},
};

const struct command *command_find(const char *name)
{
    for (const struct command_group *g = command_groups; g->title; g++)
        for (const struct command *c = g->commands; c->name; c++)
            if (strcmp(c->name, name) == 0)
                return c;
    return NULL;
}

/* More words than any command takes; those beyond are counted as surplus all the same. */
enum { WORDS_MAX = 16 };

static const char blanks[] = " \t\r\f\v";

static bool command_run_words(struct session *session, int count, char **word)
{
    char shown[VALUE_SHOWN];
    const struct command *c = command_find(word[0]);
    if (!c)
        return session_error(session, "unknown command '%s'; 'help' lists the commands",
                             value_shown(word[0], shown));
    session->command = c->name;
    const char *usage_gap = *c->usage ? " " : "";
    if (count - 1 < c->fewest)
        return session_error(session, "an argument is missing; usage: %s%s%s", c->name, usage_gap, c->usage);
    if (count - 1 > c->most)
        return session_error(session, "'%s' is one argument too many; usage: %s%s%s",
                             value_shown(word[c->most + 1], shown), c->name, usage_gap, c->usage);
    struct answer answer = {
        .out = session->out,
        .format = session->output,
        .columns = c->columns,
        .rows = c->rows,
        .gap = session->answered && session->source,
    };
    bool done = c->run(session, &(struct call){count - 1, word, &answer});
    session->answered = session->answered || (done && c->columns);
    return done;
}

/* Splits one command into words in place, and runs it if there are any. */
static void command_run(struct session *session, char *text)
{
    char *word[WORDS_MAX];
    int count = 0;
    for (char *c = text + strspn(text, blanks); *c && *c != '#' && count < WORDS_MAX;) {
        word[count++] = c;
        c += strcspn(c, blanks);
        if (*c)
            *c++ = '\0';
        c += strspn(c, blanks);
    }
    if (count > 0)
        command_run_words(session, count, word);
    session->command = NULL;
}

void command_run_text(struct session *session, const char *text)
{
    char *copy = strdup(text);
    if (!copy) {
        session_error(session, "out of memory");
        return;
    }
    bool comment = false, stop = false;
    for (char *start = copy, *c = copy; !stop; c++) {
        bool blank_before = c == start || strchr(blanks, c[-1]);
        comment = (comment && *c != '\n') || (*c == '#' && blank_before);
        if (*c != '\0' && *c != '\n' && (*c != ';' || comment))
            continue;
        char end = *c;
        long errors = session->errors;
        *c = '\0';
        command_run(session, start);
        start = c + 1;
        stop = end == '\0' || session->quit || (session->bail && session->errors > errors) ||
               ferror(session->out);
    }
    free(copy);
}
