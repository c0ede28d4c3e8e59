/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes derivations: finds the quantities that an answer needs, and their numbers. */
#include "explain/derivation.h"
#include "language/quad.h"
#include "language/text.h"
#include "session/parameters.h"
#include "train/train.h"
#include <string.h>

/* ---- The numbers of the library ---- */

/* Copies a text and replaces '@' by the number that the user typed. */
static void fill_in(const struct derivation *d, const char *text, char *filled, size_t size)
{
    char digits[WIDE_TEXT];
    quad_exact(isnan(d->height) ? d->theta : d->height, WIDE_DIGITS, digits);
    for (filled[0] = '\0'; *text; text++)
        text_add(filled, size, *text == '@' ? "(%s)" : "%.1s", *text == '@' ? digits : text);
}

bool expression_value(const struct query *query, const char *expression, domq_real *value,
                      struct problem *problem)
{
    const struct last_answer none = {.command = NULL};
    struct arena arena = {.block = NULL};
    struct query alone = *query;
    alone.ans = &none;
    struct reader r = {
        .query = &alone, .problem = problem, .at = expression, .arena = &arena, .names = name_resolve};
    struct evaluation e = query_evaluation(query, problem);
    struct quantity result;
    const struct tree *tree = expression_parse(&r);
    bool done = tree != NULL;
    *value = DOMQ_NAN;
    if (!done)
        return item_wrong(problem, NULL, expression);
    if (expression_evaluate(&e, tree, &result))
        *value = result.value;
    else if ((done = problem->at != NULL)) /* no value here, which is no error */
        problem_begin(problem, problem->command);
    arena_free(&arena);
    return done;
}

/* Finds the number of a quantity by its derived.library. Sets *value to NaN if the train has no such number.
 * Returns false on an error. */
static bool library_value(struct derivation *d, const char *library, domq_real *value)
{
    char text[512];
    if (*library == '$') {
        *value = parameter_get(&d->state, parameter_find(library + 1));
        *value = *value == EFFECT_OFF ? 0 : *value;
        return true;
    }
    fill_in(d, library, text, sizeof text);
    return expression_value(&d->query, text, value, d->problem);
}

/* ---- Sums ---- */

/* Returns the number with this name for the domino whose term is being computed. */
static domq_real term_value(const struct derivation *d, const char *name)
{
    const size_t i = d->i;
    return strcmp(name, "i") == 0         ? (domq_real)i
           : strcmp(name, "theta_i") == 0 ? d->at.link[i].theta
           : strcmp(name, "slope_i") == 0 ? d->at.link[i].slope
           : strcmp(name, "next_i") == 0  ? d->launch.link[i + 1].theta
                                          : d->launch.link[i].theta;
}

static bool name_value(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    const struct step *step = t->refers;
    const bool of_term = step->derived->is_given && !step->derived->library;
    *result = (struct quantity){.value = of_term ? term_value(e->context, step->name) : step->value};
    return true;
}

/* Counts a domino and, once there is room, stores it. */
static bool chain_add(const struct domq_link *link, void *context)
{
    struct chain *c = context;
    if (c->link)
        c->link[c->count] = *link;
    c->count++;
    return true;
}

/* Computes the tilts of all dominoes twice: in the chain `d->at` the head has the given tilt, and in the
 * chain `d->launch` it has the tilt 0. The two chains may differ in length, so dominoes with the tilt theta_f
 * are added until both are equally long. The terms of the added dominoes are 0. */
static enum dom_status chains_fill(struct derivation *d, domq_real tilt)
{
    const struct scene *scene = &d->state.scene;
    struct chain *const chain[] = {&d->at, &d->launch};
    struct domq_angles angles = {.theta_f = DOMQ_NAN};
    enum dom_status status = any_angles_find(&scene->train, &scene->compute, &angles);
    size_t room = 0; /* known after the first walk along each chain */
    for (int walk = 0; walk < 4 && status == DOM_OK; walk++) {
        struct chain *c = chain[walk % 2];
        *c = (struct chain){.link = walk < 2 ? NULL : arena_take(&d->arena, room * sizeof *c->link)};
        if (walk >= 2 && !c->link)
            return DOM_NO_MEMORY;
        status = any_chain_walk(&scene->train, &scene->compute, walk % 2 ? 0 : tilt, chain_add, c);
        room = c->count + 4 > room ? c->count + 4 : room;
    }
    const struct domq_link rest = {.theta = angles.theta_f, .slope = 0};
    for (int k = 0; k < 2; k++)
        while (status == DOM_OK && chain[k]->count < room)
            (void)chain_add(&rest, chain[k]);
    return status;
}

