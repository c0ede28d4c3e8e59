/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/parameters.h"
#include "answer/format.h"
#include "language/names.h"
#include "language/quad.h"

/* Names the type of quad precision, for 'show'. */
#if defined DOMQ_REAL_FLOAT128
#define QUAD_TYPE "__float128, 113 bits"
#elif LDBL_MANT_DIG == 113
#define QUAD_TYPE "long double, 113 bits"
#elif LDBL_MANT_DIG > DBL_MANT_DIG
#define QUAD_TYPE "long double, 64 bits"
#else
#define QUAD_TYPE "not available"
#endif

static const char s_help[] =
    "The gap is the free distance between a domino and the one before it. A length, as in 'set s 2 cm', is "
    "divided by h.";
static const char r_help[] =
    "A train is an endless row in which each domino is r times as large as the one before it, in its height, "
    "its thickness and its gap. 'rmax' finds the largest r with which a train keeps falling, and 'effect row "
    "N' makes a row that ends.";
static const char d_help[] =
    "The thickness is the measure of a domino along the row. A length, as in 'set d 7 mm', is divided by h.";
static const char q_help[] =
    "A domino that is twice as large is 2^(q - 1) times as heavy: 8 times if it is solid, like a wooden "
    "block, and 4 times if it is hollow, like a box of boards that stay as thin.";

static const char tol_help[] =
    "The tolerance decides how many dominoes are summed and when iterations stop. Tables show no more digits "
    "than it promises. Rounding errors can be larger where an answer depends strongly on a parameter: 'set "
    "errors on' shows them. The smallest tolerance is 1e-6 in float, 1e-15 in double and 1e-33 in quad "
    "precision. A new precision sets its own default, unless another tol was set. 'cost rmax' shows what a "
    "digit costs.";
static const char precision_help[] = "The same equations in float, double or quad arithmetic. Parameters are "
                                     "kept in the widest arithmetic and "
                                     "rounded to this one: in quad, 7/48 has 34 digits. tol follows if it "
                                     "still has its default; 'set digits 33' shows what quad "
                                     "gives.";
static const char errors_help[] =
    "Each number is followed by +/- and a bound of its error. The bound includes all rounding errors on the "
    "way from the parameters, what tol cuts off, and the digits that are not printed; 'digits' has no effect "
    "then. In csv and json the bound is a column or key of its own, KEY_error. The values of 'print' have no "
    "bounds.";

static const char hints_help[] =
    "While a line is typed, faint text after the cursor shows how it may go on: the last line of the history "
    "that begins so, else the arguments that the command still takes. At the end of the line the right "
    "arrow, "
    "^E and End take an earlier line, and M-f its next word. There are no hints without colours.";
static const char method_help[] =
    "With 'engine' a rigid-body engine, Chipmunk 7, runs every row, as a second opinion: it uses no "
    "equation of this program, and includes contacts that the model lacks, such as that of a fallen domino "
    "with the "
    "foot of the next. Its step is halved until the verdict no longer changes. It takes a thousand times as "
    "long, for rows of up to 200 dominoes. With 'model' the engine runs only rows with effects that the "
    "model lacks, 'effect feet' and 'effect bounce'. Endless trains are always those of the model.";

static domq_real tol_default(const struct domq_arithmetic *arithmetic)
{
    return arithmetic->tol_default;
}

static domq_real tol_floor(const struct domq_arithmetic *arithmetic)
{
    return arithmetic->tol_floor;
}

static bool fuel_check(const struct state *state, domq_real fuel, struct problem *problem)
{
    const struct domq_effect *effect = domq_dynamics(&state->scene.train);
    return fuel != DOM_FUEL_PAPER || !effect ||
           problem_error(problem, "'fuel paper' cannot be combined with %s; first enter 'effect %s off'",
                         effect->name, effect->name);
}

static bool precision_check(const struct state *state, domq_real precision, struct problem *problem)
{
    (void)state;
    const struct domq_arithmetic *arithmetic = domq_arithmetic((enum dom_precision)precision);
    return arithmetic->bits > 0 ||
           problem_error(problem, "%s: %s", arithmetic->name, dom_status_text(DOM_NO_PRECISION));
}

/* Returns the lowest value at the session's precision. */
static domq_real parameter_lowest(const struct state *state, const struct parameter *p)
{
    return p->lowest_of ? p->lowest_of(domq_arithmetic(state->scene.compute.precision)) : p->value->lowest;
}

/* Sets the precision; a tol that was the old default becomes the new one, and one below the new floor that.
 */
