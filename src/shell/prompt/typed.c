/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "prompt/typed.h"
#include "language/text.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static const struct command *command_begun(const char *word)
{
    char message[NAMES_MESSAGE];
    int k = names_find(command_names, NULL, "command", word, message);
    return k < 0 ? NULL : command_find(command_names(NULL, k));
}

/* Returns the place after the ':' of a sweep, where a command begins, and the sweep; else the line itself. */
static const char *swept_command(const char *line, const struct command **sweep)
{
    char name[32];
    const char *colon = strchr(line, ':');
    snprintf(name, sizeof name, "%.*s", (int)strcspn(line, " \t:"), line);
    const struct command *c = colon && *name ? command_begun(name) : NULL;
    if (!c || (c->argument[0].kind != ARGUMENT_GRID && c->argument[1].kind != ARGUMENT_GRID))
        return line;
    *sweep = c;
    return colon + 1 + strspn(colon + 1, " \t");
}

/* Returns true for a number without a unit. */
static bool is_number(const char *word)
{
    char *end;
    if (!isdigit((unsigned char)*word) && *word != '.')
        return false;
    strtod(word, &end);
    return *end == '\0';
}

static bool is_unit(const char *word)
{
    struct quantity q = {.value = 1};
    const char *end = unit_scan(word, &q);
    return end && *end == '\0';
}

/* Returns true if an expression goes on after a word that ends so, or with one that begins so. */
static bool operates(char c)
{
    return c != '\0' && strchr("+-*/^(,", c) != NULL;
}

/* Returns true if the argument at this place may be an expression of several words. */
static bool may_join(const struct command *c, int argument)
{
    if (!c || argument < 0 || argument >= ARGUMENTS_MAX)
        return false;
    enum argument_kind kind = c->argument[argument].kind;
    return kind != ARGUMENT_FILE && kind != ARGUMENT_REST && kind != ARGUMENT_GRID && kind != ARGUMENT_WORDS;
}

/* Takes the next word; *open: parentheses that are open in the argument before it. */
static void take_word(struct typed *t, const char *word, int *open)
{
    size_t length = strlen(t->before);
    bool joins = may_join(t->command, t->words - 2) &&
                 (*open > 0 || operates(t->before[length - 1]) || operates(*word) || *word == ')' ||
                  (t->number && is_unit(word)));
    if (t->words == 0)
        t->command = command_begun(word);
    else if (t->words == 1 && t->command && t->command->argument[1].kind == ARGUMENT_VALUE) {
        char message[NAMES_MESSAGE];
        names_list *names = t->command->argument[0].choices;
        int k = names_find(names, NULL, "parameter", word, message);
        t->parameter = k < 0 ? NULL : parameter_find(names(NULL, k));
    }
    if (t->words == 1)
        snprintf(t->choice, sizeof t->choice, "%s", word);
    *open = joins ? *open : 0;
    for (const char *c = word; *c; c++)
        *open += (*c == '(') - (*c == ')');
    t->words += !joins;
    t->number = is_number(word);
    snprintf(t->before, sizeof t->before, "%s", word);
    t->joins = may_join(t->command, t->words - 2) && (*open > 0 || operates(word[strlen(word) - 1]));
}

void typed_read(const char *line, struct typed *t)
{
    char word[TYPED_WORD];
    const char *begin = line;
    int open = 0;
    for (const char *end; *(end = text_end(begin, ";")) == ';';)
        begin = end + 1;
    begin += strspn(begin, " \t");
    *t = (struct typed){.line = begin};
    t->begin = swept_command(begin, &t->sweep);
    t->last = t->begin + strlen(t->begin);
    while (t->last > t->begin && !strchr(" \t", t->last[-1]))
        t->last--;
    /* A file name in quotes begins after its '"'. */
    const char *quote = strchr(t->begin, '"');
    for (const char *behind; quote && (behind = text_quote(quote)) != NULL;)
        quote = strchr(behind, '"');
    const char *end = quote ? quote : t->last;
    t->last = quote ? quote + 1 : t->last;
    for (const char *at = t->begin; at < end;) {
        size_t length = strcspn(at, " \t");
        length = at + length > end ? (size_t)(end - at) : length;
        snprintf(word, sizeof word, "%.*s", (int)length, at);
        at += length + strspn(at + length, " \t");
        if (*word == '>')
            t->file = true;
        else if (*word)
            take_word(t, word, &open);
    }
    t->unit = t->number && may_join(t->command, t->words - 2) && is_unit(t->last);
}

int typed_argument(const struct typed *t)
{
    return t->words - 1 - t->joins;
}