/* Returns the value of the equation of a step, or NaN if it has none. */
static domq_real equation_value(struct derivation *d, const struct step *s)
{
    struct quantity result;
    struct problem ignored = {.kind = PROBLEM_NONE};
    struct evaluation e = {.problem = &ignored, .context = d, .angle = 1};
    return expression_evaluate(&e, s->tree, &result) ? result.value : DOMQ_NAN;
}

/* Computes the terms of a sum, without the zeros at its end. */
static bool sum_value(struct derivation *d, struct step *s)
{
    const enum sum sum = s->derived->sum;
    domq_real tilt = d->theta;
    if (sum == SUM_TOP && !library_value(d, "barrier.theta_m", &tilt))
        return false;
    tilt = sum == SUM_LAUNCH ? 0 : tilt;
    if (isnan(tilt))
        return true;
    enum dom_status status = chains_fill(d, tilt);
    s->terms = d->launch.count - 1;
    s->term = status == DOM_OK ? arena_take(&d->arena, s->terms * sizeof *s->term) : NULL;
    if (!s->term)
        return problem_status(d->problem, &d->state.scene, status == DOM_OK ? DOM_NO_MEMORY : status);
    for (d->i = 0; d->i < s->terms; d->i++)
        s->term[d->i] = equation_value(d, s);
    while (s->terms > 1 && s->term[s->terms - 1] == 0)
        s->terms--;
    return true;
}

/* ---- Steps ---- */

static struct step *step_add(struct derivation *d, const char *name, int depth);

/* Adds a step for every name in an equation and makes the names refer to these steps. */
static bool names_add(struct derivation *d, struct step *s, struct tree *t)
{
    if (!t->compute) {
        struct step *needed = step_add(d, t->name, s->depth + 1);
        t->compute = name_value;
        t->refers = needed;
        bool is_new = needed != NULL;
        for (int k = 0; k < s->count; k++)
            is_new = is_new && s->needs[k] != needed;
        if (is_new && s->count < NEEDS_MOST)
            s->needs[s->count++] = needed;
        return needed;
    }
    for (struct tree *child = t->child; child; child = child->next)
        if (!names_add(d, s, child))
            return false;
    return true;
}

/* Returns a description of the quantity. If the equation does not hold for this train, the description says
 * why. */
static const char *words_of(struct derivation *d, const struct derived *q)
{
    const unsigned ends = q->ends & d->has;
    char words[256];
    int n;
    if (ends & HAS_LOSS)
        n = snprintf(words, sizeof words,
                     "%s; with %s, energy is not conserved, so the equation of motion is integrated",
                     q->words, losses_of(&d->state.scene.train));
    else if (ends & HAS_DETACHED_AT_TILT)
        n = snprintf(words, sizeof words, "%s; at this tilt the follower has slid off the head", q->words);
    else
        n = snprintf(words, sizeof words, "%s; with rounded edges the contact is found by iteration",
                     q->words);
    char *copy = ends ? arena_take(&d->arena, (size_t)n + 1) : NULL;
    if (copy)
        memcpy(copy, words, (size_t)n);
    return ends ? copy : q->words;
}

/* Adds a step for this quantity, without its value. Returns NULL on failure. */
static struct step *step_begin(struct derivation *d, const char *name, int depth)
{
    const struct derived *q = derived_list;
    while (q->words && (strcmp(q->name, name) != 0 || (q->with & d->has) != q->with))
        q++;
    if (d->count == STEPS_MOST || !q->words) {
        problem_error(d->problem,
                      q->words ? "a derivation of %s has too many quantities"
                               : "there is no equation for %s with this train",
                      name);
        return NULL;
    }
    struct step *s = &d->step[d->count++];
    *s = (struct step){.derived = q, .name = q->name, .unit = q->unit, .value = DOMQ_NAN};
    s->depth = depth;
    s->reference = q->ends & d->has ? "" : q->reference;
    s->words = words_of(d, q);
    if (s->words)
        return s;
    problem_status(d->problem, &d->state.scene, DOM_NO_MEMORY);
    return NULL;
}

/* Reduces the depth of a step to `depth`, unless it is already as small. Also reduces the depths of the steps
 * that this step needs. Called when another equation turns out to need a step of the derivation. */
static void depth_reduce(struct derivation *d, struct step *s, int depth)
{
    if (depth >= s->depth)
        return;
    s->depth = depth;
    for (int k = 0; k < s->count; k++)
        depth_reduce(d, &d->step[s->needs[k] - d->step], depth + 1);
}

