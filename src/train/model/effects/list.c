/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of the effects, which have a file each, the law of motion that they make, and the units of time
 * that depend on them. */
#include "effects/effects.h"

static const struct dom_effect *const effects[DOM_EFFECT_COUNT] = {
#define EFFECT(effect)                   [DOM_EFFECT_##effect] = &dom_effect_##effect,
#define DYNAMICS(effect, member, status) EFFECT(effect)
    DOM_DYNAMICS(DYNAMICS) DOM_EFFECTS(EFFECT)};

const struct dom_effect *dom_effect(enum dom_effect_name name)
{
    return name < DOM_EFFECT_COUNT ? effects[name] : NULL;
}

static const struct terms *const terms[] = {
#define DYNAMICS_TERMS(effect, member, status) &effect##_terms,
    DOM_DYNAMICS(DYNAMICS_TERMS)
#undef DYNAMICS_TERMS
};

KERNEL enum dom_status dynamics_choose(const dom_real effect[DOM_DYNAMICS_COUNT], struct geometry *geometry)
{
    enum dom_status status = DOM_OK;
    geometry->conservative = true;
    for (int i = 0; i < DOM_DYNAMICS_COUNT && status == DOM_OK; i++)
        if (effect[i] != 0)
            status = terms[i]->apply(geometry, (real)effect[i]);
    return status;
}

KERNEL void dynamics_of_domino(const struct dom_row *row, size_t k, dom_real effect[DOM_DYNAMICS_COUNT])
{
/* without a loop, so that effects of which all dominoes have the same value cost nothing */
#define DYNAMICS_VALUE(name, member, status)                                                                 \
    effect[DOM_EFFECT_##name] = row->member;                                                                 \
    if (name##_terms.of_domino && row->member != 0)                                                          \
        effect[DOM_EFFECT_##name] = name##_terms.of_domino(row, k);
    DOM_DYNAMICS(DYNAMICS_VALUE)
#undef DYNAMICS_VALUE
}

#define VALUE(effect, member, status) train->member,

KERNEL enum dom_status dynamics_read(const struct dom_train *train, const struct dom_compute *compute,
                                     struct geometry *geometry)
{
    const dom_real value[] = {DOM_DYNAMICS(VALUE)};
    *geometry = geometry_read(train, compute);
    return dynamics_choose(value, geometry);
}

KERNEL enum dom_status dynamics_make(const struct dom_train *train, const struct dom_compute *compute,
                                     struct geometry *geometry)
{
    enum dom_status status = dynamics_read(train, compute, geometry);
    if (status == DOM_OK)
        status = geometry_set(geometry, geometry->s, geometry->r);
    if (status == DOM_OK)
        far_make(geometry, 40); /* a duration takes about 40 passes */
    return status;
}

KERNEL enum dom_status train_make(const struct dom_train *train, const struct dom_compute *compute,
                                  struct geometry *geometry)
{
    const enum dom_status status = train_check(train, compute);
    *geometry = (struct geometry){.flow = NULL}; /* for dynamics_end */
    return status == DOM_OK ? dynamics_make(train, compute, geometry) : status;
}

KERNEL enum dom_status dynamics_check(const dom_real effect[DOM_DYNAMICS_COUNT])
{
#define STATUS(effect, member, status) status,
    static const enum dom_status bad[] = {DOM_DYNAMICS(STATUS)};
#undef STATUS
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++) {
        const struct dom_effect_argument *argument = effects[k]->argument;
        if (effect[k] != 0 && !(effect[k] >= argument->lowest && effect[k] <= argument->highest))
            return bad[k];
    }
    return DOM_OK;
}

KERNEL_SHARED bool dynamics_dissipate(const dom_real effect[DOM_DYNAMICS_COUNT])
{
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        if (effect[k] != 0 && effects[k]->dissipates)
            return true;
    return false;
}

const struct dom_effect *dom_first_effect(const struct dom_train *train)
{
    const dom_real value[] = {DOM_DYNAMICS(VALUE)};
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        if (value[k] != 0 && !effects[k]->cancels)
            return effects[k];
    return NULL;
}

bool dom_dissipates(const struct dom_train *train)
{
    const dom_real value[] = {DOM_DYNAMICS(VALUE)};
    return dynamics_dissipate(value);
}

dom_real dom_scale_tau(const struct dom_scale *scale, const struct dom_train *train)
{
    dom_real d = train->d, solid = scale->h * (1 + d * d) / (3 * scale->g);
    const dom_real value[] = {DOM_DYNAMICS(VALUE)};
    return sqrt(solid * inertia_factor(d, train->width, value));
}

#undef VALUE

dom_real dom_scale_speed(const struct dom_scale *scale, const struct dom_train *train, dom_real duration)
{
    dom_real seconds = duration * dom_scale_tau(scale, train);
    return (train->s + train->d) * train->r * scale->h / seconds;
}
