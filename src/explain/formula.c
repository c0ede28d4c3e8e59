/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes the equation of a step: as it is typed, with Greek letters, or in TeX. */
#include "explain/derivation.h"
#include "language/quad.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

void number_write(FILE *out, enum formula_style style, domq_real number, int digits)
{
    char text[WIDE_TEXT];
    quad_write(number, digits, text);
    const char *power = style == FORMULA_TEX ? strchr(text, 'e') : NULL;
    if (power)
        fprintf(out, "%.*s \\cdot 10^{%d}", (int)(power - text), text, atoi(power + 1));
    else
        fputs(text, out);
}

static size_t word_length(const char *text)
{
    size_t n = 0;
    while (isalnum((unsigned char)text[n]) || text[n] == '_')
        n++;
    return n;
}

/* Writes a quantity, by its name or its number, a function or a number of an equation. */
static void word_write(FILE *out, enum formula_style style, const struct step *s, const char *word,
                       size_t length, int digits)
{
    const struct step *needed = NULL;
    for (int k = 0; k < s->count; k++)
        if (strlen(s->needs[k]->name) == length && strncmp(s->needs[k]->name, word, length) == 0)
            needed = s->needs[k];
    const bool is_root = length == 4 && strncmp(word, "sqrt", 4) == 0;
    if (needed && digits > 0 && isfinite(needed->value)) {
        fputs(needed->value < 0 ? "(" : "", out);
        number_write(out, style, needed->value, digits);
        fputs(needed->value < 0 ? ")" : "", out);
    } else if (needed)
        fputs(needed->derived->names.text[style], out);
    else if (style == FORMULA_LETTERS && is_root)
        fputs("√", out);
    else if (style == FORMULA_TEX && *word == 'c' && word[1] == 'e')
        fputs("\\operatorname{ceil}", out);
    else if (style == FORMULA_TEX && isalpha((unsigned char)*word))
        fprintf(out, "\\%s%.*s", *word == 'a' ? "arc" : "", (int)length - (*word == 'a'),
                word + (*word == 'a'));
    else
        fprintf(out, "%.*s", (int)length, word);
}

/* Writes an operator, or a blank. */
static void operator_write(FILE *out, enum formula_style style, char c)
{
    if (c == '*')
        fputs((const char *const[]){"*", "·", " \\cdot "}[style], out);
    else if (c == '-' && style == FORMULA_LETTERS)
        fputs("−", out);
    else
        putc(c, out);
}

void equation_write(FILE *out, enum formula_style style, const struct step *s, int digits)
{
    enum { DEEPEST = 16 };
    bool is_brace[DEEPEST] = {false}; /* in TeX, whether a parenthesis that is open is written as a brace */
    bool opens_brace = false;         /* after a root or a '^' */
    int depth = 0;
    for (const char *c = s->derived->equation; *c;) {
        const size_t length = word_length(c);
        if (length > 0) {
            const bool is_power = opens_brace;
            opens_brace = style == FORMULA_TEX && strncmp(c, "sqrt(", 5) == 0;
            fputs(is_power ? "{" : "", out);
            word_write(out, style, s, c, length, digits);
            fputs(is_power ? "}" : "", out);
            c += length;
            continue;
        }
        if (*c == '(') {
            is_brace[depth++ % DEEPEST] = opens_brace;
            fputs(style != FORMULA_TEX ? "(" : opens_brace ? "{" : "\\left(", out);
        } else if (*c == ')') {
            fputs(style != FORMULA_TEX ? ")" : is_brace[--depth % DEEPEST] ? "}" : "\\right)", out);
        } else
            operator_write(out, style, *c);
        opens_brace = style == FORMULA_TEX && *c == '^';
        c++;
    }
}
