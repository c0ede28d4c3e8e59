/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'effects', which lists the effects that go beyond the paper. */
#include "explain/derivation.h"

static const char *method_of(const struct parameter *p)
{
    bool loses = p->effect->dissipates;
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        loses = loses || ((p->effect->needs >> k & 1) != 0 && effect_at(k)->dissipates);
    return p->by_engine ? "engine" : loses ? "motion" : "balance";
}

static const struct column effects_columns[] = {
    {"effect", "", "name of the effect", 9},
    {"state", "", "off, or the values of the effect", 12},
    {"method", "", "the quickest method that includes the effect: balance, motion or engine", 8},
    {"adds", "", "what the effect adds to the paper's model", 40},
    {"source", "", "source of the mathematics", 20},
    {NULL, NULL, NULL, 0},
};

static bool run_effects(const struct query *query, struct answer *a, struct problem *problem)
{
    (void)problem;
    const struct parameter *p = session_parameters;
    for (; p->name; p++)
        if (p->effect && !p->is_minor)
            column_fit(&answer_columns(a, a->columns)[1], parameter_setting(query->state, p, 10));
    for (p = session_parameters; p->name && !answer_lost(a); p++)
        if (p->effect && (!p->is_minor || query->scene->effect[p->which].on))
            answer_cells(a, cell_word(p->name), cell_word(parameter_setting(query->state, p, 10)),
                         cell_word(method_of(p)), cell_word(p->meaning), cell_word(p->effect->source));
    answer_say(a, "An effect that is off costs nothing. This scene is computed by %s.",
               scene_engine(query->scene)              ? "the rigid-body engine"
               : domq_dissipates(&query->scene->train) ? "the equation of motion"
                                                       : "the energy balance");
    return true;
}

const struct command effect_commands[] = {
    {.name = "effects",
     .synonyms = "list switch scene",
     .summary = "what effects there are, which are on, and what each adds",
     .help = "Effects decide which of three methods finds the motion, from the quickest to the slowest: "
             "the energy balance; the equation of motion, if friction or air takes energy; or a "
             "rigid-body engine, for feet that slip and dominoes that bounce, which runs rows only. An "
             "effect that is off costs no computing time. 'details' shows the methods and the sources.",
     .example = "set friction 0.2; effects; set friction off",
     .see = "set show",
     .rows = true,
     .brief = "effect state adds",
     ANSWER(effects)},
    {.name = NULL},
};
