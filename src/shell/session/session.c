/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/session.h"
#include "io/escape.h"
#include "io/terminal.h"
#include "language/names.h"
#include "language/quad.h"
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const struct word mass_words[] = {{"hollow", 3}, {"massive", 4}, {NULL, 0}};
static const struct word fuel_words[] = {{"exact", DOM_FUEL_EXACT}, {"paper", DOM_FUEL_PAPER}, {NULL, 0}};
static const struct word output_words[] = {
    {"table", OUTPUT_TABLE}, {"csv", OUTPUT_CSV}, {"json", OUTPUT_JSON}, {NULL, 0}};
static const struct word angle_words[] = {{"rad", ANGLE_RAD}, {"deg", ANGLE_DEG}, {NULL, 0}};
static const struct word switch_words[] = {{"off", 0}, {"on", 1}, {NULL, 0}};

/* So that 'show' says which. */
#if defined DOMQ_REAL_FLOAT128
#define QUAD_TYPE "__float128, 113 bits"
#elif LDBL_MANT_DIG == 113
#define QUAD_TYPE "long double, 113 bits"
#elif LDBL_MANT_DIG > DBL_MANT_DIG
#define QUAD_TYPE "long double, 64 bits"
#else
#define QUAD_TYPE "not to be had here"
#endif

static const struct word precision_words[] = {
    {"float", DOM_FLOAT}, {"double", DOM_DOUBLE}, {"quad", DOM_QUAD}, {NULL, 0}};

static const char tol_help[] =
    "It decides how far down the train the sums go and when iterations stop; tables show no more digits than "
    "it "
    "promises. Where a parameter's last digit moves the answer by more than that, so does rounding: 'set "
    "errors "
    "on' tells. The floor is that of the "
    "precision: 1e-6, 1e-15, 1e-33. A new precision takes its own default along, unless another tol was set; "
    "'cost rmax' shows what a digit costs.";
static const char precision_help[] =
    "One source of the model, compiled for each. Parameters are kept in the widest and rounded to this one: "
    "in quad 7/48 has 34 digits. tol and digits follow where they still have their defaults.";
static const char errors_help[] =
    "Behind each number stands +/- and a bound: of all rounding on the way from the parameters, as the "
    "precision "
    "has them, of what tol cuts off, and of the digits that are not printed; digits does not matter then. In "
    "csv "
    "and json it is a column or key of its own, KEY_error. The values of 'print' have none.";

static domq_real tol_default(const struct domq_arithmetic *arithmetic)
{
    return arithmetic->tol_default;
}

static domq_real tol_floor(const struct domq_arithmetic *arithmetic)
{
    return arithmetic->tol_floor;
}

static domq_real digits_default(const struct domq_arithmetic *arithmetic)
{
    return arithmetic->digits;
}

/* What the shell adds to a number of the library's lists: members of its row.  One for each number. */
#define MORE_s
#define MORE_r
#define MORE_d
#define MORE_q   .words = mass_words,
#define MORE_tol .help = tol_help, .fallback_of = tol_default, .lowest_of = tol_floor,
#define MORE_h
#define MORE_g

