/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes derivations: finds the quantities that an answer needs, their numbers, and the values of their
 * equations. */
#include "commands/explain/derivation.h"
#include "language/quad.h"
#include "session/effects.h"
#include <stdlib.h>
#include <string.h>

/* ---- The numbers of the library ---- */

/* Replaces '@' in a text by a number. */
static void fill_in(const char *text, domq_real number, char *filled, size_t size)
{
    char digits[WIDE_TEXT];
    size_t n = 0;
    quad_exact(number, WIDE_DIGITS, digits);
    for (; *text && n + 1 < size; text++)
        n += (size_t)(*text == '@' ? snprintf(filled + n, size - n, "(%s)", digits)
                                   : snprintf(filled + n, size - n, "%c", *text));
}

/* Returns the quantity of a hit that has this name, such as "margin". */
static domq_real fall_value(const struct domq_fall *fall, const char *name)
{
    return strcmp(name, "margin") == 0    ? fall->margin
           : strcmp(name, "kinetic") == 0 ? fall->kinetic
           : strcmp(name, "barrier") == 0 ? fall->barrier
           : strcmp(name, "lost") == 0    ? fall->lost
                                          : fall->kinetic + fall->lost;
}

/* Evaluates an expression that calls functions of the library or, after '#', reads a member of struct
 * domq_fall.
 * The result is NaN if the number does not exist. On failure, sets *problem and returns false. */
static bool library_value(struct derivation *d, const char *expression, domq_real *value)
{
    char text[256];
    const struct ans none = {.command = NULL};
    if (*expression == '#') {
        *value = fall_value(d->fall, expression + 1);
        return true;
    }
    fill_in(expression, isnan(d->height) ? d->theta : d->height, text, sizeof text);
    struct expression_error error;
    struct parse parse = {.text = text, .error = &error, .arena = &d->arena};
    struct resolver resolver = {.state = d->state, .ans = &none, .arena = &d->arena, .error = &error};
    struct quantity result;
    struct tree *tree = expression_parse(&parse);
    if (!tree || resolve(&resolver, tree) < 0)
        return problem_error(d->problem, "%s: %s", expression, error.message);
    *value = DOMQ_NAN;
    if (query_evaluate(&d->query, tree, &result, &error, d->problem))
        *value = result.value;
    else if (!error.message[0])
        return false;
    return true;
}

/* ---- Names in equations ---- */

static const struct derived *derived_find(unsigned has, const char *name)
{
    for (const struct derived *q = derived_list; q->names.text[0]; q++)
        if (strcmp(q->names.text[0], name) == 0 && (q->with & has) == q->with && !(q->without & has))
            return q;
    return NULL;
}

static const struct given *given_find(const char *name)
{
    const struct given *g = given_list;
    while (g->names.text[0] && strcmp(g->names.text[0], name) != 0)
        g++;
    return g;
}

static domq_real given_value(const struct derivation *d, const struct given *g)
{
    const char *name = g->names.text[0];
    const size_t i = d->i;
    if (g->parameter) {
        domq_real value = parameter_get(d->state, parameter_find(g->parameter));
        return value == EFFECT_OFF ? 0 : value;
    }
    if (strcmp(name, "theta") == 0)
        return d->theta;
    if (strcmp(name, "H") == 0)
        return d->height;
    return strcmp(name, "i") == 0         ? (domq_real)i
           : strcmp(name, "theta_i") == 0 ? d->at.link[i].theta
           : strcmp(name, "slope_i") == 0 ? d->at.link[i].slope
           : strcmp(name, "next_i") == 0  ? d->launch.link[i + 1].theta
                                          : d->launch.link[i].theta;
}

/* Returns true for a name whose value differs from term to term of a sum. */
static bool is_of_term(const struct given *g)
{
    const char *name = g->names.text[0];
    size_t length = strlen(name);
    return strcmp(name, "i") == 0 || (length > 2 && strcmp(name + length - 2, "_i") == 0);
}

/* ---- Steps ---- */

static bool name_value(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    const struct derivation *d = e->context;
    const struct step *step = t->refers;
    *result = (struct quantity){.value = step->given && is_of_term(step->given) ? given_value(d, step->given)
                                                                                : step->value};
    return true;
}

static domq_real equation_value(struct derivation *d, const struct tree *tree)
{
    struct expression_error error;
    struct evaluation e = {.error = &error, .symbol = name_value, .context = d, .angle = 1};
    struct quantity result;
    return expression_evaluate(&e, tree, &result) ? result.value : DOMQ_NAN;
}

/* Adds up the terms of a sum. */
static bool sum_value(struct derivation *d, struct step *s)
{
    const enum sum sum = s->derived->sum;
    domq_real tilt = d->theta;
    if (sum == SUM_TOP && !library_value(d, "barrier.theta_m", &tilt))
        return false;
    tilt = sum == SUM_LAUNCH ? 0 : tilt;
    if (isnan(tilt))
        return true;
    if (!chain_fill(d, &d->at, tilt) || !chain_fill(d, &d->launch, 0))
        return false;
    /* The last terms are those of detached dominoes, and are 0. */
    const size_t both = d->launch.count > d->at.count + 2 ? d->launch.count : d->at.count + 2;
    if (!chain_extend(d, &d->at, both + 2) || !chain_extend(d, &d->launch, both + 2))
        return false;
    s->terms = d->launch.count - 1;
    s->term = malloc(s->terms * sizeof *s->term);
    if (!s->term)
        return problem_status(d->problem, &d->state->scene, DOM_NO_MEMORY);
    s->computed = 0;
    for (d->i = s->terms; d->i-- > 0;) /* the smallest terms first */
        s->computed += s->term[d->i] = equation_value(d, s->tree);
    while (s->terms > 1 && s->term[s->terms - 1] == 0)
        s->terms--;
    return true;
}

