/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session.h"
#include "value.h"
#include <stdarg.h>
#include <string.h>

static const struct word mass_words[] = {{"hollow", 3}, {"massive", 4}, {NULL, 0}};
static const struct word fuel_words[] = {{"exact", DOM_FUEL_EXACT}, {"paper", DOM_FUEL_PAPER}, {NULL, 0}};
static const struct word output_words[] = {
    {"table", OUTPUT_TABLE}, {"csv", OUTPUT_CSV}, {"json", OUTPUT_JSON}, {NULL, 0}};

#define NUMBER(member, name_, default_, lowest_, highest_, unit_, meaning_)                                  \
    {.name = #name_,                                                                                         \
     .unit = unit_,                                                                                          \
     .meaning = meaning_,                                                                                    \
     .fallback = default_,                                                                                   \
     .lowest = lowest_,                                                                                      \
     .highest = highest_,                                                                                    \
     .words = #name_[0] == 'q' ? mass_words : NULL,                                                          \
     .offset = offsetof(struct session, member.name_)},
#define TRAIN_NUMBER(...) NUMBER(train, __VA_ARGS__)
#define SCALE_NUMBER(...) NUMBER(scale, __VA_ARGS__)
#define WORDS(name_, member, words_, meaning_, setting_)                                                     \
    {.name = name_,                                                                                          \
     .unit = "",                                                                                             \
     .meaning = meaning_,                                                                                    \
     .words = words_,                                                                                        \
     .words_only = true,                                                                                     \
     .offset = offsetof(struct session, member),                                                             \
     .setting = setting_},

const struct parameter session_parameters[] = {
    DOM_TRAIN_PARAMETERS(TRAIN_NUMBER) DOM_SCALE_PARAMETERS(SCALE_NUMBER)
        WORDS("fuel", train.fuel, fuel_words, "the energy balance, or the paper's closed form of (c7)", false)
            WORDS("output", output, output_words, "how answers are written", true){.name = NULL}};

void session_init(struct session *session, FILE *out)
{
    *session = (struct session){.train = dom_train_default(), .scale = dom_scale_default(), .out = out};
}

bool session_error(struct session *session, const char *format, ...)
{
    fflush(session->out); /* so that both streams keep their order where they share a file */
    if (session->source)
        fprintf(stderr, "%s:%ld: ", session->source, session->line);
    if (session->command)
        fprintf(stderr, "%s: ", session->command);
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    putc('\n', stderr);
    session->errors++;
    return false;
}

bool session_status(struct session *session, enum dom_status status)
{
    const struct dom_train *t = &session->train;
    if (status == DOM_OUT_OF_REACH)
        return session_error(session,
                             "r s = %.10g > 1: the head falls past the next domino without touching it; "
                             "at s = %.10g r may be up to 1/s = %.10g",
                             t->r * t->s, t->s, 1 / t->s);
    if (status == DOM_TOO_LONG)
        return session_error(session, "%s; a larger s, d or tol needs fewer", dom_status_text(status));
    return session_error(session, "%s", dom_status_text(status));
}

const struct parameter *parameter_find(const char *name)
{
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (strcmp(p->name, name) == 0)
            return p;
    return NULL;
}

double parameter_get(const struct session *session, const struct parameter *p)
{
    const char *place = (const char *)session + p->offset;
    if (!p->words_only)
        return *(const double *)(const void *)place;
    return *(const unsigned *)(const void *)place;
}

void parameter_put(struct session *session, const struct parameter *p, double value)
{
    char *place = (char *)session + p->offset;
    if (p->words_only)
        *(unsigned *)(void *)place = (unsigned)value;
    else
        *(double *)(void *)place = value;
}

_Static_assert(sizeof(enum output) == sizeof(unsigned) && sizeof(enum dom_fuel) == sizeof(unsigned),
               "parameter_get reads an enum as an unsigned");

const char *parameter_word(const struct parameter *p, double value)
{
    for (const struct word *w = p->words; w && w->name; w++)
        if (w->value == value)
            return w->name;
    return NULL;
}

void parameter_range(const struct parameter *p, char *text, size_t size)
{
    if (!p->words_only) {
        snprintf(text, size, "%g .. %g", p->lowest, p->highest);
        return;
    }
    text[0] = '\0';
    for (const struct word *w = p->words; w->name; w++) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s%s", used ? " | " : "", w->name);
    }
}

bool parameter_parse(struct session *session, const struct parameter *p, const char *text, double *value)
{
    char range[64], shown[VALUE_SHOWN];
    parameter_range(p, range, sizeof range);
    for (const struct word *w = p->words; w && w->name; w++) {
        if (strcmp(w->name, text) == 0) {
            *value = w->value;
            return true;
        }
    }
    if (p->words_only)
        return session_error(session, "%s cannot be '%s'; it is one of %s", p->name, value_shown(text, shown),
                             range);
    double number;
    const char *wrong = value_parse(text, &number);
    if (wrong)
        return session_error(session, "%s = '%s' %s; %s is a number in %s%s", p->name,
                             value_shown(text, shown), wrong, p->name, range,
                             p->words == mass_words ? ", hollow or massive" : "");
    if (!(number >= p->lowest && number <= p->highest))
        return session_error(session, "%s = %.10g is out of range; %s is a number in %s", p->name, number,
                             p->name, range);
    *value = number;
    return true;
}
