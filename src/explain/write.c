/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes derivations, with the equations as they are typed or with Greek letters. */
#include "explain/derivation.h"
#include "io/terminal.h"
#include "language/quad.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Equations ---- */

static const char *name_of(const struct step *s, bool letters)
{
    return letters ? s->derived->letters : s->derived->name;
}

/* Writes a number in the form that the parser accepts. */
static void number_write(FILE *out, domq_real number, int digits)
{
    char text[WIDE_TEXT];
    quad_write(number, digits, text);
    fputs(text, out);
}

/* Writes the equation of a step, or the term of a sum, with names or, if `digits` is not 0, with numbers. */
static void equation_write(FILE *out, const struct step *s, bool letters, int digits)
{
    for (const char *c = s->derived->equation; *c;) {
        size_t length = 0;
        const struct step *needed = NULL;
        while (isalnum((unsigned char)c[length]) || c[length] == '_')
            length++;
        for (int k = 0; k < s->count && length > 0; k++)
            if (strlen(s->needs[k]->name) == length && strncmp(s->needs[k]->name, c, length) == 0)
                needed = s->needs[k];
        if (needed && digits > 0 && isfinite(needed->value)) {
            fputs(needed->value < 0 ? "(" : "", out);
            number_write(out, needed->value, digits);
            fputs(needed->value < 0 ? ")" : "", out);
        } else if (needed)
            fputs(name_of(needed, letters), out);
        else if (letters && length == 4 && strncmp(c, "sqrt", 4) == 0)
            fputs("√", out);
        else if (letters && (*c == '*' || *c == '-'))
            fputs(*c == '*' ? "·" : "−", out);
        else
            fprintf(out, "%.*s", (int)(length > 0 ? length : 1), c);
        c += length > 0 ? length : 1;
    }
}

void step_numbers(FILE *out, const struct step *s, bool letters, int digits)
{
    domq_real rest = 0;
    if (!s->derived->sum) {
        equation_write(out, s, letters, digits);
        return;
    }
    for (size_t i = s->terms; i-- > TERMS_SHOWN;)
        rest += s->term[i];
    for (size_t i = 0; i < s->terms && i <= TERMS_SHOWN; i++) {
        const domq_real term = i < TERMS_SHOWN ? s->term[i] : rest;
        fputs(i == 0 && term >= 0 ? "" : term < 0 ? (i ? " - " : "-") : " + ", out);
        number_write(out, quad(fabs)(term), digits);
    }
}

/* ---- The whole derivation ---- */

/* A derivation, and the form in which to write it. */
struct writer {
    const struct derivation *derivation;
    const struct explained *explained;
    const struct explain_arguments *bound;
    FILE *out;
    bool letters;
    int digits;
};

/* Each number is the result of a few dozen operations. So its rounding error is at most a few dozen machine
 * epsilons times the largest number in its equation. A value that is smaller than ROUNDINGS machine epsilons
 * times this largest number is written as 0. */
#define ROUNDINGS 64

/* Returns true if a value differs from 0 only by rounding errors, like the margin at the largest growth. */
static bool is_rounding(const struct writer *w, const struct step *s)
{
    domq_real largest = 0;
    for (int k = 0; k < s->count; k++)
        if (isfinite(s->needs[k]->value))
            largest = quad_larger(largest, quad(fabs)(s->needs[k]->value));
    const enum precision precision = w->derivation->query.scene->compute.precision;
    return s->value != 0 &&
           quad(fabs)(s->value) <= ROUNDINGS * (domq_real)any_arithmetic(precision).epsilon * largest;
}

static void value_write(const struct writer *w, const struct step *s)
{
    if (!isfinite(s->value))
        fputs("no value: this train has no complete cycle; 'why' says more", w->out);
    else if (is_rounding(w, s))
        fputc('0', w->out);
    else if (strcmp(s->name, "r_max") == 0 || strcmp(s->name, "r_pair") == 0)
        fputs(quad_limit(s->value, w->digits), w->out);
    else
        number_write(w->out, s->value, w->digits);
    if (isfinite(s->value) && *s->unit)
        fprintf(w->out, " %s", s->unit);
}

/* Writes one quantity: its description, its equation, the equation with numbers, and its value. */
static void step_write(const struct writer *w, const struct step *s)
{
    FILE *out = w->out;
    const char *words = s->words;
    if (words[strspn(words, "abcdefghijklmnopqrstuvwxyz")] != '^') /* a symbol, such as tau^2 */
        putc(toupper((unsigned char)*words++), out);
    fprintf(out, "%s:\n    %s = ", words, name_of(s, w->letters));
    if (s->tree) {
        fputs(!s->derived->sum ? "" : w->letters ? "Σ " : "sum over i of ", out);
        equation_write(out, s, w->letters, 0);
        if (*s->reference)
            fprintf(out, "    (%s)", s->reference);
        fputs("\n      = ", out);
        if (s->tree->kind != TREE_SYMBOL) { /* the number of a symbol is the value, which follows */
            step_numbers(out, s, w->letters, w->digits);
            fputs("\n      = ", out);
        }
    }
    value_write(w, s);
    putc('\n', out);
}

