/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/answer.h"
#include "language/names.h"
#include "language/text.h"
#include "session/parameters.h"
#include <limits.h>
#include <string.h>

const char *parameter_names(const void *context, int k)
{
    (void)context;
    return session_parameters[k].name;
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

const struct parameter *parameter_by_synonym(const char *word, bool any)
{
    const struct parameter *found = NULL;
    int first = any ? INT_MAX : 1;
    for (const struct parameter *p = session_parameters; p->name && *word; p++) {
        int index = names_index(p->synonyms, ' ', word);
        if (index >= 0 && index < first) {
            found = p;
            first = index;
        }
    }
    return found;
}

bool parameter_by_value(const char *word, char message[NAMES_MESSAGE])
{
    const struct parameter *p = session_parameters;
    while (p->name && (p->effect || p->setting || names_exact(parameter_words, p, word) < 0))
        p++;
    if (p->name)
        snprintf(message, NAMES_MESSAGE,
                 "'%s' is a value of %s; enter 'set %s %s', or write 'with %s %s' at the end", word, p->name,
                 p->name, word, p->name, word);
    return p->name;
}

const char *parameter_usage_write(const struct parameter *p, char usage[PARAMETER_USAGE])
{
    snprintf(usage, PARAMETER_USAGE, "%s%s", p->name, p->effect ? "" : " VALUE");
    for (const struct domq_effect_argument *a = p->value; p->effect && a < p->value + DOM_EFFECT_ARGUMENTS;
         a++)
        if (a->name)
            text_add(usage, PARAMETER_USAGE,
                     a->optional  ? " [%s]"
                     : a->or_file ? " %s|FILE"
                                  : " %s",
                     a->name);
    return usage;
}

int parameter_search(names_list *list, const char *what, const char *word, char message[NAMES_MESSAGE])
{
    word = strcmp(word, "w") == 0 ? "width" : word;
    int k = names_find(list, NULL, what, word, message);
    if (k == NAMES_ABSENT)
        return k;
    if (k < 0 && parameter_by_value(word, message))
        return NAMES_CLOSE;
    const struct parameter *p = k < 0 ? parameter_by_synonym(word, k == NAMES_UNKNOWN) : NULL;
    if (!p || names_exact(list, NULL, p->name) < 0) {
        if (k == NAMES_UNKNOWN)
            text_add(message, NAMES_MESSAGE, "; 'show all' lists them");
        return k;
    }
    snprintf(message, NAMES_MESSAGE, "unknown %s '%s'; did you mean '%s'?", what, names_shown(word), p->name);
    return NAMES_CLOSE;
}

const struct domq_effect_argument *parameter_argument(const struct parameter *p, int i)
{
    return i < (p->effect ? DOM_EFFECT_ARGUMENTS : 1) && p->value[i].name ? &p->value[i] : NULL;
}

bool parameter_is_number(const struct parameter *p)
{
    return !p->words_only && !p->effect;
}

domq_real parameter_get(const struct state *state, const struct parameter *p)
{
    const char *place = (const char *)state + p->offset;
    return p->words_only ? *(const unsigned *)(const void *)place : *(const domq_real *)(const void *)place;
}

bool parameter_equal(const struct state *a, const struct state *b, const struct parameter *p)
{
    if (p->effect && !a->scene.effect[p->which].on && !b->scene.effect[p->which].on)
        return true;
    const size_t size = p->words_only ? sizeof(unsigned)
                        : p->effect   ? sizeof a->scene.effect->value
                                      : sizeof(domq_real);
    return (!p->share || a->scene.length[p->share].m == b->scene.length[p->share].m) &&
           memcmp((const char *)a + p->offset, (const char *)b + p->offset, size) == 0;
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

/* Returns true if the lengths that were given fit to the height. */
static bool lengths_check(const struct state *state, struct problem *problem)
{
    bool good = true;
    for (const struct parameter *p = session_parameters; p->name && good; p++)
        good = !p->share || !(state->scene.length[p->share].m > 0) || parameter_get(state, p) == EFFECT_OFF ||
               parameter_check(state, p, 0, parameter_get(state, p), problem);
    return good;
}

_Static_assert(sizeof(enum dom_fuel) == sizeof(unsigned) && sizeof(enum angle) == sizeof(unsigned) &&
                   sizeof(enum precision) == sizeof(unsigned),
               "parameter_get reads an enum as an unsigned int");

/* Sets parameters in a copy of a state. Sets *problem and returns false if a value is out of range, or cannot
 * be combined with the others. Ranges of assigned.others are not checked, nor is a length, since h may
 * change. */
static bool state_assign(struct state *state, const struct assigned *assigned, int count,
                         struct problem *problem)
{
    /* parameters that take only words, such as 'precision', are set first, because the range of tol depends
     * on the precision */
    for (int words = 1; words >= 0; words--)
        for (int i = 0; i < count; i++) {
            const struct assigned *a = &assigned[i];
            const struct parameter *p = a->parameter;
            void *place = (char *)state + p->offset;
            if (p->words_only != (words == 1))
                continue;
            if (!p->words_only && a->value != EFFECT_OFF && !(a->length.m > 0) &&
                !parameter_check(state, p, 0, a->value, problem))
                return false;
            if (p->share)
                state->scene.length[p->share] = a->length;
            if (p->before)
                p->before(state, a->value);
            if (p->effect)
                effect_put(&state->scene, p->which, a->value, a->others);
            else if (p->words_only)
                *(unsigned *)place = (unsigned)a->value;
            else
                *(domq_real *)place = a->value;
        }
    scene_apply_lengths(&state->scene);
    for (int i = 0; i < count; i++) {
        const struct parameter *p = assigned[i].parameter;
        if (p->check && !p->check(state, p, assigned[i].value, problem))
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
    return state_assign(state, assigned, count, problem) &&
           (!scene_has_lengths(&state->scene) || lengths_check(state, problem));
}

bool parameter_set(struct state *state, const struct parameter *p, const domq_real *value, int given,
                   const struct typed_length *length, struct problem *problem)
{
    struct state next = *state;
    domq_real all[DOM_EFFECT_ARGUMENTS] = {0};
    const struct domq_effect_argument *a;
    const bool off = value[0] == EFFECT_OFF, usual = off || value[0] == EFFECT_ON;
    if (value[0] == EFFECT_ON && parameter_get(state, p) != EFFECT_OFF)
        return true; /* 'set NAME on' does not change an effect that is already on */
    for (int i = 0; (a = parameter_argument(p, i)) != NULL; i++) {
        if (i >= given && !a->optional && !usual)
            return problem_error(problem, "%s, the %s, is missing; enter, for example, 'set %s %s%s%s'",
                                 a->name, a->meaning, p->name, quad_text(a->usual, 4), *a->unit ? " " : "",
                                 a->unit);
        all[i] = i < given && !usual ? value[i] : a->usual;
    }
    all[0] = off ? EFFECT_OFF : all[0];
    for (int k = 0; off && k < EFFECTS_MOST; k++)
        if (state->scene.effect[k].on && effect_needs(k, p->which))
            return problem_error(problem, "'set %s' needs the %s; first enter 'set %s off'",
                                 effect_at(k)->name, p->name, effect_at(k)->name);
    struct assigned assigned = {.parameter = p, .value = all[0], .others = all + 1};
    if (length)
        assigned.length = *length;
    if (!state_assign(&next, &assigned, 1, problem))
        return false;
    if (next.scene.slot != state->scene.slot)
        slot_drop(state->scene.slot);
    *state = next;
    return true;
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
    const char *word;
    const int digits = p->value[i].whole ? 15 : 6; /* whole numbers are written with all their digits */
    text[0] = '\0';
    if (!p->words_only && !p->value[i].words)
        snprintf(text, PARAMETER_RANGE, "%.*g .. %s", digits, (double)parameter_lowest(state, p, i),
                 quad_limit(p->value[i].highest, digits));
    else
        for (int k = 0; (word = p->words_only ? p->words[k].name : p->value[i].words[k]) != NULL; k++)
            text_add(text, PARAMETER_RANGE, "%s%s", k ? "|" : "", word);
    return text;
}

const char *parameter_text(const struct parameter *p, int i, domq_real value, int digits,
                           char text[PARAMETER_TEXT])
{
    const struct domq_effect_argument *a = &p->value[i];
    const bool is_exact = digits >= WIDE_DIGITS;
    const char *word = i == 0 ? parameter_word(p, value) : a->words ? a->words[(int)value] : NULL;
    if (word && !(i == 0 && parameter_is_number(p)))
        return word;
    if (is_exact && strcmp(a->unit, "m") == 0)
        return length_write(value, "", text);
    if (is_exact)
        return quad_exact(value, WIDE_DIGITS, text);
    /* whole numbers are written with all their digits */
    quad_write(value, a->whole || digits > 15 ? 15 : digits, text);
    if (word || (p->effect && *a->unit))
        text_add(text, PARAMETER_TEXT, word ? " (%s)" : " %s", word ? word : a->unit);
    return text;
}

const char *parameter_setting_write(const struct state *state, const struct parameter *p, int digits,
                                    char setting[PARAMETER_SETTING])
{
    const struct typed_length *length = &state->scene.length[p->share];
    const domq_real first = parameter_get(state, p),
                    *value = p->effect ? state->scene.effect[p->which].value : &first;
    const struct domq_effect_argument *a;
    char text[PARAMETER_TEXT];
    const bool is_off = first == EFFECT_OFF, is_length = length->m > 0 && !is_off;
    snprintf(setting, PARAMETER_SETTING, "%s",
             is_length ? length_write(length->m, length->unit, text)
                       : parameter_text(p, 0, first, digits, text));
    for (int i = 1; !is_off && parameter_argument(p, i); i++) {
        bool is_usual = true; /* this value and all after it may be left out */
        for (int k = i; (a = parameter_argument(p, k)) != NULL; k++)
            is_usual = is_usual && a->optional && value[k] == a->usual;
        if (is_usual)
            break;
        text_add(setting, PARAMETER_SETTING, digits >= WIDE_DIGITS ? " %s" : ", %s",
                 parameter_text(p, i, value[i], digits, text));
    }
    if (effect_slot(state, p))
        state->scene.slot->kind->setting(&state->scene, setting);
    return setting;
}

bool parameter_check(const struct state *state, const struct parameter *p, int i, domq_real value,
                     struct problem *problem)
{
    char meaning[96] = "", degrees[80] = "";
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
    const domq_real degree = QUAD_PI / 180;
    const bool is_angle = strcmp(of->unit, "rad") == 0,
               is_degrees = is_angle && (quad(fabs)(value) > 2 * QUAD_PI || value == quad(floor)(value)) &&
                            value * degree >= lowest && value * degree <= of->highest;
    if (is_angle)
        snprintf(degrees, sizeof degrees, " (%.4g .. %.4g deg)%s", (double)(lowest / degree),
                 (double)(of->highest / degree), is_degrees ? "; enter degrees as in '20 deg'" : "");
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
                             of->unit, degrees, p->words && !p->effect ? ", or a word such as " : "",
                             p->words && !p->effect ? p->words->name : "");
}

/* ---- Effects ---- */

bool effect_slot(const struct state *state, const struct parameter *p)
{
    const struct slot *slot = state->scene.slot;
    return slot && p->effect && slot->kind->effect == p->which;
}

void effect_put(struct scene *scene, int effect, domq_real value, const domq_real *others)
{
    struct effect_state *state = &scene->effect[effect];
    for (int i = 1; (others || !state->on) && i < DOM_EFFECT_ARGUMENTS; i++)
        state->value[i] = others ? others[i - 1] : effect_at(effect)->argument[i].usual;
    state->on = value != EFFECT_OFF;
    state->value[0] = value;
    if (scene->slot && scene->slot->kind->effect == effect)
        scene->slot = NULL;
    effects_apply(scene);
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