/* Returns the step for a quantity, with its value, or NULL on failure. */
static struct step *step_add(struct derivation *d, const char *name, int depth)
{
    for (int k = 0; k < d->count; k++)
        if (strcmp(d->step[k].name, name) == 0) {
            depth_reduce(d, &d->step[k], depth);
            return &d->step[k];
        }
    struct step *s = step_begin(d, name, depth);
    if (!s || (s->derived->library && !library_value(d, s->derived->library, &s->value)))
        return NULL;
    if (!s->derived->equation || s->derived->ends & d->has)
        return s;
    struct reader r = {.at = s->derived->equation, .problem = d->problem, .arena = &d->arena};
    struct tree *tree = expression_parse(&r);
    if (!tree) {
        item_wrong(d->problem, NULL, s->derived->equation);
        return NULL;
    }
    s->tree = tree;
    if (!names_add(d, s, tree) || (s->derived->sum && !sum_value(d, s)))
        return NULL;
    if (!s->derived->library)
        s->value = equation_value(d, s);
    return s;
}

/* ---- Derivations ---- */

/* What each effect of a train changes in the equations, besides losses. Each effect of the library needs an
 * entry, so that no equation is shown that no longer holds. */
#define CONDITION_friction 0u
#define CONDITION_slope    HAS_SLOPE
#define CONDITION_walls    HAS_WALLS
#define CONDITION_edges    HAS_EDGES
#define CONDITION_air      0u
#define CONDITION_drag     0u

static unsigned conditions(const struct domq_train *train, bool detached, bool reach)
{
#define CONDITION(effect, member, status) (unsigned)(train->member != 0) * CONDITION_##effect |
    return DOM_DYNAMICS(CONDITION)(domq_dissipates(train) ? HAS_LOSS : 0u) |
           (train->fuel == DOM_FUEL_PAPER ? HAS_PAPER : 0u) | (detached ? HAS_DETACHED : 0u) |
           (reach && train->rho == 0 ? HAS_REACH : 0u);
}

/* Prepares a question about the largest growth. The train gets the separation s of the question, and the
 * largest growth at this separation. Sets *reach to true if the reach limits the growth. Does nothing for
 * other questions. */
static bool train_set(struct derivation *d, const struct explained *e, domq_real value, bool *reach)
{
    struct domq_train *train = &d->state.scene.train;
    struct domq_limit limit;
    if (!e->value || strcmp(e->value, "s") != 0)
        return true;
    train->s = isnan(value) ? train->s : value;
    enum dom_status status = any_limit_rmax(train, &d->state.scene.compute, &limit);
    if (status != DOM_OK)
        return problem_limit(d->problem, &d->state.scene, status, &limit);
    if (limit.ends == DOM_END_NONE)
        return problem_no_answer(d->problem, "no growth is possible here: 'rmax' says why");
    train->r = limit.r_max;
    *reach = limit.ends == DOM_END_REACH;
    return true;
}

static bool conditions_find(struct derivation *d, bool reach)
{
    struct domq_angles angles;
    const struct scene *scene = &d->state.scene;
    enum dom_status status = any_angles_find(&scene->train, &scene->compute, &angles);
    if (status != DOM_OK)
        return problem_status(d->problem, scene, status);
    d->has = conditions(&scene->train, angles.detaches, reach) |
             (angles.detaches && d->theta > angles.theta_leave ? HAS_DETACHED_AT_TILT : 0u);
    return true;
}

bool derivation_make(struct derivation *d, const struct query *query, const struct explained *e,
                     domq_real value, struct problem *problem)
{
    bool reach = false, of_height = e->value && strcmp(e->value, "H") == 0;
    d->problem = problem;
    if (!query_with(query, NULL, 0, &d->state, &d->query, problem))
        return false;
    d->state.variables = (struct variables){.list = NULL}; /* a variable must not hide a quantity */
    d->state.settings.style.angle = ANGLE_RAD;
    d->theta = e->value && strcmp(e->value, "theta") == 0 ? value : DOMQ_NAN;
    d->height = of_height ? value : DOMQ_NAN;
    if (!train_set(d, e, value, &reach) || !conditions_find(d, reach))
        return false;
    char name[32];
    for (const char *c = e->roots; *c; c += strspn(c, " ")) {
        size_t n = strcspn(c, " ");
        snprintf(name, sizeof name, "%.*s", (int)n, c);
        c += n;
        if (!step_add(d, name, 0))
            return false;
    }
    return true;
}

void derivation_end(struct derivation *d)
{
    arena_free(&d->arena);
}
