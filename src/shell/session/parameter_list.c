/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/answer.h"
#include "language/quad.h"
#include "language/text.h"
#include "session/parameters.h"
#include <string.h>

static const char s_help[] =
    "The gap before a domino is the clear distance from the previous domino. s is this gap divided by the "
    "height of the domino. If you give a length, as in 'set s 2 cm', it is divided by h.";
static const char r_help[] = "A train is an endless row in which the height, the thickness and the gap of "
                             "each domino are r times those of the one before. 'rmax' finds the largest r at "
                             "which a train keeps falling.";
static const char d_help[] =
    "The thickness is the size of a domino along the row, and d is the thickness divided by the height. If "
    "you give a length, as in 'set d 7 mm', it is divided by h.";
static const char q_help[] =
    "A domino that is twice as large is 2^(q - 1) times as heavy: 8 times if it is solid, like a wooden "
    "block, and 4 times if it is hollow, like a box whose boards have the same thickness at every size.";
static const char width_help[] =
    "The width is the size of a domino across the row. In a train, and in a row without a file, every "
    "domino has the same width relative to its height. A length, as in 'set width 24 mm', is the width of "
    "the first domino or, in a row from a file, of all dominoes for which the file gives none. The width "
    "counts in masses that follow from a density, in the boxes of 'set walls', and in boards. 'w' is short "
    "for width.";
static const char tol_help[] =
    "The tolerance decides how many dominoes are summed and when iterations stop. Tables show no more "
    "digits than it justifies. Rounding errors can exceed it. The smallest tolerance is 1e-6 in float, "
    "1e-15 in double and 1e-33 in quad precision. If you have not set tol, 'set precision' also sets tol. "
    "'cost rmax' shows how much time each digit costs.";
static const char precision_help[] =
    "The equations are solved in float, double or quad arithmetic. Parameters keep all their digits, and are "
    "rounded when they are used: in quad, 7/48 has 34 digits. 'set digits 33' shows all digits that quad "
    "gives. Commands that search for a row or run many rows compute in double, and say so.";
static const char density_help[] =
    "If 'mass' is 0, the mass of the first domino is the density times its volume, for which 'set width' "
    "gives the width. With 'set walls', only the volume of the walls counts.";
static bool fuel_check(const struct state *state, const struct parameter *p, domq_real fuel,
                       struct problem *problem)
{
    (void)p;
    const struct domq_effect *effect = domq_first_effect(&state->scene.train);
    return fuel != DOM_FUEL_PAPER || !effect ||
           problem_no_answer(problem, "'fuel paper' cannot be combined with %s; first enter 'set %s off'",
                             effect->name, effect->name);
}

static bool precision_check(const struct state *state, const struct parameter *p, domq_real precision,
                            struct problem *problem)
{
    (void)state, (void)p;
    const struct domq_arithmetic arithmetic = any_arithmetic((enum precision)precision);
    return arithmetic.bits > 0 ||
           problem_error(problem, "%s: %s", arithmetic.name, dom_status_text(DOM_NO_PRECISION));
}

/* The default of tol and its lower bound depend on the precision. If tol has its default, it gets the default
 * of the new precision. Any other tol is kept, unless it has to be raised to the new lower bound. */
static void precision_before(struct state *state, domq_real precision)
{
    struct any_compute *compute = &state->scene.compute;
    const struct domq_arithmetic old = any_arithmetic(compute->precision),
                                 new = any_arithmetic((enum precision)precision);
    compute->tol =
        compute->tol == old.tol_default ? new.tol_default : quad_larger(compute->tol, new.tol_floor);
}

/* The numbers of the output formats, and the words that 'set output' takes for them. */
#define FORMAT_NUMBER(name) FORMAT_##name,
#define FORMAT_WORD(name)   {#name, FORMAT_##name},
enum { FORMATS(FORMAT_NUMBER) };

/* clang-format off */
#define WORD_LIST(...) (const struct word[]){__VA_ARGS__, {NULL, 0}}
/* The library's lists of parameters and effects give only some members of an entry. These macros give the others. */
#define RANGE(from_, to_) .from = from_, .to = to_
#define MORE_s .share = SHARE_s, .synonyms = "gap separation spacing distance apart", .help = s_help, RANGE(0.02, 1),
#define MORE_r .synonyms = "growth factor ratio size larger train", .help = r_help, RANGE(1, 4),
#define MORE_d .share = SHARE_d, .synonyms = "thickness thin thick depth", .help = d_help, RANGE(0.01, 1),
#define MORE_q .synonyms = "exponent wood block box weight material", .help = q_help, RANGE(1, 6), \
    .words = WORD_LIST({"hollow", 3}, {"solid", 4}, {"massive", 4}),
