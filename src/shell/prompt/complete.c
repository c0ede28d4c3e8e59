/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/command.h"
#include "io/escape.h"
#include "language/text.h"
#include "prompt/input.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <readline/readline.h>

/* The candidates at the cursor: up to three lists of names, or files. */
struct offer {
    names_list *list[3];
    const void *context[3];
    int lists;
    bool files;
};

/* Lists for names.h the commands that have a value, and ans. */
static const char *answer_names(const void *context, int k)
{
    const char *name;
    int fewest;
    for (int i = 0; (name = command_names(context, i)) != NULL; i++)
        if (command_values(command_find(name), &fewest) >= 0 && k-- == 0)
            return name;
    return k == 0 ? "ans" : NULL;
}

/* Lists for names.h the parameters that are numbers. */
static const char *number_names(const void *context, int k)
{
    (void)context;
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (parameter_is_number(p) && k-- == 0)
            return p->name;
    return NULL;
}

static void offer_list(struct offer *offer, names_list *list, const void *context)
{
    offer->list[offer->lists] = list;
    offer->context[offer->lists++] = context;
}

static struct offer offer_for(const struct argument *a, const struct parameter *p, bool first)
{
    struct offer offer = {.files = a->kind == ARGUMENT_FILE || (p && p->value->or_file)};
    bool expression = a->kind == ARGUMENT_GRID && !first;
    if (a->choices)
        offer_list(&offer, a->choices, NULL);
    else if (p && p->words)
        offer_list(&offer, parameter_offered, p);
    else if (a->kind != ARGUMENT_FILE && a->kind != ARGUMENT_REST && a->kind != ARGUMENT_NONE) {
        offer_list(&offer, number_names, NULL);
        expression = true;
    }
    if (expression) {
        offer_list(&offer, answer_names, NULL);
        offer_list(&offer, expression_names, NULL);
    }
    return offer;
}

/* Returns true if an argument may follow this word, the argument before it. */
static bool may_follow(const struct argument *a, const char *word)
{
    char message[NAMES_MESSAGE];
    const struct argument *before = a - 1;
    if (!a->follows)
        return true;
    int k = names_find(before->choices, NULL, before->of, word, message);
    return k < 0 ? before->kind == ARGUMENT_PLACE && a->follows(0)
                 : a->follows(before->kind == ARGUMENT_PLACE ? -1 - k : k);
}

/* Returns the argument that reads all words from its own on, if word i of the command is one of them; or
 * NULL.
 */
static const struct argument *words_argument(const struct command *c, int i)
{
    for (int k = 0; k <= i && k < ARGUMENTS_MAX; k++)
        if (c->argument[k].kind == ARGUMENT_WORDS)
            return &c->argument[k];
    return NULL;
}

/* Lists for names.h the commands that can be swept. */
static const char *swept_names(const void *context, int k)
{
    const char *name;
    for (int i = 0; (name = command_names(context, i)) != NULL; i++)
        if (command_find(name)->columns && !command_find(name)->unswept && k-- == 0)
            return name;
    return NULL;
}

/* Returns the candidates for the n-th word after a choice that decides them. */
static struct offer offer_behind(const struct command *c, const char *choice, int n)
{
    char message[NAMES_MESSAGE];
    struct argument a = c->argument[1];
    int k = names_find(c->argument[0].choices, NULL, c->argument[0].of, choice, message);
    a.choices = k < 0 ? NULL : a.offers(k, n);
    return a.choices ? offer_for(&a, NULL, n == 1) : (struct offer){.lists = 0};
}

/* Returns the candidates that the words before the last one ask for. swept: the line is the part after the
 * ':' of a sweep. */
static struct offer offer_at(const char *line, size_t length, bool swept)
{
    struct offer offer = {.lists = 0};
    const struct command *c = NULL;
    const struct parameter *p = NULL;
    static char last[64]; /* the offer refers to it */
    char word[64], choice[64] = "", message[NAMES_MESSAGE];
    int words = 0;
    last[0] = '\0';
    for (size_t i = 0; i < length;) {
        size_t n = strcspn(line + i, " \t");
        n = i + n > length ? length - i : n;
        snprintf(word, sizeof word, "%.*s", (int)n, line + i);
        i += n + strspn(line + i + n, " \t");
        if (*word == '\0')
            continue;
        if (*word == '>')
            return (struct offer){.files = true};
        if (words == 0) {
            int k = names_find(command_names, NULL, "command", word, message);
            c = k < 0 ? NULL : command_find(command_names(NULL, k));
        } else if (words == 1 && c && c->argument[1].kind == ARGUMENT_VALUE) {
            int k = names_find(c->argument[0].choices, NULL, "parameter", word, message);
            p = k < 0 ? NULL : parameter_find(c->argument[0].choices(NULL, k));
        }
        if (words == 1)
            memcpy(choice, word, sizeof choice);
        memcpy(last, word, sizeof last);
        words++;
    }
    const struct argument *own = c && words > 0 ? words_argument(c, words - 1) : NULL;
    if (own)
        offer_list(&offer, own->choices, last);
    else if (words == 0)
        offer_list(&offer, swept ? swept_names : command_names, NULL);
    else if (c && words > 1 && c->argument[1].offers)
        offer = offer_behind(c, choice, words - 1);
    else if (c && c->argument[0].kind == ARGUMENT_GRID)
        offer = offer_for(&c->argument[0], NULL, words == 1); /* as long as it may be */
    else if (c && words <= ARGUMENTS_MAX && c->argument[words - 1].kind == ARGUMENT_VALUE && words > 2)
        return offer; /* a second value, which only few effects have */
    else if (c && words <= ARGUMENTS_MAX && (words == 1 || may_follow(&c->argument[words - 1], last)))
        offer = offer_for(&c->argument[words - 1], c->argument[words - 1].kind == ARGUMENT_VALUE ? p : NULL,
                          words == 1);
    return offer;
}

