/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Completion at the prompt: Readline asks for one candidate after the other. */
#include "prompt/input.h"
#include <stdlib.h>
#include <string.h>

#include <readline/readline.h>

struct collected {
    char **word;
    size_t count;
};

static void collect(const char *candidate, void *context)
{
    struct collected *c = context;
    char **more = realloc(c->word, (c->count + 2) * sizeof *more);
    if (!more)
        return;
    c->word = more;
    c->word[c->count] = strdup(candidate);
    c->word[++c->count] = NULL;
}

static struct collected collected;

static char *next_match(const char *text, int state)
{
    static size_t k;
    (void)text;
    k = state ? k + 1 : 0;
    return k < collected.count ? collected.word[k] : NULL; /* Readline frees it */
}

struct session *complete_session;

char **complete_word(const char *text, int start, int end)
{
    char *line = strndup(rl_line_buffer, (size_t)end);
    (void)start;
    rl_attempted_completion_over = 1; /* never fall back to file names */
    collected = (struct collected){NULL, 0};
    if (line)
        complete_line(complete_session, line, true, collect, &collected);
    free(line);
    const char *first = collected.count ? collected.word[0] : "";
    rl_completion_suppress_append = *first && first[strlen(first) - 1] == '('; /* no blank in a function */
    char **matches = rl_completion_matches(text, next_match);
    free(collected.word);
    return matches;
}
