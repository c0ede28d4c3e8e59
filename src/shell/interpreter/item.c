/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values in the arguments of commands: expressions, words that stand for values, and values of parameters. */
#include "interpreter/question.h"
#include "session/parameters.h"
#include <ctype.h>
#include <string.h>

/* ---- Expressions ---- */

/* Text directly after a value is an error. */
static bool end_check(struct reader *r, const char *name, const char *end)
{
    if (isspace((unsigned char)*end) || (*end != '#' && command_ends(end)) || *end == '>' ||
        (r->stops && strchr(r->stops, *end)))
        return true;
    reader_place(r, end);
    return problem_error(r->problem, "unexpected '%s' after the value of %s; %s", names_shown(end), name,
                         *end == ',' && isdigit((unsigned char)end[1]) ? "use a decimal point, as in 0.5"
                         : *end == ',' ? "separate values by blanks, without a comma"
                                       : "an operator or a blank is missing");
}

/* Records what may be typed at the cursor: a value, the rest of an expression, or a unit after a number. The
 * expression from r->at to `end` has just been parsed; `is_good` is false if it has an error. */
static void value_offer(const struct reader *r, const struct argument *a, const char *end, bool is_good)
{
    struct reader behind = *r;
    behind.at = is_good ? skip_blanks(end) : end;
    struct offer *o = reader_offer(r), *inside = !is_good && end > r->at ? reader_offer(&behind) : NULL;
    o = inside ? inside : o;
    if (o) {
        o->value = *a;
        o->is_inside = inside != NULL;
    }
    if (is_good && (isdigit((unsigned char)end[-1]) || end[-1] == '.'))
        offer_kind(&behind, OFFER_UNIT);
}

bool item_wrong(struct problem *problem, const struct text *text, const char *name)
{
    char word[NAMES_SHOWN], reason[PROBLEM_TEXT / 4];
    const char *at = problem->at;
    if (!at)
        return false; /* a command in the expression has no answer */
    if (text)
        problem->column = text_column(text, at);
    snprintf(word, sizeof word, "%.*s", (int)strcspn(at, " \t;"), at);
    snprintf(reason, sizeof reason, "%.255s", problem->text);
    snprintf(problem->text, sizeof problem->text, *word ? "%s at '%s': %s" : "%s%s: %s", name,
             names_shown(word), reason);
    problem->at = NULL;
    return false;
}

bool item_bind(const struct item *item, const struct text *text, const struct query *query,
               struct quantity *quantity, domq_real *number, struct problem *problem)
{
    struct evaluation e = query_evaluation(query, problem);
    struct quantity own, *q = quantity ? quantity : &own;
    *q = (struct quantity){.value = item->number};
    if (item->at)
        problem->place = text_column(text, item->at);
    if (item->value && !expression_evaluate(&e, item->value, q))
        return item_wrong(problem, text, item->argument->name);
    *number = q->value;
    return !item->value || argument_check(query, item->argument, *q, number, problem);
}

bool item_parse_expression(struct reader *r, const struct argument *a, struct item *item)
{
    const char *begin = r->at;
    domq_real number;
    *item = (struct item){.argument = a, .at = begin};
    item->value = expression_parse(r);
    const char *end = r->at;
    r->at = begin;
    if (r->offer)
        value_offer(r, a, end, item->value != NULL);
    if (!item->value)
        return item_wrong(r->problem, r->text, a->name);
    if (!end_check(r, a->name, end))
        return false;
    r->at = end;
    return !r->evaluates || !r->names || item_bind(item, r->text, r->query, NULL, &number, r->problem);
}

/* ---- Words ---- */

/* The words that an argument takes. */
struct words {
    names_list *list, *offered; /* all words, and those that completion and messages mention */
    const void *context;
    const char *what; /* the noun in messages */
    bool only;        /* the argument takes no expression */
};

/* A names_list (see names.h) of the words that an argument of an effect accepts. */
static const char *argument_words(const void *argument, int k)
{
    return ((const struct domq_effect_argument *)argument)->words[k];
}

/*
 * Finds the next word in a list, and moves the reader behind it. The word may be abbreviated, unless it could
 * also be an expression, like h in 'set q h'. Returns the index of the word. Returns a negative number if
 * there is none, and reports the word if it cannot be an expression.
 */