static struct step *step_add(struct derivation *d, const char *name, int depth);

/* Adds a step for every name in a tree, and makes the names refer to these steps. */
static bool names_add(struct derivation *d, struct step *s, struct tree *t)
{
    if (t->kind == TREE_NAME) {
        struct step *needed = step_add(d, t->name, s->depth + 1);
        t->kind = TREE_SYMBOL;
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

static struct step *step_begin(struct derivation *d, const char *name, int depth)
{
    if (d->count == STEPS_MOST) {
        problem_error(d->problem, "a derivation has at most %d quantities", STEPS_MOST);
        return NULL;
    }
    struct step *s = &d->step[d->count++];
    *s = (struct step){.derived = derived_find(d->has, name), .computed = DOMQ_NAN, .value = DOMQ_NAN};
    s->depth = depth;
    const struct given *given = s->derived ? NULL : given_find(name);
    if (!s->derived && (!given || !given->names.text[0])) {
        problem_error(d->problem, "there is no equation of %s for this train", name);
        return NULL;
    }
    s->given = given;
    s->unit = given ? given->unit : s->derived->unit;
    if (d->fall && strcmp(s->unit, "mgh/2") == 0)
        s->unit = d->energy_unit;
    return s;
}

/* Returns the step for a quantity, with its value. Returns NULL with a problem. */
static struct step *step_add(struct derivation *d, const char *name, int depth)
{
    for (int k = 0; k < d->count; k++) {
        const struct step *known = &d->step[k];
        const char *known_name = (known->derived ? known->derived->names : known->given->names).text[0];
        if (strcmp(known_name, name) == 0)
            return &d->step[k];
    }
    struct step *s = step_begin(d, name, depth);
    if (!s)
        return NULL;
    if (s->given) {
        s->value = is_of_term(s->given) ? DOMQ_NAN : given_value(d, s->given);
        return s;
    }
    if (!library_value(d, s->derived->library, &s->value))
        return NULL;
    if (!s->derived->equation)
        return s;
    struct expression_error error;
    struct parse parse = {.text = s->derived->equation, .error = &error, .arena = &d->arena};
    struct tree *tree = expression_parse(&parse);
    if (!tree) {
        problem_error(d->problem, "%s: %s", s->derived->equation, error.message);
        return NULL;
    }
    s->tree = tree;
    if (!names_add(d, s, tree))
        return NULL;
    if (s->derived->sum)
        return sum_value(d, s) ? s : NULL;
    s->computed = equation_value(d, tree);
    return s;
}

/* ---- Derivations ---- */

static unsigned conditions(const struct domq_train *train, bool detached, bool reach)
{
    return (train->alpha != 0 ? HAS_SLOPE : 0u) | (train->mu != 0 ? HAS_FRICTION : 0u) |
           (train->rho != 0 ? HAS_EDGES : 0u) | (train->walls != 0 ? HAS_WALLS : 0u) |
           (train->fuel == DOM_FUEL_PAPER ? HAS_PAPER : 0u) | (detached ? HAS_DETACHED : 0u) |
           (reach ? HAS_REACH : 0u);
}

/* If the question is about the largest growth at a separation, sets the separation of the train, sets the
 * growth to the largest one, and sets *reach to whether the reach limits this growth. On failure, sets
 * *problem and returns false. */
static bool train_set(struct derivation *d, const struct explained *e, domq_real value, bool *reach)
{
    struct domq_train *train = &d->state->scene.train;
    struct domq_limit limit;
    if (!e->value || strcmp(e->value, "s") != 0)
        return true;
    train->s = isnan(value) ? train->s : value;
    enum dom_status status = domq_limit_rmax(train, &d->state->scene.compute, &limit);
    if (status != DOM_OK)
        return problem_status(d->problem, &d->state->scene, status);
    if (limit.ends == DOM_END_NONE)
        return problem_no_answer(d->problem, "no growth is possible here: 'rmax' says why");
    train->r = limit.r_max;
    *reach = limit.ends == DOM_END_REACH;
    return true;
}

/* Finds out which equations hold for the train. */
static bool conditions_find(struct derivation *d, bool reach)
{
    struct domq_angles angles;
    const struct scene *scene = &d->state->scene;
    if (d->fall)
        return true; /* the sizes of a row need not be those of a train */
    enum dom_status status = domq_angles_find(&scene->train, &scene->compute, &angles);
    if (status != DOM_OK)
        return problem_status(d->problem, scene, status);
    d->has = conditions(&scene->train, angles.detaches, reach) |
             (angles.detaches && d->theta > angles.theta_leave ? HAS_LEFT : 0u);
    return true;
}

bool derivation_make(struct derivation *d, const struct query *query, const struct explained *e,
                     domq_real value, const struct domq_fall *fall, struct state *state,
                     struct problem *problem)
{
    bool reach = false, of_height = e->value && strcmp(e->value, "H") == 0;
    *state = *query->state;
    state->variables = (struct variables){.list = NULL}; /* a variable must not hide a quantity */
    state->settings.style.angle = ANGLE_RAD;
    *d = (struct derivation){.query = *query, .state = state, .problem = problem, .fall = fall};
    d->energy_unit = scene_has_masses(&state->scene) ? "J" : "mgh/2";
    d->query.state = state;
    d->query.scene = &state->scene;
    d->query.next = NULL;
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
    for (int k = 0; k < d->count; k++)
        free(d->step[k].term);
    chain_free(&d->launch);
    chain_free(&d->at);
    arena_free(&d->arena);
}
