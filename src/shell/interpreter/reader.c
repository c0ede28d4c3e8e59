/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/question.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <readline/tilde.h>

void reader_place(const struct reader *r, const char *at)
{
    if (r->text)
        r->problem->place = text_column(r->text, at);
}

/* ---- Memory ---- */

void *reader_memory(struct reader *r, size_t size)
{
    void *memory = arena_take(r->arena, size);
    if (!memory)
        problem_error(r->problem, "out of memory");
    return memory;
}

char *reader_copy(struct reader *r, const char *text, size_t length)
{
    char *copy = reader_memory(r, length + 1);
    return copy ? memcpy(copy, text, length) : NULL;
}

/* ---- Words ---- */

char *read_word(struct reader *r, enum word_form form)
{
    char ends[16];
    bool is_quoted = form != WORD_BARE && *r->at == '"';
    const char *begin = r->at + is_quoted, *end;
    if (is_quoted) {
        const char *behind = text_quote(r->at);
        if (!behind) {
            problem_error(r->problem, "this '\"' is never closed");
            return NULL;
        }
        end = behind - 1;
        r->at = behind;
    } else {
        snprintf(ends, sizeof ends, " \t\r\f\v;%s", r->stops ? r->stops : "");
        r->at = end = begin + strcspn(begin, ends);
    }
    if (form == WORD_TYPED) {
        begin = text_typed(r->text, begin);
        end = text_typed(r->text, end);
    }
    char *word = reader_copy(r, begin, (size_t)(end - begin)), *to = word;
    for (const char *c = word; is_quoted && c && *c; c++) {
        *to++ = *c;
        c += *c == '"' && c[1] == '"';
    }
    if (is_quoted && word)
        *to = '\0';
    return word;
}

char *read_file(struct reader *r)
{
    char *name = read_word(r, WORD_TYPED);
    if (!name || *name != '~')
        return name;
    char *path = tilde_expand_word(name);
    name = path ? reader_copy(r, path, strlen(path)) : NULL;
    free(path);
    return name;
}

bool word_is_next(const struct reader *r, const char *word)
{
    size_t n = *r->at == *word ? strlen(word) : 0;
    return n > 0 && strncmp(r->at, word, n) == 0 && !strchr("_.(", r->at[n] ? r->at[n] : ' ') &&
           !isalnum((unsigned char)r->at[n]);
}

/* A names_list (see names.h) that has only one word, which is passed as the context. */
static const char *single_word(const void *word, int k)
{
    return k == 0 ? word : NULL;
}

bool reader_takes(struct reader *r, const char *word)
{
    bool is_next = word_is_next(r, word);
    offer_names(r, single_word, word);
    if (is_next)
        r->at = skip_blanks(r->at + strlen(word));
    return is_next;
}

/* ---- Ends ---- */

bool reader_ends(struct reader *r)
{
    r->at = skip_blanks(r->at);
    return command_ends(r->at) || *r->at == '>' || (r->stops && strchr(r->stops, *r->at)) ||
           word_is_next(r, "with") || (r->details && word_is_next(r, "details"));
}

/* ---- The cursor of a line that is being typed ---- */

void offer_kind(const struct reader *r, enum offer_kind kind)
{
    struct offer *o = reader_offer(r);
    if (o)
        o->kinds |= kind;
}

void offer_names(const struct reader *r, names_list *list, const void *context)
{
    struct offer *o = reader_offer(r);
    for (int i = 0; o && i < o->lists; i++)
        if (o->names[i] == list && o->context[i] == context)
            return;
    if (o && list && o->lists < OFFER_LISTS) {
        o->names[o->lists] = list;
        o->context[o->lists++] = context;
    }
}
