/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is the same in every precision; its arithmetic is the widest. */
#define REAL_QUAD
#include "dynamics/list.h"
#include "numerics/real.h"

const char *dom_status_text(enum dom_status status)
{
    switch (status) {
#define TEXT(name, text)                                                                                     \
    case DOM_##name:                                                                                         \
        return text;
        DOM_STATUSES(TEXT)
#undef TEXT
    }
    return "unknown status";
}

#define DEFAULT(name, default_, lowest, highest, unit, meaning) .name = default_,

struct dom_train dom_train_default(void)
{
    return (struct dom_train){DOM_TRAIN_PARAMETERS(DEFAULT).precision = DOM_DOUBLE, .fuel = DOM_FUEL_EXACT};
}

struct dom_scale dom_scale_default(void)
{
    return (struct dom_scale){DOM_SCALE_PARAMETERS(DEFAULT)};
}

const char *dom_end_text(enum dom_end end)
{
    static const char *const text[] = {
        [DOM_END_NONE] = "none", [DOM_END_BARRIER] = "barrier", [DOM_END_REACH] = "reach"};
    return text[end];
}

const char *dom_event_text(enum dom_event_kind kind)
{
    static const char *const text[] = {[DOM_EVENT_LAUNCH] = "launch",
                                       [DOM_EVENT_FALL] = "fall",
                                       [DOM_EVENT_TOP] = "top",
                                       [DOM_EVENT_STOP] = "stop",
                                       [DOM_EVENT_HIT] = "hit"};
    return text[kind];
}

dom_real dom_scale_tau(const struct dom_scale *scale, dom_real d)
{
    return sqrt(scale->h * (1 + d * d) / (3 * scale->g));
}

dom_real dom_scale_speed(const struct dom_scale *scale, const struct dom_train *train, dom_real duration)
{
    dom_real seconds = duration * dom_scale_tau(scale, train->d);
    return (train->s + train->d) * train->r * scale->h / seconds;
}

/*
 * The floors of tol: some five units, for the roundings that no tolerance undoes.  A long double of 64
 * bits is the best that some machines have.
 */
#define TENTH(power) (1 / (dom_real)(power)) /* of a power of ten that a double holds exactly */

const struct dom_arithmetic *dom_arithmetic(enum dom_precision precision)
{
    static const struct dom_arithmetic table[] = {
        [DOM_FLOAT] = {"float", "float", FLT_MANT_DIG, (double)FLT_EPSILON, TENTH(1e5), TENTH(1e6), 5},
        [DOM_DOUBLE] = {"double", "double", DBL_MANT_DIG, DBL_EPSILON, TENTH(1e12), TENTH(1e15), 10},
#if defined DOM_REAL_FLOAT128
        [DOM_QUAD] = {"quad", "__float128", 113, 0x1p-112, TENTH(1e15) / 1e15, TENTH(1e15) / 1e18, 30},
#elif LDBL_MANT_DIG == 113
        [DOM_QUAD] = {"quad", "long double", 113, 0x1p-112, TENTH(1e15) / 1e15, TENTH(1e15) / 1e18, 30},
#elif LDBL_MANT_DIG > DBL_MANT_DIG
        [DOM_QUAD] = {"quad", "long double", LDBL_MANT_DIG, (double)LDBL_EPSILON, TENTH(1e17), TENTH(1e18),
                      17},
#else
        [DOM_QUAD] = {"quad", "none wider than double", 0, DBL_EPSILON, TENTH(1e12), TENTH(1e15), 10},
#endif
    };
    return &table[precision];
}

const char *dom_row_end_text(enum dom_row_end end)
{
    static const char *const text[] = {
#define END_TEXT(name, text) [DOM_ROW_##name] = text,
        DOM_ROW_ENDS(END_TEXT)
#undef END_TEXT
    };
    return text[end];
}

void dom_row_of_train(const struct dom_train *train, const struct dom_scale *scale, dom_real mass,
                      struct dom_domino *domino, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        dom_real height = scale->h * pow(train->r, (dom_real)k);
        domino[k] = (struct dom_domino){
            .height = height,
            .thickness = train->d * height,
            .gap = k == 0 ? 0 : train->s * height,
            .mass = mass * pow(train->r, (train->q - 1) * (dom_real)k),
        };
    }
}

const struct dom_effect *dom_effect(enum dom_effect_name name)
{
    static const struct dom_effect *const all[] = {
#define DYNAMICS(effect, member) &dom_effect_##effect,
#define EFFECT(effect)           &dom_effect_##effect,
        DOM_DYNAMICS(DYNAMICS) DOM_EFFECTS(EFFECT)
#undef DYNAMICS
#undef EFFECT
    };
    return all[name];
}

const struct dom_effect *dom_dynamics(const struct dom_train *train)
{
    const struct dynamics_values values = dynamics_of_train(train);
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        if (dynamics_on(values.of[k]))
            return dom_effect((enum dom_effect_name)k);
    return NULL;
}

const struct dom_effect *dom_law(const struct dom_train *train)
{
    const struct dynamics_values values = dynamics_of_train(train);
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        if (dynamics_on(values.of[k]) && dom_effect((enum dom_effect_name)k)->dissipates)
            return dom_effect((enum dom_effect_name)k);
    return &dom_energy_balance;
}
