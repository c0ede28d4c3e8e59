/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'explain', which shows where a number comes from. */
#include "domino_proof.h"
#include "explain/derivation.h"
#include "interpreter/question.h"
#include "language/quad.h"
#include "language/text.h"
#include "train/train.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static const struct column explain_columns[] = {
    {"quantity", "", "the quantity", 9},
    {"equation", "",
     "the equation for the quantity, as one would type it; 'sum' stands for the sum over all dominoes i", 40},
    {"numbers", "", "the equation with numbers; for a sum, its first terms and the sum of the others", 40},
    {"value", "", "the number that the program computes", 0},
    {"unit", "", "the unit of the value: h is the height of the head, mgh/2 its energy, tau its unit of time",
     6},
    {"needs", "", "the quantities that the equation contains", 16},
    {"reference", "", "the number and the label of the equation in the paper", 9},
    {"depth", "", "the number of equations on the shortest path from this quantity to the answer", 5},
    {"meaning", "", "what the quantity is and, if it has no equation, why not", 40},
    {NULL, NULL, NULL, 0},
};

/* ---- Arguments ---- */

/* The arguments after the name of the question. */
struct explain_arguments {
    domq_real value; /* the value after the question, or NaN if there is none */
    bool deep;
};

struct explain_parsed {
    struct item value;
    bool deep;
};

static const char *deep_names(const void *context, int k)
{
    (void)context;
    return k == 0 ? "deep" : NULL;
}

/* Returns true if the word can be the number or the label of an equation, such as 24, c6 or A18. */
static bool is_label(const char *word, size_t length)
{
    const size_t letters = isalpha((unsigned char)*word) ? 1 : 0;
    return length > letters && length <= 3 && strspn(word + letters, "0123456789") >= length - letters;
}

/* Parses the name of a command, or an equation of the paper, as in 'explain c6' and 'explain 24', which may
 * be in parentheses. */
static bool what_parse(struct reader *r, struct question *q)
{
    static const struct argument what = {
        .name = "WHAT", .kind = ARGUMENT_CHOICE, .noun = "question", .choices = explained_names};
    struct item *item = &q->item[0];
    const bool opens = *r->at == '(';
    const char *begin = r->at + opens;
    const size_t length = strcspn(begin, " \t\r\f\v);>#");
    if (r->offer || !is_label(begin, length)) {
        if (item_parse(r, &what, item))
            return true;
        if (strstr(r->problem->text, "use one of"))
            text_add(r->problem->text, sizeof r->problem->text,
                     "; an equation is named by its label in the paper, as in 'explain c7'");
        return false;
    }
    *item = (struct item){.at = r->at};
    reader_place(r, r->at);
    r->at = begin + length + (opens && begin[length] == ')');
    int number = atoi(begin);
    for (const struct explained *e = explained_list; e->name; e++)
        if (e->needs != COMMAND &&
            (--number == 0 || (strlen(e->name) == length && strncmp(e->name, begin, length) == 0))) {
            item->number = e - explained_list;
            return true;
        }
    return problem_error(r->problem,
                         "the paper has no equation (%.*s), only (1; a1) to (59; e8), which 'man "
                         "domino-model' lists",
                         (int)length, begin);
}

static const struct argument *value_argument(const struct explained *e)
{
    static const struct argument tilt = {.name = "VALUE", .kind = ARGUMENT_TILT},
                                 separation = {.name = "VALUE", .kind = ARGUMENT_VALUE_OF, .parameter = "s"},
                                 height = {.name = "VALUE", .kind = ARGUMENT_HEIGHT};
    return !e->value                        ? NULL
           : strcmp(e->value, "theta") == 0 ? &tilt
           : strcmp(e->value, "s") == 0     ? &separation
                                            : &height;
}

