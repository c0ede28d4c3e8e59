/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/parameters.h"
#include "answer/format.h"
#include "language/names.h"
#include "language/text.h"
#include <limits.h>
#include <string.h>

const char *parameter_names(const void *context, int k)
{
    (void)context;
    return session_parameters[k].name;
}

const char *effect_names(const void *context, int k)
{
    (void)context;
    const struct parameter *p = session_parameters;
    while (p->name && !(p->effect && k-- == 0))
        p++;
    return p->name;
}

bool effect_exists(int effect)
{
    return effect_at(effect) && parameter_find(effect_at(effect)->name);
}

const char *parameter_words(const void *parameter, int k)
{
    const struct word *words = ((const struct parameter *)parameter)->words;
    return words ? words[k].name : NULL;
}

const char *parameter_offered(const void *parameter, int k)
{
    const struct parameter *p = parameter;
    for (const struct word *w = p->words; w && w->name; w++)
        if (parameter_word(p, w->value) == w->name && k-- == 0)
            return w->name;
    return NULL;
}

const struct parameter *parameter_find(const char *name)
{
    const struct parameter *p = session_parameters;
    while (p->name && (*p->name != *name || strcmp(p->name, name) != 0))
        p++;
    return p->name ? p : NULL;
}

const struct parameter *parameter_by_synonym(const char *word, bool any)
{
    const struct parameter *found = NULL;
    int first = any ? INT_MAX : 1;
    for (const struct parameter *p = session_parameters; p->name && *word; p++) {
        int index = names_index(parameter_synonyms(p), ' ', word);
        if (index >= 0 && index < first) {
            found = p;
            first = index;
        }
    }
    return found;
}

const struct parameter *parameter_by_value(const char *word)
{
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (!p->effect && !p->setting && names_exact(parameter_words, p, word) >= 0)
            return p;
    return NULL;
}

/* A list of names, without those of effects. */
struct without_effects {
    names_list *list;
};

static const char *without_effects_names(const void *context, int k)
{
    const struct without_effects *without = context;
    const char *name;
    for (int i = 0; (name = without->list(NULL, i)) != NULL; i++) {
        const struct parameter *p = parameter_find(name);
        if (!(p && p->effect) && k-- == 0)
            break;
    }
    return name;
}

int parameter_search(names_list *list, const char *what, const char *word, char message[NAMES_MESSAGE])
{
    /* One or two letters mean a measure, not an effect: w is the width, not the walls. */
    const bool is_short = strlen(word) < 3 && names_exact(list, NULL, word) < 0;
    const struct without_effects without = {list};
    int k = is_short ? names_find(without_effects_names, &without, what, word, message)
                     : names_find(list, NULL, what, word, message);
    if (is_short && k >= 0)
        k = names_exact(list, NULL, without_effects_names(&without, k));
    const char *feature = k < 0 && !parameter_find(word) ? parameter_missing(word) : NULL;
    if (feature) {
        snprintf(message, NAMES_MESSAGE, "'%s' belongs to '%s', which this build of the program leaves out",
                 word, feature);
        return NAMES_UNKNOWN;
    }
    const struct parameter *p = k < 0 ? parameter_by_value(word) : NULL;
    if (p) {
        snprintf(message, NAMES_MESSAGE, "'%s' is a value of %s; enter 'set %s %s'", word, p->name, p->name,
                 word);
        return NAMES_CLOSE;
    }
    p = k < 0 ? parameter_by_synonym(word, k == NAMES_UNKNOWN) : NULL;
    if (!p || names_exact(list, NULL, p->name) < 0)
        return k;
    snprintf(message, NAMES_MESSAGE, "unknown %s '%s'; did you mean '%s'?", what, names_shown(word), p->name);
    return NAMES_CLOSE;
}

const struct domq_effect_argument *parameter_argument(const struct parameter *p, int i)
{
    return i < (p->effect ? DOM_EFFECT_ARGUMENTS : 1) && p->value[i].name ? &p->value[i] : NULL;
}