static void precision_put(struct state *state, domq_real precision)
{
    enum dom_precision before = state->scene.compute.precision;
    for (const struct parameter *p = session_parameters; p->name; p++) {
        if (!p->fallback_of)
            continue;
        state->scene.compute.precision = before;
        domq_real value = parameter_get(state, p), was = parameter_fallback(state, p);
        state->scene.compute.precision = (enum dom_precision)precision;
        value = value == was ? parameter_fallback(state, p) : value;
        parameter_put(state, p, p->lowest_of ? quad_larger(value, parameter_lowest(state, p)) : value);
    }
}

/* Adds members to the row of a number of the library's lists; each number has one. */
#define MORE_s .synonyms = "gap separation spacing distance apart", .help = s_help,
#define MORE_r .synonyms = "growth factor ratio size larger train", .help = r_help,
#define MORE_d .synonyms = "thickness thin thick depth width", .help = d_help,
#define MORE_q                                                                                               \
    .synonyms = "exponent wood block box weight material", .help = q_help,                                   \
    .words = (const struct word[]){{"hollow", 3}, {"solid", 4}, {"massive", 4}, {NULL, 0}},
#define MORE_tol                                                                                             \
    .synonyms = "tolerance accuracy precision", .help = tol_help, .fallback_of = tol_default,                \
    .lowest_of = tol_floor,
#define MORE_h .synonyms = "height size tall scale",
#define MORE_g .synonyms = "gravity acceleration weight moon planet",

/* Formats by number, in the order of their list. */
#define FORMAT_NUMBER(name) FORMAT_##name,
#define FORMAT_WORD(name)   {#name, FORMAT_##name},
enum { FORMATS(FORMAT_NUMBER) };

/* Rows whose commas are a macro's are not rows to clang-format. */
/* clang-format off */
#define WORD_LIST(...) (const struct word[]){__VA_ARGS__, {NULL, 0}}
#define SWITCH WORD_LIST({"off", 0}, {"on", 1})
/* A row's first members: where it is stored, and its value. */
#define ROW(name_, member, unit_, meaning_, ...) \
    .name = name_, .offset = offsetof(struct state, member), \
    .value = (const struct domq_effect_argument[]){{.name = name_, .unit = unit_, .meaning = meaning_, __VA_ARGS__}}