static bool explain_parse(struct reader *r, struct question *q)
{
    static const struct argument deep = {
        .name = "deep", .kind = ARGUMENT_CHOICE, .noun = "word", .choices = deep_names};
    const struct explained *e = &explained_list[(int)q->item[0].number];
    struct explain_parsed *p = q->parsed = reader_memory(r, sizeof *p);
    struct item word;
    if (!p)
        return false;
    offer_names(r, deep_names, NULL);
    if (e->value && !reader_ends(r) && !word_is_next(r, "deep")) {
        if (!item_parse(r, value_argument(e), &p->value))
            return false;
    }
    reader_place(r, r->at);
    if (reader_ends(r))
        return true;
    p->deep = true;
    return item_parse(r, &deep, &word);
}

static bool explain_bind(const struct question *q, const struct query *query, struct arguments *given,
                         struct problem *problem)
{
    const struct explain_parsed *parsed = q->parsed;
    struct explain_arguments *b = arguments_take(given, sizeof *b, query, problem);
    if (!b)
        return false;
    b->deep = parsed->deep;
    b->value = DOMQ_NAN;
    return !parsed->value.argument || item_bind(&parsed->value, q->text, query, NULL, &b->value, problem);
}

/* ---- Texts ---- */

enum { EQUATION_TEXT = 2000 }; /* an equation has at most NEEDS_MOST numbers */

static const char *name_of(const struct step *s, bool letters)
{
    return letters ? s->derived->letters : s->derived->name;
}

/* Appends a number in the form that the parser accepts. */
static void number_add(char *text, domq_real number, int digits)
{
    char written[WIDE_TEXT];
    quad_write(number, digits, written);
    text_add(text, EQUATION_TEXT, "%s", written);
}

/* Appends the equation of a step, or the term of a sum, with names or, if `digits` is not 0, with numbers. */
static void equation_add(char *text, const struct step *s, bool letters, int digits)
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
            text_add(text, EQUATION_TEXT, needed->value < 0 ? "(" : "");
            number_add(text, needed->value, digits);
            text_add(text, EQUATION_TEXT, needed->value < 0 ? ")" : "");
        } else if (needed)
            text_add(text, EQUATION_TEXT, "%s", name_of(needed, letters));
        else if (letters && length == 4 && strncmp(c, "sqrt", 4) == 0)
            text_add(text, EQUATION_TEXT, "√");
        else if (letters && (*c == '*' || *c == '-'))
            text_add(text, EQUATION_TEXT, *c == '*' ? "·" : "−");
        else
            text_add(text, EQUATION_TEXT, "%.*s", (int)(length > 0 ? length : 1), c);
        c += length > 0 ? length : 1;
    }
}

/* Appends the equation of a step with numbers. Of a sum with many terms, only the first ones are written, and
 * the others are added up. */
static void numbers_add(char *text, const struct step *s, bool letters, int digits)
{
    domq_real rest = 0;
    if (!s->derived->sum) {
        equation_add(text, s, letters, digits);
        return;
    }
    for (size_t i = s->terms; i-- > TERMS_SHOWN;)
        rest += s->term[i];
    for (size_t i = 0; i < s->terms && i <= TERMS_SHOWN; i++) {
        const domq_real term = i < TERMS_SHOWN ? s->term[i] : rest;
        text_add(text, EQUATION_TEXT, "%s", i == 0 && term >= 0 ? "" : term < 0 ? (i ? " - " : "-") : " + ");
        number_add(text, quad(fabs)(term), digits);
    }
}

/* A row for csv and json. */
static void step_row(struct answer *a, const struct derivation *d, const struct step *s)
{
    char needs[256] = "", equation[EQUATION_TEXT] = "", numbers[EQUATION_TEXT] = "";
    const struct cell none = cell_real(DOMQ_NAN);
    if (s->tree) {
        text_add(equation, sizeof equation, s->derived->sum ? "sum(%s)" : "%s", s->derived->equation);
        numbers_add(numbers, s, false, d->query.scene->compute.precision == IN_QUAD ? WIDE_DIGITS : 17);
    }
    for (int k = 0; k < s->count; k++)
        text_add(needs, sizeof needs, "%s%s", k ? " " : "", s->needs[k]->name);
    answer_row(a,
               ROW(cell_word(s->name), s->tree ? cell_word(equation) : none,
                   s->tree ? cell_word(numbers) : none, cell_without_error(s->value), cell_word(s->unit),
                   cell_word(needs), cell_word(s->reference), cell_count(s->depth), cell_word(s->words)),
               NULL);
}

