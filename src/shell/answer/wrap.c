/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/wrap.h"
#include <ctype.h>
#include <stdbool.h>
#include <string.h>

/* Returns true if a word of n bytes stays in one line with the next one: "r = 1.5", "7.5 cm", "5 %",
 * "2: 0.14". */
static bool word_joins(const char *word, size_t n)
{
    const char *next = word + n + 1, last = word[n - 1];
    size_t length = strcspn(next, " .,;:)\n");
    bool unit = *next == '%' || (length > 0 && length <= 2 && isalpha((unsigned char)*next));
    bool number = isdigit((unsigned char)*word) != 0;
    return *next == '=' || last == '=' || (number && unit && isdigit((unsigned char)last)) ||
           (number && last == ':' && isdigit((unsigned char)*next));
}

static size_t line_piece(const char *text)
{
    size_t n = strcspn(text, " "), word = 0;
    while (n > word && text[n] == ' ' && word_joins(text + word, n - word)) {
        word = n + 1;
        n = word + strcspn(text + word, " ");
    }
    return n;
}

static int columns_of(const char *text, size_t length)
{
    int columns = 0;
    for (size_t i = 0; i < length; i++)
        columns += ((unsigned char)text[i] & 0xc0) != 0x80;
    return columns;
}

size_t line_break(const char *text, int columns)
{
    size_t end = strcspn(text, "\n"), at = line_piece(text);
    at = at < end ? at : end;
    while (at > 1 && columns_of(text, at) > columns) /* a piece that is longer than a line is broken itself */
        at--;
    while (at > 1 && ((unsigned char)text[at] & 0xc0) == 0x80)
        at--;
    while (at < end && text[at] == ' ') {
        size_t next = at + 1 + line_piece(text + at + 1);
        next = next < end ? next : end;
        if (columns_of(text, next) > columns)
            break;
        at = next;
    }
    return at;
}

/* Returns the columns that the longest piece of a text takes. */
static int longest_piece(const char *text)
{
    int longest = 0;
    for (size_t n; *text; text += n + (text[n] == ' ')) {
        n = line_piece(text);
        int columns = columns_of(text, n);
        longest = columns > longest ? columns : longest;
    }
    return longest;
}

void write_blanks(FILE *out, int blanks)
{
    static const char some[] = "                                ";
    for (int n; blanks > 0; blanks -= n) {
        n = blanks < (int)sizeof some - 1 ? blanks : (int)sizeof some - 1;
        fwrite(some, 1, (size_t)n, out);
    }
}

/* Writes a text that has no end on the right, as its words would be: no blanks before it, one fewer after it.
 */
static void write_whole(FILE *out, const char *text)
{
    text += strspn(text, " ");
    size_t length = strlen(text);
    fwrite(text, 1, length > 0 && text[length - 1] == ' ' ? length - 1 : length, out);
}

void write_wrapped(FILE *out, const char *text, int left, int right)
{
    enum { BELOW = 4 }; /* where text begins that has too little room beside what is before it */
    if (!right) {
        write_whole(out, text);
        return;
    }
    if (left > BELOW && left + longest_piece(text) > right) {
        left = BELOW;
        fprintf(out, "\n%*s", left, "");
    }
    int at = left;
    while (*text) {
        size_t length = line_piece(text);
        int columns = columns_of(text, length);
        if (at > left && at + 1 + columns > right) {
            fprintf(out, "\n%*s", left, "");
            at = left;
        }
        if (at > left)
            putc(' ', out);
        at += columns + (at > left);
        fwrite(text, 1, length, out);
        text += length + (text[length] == ' ');
    }
}