/* Returns the command before the dot at the end of text, as in 'rmax.' or 'rmax(0.3).'; NULL if there is
 * none. */
static const struct command *command_before_dot(const char *text, const char *dot)
{
    const char *end = dot;
    if (end > text && end[-1] == ')')
        while (end > text && *end != '(')
            end--;
    const char *begin = end;
    while (begin > text && (isalnum((unsigned char)begin[-1]) || begin[-1] == '_'))
        begin--;
    char name[32];
    snprintf(name, sizeof name, "%.*s", (int)(end - begin), begin);
    const struct command *c = command_find(name);
    int fewest;
    return c && command_values(c, &fewest) >= 0 ? c : NULL;
}

/* Returns the place after the ':' of a sweep, where a command begins; else the line itself. */
static const char *swept_command(const char *line)
{
    char name[32], message[NAMES_MESSAGE];
    const char *colon = strchr(line, ':');
    snprintf(name, sizeof name, "%.*s", (int)strcspn(line, " \t:"), line);
    int k = colon && *name ? names_find(command_names, NULL, "command", name, message) : -1;
    const struct command *c = k < 0 ? NULL : command_find(command_names(NULL, k));
    if (!c || (c->argument[0].kind != ARGUMENT_GRID && c->argument[1].kind != ARGUMENT_GRID))
        return line;
    return colon + 1 + strspn(colon + 1, " \t");
}

void complete_line(const char *line, bool files, void (*emit)(const char *, void *), void *context)
{
    const char *begin = line, *last;
    for (const char *end; *(end = text_end(begin, ";")) == ';';)
        begin = end + 1;
    begin += strspn(begin, " \t");
    const char *line_begin = begin;
    begin = swept_command(begin);
    last = begin + strlen(begin);
    while (last > begin && !strchr(" \t", last[-1]))
        last--;
    /* A file name in quotes begins after its '"'. */
    const char *quote = strchr(begin, '"');
    for (const char *behind; quote && (behind = text_quote(quote)) != NULL;)
        quote = strchr(behind, '"');
    last = quote ? quote + 1 : last;
    struct offer offer = offer_at(begin, (size_t)(last - (quote != NULL) - begin), begin > line_begin);
    /* In an expression the name begins after the operator. */
    const char *name = last;
    for (const char *c = last; *c && offer.lists == 3; c++)
        if (!isalnum((unsigned char)*c) && *c != '_')
            name = c + 1;
    if (name > last && name[-1] == '.') {
        const struct command *c = command_before_dot(last, name - 1);
        offer = (struct offer){.lists = 0};
        if (c)
            offer_list(&offer, command_keys, c);
    }
    for (int l = 0; l < offer.lists; l++) {
        const char *candidate;
        for (int k = 0; (candidate = offer.list[l](offer.context[l], k)) != NULL; k++) {
            char whole[128];
            snprintf(whole, sizeof whole, "%.*s%s", (int)(name - last), last, candidate);
            if (strncmp(candidate, name, strlen(name)) == 0 && !escape_needed(whole)) /* as typed before it */
                emit(whole, context);
        }
    }
    char *file;
    for (int state = 0; offer.files && files && (file = rl_filename_completion_function(last, state)) != NULL;
         state = 1) {
        rl_filename_completion_desired = 1; /* a '/' after folders, '"' around blanks */
        if (!escape_needed(file))           /* it is written on the terminal */
            emit(file, context);
        free(file);
    }
}

/* ---- Readline asks for one candidate after the other ---- */

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

char **complete_word(const char *text, int start, int end)
{
    char *line = strndup(rl_line_buffer, (size_t)end);
    (void)start;
    rl_attempted_completion_over = 1; /* never fall back to file names */
    collected = (struct collected){NULL, 0};
    if (line)
        complete_line(line, true, collect, &collected);
    free(line);
    char **matches = rl_completion_matches(text, next_match);
    free(collected.word);
    return matches;
}