#define MORE_width .share = SHARE_width, .synonyms = "wide broad breadth", .help = width_help, RANGE(0.05, 5),
#define MORE_tol .synonyms = "tolerance accuracy precision", .help = tol_help, .of_precision = true,
#define MORE_h .synonyms = "height size tall scale", RANGE(0.005, 10),
#define MORE_g .synonyms = "gravity acceleration weight moon planet", RANGE(0.1, 30),
#define MORE_friction .example = "set q hollow; set friction 0.2; rmax 0.4; set friction off", RANGE(0, 2),
#define MORE_slope .example = "set slope on; rmax", RANGE(-0.14, 0.14),
#define MORE_edges .share = SHARE_edges, .example = "set q hollow; set edges 0.01; rmax 0.2; set edges off", RANGE(0, 0.05),
#define MORE_walls .share = SHARE_walls, .example = "set walls 1 mm; duration; set walls off", RANGE(1e-4, 0.07),
#define MORE_air .example = "set density 650; set air on; rmax 0.4; set air off", RANGE(0, 5),
#define MORE_drag .example = "set density 650; set air on; set drag 2; rmax 0.4; set drag off; set air off", RANGE(0.5, 3),
#define MORE_push .share = SHARE_push, .example = "set push 3; rmax 0.4; set push off", RANGE(0, 30),
#define MORE_release .words = release_words, .example = "set release 20 deg; rmax 0.4; set release off", RANGE(0, 1.5),
#define SWITCH WORD_LIST({"off", 0}, {"on", 1})
/* The first members of an entry: the name, and the meaning, the offset and the description of the value. */
#define ENTRY(name_, member, unit_, meaning_, ...) \
    .name = name_, .offset = offsetof(struct state, member), .meaning = meaning_, \
    .value = (const struct domq_effect_argument[]){{.name = name_, .unit = unit_, __VA_ARGS__}}