const char *parameter_meaning(const struct parameter *p)
{
    return p->effect ? p->effect->adds : p->value->meaning;
}

const char *parameter_help(const struct parameter *p)
{
    return p->effect ? p->effect->help : p->help;
}

const char *parameter_synonyms(const struct parameter *p)
{
    return p->effect ? p->effect->synonyms : p->synonyms;
}

bool parameter_is_number(const struct parameter *p)
{
    return !p->words_only && !p->effect;
}

domq_real parameter_get(const struct state *state, const struct parameter *p)
{
    const struct effect_state *effect = &state->scene.effect[p->which];
    const char *place = (const char *)state + p->offset;
    if (p->effect)
        return effect->on ? effect->value[0] : EFFECT_OFF;
    if (!p->words_only)
        return *(const domq_real *)(const void *)place;
    return *(const unsigned *)(const void *)place;
}

domq_real parameter_fallback(const struct state *state, const struct parameter *p)
{
    return p->effect         ? EFFECT_OFF
           : p->of_precision ? any_arithmetic(state->scene.compute.precision).tol_default
                             : p->value->usual;
}

static domq_real parameter_lowest(const struct state *state, const struct parameter *p, int i)
{
    return p->of_precision ? any_arithmetic(state->scene.compute.precision).tol_floor : p->value[i].lowest;
}

#define SHARE_NAME(name) #name,
static const char *const share_names[] = {SHARES(SHARE_NAME)};
#undef SHARE_NAME

int parameter_share(const struct parameter *p)
{
    for (int k = 0; k < SHARE_COUNT && (*p->value->unit == 'h' || *p->value->unit == 'r'); k++)
        if (strcmp(share_names[k], p->name) == 0)
            return k;
    return -1;
}

bool lengths_check(const struct state *state, struct problem *problem)
{
    bool good = true;
    for (int k = 0; k < SHARE_COUNT && good; k++) {
        const struct parameter *p = state->scene.length[k].m > 0 ? parameter_find(share_names[k]) : NULL;
        good = !p || parameter_get(state, p) == EFFECT_OFF ||
               parameter_check(state, p, 0, parameter_get(state, p), problem);
    }
    return good;
}

static void parameter_put(struct state *state, const struct assigned *a)
{
    const struct parameter *p = a->parameter;
    const int share = parameter_share(p);
    if (share >= 0)
        state->scene.length[share] = a->length;
    char *place = (char *)state + p->offset;
    if (p->before)
        p->before(state, a->value);
    if (p->effect)
        effect_put(&state->scene, p->which, a->value, a->others);
    else if (p->words_only)
        *(unsigned *)(void *)place = (unsigned)a->value;
    else
        *(domq_real *)(void *)place = a->value;
}

_Static_assert(sizeof(enum dom_fuel) == sizeof(unsigned) && sizeof(enum angle) == sizeof(unsigned) &&
                   sizeof(enum precision) == sizeof(unsigned),
               "parameter_get reads an enum as an unsigned int");

bool state_assign(struct state *state, const struct assigned *assigned, int count, struct problem *problem)
{
    /* parameters that take only words, such as 'precision', are set first, because the range of tol depends
     * on the precision */
    for (int words = 1; words >= 0; words--)
        for (int i = 0; i < count; i++) {
            const struct assigned *a = &assigned[i];
            const struct parameter *p = a->parameter;
            if (p->words_only != (words == 1))
                continue;
            if (!p->words_only && a->value != EFFECT_OFF && !(a->length.m > 0) &&
                !parameter_check(state, p, 0, a->value, problem))
                return false;
            parameter_put(state, a);
        }
    scene_apply_lengths(&state->scene);
    for (int i = 0; i < count; i++) {
        const struct parameter *p = assigned[i].parameter;
        if (p->effect && state->scene.effect[p->which].on &&
            !effect_check_needs(&state->scene, p->which, problem))
            return false;
        if (p->check && !p->check(state, assigned[i].value, problem))
            return false;
    }
    return true;
}

