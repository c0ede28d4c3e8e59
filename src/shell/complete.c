/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "complete.h"
#include "command.h"
#include <stdlib.h>
#include <string.h>

#include <readline/readline.h>

/* What may stand at the cursor; Readline asks for one candidate after the other. */
static enum { OFFER_NOTHING, OFFER_COMMANDS, OFFER_PARAMETERS, OFFER_WORDS } offer;
static const struct parameter *offer_parameter;

/* The k-th word on offer, NULL behind the last. */
static const char *candidate(int k)
{
    if (offer == OFFER_COMMANDS) {
        for (const struct command_group *g = command_groups; g->title; g++)
            for (const struct command *c = g->commands; c->name; c++)
                if (k-- == 0)
                    return c->name;
    } else if (offer == OFFER_PARAMETERS) {
        return session_parameters[k].name;
    } else if (offer == OFFER_WORDS && offer_parameter->words) {
        return offer_parameter->words[k].name;
    }
    return NULL;
}

static char *next_match(const char *text, int state)
{
    static int k;
    const char *name;
    k = state ? k : 0;
    while ((name = candidate(k)) != NULL) {
        k++;
        if (strncmp(name, text, strlen(text)) == 0)
            return strdup(name);
    }
    return NULL;
}

char **complete_word(const char *text, int start, int end)
{
    (void)end;
    rl_attempted_completion_over = 1; /* never fall back to file names */
    char head[256];
    char *word[2] = {NULL, NULL};
    int words = 0, from = start;
    while (from > 0 && rl_line_buffer[from - 1] != ';')
        from--;
    snprintf(head, sizeof head, "%.*s", start - from, rl_line_buffer + from);
    char *rest = NULL;
    for (char *w = strtok_r(head, " \t", &rest); w; w = strtok_r(NULL, " \t", &rest), words++)
        if (words < 2)
            word[words] = w;

    const struct command *command = words ? command_find(word[0]) : NULL;
    offer = OFFER_NOTHING;
    if (words == 0) {
        offer = OFFER_COMMANDS;
    } else if (command && words == 1) {
        offer = command->first == ARGUMENT_COMMAND     ? OFFER_COMMANDS
                : command->first == ARGUMENT_PARAMETER ? OFFER_PARAMETERS
                                                       : OFFER_NOTHING;
    } else if (command && words == 2 && command->first == ARGUMENT_PARAMETER && command->most > 1) {
        offer_parameter = parameter_find(word[1]);
        offer = offer_parameter ? OFFER_WORDS : OFFER_NOTHING;
    }
    return rl_completion_matches(text, next_match);
}
