/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes derivations as text and as TeX documents. */
#include "answer/extension.h"
#include "answer/wrap.h"
#include "explain/derivation.h"
#include "io/escape.h"
#include "language/quad.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static void step_symbols(FILE *out, enum formula_style style, const struct step *s)
{
    static const char *const sums[FORMULA_STYLES] = {"sum over i of ", "Σ ", "\\sum_i "};
    fputs(s->derived->sum ? sums[style] : "", out);
    equation_write(out, style, s, 0);
}

static void terms_write(FILE *out, enum formula_style style, const struct step *s, int digits, size_t shown)
{
    domq_real rest = 0;
    for (size_t i = s->terms; i-- > shown;)
        rest += s->term[i];
    for (size_t i = 0; i < s->terms && i < shown; i++) {
        fputs(i == 0 && s->term[i] >= 0 ? "" : s->term[i] < 0 ? (i ? " - " : "-") : " + ", out);
        number_write(out, style, quad(fabs)(s->term[i]), digits);
    }
    if (s->terms > shown) {
        fputs(rest < 0 ? " - " : " + ", out);
        number_write(out, style, quad(fabs)(rest), digits);
    }
}

void step_numbers(FILE *out, enum formula_style style, const struct step *s, int digits)
{
    if (s->derived->sum)
        terms_write(out, style, s, digits, TERMS_SHOWN);
    else
        equation_write(out, style, s, digits);
}

/* ---- The whole derivation ---- */

/* The texts before, between and after the equations of a derivation. */
enum piece { HEADING, OPEN, EQUALS, JOIN, CLOSE, GIVEN, LIST, ITEM, MEANING, END, NO_VALUE };

static const char *const texts[][2] = {
    /* as text, and in TeX */
    [HEADING] = {":\n", ":\n\n"},
    [OPEN] = {"    ", "\\[\n\\begin{aligned}\n"},
    [EQUALS] = {" = ", " &= "},
    [JOIN] = {"\n      = ", " \\\\\n&= "},
    [CLOSE] = {"", "\\end{aligned}\n\\]\n"},
    [GIVEN] = {"given:\n", "Given:\n\n"},
    [LIST] = {"", "\\begin{itemize}\n"},
    [ITEM] = {"    ", "\\item $"},
    [MEANING] = {": ", "$: "},
    [END] = {"", "\\end{itemize}\n"},
    [NO_VALUE] = {"no value: this train has no complete cycle; 'why' says more", "\\text{no value}"},
};

/* A derivation, and the form in which to write it. */
struct writer {
    const struct derivation *derivation;
    FILE *out;
    enum formula_style style;
    int digits;
    domq_real value; /* the value that the user typed after the question, or NaN */
};

static void put(const struct writer *w, enum piece text)
{
    fputs(texts[text][w->style == FORMULA_TEX], w->out);
}

static void words_write(const struct writer *w, const char *words)
{
    char piece[ESCAPE_PIECE];
    for (const char *c = words; *c; c++)
        if (w->style == FORMULA_TEX)
            fputs(escape_tex(*c, piece), w->out);
        else
            putc(*c, w->out);
}

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

/* Writes a value with its unit, which TeX sets in upright letters. */
static void value_write(const struct writer *w, const struct step *s)
{
    FILE *out = w->out;
    if (!isfinite(s->value)) {
        put(w, NO_VALUE);
        return;
    }
    if (is_rounding(w, s))
        putc('0', out);
    else if (strcmp(s->name, "r_max") == 0 || strcmp(s->name, "r_pair") == 0)
        fputs(quad_limit(s->value, w->digits), out);
    else
        number_write(w->out, w->style, s->value, w->digits);
    if (*s->unit)
        fprintf(out, w->style == FORMULA_TEX ? "\\,\\mathrm{%s}" : " %s", s->unit);
}

/* Writes one quantity: its description, its equation, the equation with numbers, and its value. */
static void step_write(const struct writer *w, const struct step *s)
{
    FILE *out = w->out;
    const char *words = s->words;
    if (words[strspn(words, "abcdefghijklmnopqrstuvwxyz")] != '^') /* a symbol, such as tau^2 */
        putc(toupper((unsigned char)*words++), out);
    words_write(w, words);
    if (w->style == FORMULA_TEX && *s->reference)
        fprintf(out, " (%s)", s->reference);
    put(w, HEADING);
    put(w, OPEN);
    fputs(s->derived->names.text[w->style], out);
    put(w, EQUALS);
    if (s->tree) {
        step_symbols(out, w->style, s);
        if (w->style != FORMULA_TEX && *s->reference)
            fprintf(out, "    (%s)", s->reference);
        put(w, JOIN);
        if (s->tree->kind != TREE_SYMBOL) { /* the number of a symbol is the value, which follows */
            step_numbers(out, w->style, s, w->digits);
            put(w, JOIN);
        }
    }
    value_write(w, s);
    putc('\n', out);
    put(w, CLOSE);
}

/* Writes a list of quantities that are named but not derived. */
static void list_write(const struct writer *w, const struct step *const *list, int count)
{
    FILE *out = w->out;
    put(w, LIST);
    for (int k = 0; k < count; k++) {
        put(w, ITEM);
        fputs(list[k]->derived->names.text[w->style], out);
        if (isfinite(list[k]->value)) { /* a quantity that is different in each term has no single value */
            fputs(" = ", out);
            value_write(w, list[k]);
        }
        put(w, MEANING);
        words_write(w, list[k]->words);
        putc('\n', out);
    }
    put(w, END);
}