/* ---- For people ---- */

/* Returns true if a value differs from 0 only by rounding errors, like the margin at the largest growth. Each
 * number is the result of a few dozen operations, so its error is at most a few dozen machine epsilons times
 * the largest number in its equation. */
static bool is_rounding(const struct derivation *d, const struct step *s)
{
    enum { ROUNDINGS = 64 };
    domq_real largest = 0;
    for (int k = 0; k < s->count; k++)
        if (isfinite(s->needs[k]->value))
            largest = quad_larger(largest, quad(fabs)(s->needs[k]->value));
    const double epsilon = any_arithmetic(d->query.scene->compute.precision).epsilon;
    return s->value != 0 && quad(fabs)(s->value) <= ROUNDINGS * (domq_real)epsilon * largest;
}

static void value_add(char *text, const struct answer *a, const struct derivation *d, const struct step *s)
{
    const int digits = (int)a->style.digits;
    if (!isfinite(s->value)) {
        text_add(text, EQUATION_TEXT, "no value: this train has no complete cycle; 'why' says more");
        return;
    }
    if (strcmp(s->name, "r_max") == 0 || strcmp(s->name, "r_pair") == 0)
        text_add(text, EQUATION_TEXT, "%s", quad_limit(s->value, digits));
    else
        number_add(text, is_rounding(d, s) ? 0 : s->value, digits);
    text_add(text, EQUATION_TEXT, "%s%s", *s->unit ? " " : "", s->unit);
}

/* Prints one quantity: its description, its equation, the equation with numbers, and its value. */
static void step_say(struct answer *a, const struct derivation *d, const struct step *s, bool is_first)
{
    const bool letters = a->layout.letters;
    const char *words = s->words;
    const bool is_symbol = words[strspn(words, "abcdefghijklmnopqrstuvwxyz")] == '^'; /* such as tau^2 */
    char equation[EQUATION_TEXT] = "", numbers[EQUATION_TEXT] = "", value[EQUATION_TEXT] = "";
    answer_say(a, is_first ? "%c%s:" : "\n%c%s:", is_symbol ? *words : toupper((unsigned char)*words),
               words + 1);
    value_add(value, a, d, s);
    if (!s->tree) {
        answer_say(a, "    %s = %s", name_of(s, letters), value);
        return;
    }
    equation_add(equation, s, letters, 0);
    answer_say(a, "    %s = %s%s%s%s%s", name_of(s, letters),
               !s->derived->sum ? ""
               : letters        ? "Σ "
                                : "sum over i of ",
               equation, *s->reference ? "    (" : "", s->reference, *s->reference ? ")" : "");
    numbers_add(numbers, s, letters, (int)a->style.digits);
    if (!s->tree->name || s->tree->count > 0) /* the number of a symbol is the value */
        answer_say(a, "      = %s", numbers);
    answer_say(a, "      = %s", value);
}

/* Writes a quantity that is named but not derived. One that is different in each term has no single value. */
static const char *meaning_of(const struct answer *a, const struct derivation *d, const struct step *s,
                              char text[EQUATION_TEXT])
{
    snprintf(text, EQUATION_TEXT, "    %s%s", name_of(s, a->layout.letters), isfinite(s->value) ? " = " : "");
    if (isfinite(s->value))
        value_add(text, a, d, s);
    text_add(text, EQUATION_TEXT, ": %s", s->words);
    return text;
}

/* Domino i has the weight S_i in the sum of the equations of motion, so that the contact forces cancel. */
static const char *const losses[] = {
    "(A/2) dw/dtheta + B w = C",          "A = sum r^(-(q+1) i) S_i theta_i'",
    "B = sum r^(-(q+1) i) S_i theta_i''", "C = 1/2 sum r^(-q i) S_i (x_i - d y_i)",
    "S_0 = 1, S_(i+1) = S_i a_i/b_i",     NULL};

