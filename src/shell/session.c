/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session.h"
#include "terminal.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const struct word mass_words[] = {{"hollow", 3}, {"massive", 4}, {NULL, 0}};
static const struct word fuel_words[] = {{"exact", DOM_FUEL_EXACT}, {"paper", DOM_FUEL_PAPER}, {NULL, 0}};
static const struct word output_words[] = {
    {"table", OUTPUT_TABLE}, {"csv", OUTPUT_CSV}, {"json", OUTPUT_JSON}, {NULL, 0}};
static const struct word angle_words[] = {{"rad", ANGLE_RAD}, {"deg", ANGLE_DEG}, {NULL, 0}};
static const struct word switch_words[] = {{"off", 0}, {"on", 1}, {NULL, 0}};

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
#define WORDS(name_, member, words_, setting_, meaning_)                                                     \
    {.name = name_,                                                                                          \
     .unit = "",                                                                                             \
     .meaning = meaning_,                                                                                    \
     .words = words_,                                                                                        \
     .words_only = true,                                                                                     \
     .offset = offsetof(struct session, member),                                                             \
     .setting = setting_},

const struct parameter session_parameters[] = {
    DOM_TRAIN_PARAMETERS(TRAIN_NUMBER) DOM_SCALE_PARAMETERS(SCALE_NUMBER)
        WORDS("fuel", train.fuel, fuel_words, false, "energy balance, or the paper's closed form of (c7)")
            WORDS("output", style.output, output_words, true,
                  "how answers are written"){.name = "digits",
                                             .unit = "",
                                             .meaning = "significant digits in tables; csv and json have 17",
                                             .fallback = 10,
                                             .lowest = 1,
                                             .highest = 17,
                                             .whole = true,
                                             .offset = offsetof(struct session, style.digits),
                                             .setting = true},
    WORDS("angle", style.angle, angle_words, true, "unit of angles, typed and answered")
        WORDS("timing", timing, switch_words, true, "whether every answer ends with its time"){.name = NULL},
};

/* Blanks before a line that is repeated above its caret. */
enum { CARET_INDENT = 2 };

void session_init(struct session *session, FILE *out)
{
    *session = (struct session){.train = dom_train_default(), .scale = dom_scale_default(), .out = out};
    session->style.digits = parameter_find("digits")->fallback;
}

/*
 * At the prompt a caret points at the place: in the typed line, if that stands right above, else in a
 * copy of it.
 */
static void session_caret(const struct session *session)
{
    int width = terminal_width(stderr), at = session->prompt_width + session->column;
    if (!session->prompt_width || !session->column || !session->typed)
        return;
    bool above = session->fresh && width > 0;
    if (!above && session->typed_columns + CARET_INDENT >= width)
        return;
    if (above) /* a long line goes on in the next row */
        at = (at - 1) % width + 1;
    if (!above)
        fprintf(stderr, "%*s%.*s\n", CARET_INDENT, "", session->typed_length, session->typed);
    fprintf(stderr, "%*s\n", above ? at : session->column + CARET_INDENT, "^");
}

bool session_error(struct session *session, const char *format, ...)
{
    char text[1024];
    int n = 0;
    fflush(session->out); /* so that both streams keep their order where they share a file */
    ticker_stop();
    session_caret(session);
    if (session->source && session->column)
        n = snprintf(text, sizeof text, "%s:%ld:%d: ", session->source, session->line, session->column);
    else if (session->source)
        n = snprintf(text, sizeof text, "%s:%ld: ", session->source, session->line);
    n = n < (int)sizeof text / 2 ? n : (int)sizeof text / 2;
    if (session->command)
        n += snprintf(text + n, sizeof text - (size_t)n, "%s: ", session->command);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + n, sizeof text - (size_t)n, format, arguments);
    va_end(arguments);
    bool colour = terminal_colour(stderr) && !session->source;
    fputs(colour ? "\033[31m" : "", stderr);
    output_wrapped(stderr, text, 0, session->prompt_width ? terminal_width(stderr) : 0);
    fputs(colour ? "\033[m\n" : "\n", stderr);
    session->fresh = false;
    session->errors++;
    return false;
}

bool session_stops(const struct session *session, long errors)
{
    return session->quit || ferror(session->out) || (session->bail && session->errors > errors) ||
           (session->train.interrupt && *session->train.interrupt);
}

bool session_status(struct session *session, enum dom_status status)
{
    const struct dom_train *t = &session->train;
    session->column = 0;
    if (status == DOM_OUT_OF_REACH)
        return session_error(session,
                             "r s = %.10g > 1: the head falls past the next domino without touching it; "
                             "at s = %.10g r may be up to 1/s = %.17g",
                             t->r * t->s, t->s, 1 / t->s);
    if (status == DOM_TOO_LONG)
        return session_error(session, "%s; a larger s, d or tol needs fewer", dom_status_text(status));
    return session_error(session, "%s", dom_status_text(status));
}

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

_Static_assert(sizeof(enum output) == sizeof(unsigned) && sizeof(enum dom_fuel) == sizeof(unsigned) &&
                   sizeof(enum angle) == sizeof(unsigned),
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

void parameter_text(const struct parameter *p, double value, int digits, char *text, size_t size)
{
    const char *word = p->words_only ? parameter_word(p, value) : NULL;
    if (word) {
        snprintf(text, size, "%s", word);
        return;
    }
    /* Where all digits are wanted, the fewest that read back to the same double. */
    for (int n = digits < 17 ? digits : 15; n <= digits; n++) {
        snprintf(text, size, "%.*g", n, value);
        if (strtod(text, NULL) == value)
            return;
    }
}

bool parameter_check(struct session *session, const struct parameter *p, double value)
{
    char range[64];
    parameter_range(p, range, sizeof range);
    if (p->whole && value != floor(value))
        return session_error(session, "%s = %.10g is no whole number; %s is one in %s", p->name, value,
                             p->name, range);
    if (value >= p->lowest && value <= p->highest)
        return true;
    return session_error(session, "%s = %.10g is out of range; %s is a number in %s%s%s%s", p->name, value,
                         p->name, range, *p->unit ? " " : "", p->unit,
                         p->words ? ", or one of its words" : "");
}