/* Writes the meanings and values of the quantities that the equations of the answer contain. */
static void meanings_write(const struct writer *w, const struct explained *e)
{
    const struct derivation *d = w->derivation;
    const struct step *needed[STEPS_MOST];
    int count = 0;
    bool has_equations = false;
    for (int k = 0; k < d->count; k++)
        if (d->step[k].depth == 1) {
            has_equations = has_equations || !d->step[k].derived->is_given;
            needed[count++] = &d->step[k];
        }
    list_write(w, needed, count);
    if (has_equations && w->style != FORMULA_TEX)
        fprintf(w->out, "\n'explain %s%s%s deep' also shows the equations for these quantities.\n", e->name,
                isnan(w->value) ? "" : " ", isnan(w->value) ? "" : quad_text(w->value, 10));
}

/* Writes the equations of the answer or, if `deep` is true, of all quantities. */
static void equations_write(const struct writer *w, bool deep)
{
    const struct step *given[STEPS_MOST];
    int count = 0, written = 0;
    for (int k = 0; k < w->derivation->count; k++) {
        const struct step *s = &w->derivation->step[k];
        if (s->derived->is_given)
            given[count++] = s;
        if (s->derived->is_given || (s->depth > 0 && !deep))
            continue;
        if (written++)
            putc('\n', w->out);
        step_write(w, s);
    }
    if (deep && count > 0) {
        putc('\n', w->out);
        put(w, GIVEN);
        list_write(w, given, count);
    }
}

/* Writes the equations of an effect or of a law of motion. */
static void effect_write(const struct writer *w, const char *with, const struct domq_effect *e)
{
    if (!e->equations)
        return;
    fprintf(w->out, "\n%s%s", w->style == FORMULA_TEX ? "\\medskip\n" : "", with);
    words_write(w, e->name);
    fputs(w->style == FORMULA_TEX ? ":\\\\\n" : ":\n", w->out);
    for (const char *const *line = e->equations; *line; line++) {
        fputs(w->style == FORMULA_TEX ? "\\hspace*{2em}" : "    ", w->out);
        words_write(w, *line);
        fputs(w->style == FORMULA_TEX ? "\\\\\n" : "\n", w->out);
    }
}

/* If the derivation ends because of an effect, writes the equations of the law of motion and of the effects
 * that are on. */
static void effects_write(const struct writer *w)
{
    const struct derivation *d = w->derivation;
    const struct scene *scene = &d->state->scene;
    bool ends = false;
    for (int k = 0; k < d->count; k++)
        ends = ends || (d->step[k].derived->ends & d->has & (HAS_LOSS | HAS_EDGES)) != 0;
    if (!ends)
        return;
    effect_write(w, "", domq_law(&scene->train));
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        if (scene->effect[k].on)
            effect_write(w, "with ", effect_at(k));
}

/* Writes a lesson in TeX. */
static void document_write(const struct writer *w, const struct explained *e, bool deep)
{
    FILE *out = w->out;
    fprintf(out,
            "\\documentclass{article}\n\\usepackage{amsmath}\n\\setlength{\\parindent}{0pt}\n"
            "\\begin{document}\n\\section*{Where %s comes from}\n\n",
            e->name);
    equations_write(w, deep);
    if (!deep) {
        fputs("\nwith\n\n", out);
        meanings_write(w, e);
    }
    effects_write(w);
    fputs("\\end{document}\n", out);
}

/* Writes lines of text so that they fit the terminal. Broken lines keep their indentation. */
static void lines_write(FILE *out, char *text, int width)
{
    for (char *line = text, *end; (end = strchr(line, '\n')); line = end + 1) {
        const int indent = (int)strspn(line, " ");
        *end = '\0';
        fprintf(out, "%*s", indent, "");
        write_wrapped(out, line + indent, indent, width);
        putc('\n', out);
    }
}

/* Writes a derivation as plain text that fits the terminal. What the symbols mean is left to the details. */
static bool text_write(struct writer *w, const struct explained *e, bool deep, struct answer *a,
                       struct problem *problem)
{
    FILE *const to[] = {a->out, deep ? NULL : answer_rest(a)};
    for (int k = 0; k < 2 && to[k]; k++) {
        char *text = NULL;
        size_t size;
        w->out = open_memstream(&text, &size);
        if (w->out && k == 0) {
            equations_write(w, deep);
            effects_write(w);
        } else if (w->out)
            meanings_write(w, e);
        const bool whole = w->out && fclose(w->out) == 0;
        if (whole && k == 0)
            answer_say(a, "%s", strtok(text, "\n")); /* the first line begins the answer */
        if (whole)
            lines_write(to[k], k == 0 ? text + strlen(text) + 1 : text, a->layout.width);
        free(text);
        if (!whole)
            return problem_status(problem, w->derivation->query.scene, DOM_NO_MEMORY);
    }
    return true;
}

bool explain_write(struct answer *a, const struct derivation *d, const struct explained *e,
                   const struct explain_arguments *bound, struct problem *problem)
{
    const bool is_document = a->path && extension_of(a->path)->is_document;
    struct writer w = {.derivation = d, .digits = (int)a->style.digits, .value = bound->value};
    answer_plan(a, NULL);
    w.out = a->out;
    w.style = is_document ? FORMULA_TEX : a->layout.letters ? FORMULA_LETTERS : FORMULA_PLAIN;
    if (is_document) {
        document_write(&w, e, bound->deep);
        return true;
    }
    return text_write(&w, e, bound->deep, a, problem);
}