#define NUMBER(member, name_, default_, lowest_, highest_, unit_, meaning_)                                  \
    {.name = #name_,                                                                                         \
     .unit = unit_,                                                                                          \
     .meaning = meaning_,                                                                                    \
     .fallback = (domq_real)(default_),                                                                      \
     .lowest = (domq_real)(lowest_),                                                                         \
     .highest = (domq_real)(highest_),                                                                       \
     .offset = offsetof(struct session, member.name_),                                                       \
     MORE_##name_},
#define TRAIN_NUMBER(...)   NUMBER(train, __VA_ARGS__)
#define COMPUTE_NUMBER(...) NUMBER(compute, __VA_ARGS__)
#define SCALE_NUMBER(...)   NUMBER(scale, __VA_ARGS__)
#define WORDS(name_, member, words_, fallback_, setting_, meaning_, help_)                                   \
    {                                                                                                        \
        .name = name_, .unit = "", .meaning = meaning_, .help = help_, .fallback = fallback_,                \
        .words = words_, .words_only = true, .offset = offsetof(struct session, member), .setting = setting_ \
    }

/* clang-format off: to it the lists, whose commas are their own, are no elements. */
const struct parameter session_parameters[] = {
    DOMQ_TRAIN_PARAMETERS(TRAIN_NUMBER) DOMQ_COMPUTE_PARAMETERS(COMPUTE_NUMBER) DOMQ_SCALE_PARAMETERS(
        SCALE_NUMBER){.name = "mass",
                      .unit = "kg",
                      .meaning = "mass of the first domino, 0 for none: energies are then in m g h/2",
                      .highest = 1e9,
                      .offset = offsetof(struct session, mass)},
    {.name = "density",
     .unit = "kg/m^3",
     .meaning = "of solid dominoes half as wide as tall, where no mass is set",
     .highest = 1e9,
     .offset = offsetof(struct session, density)},
    WORDS("fuel", train.fuel, fuel_words, DOM_FUEL_EXACT, false,
          "energy balance, or the paper's closed form of (c7)", NULL),
    WORDS("precision", compute.precision, precision_words, DOM_DOUBLE, false,
          "arithmetic of the answers; quad is " QUAD_TYPE, precision_help),
    {.name = "seed",
     .unit = "",
     .meaning = "of random rows: the same seed, the same rows",
     .fallback = 1,
     .highest = (domq_real)4294967295.0,
     .whole = true,
     .offset = offsetof(struct session, seed)},
    {.name = "threads",
     .unit = "",
     .meaning = "of curves, sweeps and studies; 0: as many as there are processors",
     .highest = 256,
     .whole = true,
     .offset = offsetof(struct session, threads),
     .setting = true},
    WORDS("output", style.output, output_words, OUTPUT_TABLE, true, "how answers are written", NULL),
    {.name = "digits",
     .unit = "",
     .meaning = "significant digits in tables; csv and json have all",
     .fallback = 10,
     .lowest = 1,
     .highest = WIDE_DIGITS,
     .whole = true,
     .fallback_of = digits_default,
     .offset = offsetof(struct session, style.digits),
     .setting = true},
    WORDS("angle", style.angle, angle_words, ANGLE_RAD, true, "unit of angles, typed and answered", NULL),
    WORDS("errors", style.errors, switch_words, 0, true, "whether every number has the bound of its error",
          errors_help),
    WORDS("timing", timing, switch_words, 0, true, "whether every answer ends with its time", NULL),
    {.name = NULL},
};
/* clang-format on */

/* Blanks before a line that is repeated above its caret. */
enum { CARET_INDENT = 2 };

void session_init(struct session *session, FILE *out)
{
    *session = (struct session){.train = domq_train_default(),
                                .compute = domq_compute_default(),
                                .scale = domq_scale_default(),
                                .out = out};
    session->style.digits = parameter_find("digits")->fallback;
    session->seed = parameter_find("seed")->fallback;
}

void listed_free(struct listed_row *row)
{
    free(row->domino);
    free(row->path);
    free(row->placed);
    *row = (struct listed_row){.domino = NULL};
}

void effects_apply(struct session *session)
{
    const struct effect_state *friction = &session->effect[DOM_EFFECT_friction];
    session->train.mu = friction->on ? friction->value[0] : 0;
}

void effects_reset(struct session *session)
{
    for (int k = 0; k < DOM_EFFECT_COUNT; k++)
        session->effect[k] = (struct effect_state){.on = false};
    listed_free(&session->listed);
    effects_apply(session);
}

void session_close(struct session *session)
{
    effects_reset(session);
}

domq_real session_block_mass(const struct session *session, domq_real height, domq_real thickness)
{
    return session->mass > 0 ? session->mass : session->density * height * height * thickness / 2;
}

domq_real session_mass(const struct session *session)
{
    domq_real h = session->scale.h;
    return session_block_mass(session, h, session->train.d * h);
}

/* Returns true if the typed line may be written again: it was pasted, perhaps. */
static bool typed_is_plain(const struct session *session)
{
    char *typed = strndup(session->typed, (size_t)session->typed_length);
    bool plain = typed && !escape_needed(typed);
    free(typed);
    return plain;
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
    if (!above && (session->typed_columns + CARET_INDENT >= width || !typed_is_plain(session)))
        return;
    if (above) /* a long line goes on in the next row */
        at = (at - 1) % width + 1;
    if (!above)
        fprintf(stderr, "%*s%.*s\n", CARET_INDENT, "", session->typed_length, session->typed);
    fprintf(stderr, "%*s\n", above ? at : session->column + CARET_INDENT, "^");
}

/* A point of a sweep has no terminal: the first message is kept. */
static void session_hear(const struct session *session, bool no_answer, const char *format, va_list arguments)
{
    struct captured_error *h = session->captured_error;
    if (*h->text)
        return;
    h->column = session->column;
    h->command = session->command;
    h->no_answer = no_answer;
    vsnprintf(h->text, sizeof h->text, format, arguments);
}

static void session_tell(struct session *session, const char *format, va_list arguments)
{
    char told[1024], text[4 * sizeof told], shown[NAMES_SHOWN];
    const char *source = session->source;
    if (source && escape_needed(source))
        source = names_shown(source, shown); /* a name may not hide the message behind it */
    int n = 0;
    fflush(session->out); /* so that both streams keep their order where they share a file */
    ticker_stop();
    session_caret(session);
    if (source && session->column)
        n = snprintf(told, sizeof told, "%s:%ld:%d: ", source, session->line, session->column);
    else if (source)
        n = snprintf(told, sizeof told, "%s:%ld: ", source, session->line);
    n = n < (int)sizeof told / 2 ? n : (int)sizeof told / 2;
    if (session->command)
        n += snprintf(told + n, sizeof told - (size_t)n, "%s: ", session->command);
    vsnprintf(told + n, sizeof told - (size_t)n, format, arguments);
    escape_text(told, text, sizeof text);
    bool colour = terminal_colour(stderr) && !session->source;
    fputs(colour ? "\033[31m" : "", stderr);
    output_wrapped(stderr, text, 0, session->prompt_width ? terminal_width(stderr) : 0);
    fputs(colour ? "\033[m\n" : "\n", stderr);
    session->fresh = false;
}

static bool session_say(struct session *session, bool no_answer, const char *format, va_list arguments)
{
    if (session->captured_error)
        session_hear(session, no_answer, format, arguments);
    else
        session_tell(session, format, arguments);
    session->errors++;
    return false;
}

bool session_error(struct session *session, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    session_say(session, false, format, arguments);
    va_end(arguments);
    return false;
}

void session_note(struct session *session, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    session_tell(session, format, arguments);
    va_end(arguments);
}

bool session_no_answer(struct session *session, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    session_say(session, true, format, arguments);
    va_end(arguments);
    return false;
}

struct range session_part(const struct session *session, size_t points)
{
    struct shard s = session->shard;
    if (s.parts == 0)
        return (struct range){0, points};
    /* points k / parts, rounded down, without the product, which may be too large. */
    size_t whole = points / s.parts, rest = points % s.parts, k = s.part - 1;
    size_t first = whole * k + rest * k / s.parts, end = whole * (k + 1) + rest * (k + 1) / s.parts;
    return (struct range){first, end - first};
}

bool session_stops(const struct session *session, long errors)
{
    return session->quit || ferror(session->out) || (session->bail && session->errors > errors) ||
           dom_raised(session->compute.interrupt);
}

bool session_status(struct session *session, enum dom_status status)
{
    const struct domq_train *t = &session->train;
    session->column = 0;
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY) /* no matter with which values */
        return session_error(session, "%s", dom_status_text(status));
    if (status == DOM_OUT_OF_REACH)
        return session_no_answer(session,
                                 "r s = %s > 1: the head falls past the next domino without touching it; "
                                 "at s = %s r may be up to 1/s = %.17g",
                                 quad_shown(t->r * t->s).text, quad_shown(t->s).text, (double)(1 / t->s));
    if (status == DOM_NO_METHOD && t->mu > 0 && t->fuel == DOM_FUEL_PAPER)
        return session_no_answer(
            session, "the paper's closed form of the fuel knows no friction; 'set fuel exact', or "
                     "'effect friction off'");
    if (status == DOM_TOO_LONG)
        return session_no_answer(session, "%s; a larger s, d or tol needs fewer", dom_status_text(status));
    return session_no_answer(session, "%s", dom_status_text(status));
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

domq_real parameter_get(const struct session *session, const struct parameter *p)
{
    const char *place = (const char *)session + p->offset;
    if (!p->words_only)
        return *(const domq_real *)(const void *)place;
    return *(const unsigned *)(const void *)place;
}

void parameter_put(struct session *session, const struct parameter *p, domq_real value)
{
    char *place = (char *)session + p->offset;
    if (p->words_only)
        *(unsigned *)(void *)place = (unsigned)value;
    else
        *(domq_real *)(void *)place = value;
}

_Static_assert(sizeof(enum output) == sizeof(unsigned) && sizeof(enum dom_fuel) == sizeof(unsigned) &&
                   sizeof(enum angle) == sizeof(unsigned) && sizeof(enum dom_precision) == sizeof(unsigned),
               "parameter_get reads an enum as an unsigned");

const char *parameter_word(const struct parameter *p, domq_real value)
{
    for (const struct word *w = p->words; w && w->name; w++)
        if (w->value == value)
            return w->name;
    return NULL;
}

void parameter_range(const struct session *session, const struct parameter *p, char *text, size_t size)
{
    if (!p->words_only) {
        snprintf(text, size, "%g .. %g", (double)parameter_lowest(session, p), (double)p->highest);
        return;
    }
    text[0] = '\0';
    for (const struct word *w = p->words; w->name; w++) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s%s", used ? "|" : "", w->name);
    }
}

