/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/words.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <readline/tilde.h>

int reader_column(const struct reader *r, const char *place)
{
    return r->text ? text_column(r->text, place) : r->problem->place;
}

bool command_ends(const char *c)
{
    return *c == '\0' || *c == ';' || *c == '#';
}

const char unclosed[] = "this '\"' is never closed";

/* The place of a word in the line, without its quotes. */
struct place {
    const char *begin, *end;
    bool quoted;
};

/* Passes a word.  Returns false if a '"' is never closed. */
static bool pass_word(struct reader *r, bool quotes, struct place *word)
{
    char ends[16];
    snprintf(ends, sizeof ends, " \t\r\f\v;%s", r->stops ? r->stops : "");
    *word = (struct place){.begin = r->at, .quoted = quotes && *r->at == '"'};
    if (!word->quoted) {
        r->at = word->end = word->begin + strcspn(word->begin, ends);
        return true;
    }
    const char *behind = text_quote(r->at);
    if (!behind)
        return false;
    word->begin++;
    word->end = behind - 1;
    r->at = behind;
    return true;
}

/* Returns a copy of the text; between quotes '""' is one '"'. */
static char *copy_word(struct reader *r, const char *begin, const char *end, bool quoted)
{
    char *copy = arena_text(r->arena, begin, (size_t)(end - begin)), *to = copy;
    for (const char *c = copy; quoted && c && *c; c++) {
        *to++ = *c;
        c += *c == '"' && c[1] == '"';
    }
    if (quoted && copy)
        *to = '\0';
    return copy;
}

char *read_word(struct reader *r, bool quotes)
{
    struct place word;
    return pass_word(r, quotes, &word) ? copy_word(r, word.begin, word.end, word.quoted) : NULL;
}

char *read_text(struct reader *r)
{
    struct place word;
    if (!pass_word(r, true, &word))
        return NULL;
    return copy_word(r, text_typed(r->text, word.begin), text_typed(r->text, word.end), word.quoted);
}

char *read_file(struct reader *r)
{
    char *name = read_text(r);
    if (!name || *name != '~')
        return name;
    char *path = tilde_expand_word(name);
    name = path ? arena_text(r->arena, path, strlen(path)) : NULL;
    free(path);
    return name;
}

struct offer *reader_offer(const struct reader *r)
{
    struct offer *e = r->offer;
    return e && (r->at == e->cursor || (*r->at == '"' && r->at + 1 == e->cursor)) ? e : NULL;
}

void offer_kind(const struct reader *r, enum offer_kind kind)
{
    struct offer *e = reader_offer(r);
    if (e)
        e->kinds |= kind;
}

void offer_names(const struct reader *r, names_list *list, const void *context)
{
    struct offer *e = reader_offer(r);
    for (int i = 0; e && i < e->lists; i++)
        if (e->names[i] == list && e->context[i] == context)
            return;
    if (!e || !list || e->lists == OFFER_LISTS)
        return;
    e->names[e->lists] = list;
    e->context[e->lists++] = context;
}

void offer_value(const struct reader *r, const struct argument *a, bool is_inside)
{
    struct offer *e = reader_offer(r);
    if (!e)
        return;
    e->value = *a;
    e->is_inside = is_inside;
}

void reader_named(const struct reader *r, const char *begin, const char *end)
{
    if (!r->offer)
        return;
    r->offer->typed = (size_t)(end - begin);
    if (r->offer->is_command)
        memset(r->offer->is_command + (begin - r->text->line), true, (size_t)(end - begin));
}

/* Lists for names.h the one word that is the context. */
static const char *this_word(const void *word, int k)
{
    return k == 0 ? word : NULL;
}

bool word_is_next(const struct reader *r, const char *word)
{
    size_t n = strlen(word);
    return strncmp(r->at, word, n) == 0 && !strchr("_.(", r->at[n] ? r->at[n] : ' ') &&
           !isalnum((unsigned char)r->at[n]);
}

bool reader_takes(struct reader *r, const char *word)
{
    bool is_next = word_is_next(r, word);
    offer_names(r, this_word, word);
    if (is_next)
        r->at = skip_blanks(r->at + strlen(word));
    return is_next;
}

bool reader_ends(struct reader *r)
{
    r->at = skip_blanks(r->at);
    return command_ends(r->at) || *r->at == '>' || *r->at == '|' || (r->stops && strchr(r->stops, *r->at)) ||
           word_is_next(r, "with");
}

void reader_place(struct reader *r, const char *at)
{
    r->problem->place = reader_column(r, at);
}