/* Prints the equations of an effect or of the equation of motion. */
static void effect_say(struct answer *a, const char *with, const char *name, const char *const *line)
{
    if (line)
        answer_say(a, "\n%s%s:", with, name);
    for (; line && *line; line++)
        answer_say(a, "    %s", *line);
}

/* Prints the equations of the answer or, if it is deep, of all quantities. Otherwise the details have the
 * meanings of the quantities in the equations. If the derivation ends because of an effect, the equations of
 * the law of motion and of the effects that are on follow. */
static void derivation_say(struct answer *a, const struct derivation *d, const struct explained *e,
                           const struct explain_arguments *asked)
{
    const struct scene *scene = &d->state.scene;
    char text[EQUATION_TEXT];
    int written = 0, given = 0;
    bool ends = false, has_equations = false;
    answer_plan(a, NULL);
    for (const struct step *s = d->step; s < d->step + d->count; s++) {
        ends = ends || (s->derived->ends & d->has & (HAS_LOSS | HAS_EDGES)) != 0;
        has_equations = has_equations || (s->depth == 1 && !s->derived->is_given);
        if (!s->derived->is_given && (s->depth == 0 || asked->deep))
            step_say(a, d, s, written++ == 0);
        if (s->depth == 1 && !asked->deep)
            answer_detail(a, "%s", meaning_of(a, d, s, text));
    }
    for (const struct step *s = d->step; s < d->step + d->count && asked->deep; s++)
        if (s->derived->is_given) {
            if (given++ == 0)
                answer_say(a, "\ngiven:");
            answer_say(a, "%s", meaning_of(a, d, s, text));
        }
    if (ends && domq_dissipates(&scene->train))
        effect_say(a, "", "equation of motion", losses);
    for (int k = 0; k < DOM_DYNAMICS_COUNT && ends; k++)
        if (scene->effect[k].on)
            effect_say(a, "with ", effect_at(k)->name, effect_at(k)->equations);
    if (has_equations && !asked->deep)
        answer_detail(a, "\n'explain %s%s%s deep' also shows the equations for these quantities.", e->name,
                      isnan(asked->value) ? "" : " ", isnan(asked->value) ? "" : quad_text(asked->value, 10));
}

/* ---- The command ---- */

/* Checks that an equation of the paper holds for this train, at this tilt of the head. */
static bool equation_holds(const struct query *query, const struct explained *e, domq_real tilt,
                           struct problem *problem)
{
    const struct domq_train *train = &query->scene->train;
    const struct domq_effect *effect = domq_first_effect(train);
    const char *label = e->name;
    struct domq_angles angles;
    struct domq_contact contact;
    if (e->needs <= HOLDS)
        return true;
    if (effect)
        return problem_no_answer(problem, "equation (%s) does not include %s; first enter 'set %s off'",
                                 label, effect->name, effect->name);
    if (train->fuel == DOM_FUEL_PAPER)
        return problem_no_answer(problem, "equation (%s) needs the exact fuel; first enter 'set fuel exact'",
                                 label);
    enum dom_status status = any_angles_find(train, &query->scene->compute, &angles);
    if (status == DOM_OK)
        status = any_contact_find(train, &query->scene->compute, e->needs == LEANING ? tilt : 0, &contact);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    if (e->needs == PAIR && angles.theta_u >= angles.theta_c)
        return problem_no_answer(problem, "(5; b0) does not hold: domino 1 hits before it tips over; first "
                                          "enter a larger s");
    if (e->needs >= LEANING && angles.detaches && contact.theta_1 >= angles.theta_leave)
        return problem_no_answer(
            problem, "equation (%s) has no value at this tilt, because domino 2 has slid off domino 1",
            label);
    return true;
}