void parameter_text(const struct parameter *p, domq_real value, int digits, char *text, size_t size)
{
    char number[WIDE_TEXT];
    const char *word = p->words_only ? parameter_word(p, value) : NULL;
    snprintf(text, size, "%s",
             word                    ? word
             : digits >= WIDE_DIGITS ? quad_exact(value, number)
                                     : quad_text(value, digits < 15 ? digits : 15, number));
}

domq_real parameter_fallback(const struct session *session, const struct parameter *p)
{
    return p->fallback_of ? p->fallback_of(domq_arithmetic(session->compute.precision)) : p->fallback;
}

domq_real parameter_lowest(const struct session *session, const struct parameter *p)
{
    return p->lowest_of ? p->lowest_of(domq_arithmetic(session->compute.precision)) : p->lowest;
}

const struct parameter *parameter_in_order(int k)
{
    for (int round = 0; round < 3; round++)
        for (const struct parameter *p = session_parameters; p->name; p++)
            if (round == (!p->words_only ? 2 : !p->setting) && k-- == 0)
                return p;
    return NULL;
}

bool session_precision(struct session *session, enum dom_precision precision)
{
    bool changed = false;
    enum dom_precision before = session->compute.precision;
    for (const struct parameter *p = session_parameters; p->name; p++) {
        session->compute.precision = before;
        domq_real value = parameter_get(session, p), was = parameter_fallback(session, p);
        session->compute.precision = precision;
        domq_real now = value == was ? parameter_fallback(session, p) : value;
        if (p->lowest_of)
            now = quad_larger(now, parameter_lowest(session, p));
        if (p->fallback_of && now != value) {
            parameter_put(session, p, now);
            changed = changed || p->lowest_of;
        }
    }
    return changed;
}