/* Writes a quantity that is named but not derived. */
static void meaning_write(const struct writer *w, const struct step *s)
{
    fprintf(w->out, "    %s", name_of(s, w->letters));
    if (isfinite(s->value)) { /* a quantity that is different in each term has no single value */
        fputs(" = ", w->out);
        value_write(w, s);
    }
    fprintf(w->out, ": %s\n", s->words);
}

/* Writes the meanings and values of the quantities that the equations of the answer contain. */
static void meanings_write(const struct writer *w)
{
    const struct derivation *d = w->derivation;
    const domq_real value = w->bound->value;
    bool has_equations = false;
    for (int k = 0; k < d->count; k++)
        if (d->step[k].depth == 1) {
            has_equations = has_equations || !d->step[k].derived->is_given;
            meaning_write(w, &d->step[k]);
        }
    if (has_equations)
        fprintf(w->out, "\n'explain %s%s%s deep' also shows the equations for these quantities.\n",
                w->explained->name, isnan(value) ? "" : " ", isnan(value) ? "" : quad_text(value, 10));
}

/* Domino i has the weight S_i in the sum of the equations of motion, so that the contact forces cancel. */
static const char *const losses[] = {
    "(A/2) dw/dtheta + B w = C",          "A = sum r^(-(q+1) i) S_i theta_i'",
    "B = sum r^(-(q+1) i) S_i theta_i''", "C = 1/2 sum r^(-q i) S_i (x_i - d y_i)",
    "S_0 = 1, S_(i+1) = S_i a_i/b_i",     NULL};

/* Writes the equations of an effect or of a law of motion. */
static void effect_write(const struct writer *w, const char *name, const char *const *line)
{
    if (line)
        fprintf(w->out, "\n%s:\n", name);
    for (; line && *line; line++)
        fprintf(w->out, "    %s\n", *line);
}

/* Writes the equations of the answer or, on request, of all quantities. If the derivation ends because of an
 * effect, the equations of the law of motion and of the effects that are on follow. */
static void equations_write(const struct writer *w)
{
    const struct derivation *d = w->derivation;
    const struct scene *scene = &d->state.scene;
    int given = 0, written = 0;
    bool ends = false;
    for (int k = 0; k < d->count; k++) {
        const struct step *s = &d->step[k];
        ends = ends || (s->derived->ends & d->has & (HAS_LOSS | HAS_EDGES)) != 0;
        if (s->derived->is_given || (s->depth > 0 && !w->bound->deep))
            continue;
        fputs(written++ ? "\n" : "", w->out);
        step_write(w, s);
    }
    for (int k = 0; k < d->count && w->bound->deep; k++)
        if (d->step[k].derived->is_given) {
            fputs(given++ ? "" : "\ngiven:\n", w->out);
            meaning_write(w, &d->step[k]);
        }
    if (ends && domq_dissipates(&scene->train))
        effect_write(w, "equation of motion", losses);
    for (int k = 0; k < DOM_DYNAMICS_COUNT && ends; k++)
        if (scene->effect[k].on) {
            char name[40];
            snprintf(name, sizeof name, "with %s", effect_at(k)->name);
            effect_write(w, name, effect_at(k)->equations);
        }
}

bool explain_write(struct answer *a, const struct derivation *d, const struct explained *e,
                   const struct explain_arguments *bound, struct problem *problem)
{
    answer_plan(a, NULL);
    struct writer w = {.derivation = d,
                       .explained = e,
                       .bound = bound,
                       .letters = a->layout.letters,
                       .digits = (int)a->style.digits};
    /* What the symbols mean is left to the details. */
    FILE *const to[] = {a->out, bound->deep ? NULL : answer_rest(a)};
    for (int k = 0; k < 2 && to[k]; k++) {
        char *text = NULL;
        size_t size;
        w.out = open_memstream(&text, &size);
        if (w.out)
            (k == 0 ? equations_write : meanings_write)(&w);
        if (!w.out || fclose(w.out) != 0) {
            free(text);
            return problem_status(problem, d->query.scene, DOM_NO_MEMORY);
        }
        char *line = text;
        for (char *end; (end = strchr(line, '\n')); line = end + 1) {
            *end = '\0';
            const int indent = (int)strspn(line, " ");
            if (k == 0 && line == text) { /* the first line begins the answer */
                answer_say(a, "%s", line);
                continue;
            }
            fprintf(to[k], "%*s", indent, "");
            write_wrapped(to[k], line + indent, indent, a->layout.width); /* lines keep their indentation */
            putc('\n', to[k]);
        }
        free(text);
    }
    return true;
}