#define NUMBER(of, name_, default_, lowest_, highest_, unit_, meaning_) \
    {ENTRY(#name_, of.name_, unit_, meaning_, .usual = (domq_real)(default_), .lowest = (domq_real)(lowest_), \
         .highest = (domq_real)(highest_)), MORE_##name_},
#define TRAIN_NUMBER(...) NUMBER(scene.train, __VA_ARGS__)
#define COMPUTE_NUMBER(...) NUMBER(scene.compute, __VA_ARGS__)
#define SCALE_NUMBER(...) NUMBER(scene.scale, __VA_ARGS__)
#define DYNAMICS(name, member, status) EFFECT(name)
#define EFFECT(name_) {MORE_##name_ .effect = &domq_effect_##name_, .which = DOM_EFFECT_##name_},

static const struct word effect_words[] = {{"off", EFFECT_OFF}, {"on", EFFECT_ON}, {NULL, 0}},
                         release_words[] = {
                             {"off", EFFECT_OFF}, {"on", EFFECT_ON}, {"touch", RELEASE_TOUCH}, {NULL, 0}};

static const struct parameter every_parameter[] = {
    DOMQ_TRAIN_PARAMETERS(TRAIN_NUMBER)
    DOMQ_COMPUTE_PARAMETERS(COMPUTE_NUMBER)
    DOMQ_SCALE_PARAMETERS(SCALE_NUMBER)
    {ENTRY("mass", scene.mass, "kg", "mass of the first domino, 0 if not known; if no masses are known, energies are in m g h/2", .highest = 1e9),
     .synonyms = "weight kilogram energy joule", RANGE(1e-3, 10)},
    {ENTRY("density", scene.density, "kg/m^3", "density of the material of the first domino; 0 if not known",
         .highest = 1e9),
     .synonyms = "wood weight material", .help = density_help, RANGE(50, 10000)},
    {ENTRY("fuel", scene.train.fuel, "", "how the fuel is computed: by the energy balance, or by the paper's closed form (25; c7)", .usual = DOM_FUEL_EXACT),
     .synonyms = "energy paper",
     .words = WORD_LIST({"exact", DOM_FUEL_EXACT}, {"paper", DOM_FUEL_PAPER}), .words_only = true,
     .check = fuel_check},
    {ENTRY("precision", scene.compute.precision, "", "arithmetic of the answers", .usual = IN_DOUBLE),
     .synonyms = "accuracy digits float double quad",
     .words = WORD_LIST({"float", IN_FLOAT}, {"double", IN_DOUBLE}, {"quad", IN_QUAD}), .words_only = true,
     .help = precision_help, .moves = "tol", .check = precision_check, .before = precision_before},
    {ENTRY("output", settings.style.output, "", "format in which answers are printed", .usual = 0),
     .synonyms = "csv json format spreadsheet",
     .words = (const struct word[]){FORMATS(FORMAT_WORD){NULL, 0}}, .words_only = true, .setting = true},
    {ENTRY("header", settings.style.header, "", "whether csv begins with the names of its columns", .usual = 1),
     .synonyms = "columns names first line csv",
     .words = SWITCH, .words_only = true, .setting = true},
    {ENTRY("digits", settings.style.digits, "", "significant digits in tables; csv and json always have all digits", .lowest = 1,
         .highest = WIDE_DIGITS, .usual = DIGITS_DEFAULT, .whole = true),
     .synonyms = "decimals accuracy", .setting = true},
    {ENTRY("angle", settings.style.angle, "", "unit of angles, both in input and in answers", .usual = ANGLE_RAD),
     .synonyms = "degrees radians",
     .words = WORD_LIST({"rad", ANGLE_RAD}, {"deg", ANGLE_DEG}), .words_only = true, .setting = true},
    DOM_DYNAMICS(DYNAMICS)
    EFFECT(push) /* and 'row', which a feature adds */
    EFFECT(release)
};
/* clang-format on */

enum { PARAMETERS_MOST = 64 };
static struct parameter built[PARAMETERS_MOST], *end = built;
const struct parameter *session_parameters = built;

/* The effects that features describe, from number DOM_EFFECT_COUNT on. */
static const struct parameter *effects[EFFECTS_MOST];
static int effect_count;

const struct domq_effect *effect_at(int k)
{
    return k < DOM_EFFECT_COUNT ? domq_effect((enum dom_effect_name)k) : effects[k]->effect;
}

const struct parameter *parameter_find(const char *name)
{
    const struct parameter *p = session_parameters;
    while (p->name && (*p->name != *name || strcmp(p->name, name) != 0))
        p++;
    return p->name ? p : NULL;
}

bool effect_needs(int effect, int other)
{
    const char *name = effect < DOM_EFFECT_COUNT ? NULL : effects[effect]->needs;
    return other != DOM_EFFECT_row && ((effect_at(effect)->needs >> other & 1) != 0 ||
                                       (name && strcmp(name, effect_at(other)->name) == 0));
}

bool effect_check_needs(const struct scene *scene, int effect, struct problem *problem)
{
    for (int k = 0; k < effect_count; k++)
        if (effect_needs(effect, k) && !scene->effect[k].on)
            return problem_error(problem, "'set %s' needs the effect %s; first enter 'set %s on'",
                                 effect_at(effect)->name, effect_at(k)->name, effect_at(k)->name);
    return effect >= DOM_DYNAMICS_COUNT || effect_at(effect)->cancels ||
           scene->train.fuel != DOM_FUEL_PAPER ||
           problem_no_answer(problem, "'fuel paper' cannot be combined with %s; first enter 'set fuel exact'",
                             effect_at(effect)->name);
}

/* The hook parameter.check of all effects. */
static bool effect_check(const struct state *state, const struct parameter *p, domq_real value,
                         struct problem *problem)
{
    return value == EFFECT_OFF || effect_check_needs(&state->scene, p->which, problem);
}

void parameters_begin(void)
{
    effect_count = DOM_EFFECT_COUNT;
    end = built;
    for (size_t k = 0; k < sizeof every_parameter / sizeof *every_parameter; k++)
        parameters_add(&every_parameter[k]);
}

void parameters_add(const struct parameter *p)
{
    const struct domq_effect *effect = p->effect;
    struct parameter added = *p;
    if (p->number) {
        effects[effect_count] = p;
        added.which = *p->number = effect_count++;
    }
    if ((p->needs && !parameter_find(p->needs)) || end == built + PARAMETERS_MOST - 1)
        return;
    if (effect) {
        added.name = effect->name;
        added.value = effect->argument;
        added.meaning = effect->adds;
        added.help = effect->help;
        added.synonyms = effect->synonyms;
        added.words = p->words ? p->words : effect_words;
        added.check = effect_check;
        added.offset = offsetof(struct state, scene.effect) +
                       (size_t)added.which * sizeof(struct effect_state) +
                       offsetof(struct effect_state, value);
    }
    /* effects come last, in the order of their numbers */
    struct parameter *at = end++;
    for (; at > built && at[-1].effect && (!effect || at[-1].which > added.which); at--)
        *at = at[-1];
    *at = added;
    end->name = NULL;
}