struct domq_compute session_compute(const struct session *session)
{
    struct domq_compute compute = session->compute;
    compute.errors = session->style.errors;
    return compute;
}

struct output_style session_style(const struct session *session)
{
    struct output_style style = session->style;
    int bits = domq_arithmetic(session->compute.precision)->bits;
    style.precision = session->compute.precision;
    style.all_digits = 2 + bits * 30103 / 100000; /* ceil(1 + bits log10(2)) */
    style.tol_digits = (int)quad_larger(quad(floor)(-quad(log10)(session->compute.tol) + (domq_real)1e-6), 1);
    style.digits = quad_smaller(style.digits, style.all_digits);
    return style;
}

bool parameter_check(struct session *session, const struct parameter *p, domq_real value)
{
    char range[64];
    const struct domq_arithmetic *arithmetic = domq_arithmetic(session->compute.precision);
    domq_real lowest = parameter_lowest(session, p);
    parameter_range(session, p, range, sizeof range);
    if (p->whole && value != quad(floor)(value))
        return session_no_answer(session, "%s = %s is no whole number; %s is one in %s", p->name,
                                 quad_shown(value).text, p->name, range);
    /* The doubles of the table are the nearest to decimals: both are inside. */
    if ((value >= lowest || (p->lowest_of && (double)value >= (double)lowest)) && value <= p->highest)
        return true;
    if (p->lowest_of && value > 0 && value < lowest)
        return session_no_answer(
            session, "%s = %s is below what %s precision can give; %s is a number in %s%s", p->name,
            quad_shown(value).text, arithmetic->name, p->name, range,
            session->compute.precision == DOM_QUAD ? "" : ", a wider precision has a lower floor");
    return session_no_answer(session, "%s = %s is out of range; %s is a number in %s%s%s%s", p->name,
                             quad_shown(value).text, p->name, range, *p->unit ? " " : "", p->unit,
                             p->words ? ", or one of its words" : "");
}
