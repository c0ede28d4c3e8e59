/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/wrap.h"
#include "io/terminal.h"
#include <ctype.h>
#include <stdbool.h>
#include <string.h>

/* Returns true if a word of n bytes must stay on the same line as the word after it. For example, no line may
 * be broken within "r = 1.5", "7.5 cm" or "5 %". */
static bool word_joins(const char *word, size_t n)
{
    const char *next = word + n + 1, last = word[n - 1];
    size_t length = strcspn(next, " .,;:)\n");
    bool unit = *next == '%' || (length > 0 && length <= 2 && isalpha((unsigned char)*next));
    bool number = isdigit((unsigned char)*word) != 0;
    return *next == '=' || last == '=' || (number && unit && isdigit((unsigned char)last)) ||
           (number && last == ':' && isdigit((unsigned char)*next));
}

/* Returns the length of the first piece of a string (see wrap.h). */
static size_t piece_length(const char *text)
{
    size_t n = strcspn(text, " \n"), word = 0;
    while (n > word && text[n] == ' ' && word_joins(text + word, n - word)) {
        word = n + 1;
        n = word + strcspn(text + word, " \n");
    }
    return n;
}

size_t line_break(const char *text, int columns)
{
    size_t n = piece_length(text);
    while (n > 1 && (utf8_width(text, n) > columns || ((unsigned char)text[n] & 0xc0) == 0x80))
        n--;
    while (text[n] == ' ') {
        size_t next = n + 1 + piece_length(text + n + 1);
        if (utf8_width(text, next) > columns)
            break;
        n = next;
    }
    return n;
}

void write_wrapped(FILE *out, const char *text, int left, int right)
{
    enum { BELOW = 4 };
    int longest = 0;
    text += strspn(text, " ");
    for (const char *piece = text; *piece && right; piece += *piece != '\0') {
        const size_t n = piece_length(piece);
        const int columns = utf8_width(piece, n);
        longest = columns > longest ? columns : longest;
        piece += n;
    }
    /* If the longest piece does not fit between `left` and `right`, the text begins on the next line, with
     * less indentation. */
    if (right && left > BELOW && left + longest > right) {
        left = BELOW;
        fprintf(out, "\n%*s", left, "");
    }
    while (*text) {
        size_t n = strlen(text);
        if (right) {
            size_t piece = piece_length(text), fitting = line_break(text, right - left);
            n = piece > fitting ? piece : fitting;
        }
        const char *end = text + n + strspn(text + n, " ");
        while (n > 0 && text[n - 1] == ' ')
            n--;
        fwrite(text, 1, n, out);
        bool is_broken = *end != '\0';
        text = end + (*end == '\n');
        if (is_broken)
            fprintf(out, "\n%*s", *text ? left : 0, "");
    }
}