#define NUMBER(of, name_, default_, lowest_, highest_, unit_, meaning_) \
    {ROW(#name_, of.name_, unit_, meaning_, .usual = (domq_real)(default_), .lowest = (domq_real)(lowest_), \
         .highest = (domq_real)(highest_)), MORE_##name_},
#define TRAIN_NUMBER(...) NUMBER(scene.train, __VA_ARGS__)
#define COMPUTE_NUMBER(...) NUMBER(scene.compute, __VA_ARGS__)
#define SCALE_NUMBER(...) NUMBER(scene.scale, __VA_ARGS__)
#define DYNAMICS(name, member, status) EFFECT(name)
#define EFFECT(name) EFFECT_ROW(name, domq_effect_##name, DOM_EFFECT_##name)
#define ENGINE_EFFECT(name) EFFECT_ROW(name, engine_effect_##name, EFFECT_##name)
#define EFFECT_ROW(name_, of, number) \
    {.name = #name_, .value = of.argument, .effect = &of, .which = number, .words = WORD_LIST({"off", EFFECT_OFF}, {"on", EFFECT_ON})},

const struct parameter session_parameters[] = {
    DOMQ_TRAIN_PARAMETERS(TRAIN_NUMBER)
    DOMQ_COMPUTE_PARAMETERS(COMPUTE_NUMBER)
    DOMQ_SCALE_PARAMETERS(SCALE_NUMBER)
    {ROW("mass", scene.mass, "kg", "mass of the first domino; 0 for none: energies in m g h/2", .highest = 1e9),
     .synonyms = "weight kilogram energy joule"},
    {ROW("density", scene.density, "kg/m^3", "density of the first domino, solid, half as wide as tall; 0 for none",
         .highest = 1e9),
     .synonyms = "wood weight material"},
    {ROW("fuel", scene.train.fuel, "", "energy balance, or the paper's closed form of (25; c7)", .usual = DOM_FUEL_EXACT),
     .synonyms = "energy paper",
     .words = WORD_LIST({"exact", DOM_FUEL_EXACT}, {"paper", DOM_FUEL_PAPER}), .words_only = true,
     .check = fuel_check},
    {ROW("precision", scene.compute.precision, "", "arithmetic of the answers; quad is " QUAD_TYPE, .usual = DOM_DOUBLE),
     .synonyms = "accuracy digits float double quad",
     .words = WORD_LIST({"float", DOM_FLOAT}, {"double", DOM_DOUBLE}, {"quad", DOM_QUAD}), .words_only = true,
     .help = precision_help, .moves = "tol", .check = precision_check, .put = precision_put},
    {ROW("method", scene.method, "", "what runs rows: the model, or a rigid-body engine", .usual = METHOD_MODEL),
     .synonyms = "engine chipmunk simulation second opinion compare check",
     .words = WORD_LIST({"model", METHOD_MODEL}, {"engine", METHOD_ENGINE}), .words_only = true,
     .help = method_help},
    {ROW("seed", scene.seed, "", "start of the random numbers: the same seed, the same rows", .highest = (domq_real)4294967295.0,
         .usual = SEED_DEFAULT, .whole = true),
     .synonyms = "random chance"},
    {ROW("threads", settings.threads, "", "threads of curves, sweeps and studies; 0: one a processor",
         .highest = 256, .whole = true),
     .synonyms = "parallel cores processors cpu fast", .setting = true},
    {ROW("output", settings.style.output, "", "how answers are written", .usual = 0),
     .synonyms = "format csv json spreadsheet",
     .words = (const struct word[]){FORMATS(FORMAT_WORD){NULL, 0}}, .words_only = true, .setting = true},
    {ROW("header", settings.style.header, "", "whether csv begins with the names of its columns", .usual = 1),
     .synonyms = "csv columns names first line",
     .words = SWITCH, .words_only = true, .setting = true},
    {ROW("digits", settings.style.digits, "", "significant digits in tables; csv and json have all", .lowest = 1,
         .highest = WIDE_DIGITS, .usual = DIGITS_DEFAULT, .whole = true),
     .synonyms = "decimals accuracy", .setting = true},
    {ROW("angle", settings.style.angle, "", "unit of angles, in input and answers", .usual = ANGLE_RAD),
     .synonyms = "degrees radians",
     .words = WORD_LIST({"rad", ANGLE_RAD}, {"deg", ANGLE_DEG}), .words_only = true, .setting = true},
    {ROW("errors", settings.style.errors, "", "whether each number has a bound of its error", .usual = 0),
     .synonyms = "accuracy uncertainty precision bounds",
     .words = SWITCH, .words_only = true, .setting = true, .help = errors_help},
    {ROW("timing", settings.timing, "", "whether each answer ends with its time", .usual = 0),
     .synonyms = "seconds speed fast",
     .words = SWITCH, .words_only = true, .setting = true},
    {ROW("hints", settings.hints, "", "whether the prompt shows how a line may go on", .usual = 1),
     .synonyms = "suggestion grey prompt history usage",
     .words = SWITCH, .words_only = true, .setting = true, .help = hints_help},
    DOM_DYNAMICS(DYNAMICS)
    DOM_EFFECTS(EFFECT)
    ENGINE_EFFECTS(ENGINE_EFFECT)
    {.name = NULL},
};
/* clang-format on */

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

const struct parameter *parameter_find(const char *name)
{
    int k = names_exact(parameter_names, NULL, name);
    return k < 0 ? NULL : &session_parameters[k];
}

const struct domq_effect_argument *parameter_value(const struct parameter *p, int i)
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
    return p->effect        ? EFFECT_OFF
           : p->fallback_of ? p->fallback_of(domq_arithmetic(state->scene.compute.precision))
                            : p->value->usual;
}

void parameter_put(struct state *state, const struct parameter *p, domq_real value)
{
    char *place = (char *)state + p->offset;
    if (p->put)
        p->put(state, value);
    if (p->effect)
        effect_put(&state->scene, p->which, value);
    else if (p->words_only)
        *(unsigned *)(void *)place = (unsigned)value;
    else
        *(domq_real *)(void *)place = value;
}

_Static_assert(sizeof(enum dom_fuel) == sizeof(unsigned) && sizeof(enum angle) == sizeof(unsigned) &&
                   sizeof(enum dom_precision) == sizeof(unsigned),
               "parameter_get reads an enum as an unsigned");

bool parameter_set(struct state *state, const struct parameter *p, const domq_real *value, int given,
                   const char *path, const struct means *means, struct problem *problem)
{
    if (p->effect)
        return effect_turn(&state->scene, p->which, value, given, path, means, problem);
    if (p->check && !p->check(state, value[0], problem))
        return false;
    parameter_put(state, p, value[0]);
    return true;
}

bool state_assign(struct state *state, const struct assigned *assigned, int count, struct problem *problem)
{
    for (int words = 1; words >= 0; words--)
        for (int i = 0; i < count; i++) {
            const struct parameter *p = assigned[i].parameter;
            domq_real value = assigned[i].value;
            if (p->words_only != (words == 1))
                continue;
            if (!p->words_only && value != EFFECT_OFF && !parameter_check(state, p, 0, value, problem))
                return false;
            parameter_put(state, p, value);
        }
    for (int i = 0; i < count; i++) {
        const struct parameter *p = assigned[i].parameter;
        if (p->effect && state->scene.effect[p->which].on && !effect_needs(&state->scene, p->which, problem))
            return false;
    }
    return true;
}

/* Returns the place of a parameter among those that are set one after the other. */
static int rank(const struct state *state, const struct parameter *p)
{
    if (p->effect)
        return state->scene.effect[p->which].on ? 5
                                                : !p->effect->needs; /* what needs another one is off first */
    return !p->words_only ? 4 : p->setting ? 2 : 3;
}

const struct parameter *parameter_in_order(const struct state *state, int k)
{
    for (int at = 0; at <= 5; at++)
        for (const struct parameter *p = session_parameters; p->name; p++)
            if (rank(state, p) == at && k-- == 0)
                return p;
    return NULL;
}

void parameter_save(const struct state *state, const struct parameter *p, const char *folder, FILE *out)
{
    char value[WIDE_TEXT], unit[64];
    if (p->effect) {
        effect_save(&state->scene, p->which, folder, out);
        return;
    }
    parameter_text(p, parameter_get(state, p), WIDE_DIGITS, value, sizeof value);
    struct quantity quantity = expression_unit(p->value->unit);
    bool has_unit = parameter_is_number(p) && !quantity_plain(quantity) && !quantity.angle;
    fprintf(out, "set %s %s%s%s\n", p->name, value, has_unit ? " " : "",
            has_unit ? expression_unit_typed(quantity, unit, sizeof unit) : "");
}

const char *parameter_word(const struct parameter *p, domq_real value)
{
    for (const struct word *w = p->words; w && w->name; w++)
        if (w->value == value)
            return w->name;
    return NULL;
}

void parameter_range(const struct state *state, const struct parameter *p, int i, char *text, size_t size)
{
    int digits = p->value[i].whole ? 15 : 6; /* a whole number is shown whole */
    if (!p->words_only)
        snprintf(text, size, "%.*g .. %.*g", digits,
                 (double)(i ? p->value[i].lowest : parameter_lowest(state, p)), digits,
                 (double)p->value[i].highest);
    size_t used = 0;
    for (const struct word *w = p->words; p->words_only && w->name && used < size; w++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", used ? "|" : "", w->name);
}

void parameter_text(const struct parameter *p, domq_real value, int digits, char *text, size_t size)
{
    char number[WIDE_TEXT];
    const char *word = parameter_is_number(p) ? NULL : parameter_word(p, value);
    digits = p->value->whole && digits < 15 ? 15 : digits; /* a whole number is shown whole */
    snprintf(text, size, "%s",
             word                    ? word
             : digits >= WIDE_DIGITS ? quad_exact(value, number)
                                     : quad_text(value, digits < 15 ? digits : 15, number));
}

bool parameter_check(const struct state *state, const struct parameter *p, int i, domq_real value,
                     struct problem *problem)
{
    char range[64], meaning[96] = "";
    const struct domq_effect_argument *of = &p->value[i];
    const struct domq_arithmetic *arithmetic = domq_arithmetic(state->scene.compute.precision);
    domq_real lowest = i ? of->lowest : parameter_lowest(state, p);
    bool broken = of->whole && value != quad(floor)(value);
    /* The doubles of the table are the nearest to decimals: both are inside. */
    if (!broken && (value >= lowest || (p->lowest_of && (double)value >= (double)lowest)) &&
        value <= of->highest)
        return true;
    parameter_range(state, p, i, range, sizeof range);
    if (broken)
        return problem_no_answer(problem, "%s = %s is not a whole number; %s is a whole number in %s",
                                 of->name, quad_shown(value).text, of->name, range);
    if (p->lowest_of && value > 0 && value < lowest)
        return problem_no_answer(
            problem, "%s = %s is below what %s precision can give; %s is a number in %s%s", p->name,
            quad_shown(value).text, arithmetic->name, p->name, range,
            state->scene.compute.precision == DOM_QUAD ? "" : ", a wider precision has a lower floor");
    if (p->effect)
        snprintf(meaning, sizeof meaning, ", the %s,", of->meaning);
    return problem_no_answer(problem, "%s = %s is out of range; %s%s is a number in %s%s%s%s", of->name,
                             quad_shown(value).text, of->name, meaning, range, *of->unit ? " " : "", of->unit,
                             p->words && !p->effect ? ", or one of its words" : "");
}

struct answer_style state_style(const struct state *state)
{
    struct answer_style style = state->settings.style;
    int bits = domq_arithmetic(state->scene.compute.precision)->bits;
    style.format = format_at(style.output);
    style.precision = state->scene.compute.precision;
    style.all_digits = 2 + bits * 30103 / 100000; /* ceil(1 + bits log10(2)) */
    style.tol_digits = (int)fmax(floor(-log10((double)state->scene.compute.tol) + 1e-6), 1);
    style.digits = quad_smaller(style.digits, style.all_digits);
    return style;
}
