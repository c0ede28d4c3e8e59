/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/text.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *typed, *plain;
} letters[] = {
    {"θ", "theta"}, {"π", "pi"},       {"τ", "tau"},          {"ω", "omega"},        {"−", "-"}, {"×", "*"},
    {"·", "*"},     {"÷", "/"},        {"²", "^2"},           {"°", "deg"},          {"₀", "0"}, {"₁", "1"},
    {"∞", "inf"},   {"\xc2\xa0", " "}, {"\xe2\x80\xaf", " "}, {"\xef\xbb\xbf", " "}, /* byte order mark */
};

enum { LONGEST = 5 }; /* letters of the longest plain form */

/* Makes the text of a line that is plain already, in the text's own room if that is enough. */
static bool text_plain(struct text *text, size_t length)
{
    text->line = length < sizeof text->own ? text->own : malloc(length + 1);
    if (!text->line)
        return false;
    memcpy(text->line, text->typed, length);
    text->line[length] = '\0';
    return true;
}

bool text_make(struct text *text, const char *typed, size_t length)
{
    size_t size = length + 1, n = 0;
    int column = 0;
    text->typed = typed;
    text->column = text->from = NULL;
    for (size_t i = 0; i < length; i++)
        size += (unsigned char)typed[i] >= 0x80 ? LONGEST : 0;
    if (size == length + 1)
        return text_plain(text, length);
    text->line = malloc(size);
    text->column = malloc(size * sizeof *text->column);
    text->from = malloc(size * sizeof *text->from);
    if (!text->line || !text->column || !text->from) {
        text_free(text);
        return false;
    }
    for (size_t i = 0; i < length;) {
        const char *plain = NULL;
        size_t taken = 1;
        for (size_t k = 0; (unsigned char)typed[i] >= 0x80 && k < sizeof letters / sizeof *letters && !plain;
             k++) {
            size_t bytes = strlen(letters[k].typed);
            if (bytes <= length - i && memcmp(typed + i, letters[k].typed, bytes) == 0) {
                plain = letters[k].plain;
                taken = bytes;
            }
        }
        column += ((unsigned char)typed[i] & 0xc0) != 0x80;
        const char *from = plain ? plain : typed + i;
        for (size_t k = 0, bytes = plain ? strlen(plain) : 1; k < bytes; k++) {
            text->column[n] = column;
            text->from[n] = (int)i;
            text->line[n++] = from[k];
        }
        i += taken;
    }
    text->line[n] = '\0';
    text->column[n] = column + 1;
    text->from[n] = (int)length;
    return true;
}

void text_free(struct text *text)
{
    if (text->line != text->own)
        free(text->line);
    free(text->column);
    free(text->from);
}

ssize_t text_read(char **line, size_t *size, FILE *in)
{
    enum { LEAST = 256 };
    size_t n = 0;
    int c = 0;
    bool nul = false;
    while (!(nul && n > TEXT_MOST) && (c = getc_unlocked(in)) != EOF && c != '\n') {
        nul = nul || c == '\0';
        if (n + 1 >= *size && n <= TEXT_MOST) {
            size_t larger = *size ? 2 * *size : LEAST;
            char *more = realloc(*line, larger);
            if (!more)
                return -1;
            *line = more;
            *size = larger;
        }
        if (n <= TEXT_MOST)
            (*line)[n++] = (char)c;
    }
    if (c == EOF && (n == 0 || ferror(in)))
        return -1;
    if (*size == 0 && !(*line = malloc(*size = LEAST)))
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

/* Returns true if the letter is one of these, which are few. */
static bool is_among(char letter, const char *all)
{
    while (*all && *all != letter)
        all++;
    return *all != '\0';
}

const char *text_end(const char *c, const char *ends)
{
    for (const char *begin = c; *c && !is_among(*c, ends);) {
        if (*c == '#' && (c == begin || isspace((unsigned char)c[-1])))
            break;
        const char *next = *c == '"' ? text_quote(c) : c + 1;
        c = next ? next : c + strlen(c);
    }
    return c;
}

bool text_continues(char *line)
{
    size_t n = strlen(line);
    while (n > 0 && (line[n - 1] == ' ' || line[n - 1] == '\t' || line[n - 1] == '\r'))
        n--;
    if (n == 0 || line[n - 1] != '\\' || *text_end(line, "") == '#')
        return false;
    line[n - 1] = '\0';
    return true;
}

int text_column(const struct text *text, const char *place)
{
    size_t at = (size_t)(place - text->line);
    return text->column ? text->column[at] : (int)at + 1;
}

const char *text_typed(const struct text *text, const char *place)
{
    size_t at = (size_t)(place - text->line);
    return text->typed + (text->from ? (size_t)text->from[at] : at);
}