static bool run_explain(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct explained *e = &explained_list[(int)query->given->number[0]];
    struct explain_arguments asked = {.value = DOMQ_NAN};
    struct domq_angles angles;
    if (query->given->bound)
        asked = *(const struct explain_arguments *)query->given->bound;
    /* An equation is about the tilt in the middle of the cycle if no tilt is given. */
    if (isnan(asked.value) && e->needs != COMMAND && e->value &&
        any_angles_find(&query->scene->train, &query->scene->compute, &angles) == DOM_OK)
        asked.value = angles.theta_c / 2;
    if (e->value && strcmp(e->value, "s") != 0 && isnan(asked.value))
        return problem_error(problem, "'explain %s' needs a value, for example 'explain %s %s'", e->name,
                             e->name, strcmp(e->value, "H") == 0 ? "112 m" : "0.2");
    if (!equation_holds(query, e, asked.value, problem))
        return false;
    struct derivation *d = calloc(1, sizeof *d);
    if (!d)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    bool done = derivation_make(d, query, e, asked.value, problem);
    if (done && answer_for_people(a))
        derivation_say(a, d, e, &asked);
    for (int n = 0; n < d->count && done && !answer_for_people(a); n++)
        if (d->step[n].depth <= (asked.deep ? STEPS_MOST : 1))
            step_row(a, d, &d->step[n]);
    derivation_end(d);
    free(d);
    return done;
}

static const struct command explain_commands[] = {
    {.name = "explain",
     .synonyms = "derive derivation equation formula show steps proof lesson teacher",
     .train = true,
     .argument = {{.name = "WHAT",
                   .kind = ARGUMENT_WORDS,
                   .noun = "question",
                   .parse = what_parse,
                   .choices = explained_names},
                  {.name = "MORE",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = explain_parse,
                   .bind = explain_bind,
                   .choices = deep_names}},
     .summary = "where a number comes from: its equations, with numbers filled in",
     .help = "WHAT is a command, such as barrier, or an equation of the paper by its label or number, such "
             "as c6 or 24, from a1 to e8. For each quantity of its answer, 'explain' shows the equation in "
             "symbols and with numbers, and the value; 'details' lists the quantities in the equation. With "
             "'deep' at the end, these quantities are explained as well, down to the parameters. The values "
             "are the ones that the commands themselves print. With theta1, energy and omega, the first "
             "word of MORE is a tilt; with rmax, a separation; with count, a height. With friction or "
             "rounded edges, a quantity may have no equation in closed form. A maximum that the program "
             "finds by a search has none either. The derivation then says so and ends. json gives the tree: "
             "'needs' names the quantities in each equation.",
     .example = "explain theta1 0.2; explain barrier deep",
     .see = "why theta1 barrier launch recipe paper",
     .sweep.refusal = "it explains one train",
     .rows = true,
     .brief = "*",
     ANSWER(explain)},
    {.name = "recipe",
     .synonyms = "paper method algorithm steps compare",
     .train = true,
     .summary = "the paper's recipe for the largest growth, compared with this program",
     .help = "The section 'A general domino train' ends with five steps 'to find the maximum r'. 'recipe' "
             "shows the number that each step gives at the session's s and r. It compares the paper's number "
             "with this program's, and says why they differ. With friction, a slope, walls or rounded edges "
             "there is no recipe.",
     .example = "set q hollow; recipe",
     .see = "paper explain rmax best fuel",
     .sweep.refusal = "the paper's steps are compared for one train at a time",
     .rows = true,
     .brief = "step quantity paper program",
     ANSWER(recipe)},
    {.name = "paper",
     .synonyms = "figures table compare reproduce van Leeuwen magnification",
     .summary = "numbers and figures of the paper, next to the exact values",
     .help = "A table of numbers from the paper: points of the figures, the largest growth, the best "
             "separation, the printed equations and the quiz. Each number is computed twice: with the "
             "paper's formulas, such as the closed form of the fuel, and with the fuel from the energy "
             "balance. The table says why the two results differ. It is about the paper's own dominoes and "
             "does not depend on the scene.",
     .example = "paper",
     .see = "recipe explain curve plot",
     .sweep.refusal = "it does not depend on the scene",
     .rows = true,
     .brief = "*",
     ANSWER(paper)},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"Where a number comes from", "limits", explain_commands},
    {"Effects beyond the paper", "settings", effect_commands},
    {NULL, NULL, NULL},
};

static const struct method paper = {"paper", dom_paper_barrier, dom_paper_rmax};

const struct feature explain_feature = {.name = "explain", .groups = groups, .method = &paper};
