/* SPDX-License-Identifier: GPL-3.0-or-later */
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

bool item_parse(struct reader *r, const struct argument *a, struct item *item)
{
    const char *begin = r->at;
    /* completion must read on after a name that is not known */
    r->names = r->unresolved || r->offer ? NULL : name_resolve;
    struct tree *tree = expression_parse(r);
    const char *end = r->at;
    r->at = begin;
    *item = (struct item){.argument = a, .value = tree, .at = begin};
    if (r->offer) { /* a value, the rest of an expression, or a unit after a number */
        struct reader behind = *r;
        behind.at = tree ? skip_blanks(end) : end;
        struct offer *o = reader_offer(r), *inside = !tree && end > begin ? reader_offer(&behind) : NULL;
        o = inside ? inside : o;
        if (o) {
            o->value = *a;
            o->is_inside = inside != NULL;
        }
        if (tree && (isdigit((unsigned char)end[-1]) || end[-1] == '.'))
            offer_kind(&behind, OFFER_UNIT);
    }
    if (!tree || (r->names && !is_single(r->problem, tree)))
        return item_wrong(r->problem, r->text, a->name);
    if (!end_check(r, a->name, end))
        return false;
    r->at = end;
    domq_real number;
    return !r->evaluates || r->unresolved || item_bind(item, r->text, r->query, NULL, &number, r->problem);
}

/* ---- Words for values ---- */

/*
 * Returns the index of the next word in a list. The word may be abbreviated, unless it could also be an
 * expression, like h in 'set q h'. If the list does not have the word, returns a negative number and does not
 * move the reader. `message` then explains the failure, but is empty if the word may be an expression.
 */
static int word_find(struct reader *r, names_list *list, const void *context, const char *what,
                     bool is_word_only, char message[NAMES_MESSAGE])
{
    const char *begin = r->at, *word = read_word(r, WORD_BARE);
    message[0] = '\0';
    if (!word)
        return NAMES_UNKNOWN;
    bool is_word = is_word_only || (*word && word[strspn(word, "abcdefghijklmnopqrstuvwxyz")] == '\0' &&
                                    !is_value_name(r->query->state, word));
    int k = is_word ? names_find(list, context, what, word, message) : names_exact(list, context, word);
    if (k < 0)
        r->at = begin;
    return k;
}

/* A names_list (see names.h) of the words that an argument of an effect accepts. */
static const char *argument_words(const void *argument, int k)
{
    return ((const struct domq_effect_argument *)argument)->words[k];
}

bool item_parse_value(struct reader *r, const struct parameter *p, int i, const char *name, struct item *item)
{
    const char *begin = r->at;
    char message[NAMES_MESSAGE], what[32];
    const char *const *words = i > 0 ? p->value[i].words : NULL;
    if (words) {
        offer_names(r, argument_words, &p->value[i]);
        int k = word_find(r, argument_words, &p->value[i], name, true, message);
        *item = (struct item){.number = k, .at = begin};
        return k >= 0 || problem_error(r->problem, "%s (%s is %s or %s)", message, name, words[0], words[1]);
    }
    if (p->words && i == 0) {
        offer_names(r, parameter_offered, p);
        snprintf(what, sizeof what, "value of %s", p->name);
        int k = word_find(r, parameter_words, p, what, p->words_only, message);
        if (k >= 0) {
            *item = (struct item){.number = p->words[k].value, .at = begin};
            return true;
        }
        if (*message)
            return problem_error(
                r->problem, p->words_only ? "%s (%s is one of %s)" : "%s (%s is a number in the range %s)",
                message, p->name, parameter_range(r->query->state, p, 0));
    }
    struct argument *a = reader_memory(r, sizeof *a);
    if (!a)
        return false;
    *a = (struct argument){.name = name, .kind = ARGUMENT_VALUE_OF, .parameter = p->name, .which = i};
    return item_parse(r, a, item);
}

bool item_parse_choice(struct reader *r, const struct argument *a, struct item *item)
{
    char message[NAMES_MESSAGE], all[NAMES_ALL];
    offer_names(r, a->choices, NULL);
    *item = (struct item){.at = r->at};
    const char *word = item->word = read_word(r, WORD_BARE);
    if (!word)
        return false;
    int k = parameter_search(a->choices, a->noun, word, message);
    item->number = k;
    if (k >= 0)
        return true;
    if (k == NAMES_CLOSE)
        return problem_error(r->problem, "%s", message);
    return problem_error(r->problem, "unknown %s '%s'; use one of: %s", a->noun, names_shown(word),
                         names_join(a->choices, NULL, "", all));
}

bool item_parse_place(struct reader *r, const struct argument *a, struct item *item)
{
    char message[NAMES_MESSAGE];
    const char *begin = r->at;
    offer_names(r, a->choices, NULL);
    int k = word_find(r, a->choices, NULL, a->noun, false, message);
    if (k < 0)
        return *message ? item_parse_choice(r, a, item) : item_parse(r, a, item);
    *item = (struct item){.number = -1 - k, .at = begin};
    return true;
}

/* ---- Parameters and their values ---- */

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
    bool has_mass = expression_unit(p->value->unit).mass != 0;
    if (o)
        o->parameter = p;
    /* In "r 2 s 0.3 g 1.6", s and g are the names of parameters, not seconds and grams. Only after a mass, g
     * means grams. */
    r->no_unit = has_mass ? "s" : "sg";
    bool good = item_parse_value(r, p, 0, p->value->name, item);
    r->no_unit = no_unit;
    if (good && p->effect && !item->value && item->number == EFFECT_ON)
        item->number = p->value->usual;
    return good;
}

const struct assignment *assignments_parse(struct reader *r)
{
    static const char form[] = "'with' takes parameters and effects, as in 'rmax with q hollow d 0.1'";
    const struct assignment *first = NULL, **last = &first;
    for (int count = 0; !reader_ends(r); count++) {
        const struct parameter *p = parameter_parse(r, form);
        struct assignment *a = p ? reader_memory(r, sizeof *a) : NULL;
        if (p && count == ASSIGNED_MAX)
            problem_error(r->problem, "'with' takes at most %d parameters", ASSIGNED_MAX);
        if (!a || count == ASSIGNED_MAX)
            return NULL;
        r->at = skip_blanks(r->at);
        r->at = skip_blanks(r->at + (*r->at == '='));
        reader_place(r, r->at);
        if (reader_ends(r)) {
            problem_error(
                r->problem,
                "the value of %s after 'with' is missing; enter, for example, 'rmax with q hollow d 0.1'",
                p->name);
            return NULL;
        }
        a->parameter = p;
        if (!item_parse_listed(r, p, &a->item))
            return NULL;
        *last = a;
        last = &a->next;
    }
    if (!first) {
        reader_place(r, r->at);
        problem_error(r->problem, "%s", form);
    }
    return first;
}