bool query_with(const struct query *query, const struct assigned *assigned, int count, struct state *state,
                struct query *changed, struct problem *problem)
{
    *state = *query->state;
    *changed = *query;
    changed->state = state;
    changed->scene = &state->scene;
    changed->next = NULL;
    return state_assign(state, assigned, count, problem) && lengths_check(state, problem);
}

bool parameter_set(struct state *state, const struct parameter *p, const domq_real *value, int given,
                   const struct typed_length *length, struct problem *problem)
{
    struct state next = *state;
    domq_real all[DOM_EFFECT_ARGUMENTS];
    if (p->effect && given > 0 && value[0] == EFFECT_ON && state->scene.effect[p->which].on)
        return true; /* 'set NAME on' does not change an effect that is already on */
    if (p->effect && !effect_complete(&state->scene, p->which, value, given, all, problem))
        return false;
    struct assigned assigned = {
        .parameter = p, .value = p->effect ? all[0] : value[0], .others = p->effect ? all + 1 : NULL};
    if (length)
        assigned.length = *length;
    if (!state_assign(&next, &assigned, 1, problem))
        return false;
    if (p->effect && p->which == DOM_EFFECT_row)
        listed_free(&state->scene.listed);
    *state = next;
    return true;
}

/* Returns the rank of a parameter. Parameters with a lower rank are restored first. */
static int rank(const struct state *state, const struct parameter *p)
{
    /* Effects that are off come first. An effect cannot be turned off while another effect needs it, so those
     * that need others, and not just a row, are the first. Effects that are on come last. */
    const unsigned row = 1U << DOM_EFFECT_row;
    if (p->effect)
        return state->scene.effect[p->which].on ? 6 : p->effect->needs & ~row ? 0 : 2;
    /* A parameter that takes only words, such as 'precision', comes before those that take numbers, because
     * the range of tol depends on the precision. */
    return !p->words_only ? 5 : p->setting ? 3 : 4;
}

const struct parameter *parameter_in_order(const struct state *state, int k)
{
    for (int at = 0; at <= 6; at++)
        for (const struct parameter *p = session_parameters; p->name; p++)
            if (rank(state, p) == at && k-- == 0)
                return p;
    return NULL;
}

void parameter_save(const struct state *state, const struct parameter *p, const char *folder, FILE *out)
{
    char text[WIDE_TEXT];
    if (p->effect) {
        effect_save(&state->scene, p->which, folder, out);
        if (p->save)
            p->save(&state->scene, out);
        return;
    }
    const char *value = parameter_text(p, parameter_get(state, p), WIDE_DIGITS, text);
    struct quantity quantity = expression_unit(p->value->unit);
    const int share = parameter_share(p);
    if (share >= 0 && state->scene.length[share].m > 0) {
        const struct typed_length *length = &state->scene.length[share];
        fprintf(out, "set %s %s\n", p->name, length_write(length->m, length->unit, (char[LENGTH_TEXT]){""}));
        return;
    }
    if (strcmp(p->value->unit, "m") == 0) {
        fprintf(out, "set %s %s\n", p->name,
                length_write(parameter_get(state, p), "", (char[LENGTH_TEXT]){""}));
        return;
    }
    bool has_unit = parameter_is_number(p) && !quantity_is_dimensionless(quantity) && !quantity.angle;
    fprintf(out, "set %s %s%s%s\n", p->name, value, has_unit ? " " : "",
            has_unit ? unit_write(quantity, "*", (char[UNIT_TEXT]){""}) : "");
}

const char *parameter_word(const struct parameter *p, domq_real value)
{
    for (const struct word *w = p->words; w && w->name; w++)
        if (w->value == value)
            return w->name;
    return NULL;
}