static int word_parse(struct reader *r, const struct words *w, struct item *item)
{
    char message[NAMES_MESSAGE], all[NAMES_ALL];
    const char *begin = r->at, *word = read_word(r, WORD_BARE);
    if (!word)
        return NAMES_UNKNOWN;
    const size_t length = strlen(word);
    const char *bare = reader_copy(r, word, length - (length > 0 && word[length - 1] == ','));
    if (bare && strlen(bare) < length && names_exact(w->list, w->context, bare) >= 0) {
        reader_place(r, r->at - 1);
        problem_error(r->problem, "unexpected ',' after '%s'; separate values by blanks, without a comma",
                      bare);
        return NAMES_CLOSE;
    }
    const bool is_word = w->only || (*word && word[strspn(word, "abcdefghijklmnopqrstuvwxyz")] == '\0' &&
                                     !is_value_name(r->query->state, word));
    const int k = !is_word     ? names_exact(w->list, w->context, word)
                  : w->context ? names_find(w->list, w->context, w->what, word, message)
                               : parameter_search(w->list, w->what, word, message);
    item->word = k >= 0 && !w->context ? word : NULL;
    r->at = k >= 0 ? r->at : begin;
    if (k >= 0)
        return k;
    if (is_word && k != NAMES_UNKNOWN)
        problem_error(r->problem, "%s", message);
    else if (is_word)
        problem_error(r->problem, "unknown %s '%s'; use one of: %s%s%s", w->what, names_shown(word),
                      names_join(w->offered, w->context, "", all), w->only ? "" : " or ",
                      w->only                      ? ""
                      : w->list == parameter_words ? parameter_range(r->query->state, w->context, 0)
                                                   : "an angle");
    return k;
}

bool item_parse(struct reader *r, const struct argument *a, struct item *item)
{
    const struct parameter *p = a->kind == ARGUMENT_VALUE_OF ? parameter_find(a->parameter) : NULL;
    struct words w = {.list = NULL};
    char what[40];
    *item = (struct item){.argument = a, .at = r->at};
    if (p && a->which > 0 && p->value[a->which].words)
        w = (struct words){argument_words, argument_words, &p->value[a->which], a->name, true};
    else if (p && a->which == 0 && p->words) {
        snprintf(what, sizeof what, "value of %s", p->name);
        w = (struct words){parameter_words, parameter_offered, p, what, p->words_only};
    } else if (a->kind == ARGUMENT_CHOICE || a->kind == ARGUMENT_PLACE)
        w = (struct words){a->choices, a->choices, NULL, a->noun, a->kind == ARGUMENT_CHOICE};
    if (!w.list)
        return item_parse_expression(r, a, item);
    offer_names(r, w.offered, w.context);
    const int k = word_parse(r, &w, item);
    if (k < 0)
        return !w.only && r->problem->kind == PROBLEM_NONE && item_parse_expression(r, a, item);
    item->number = p && w.list == parameter_words ? p->words[k].value
                   : a->kind == ARGUMENT_PLACE    ? -1 - k
                                                  : k;
    return true;
}

/* ---- Parameters and their values ---- */

bool item_parse_value(struct reader *r, const struct parameter *p, int i, struct item *item)
{
    struct argument *a = reader_memory(r, sizeof *a);
    if (!a)
        return false;
    *a = (struct argument){
        .name = p->value[i].name, .kind = ARGUMENT_VALUE_OF, .parameter = p->name, .which = i};
    return item_parse(r, a, item);
}

/* A names_list (see names.h) of the parameters of the model and, after them, the effects. */
static const char *model_names(const void *context, int k)
{
    const struct parameter *p = session_parameters;
    (void)context;
    while (p->name && (p->setting || k-- > 0))
        p++;
    return p->name;
}

const struct parameter *parameter_parse(struct reader *r, const char *form)
{
    char message[NAMES_MESSAGE];
    reader_place(r, r->at);
    offer_names(r, model_names, NULL);
    char *word = read_word(r, WORD_BARE);
    if (!word)
        return NULL;
    int k = parameter_search(model_names, "parameter", word, message);
    if (k >= 0)
        return parameter_find(model_names(NULL, k));
    if (parameter_find(word))
        problem_error(r->problem,
                      "'%s' is a setting of the calculator; use a parameter of the model or an effect here",
                      word);
    else if (*r->at == ',')
        problem_error(r->problem, "',' separates values, not parameters; write only a blank before the next "
                                  "parameter, as in 'r 1 1.5 3 s 0.3, 0.5'");
    else if (isalpha((unsigned char)*word))
        problem_error(r->problem, "%s", message);
    else
        problem_error(r->problem, "'%s' is not the name of a parameter; %s", names_shown(word), form);
    return NULL;
}

bool item_parse_listed(struct reader *r, const struct parameter *p, struct item *item)
{
    const char *no_unit = r->no_unit;
    struct offer *o = reader_offer(r);
    if (o)
        o->parameter = p;
    /* In "r 2 s 0.3 g 1.6", s and g are the names of parameters, not seconds and grams. Only after a mass, g
     * means grams. */
    r->no_unit = expression_unit(p->value->unit).mass != 0 ? "s" : "sg";
    bool good = item_parse_value(r, p, 0, item);
    r->no_unit = no_unit;
    if (good && p->effect && !item->value && item->number == EFFECT_ON)
        item->number = p->value->usual;
    return good;
}
