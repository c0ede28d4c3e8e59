/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/text.h"
#include <ctype.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *typed, *plain;
} letters[] = {
    {"θ", "theta"}, {"π", "pi"},       {"τ", "tau"},          {"ω", "omega"},        {"−", "-"}, {"×", "*"},
    {"·", "*"},     {"÷", "/"},        {"²", "^2"},           {"°", "deg"},          {"₀", "0"}, {"₁", "1"},
    {"∞", "inf"},   {"\xc2\xa0", " "}, {"\xe2\x80\xaf", " "}, {"\xef\xbb\xbf", " "}, /* the byte order mark */
};

enum { PLAIN_MOST = 5 }; /* the length of the longest names, "theta" and "omega" */

/* Converts the first character of the string `typed`, which has `size` bytes. If the character is in the
 * table `letters`, returns its ASCII text. Otherwise copies only the first byte of the character to `byte`,
 * and returns `byte`. In both cases, stores in *length how many bytes of `typed` have been converted. */
static const char *plain_form(const char *typed, size_t size, char byte[2], size_t *length)
{
    for (size_t k = 0; (unsigned char)*typed >= 0x80 && k < sizeof letters / sizeof *letters; k++) {
        *length = strlen(letters[k].typed);
        if (*length <= size && memcmp(typed, letters[k].typed, *length) == 0)
            return letters[k].plain;
    }
    *length = 1;
    byte[0] = *typed;
    byte[1] = '\0';
    return byte;
}

bool text_make(struct text *text, const char *typed, size_t length)
{
    size_t size = length + 1, n = 0, taken;
    int column = 0;
    for (size_t i = 0; i < length; i++)
        size += (unsigned char)typed[i] >= 0x80 ? PLAIN_MOST : 0;
    bool is_ascii = size == length + 1;
    *text = (struct text){.typed = typed,
                          .line = malloc(size),
                          .origin = is_ascii ? NULL : malloc(size * sizeof *text->origin)};
    if (!text->line || (!text->origin && !is_ascii)) {
        text_free(text);
        return false;
    }
    if (is_ascii) {
        memcpy(text->line, typed, length);
        text->line[length] = '\0';
        return true;
    }
    for (size_t i = 0; i < length; i += taken) {
        char byte[2];
        const char *plain = plain_form(typed + i, length - i, byte, &taken);
        column += ((unsigned char)typed[i] & 0xc0) != 0x80;
        do { /* not a while loop, so that a typed NUL byte is copied too */
            text->origin[n] = (struct origin){column, (int)i};
            text->line[n++] = *plain;
        } while (*plain && *++plain);
    }
    text->origin[n] = (struct origin){column + 1, (int)length};
    text->line[n] = '\0';
    return true;
}

void text_free(struct text *text)
{
    free(text->line);
    free(text->origin);
}

ssize_t text_read(char **line, size_t *size, FILE *in)
{
    size_t n = 0;
    int c = 0;
    /* If a line is too long and contains a NUL byte, the remainder of the line is not read. The input may
     * come from a device such as /dev/zero, which never ends. */
    for (bool has_nul = false; !(has_nul && n > TEXT_MOST);) {
        if (n + 1 >= *size) {
            size_t larger = *size ? 2 * *size : 256;
            char *more = realloc(*line, larger);
            if (!more)
                return -1;
            *line = more;
            *size = larger;
        }
        if ((c = getc_unlocked(in)) == EOF || c == '\n')
            break;
        has_nul = has_nul || c == '\0';
        if (n <= TEXT_MOST)
            (*line)[n++] = (char)c;
    }
    if (c == EOF && (n == 0 || ferror(in)))
        return -1;
    (*line)[n] = '\0';
    return (ssize_t)n;
}

const char *skip_blanks(const char *c)
{
    while (*c == ' ' || (*c >= '\t' && *c <= '\r' && *c != '\n'))
        c++;
    return c;
}

const char *text_quote(const char *c)
{
    while ((c = strchr(c + 1, '"')) != NULL && *++c == '"')
        ;
    return c;
}

const char *text_end(const char *c, const char *ends)
{
    char stops[8] = "#\"";
    strncat(stops, ends, sizeof stops - sizeof "#\"");
    for (const char *begin = c; *(c += strcspn(c, stops));) {
        /* A '#' begins a comment only at the beginning of the text or after a blank. */
        if (strchr(ends, *c) || (*c == '#' && (c == begin || isspace((unsigned char)c[-1]))))
            break;
        const char *next = *c == '"' ? text_quote(c) : c + 1;
        c = next ? next : c + strlen(c);
    }
    return c;
}

void text_add(char *text, size_t size, const char *format, ...)
{
    size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + used, size - used, format, arguments);
    va_end(arguments);
}

const char *text_typed(const struct text *text, const char *place)
{
    return text->typed + (text->origin ? text->origin[place - text->line].offset : place - text->line);
}

/* ---- Memory ---- */

struct arena_block {
    struct arena_block *before;
    _Alignas(max_align_t) unsigned char bytes[];
};

enum { BLOCK = 1000 }; /* the size of a block; malloc is fastest for blocks of up to 1 KB */

void *arena_take(struct arena *arena, size_t size)
{
    const size_t align = _Alignof(max_align_t);
    size = (size + align - 1) / align * align;
    if (!arena->block || size > arena->size - arena->used) {
        size_t room = size > BLOCK ? size : BLOCK;
        struct arena_block *block = malloc(sizeof *block + room);
        if (!block)
            return NULL;
        block->before = arena->block;
        arena->block = block;
        arena->used = 0;
        arena->size = room;
    }
    unsigned char *bytes = arena->block->bytes + arena->used;
    arena->used += size;
    return memset(bytes, 0, size);
}

void arena_free(struct arena *arena)
{
    while (arena->block) {
        struct arena_block *before = arena->block->before;
        free(arena->block);
        arena->block = before;
    }
    *arena = (struct arena){.block = NULL};
}