const char *parameter_range_write(const struct state *state, const struct parameter *p, int i,
                                  char text[PARAMETER_RANGE])
{
    int digits = p->value[i].whole ? 15 : 6; /* whole numbers are written with all their digits */
    text[0] = '\0';
    for (const char *const *word = p->value[i].words; word && *word; word++)
        text_add(text, PARAMETER_RANGE, "%s%s", *text ? "|" : "", *word);
    if (!p->words_only && !p->value[i].words)
        text_add(text, PARAMETER_RANGE, "%.*g .. %.*g", digits, (double)parameter_lowest(state, p, i), digits,
                 (double)p->value[i].highest);
    for (const struct word *w = p->words; p->words_only && w->name; w++)
        text_add(text, PARAMETER_RANGE, "%s%s", *text ? "|" : "", w->name);
    return text;
}

const char *parameter_text(const struct parameter *p, domq_real value, int digits, char text[WIDE_TEXT])
{
    const char *word = parameter_is_number(p) ? NULL : parameter_word(p, value);
    /* whole numbers are written with all their digits */
    digits = p->value->whole && digits < 15 ? 15 : digits;
    return word                    ? word
           : digits >= WIDE_DIGITS ? quad_exact(value, WIDE_DIGITS, text)
                                   : quad_write(value, digits < 15 ? digits : 15, text);
}

bool parameter_check(const struct state *state, const struct parameter *p, int i, domq_real value,
                     struct problem *problem)
{
    char meaning[96] = "";
    const struct domq_effect_argument *of = &p->value[i];
    const struct domq_arithmetic arithmetic = any_arithmetic(state->scene.compute.precision);
    domq_real lowest = parameter_lowest(state, p, i);
    bool broken = of->whole && value != quad(floor)(value);
    /* A bound such as 1e-15 cannot be represented exactly, so the nearest double is accepted. */
    if (!broken && (value >= lowest || (p->of_precision && (double)value >= (double)lowest)) &&
        value <= of->highest)
        return true;
    const char *range = parameter_range(state, p, i);
    /* A number without a unit is in radians, but may be meant in degrees: if it is too large for an angle, or
     * a whole number. */
    const domq_real degrees = value * (QUAD_PI / 180);
    const bool is_degrees = strcmp(of->unit, "rad") == 0 &&
                            (quad(fabs)(value) > 2 * QUAD_PI || value == quad(floor)(value)) &&
                            degrees >= lowest && degrees <= of->highest;
    if (broken)
        return problem_no_answer(problem,
                                 "%s = %s is not a whole number; %s must be a whole number in the range %s",
                                 of->name, quad_text(value, 10), of->name, range);
    if (p->of_precision && value > 0 && value < lowest)
        return problem_no_answer(
            problem, "%s = %s is too small for %s precision; %s must be in the range %s%s", p->name,
            quad_text(value, 10), arithmetic.name, p->name, range,
            state->scene.compute.precision == IN_QUAD ? "" : "; a higher precision allows smaller values");
    if (p->effect)
        /* what follows a ';' in a meaning would not fit into this sentence */
        snprintf(meaning, sizeof meaning, ", the %.*s,", (int)strcspn(of->meaning, ";"), of->meaning);
    return problem_no_answer(problem, "%s = %s is out of range; %s%s must be in the range %s%s%s%s%s%s",
                             of->name, quad_text(value, 10), of->name, meaning, range, *of->unit ? " " : "",
                             of->unit, is_degrees ? "; enter degrees as in '20 deg'" : "",
                             p->words && !p->effect ? ", or a word such as " : "",
                             p->words && !p->effect ? p->words->name : "");
}

struct answer_style state_style(const struct state *state)
{
    struct answer_style style = state->settings.style;
    int bits = any_arithmetic(state->scene.compute.precision).bits;
    style.format = formats[style.output];
    style.precision = state->scene.compute.precision;
    /* An exact round trip needs ceil(1 + bits log10(2)) digits, where log10(2) = 0.30103. */
    style.all_digits = 2 + bits * 30103 / 100000;
    style.tol = (double)state->scene.compute.tol;
    style.digits = quad_smaller(style.digits, style.all_digits);
    return style;
}
