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

KERNEL_SHARED struct dom_train dynamics_of_domino(const struct dom_row *row, size_t k)
{
#define OF_ROW(effect, member, status) .member = row->member,
    const struct dom_domino *self = &row->domino[k];
    const dom_real height = self->height, width = self->width > 0 ? self->width : height / 2;
    struct dom_train own = {DOM_DYNAMICS(OF_ROW).d = self->thickness / height, .q = 4,
                            .width = width / height};
#undef OF_ROW
    own.walls = height > row->boxes_above ? row->walls / height : 0;
    own.air = row->air * height * self->thickness * width / self->mass; /* the ratio of the densities */
    if (row->rho != 0 && self->radius > 0)
        own.rho = self->radius / height;
    return own;
}

#define VALUE(effect, member, status) train->member,

KERNEL enum dom_status dynamics_read(const struct dom_train *train, const struct dom_compute *compute,
                                     struct geometry *geometry)
{
#define APPLY(effect, member, status) effect##_apply,
    static enum dom_status (*const apply[])(struct geometry *, real) = {DOM_DYNAMICS(APPLY)};
#undef APPLY
    const dom_real value[] = {DOM_DYNAMICS(VALUE)};
    const struct dom_compute how = compute_or_default(compute);
    enum dom_status status = DOM_OK;
    *geometry = (struct geometry){.s = (real)train->s,
                                  .r = (real)train->r,
                                  .d = (real)train->d,
                                  .q = (real)train->q,
                                  .width = (real)train->width,
                                  .tol = (real)how.tol,
                                  .conservative = true,
                                  .inertia_factor = 1,
                                  .n = CHAIN_ENDLESS,
                                  .interrupt = how.interrupt,
                                  .work = how.work};
    geometry->steepest = hypot(1, geometry->d);
    geometry_gravity(geometry, 0, 1);
    for (int k = 0; k < DOM_DYNAMICS_COUNT && status == DOM_OK; k++)
        if (value[k] != 0)
            status = apply[k](geometry, (real)value[k]);
    return status;
}

KERNEL enum dom_status train_make(const struct dom_train *train, const struct dom_compute *compute,
                                  bool energies, struct geometry *geometry)
{
    enum dom_status status = train_check(train, compute);
    if (status == DOM_OK)
        status = dynamics_read(train, compute, geometry);
    if (status == DOM_OK)
        status = geometry_set(geometry, geometry->s, geometry->r);
    if (status == DOM_OK && energies)
        far_make(geometry, 40); /* a duration takes about 40 passes */
    return status;
}

KERNEL enum dom_status dynamics_check(const struct dom_train *train)
{
#define STATUS(effect, member, status) status,
    static const enum dom_status bad[] = {DOM_DYNAMICS(STATUS)};
#undef STATUS
    const dom_real value[] = {DOM_DYNAMICS(VALUE)};
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++) {
        const struct dom_effect_argument *argument = effects[k]->argument;
        if (value[k] != 0 && !(value[k] >= argument->lowest && value[k] <= argument->highest))
            return bad[k];
    }
    return DOM_OK;
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
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        if (value[k] != 0 && effects[k]->dissipates)
            return true;
    return false;
}

#undef VALUE

dom_real dom_scale_tau(const struct dom_scale *scale, const struct dom_train *train)
{
    const real d = train->d;
    struct dom_box box = {1, 1}; /* a solid block, if there are no walls */
    dom_box_find(1, d, train->width, train->walls, &box);
    const real inertia = box.inertia + air_entrained(d, train->width, train->air);
    return sqrt(scale->h * (1 + d * d) / (3 * scale->g) * inertia);
}

dom_real dom_scale_speed(const struct dom_scale *scale, const struct dom_train *train, dom_real duration)
{
    dom_real seconds = duration * dom_scale_tau(scale, train);
    return (train->s + train->d) * train->r * scale->h / seconds;
}
