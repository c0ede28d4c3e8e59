/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command design, which finds a row with a given last height, a given safety and a limit on its length.
 */
#include "answer/format.h"
#include "commands/planning/planning.h"
#include "commands/rows/falling.h"
#include "language/quad.h"
#include <stdlib.h>

const struct column design_columns[] = {
    {"s", "h", "the gap divided by the height", 0},
    {"r", "", "the growth from domino to domino", 0},
    {"steps", "", "n, with h r^n = H: the row has n + 1 dominoes", 0},
    {"feet", "m", "the length from the back of the first domino to the front of the last one", 0},
    {"length", "m", "the length with the last domino fallen", 0},
    {"mass", "kg", "the mass of all dominoes, if masses are known", 0},
    {"surface", "m^2", "the surface of the walls of all dominoes, if q is 3", 0},
    {"volume", "m^3", "the volume of all dominoes, if q is not 3", 0},
    {"safety", "", "the energy of the weakest domino, divided by the energy that it needs", 0},
    {"weakest", "", "the weakest domino, which has this safety", 0},
    {"train", "", "the safety of the endless train", 0},
    {"seconds", "s", "the time until the last domino lies, as 'fall' measures it", 0},
    {NULL, NULL, NULL, 0},
};

/* ---- The dominoes of a design ---- */

struct plan {
    struct domq_domino *domino;
    size_t count;
    bool has_masses; /* masses are in kg; otherwise the first domino has the mass 1 */
    bool hollow;
};

/* Makes the dominoes of a design, with the last one exactly `height` tall. If memory runs out, sets *problem
 * and returns false. */
static bool plan_make(const struct query *query, struct problem *problem, const struct domq_design *d,
                      domq_real height, struct plan *p)
{
    struct domq_train train = query->scene->train;
    const domq_real mass = scene_mass(query->scene);
    train.s = d->s;
    train.r = d->r;
    *p = (struct plan){.count = d->steps + 1, .has_masses = mass > 0, .hollow = train.q == 3};
    p->domino = malloc(p->count * sizeof *p->domino);
    if (!p->domino)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    domq_row_of_train(&train, &query->scene->scale, p->has_masses ? mass : 1, p->domino, p->count);
    p->domino[d->steps].height = height;
    return true;
}

/* Returns the surface of a hollow domino, or the volume of a solid one. Dominoes are assumed to be half as
 * wide as they are tall. */
static domq_real plan_material(const struct plan *p, const struct domq_domino *d)
{
    domq_real width = d->height / 2;
    return p->hollow ? 2 * (d->height * width + d->height * d->thickness + width * d->thickness)
                     : d->height * width * d->thickness;
}

/* Lists the dominoes: for people with the sizes to saw and the places to stand them, and for a file with the
 * columns that 'effect row FILE' reads. */
static void plan_write(struct answer *a, const struct plan *p, bool file)
{
    static const struct column columns[] = {
        {"domino", "", "", 6},   {"height", "m", "", 9},    {"thickness", "m", "", 9},
        {"gap", "m", "", 9},     {"at", "m", "", 9},        {"mass", "kg", "", 9},
        {"relative", "", "", 9}, {"surface", "m^2", "", 9}, {"volume", "m^3", "", 9},
        {NULL, NULL, NULL, 0},
    };
    const struct domq_domino *last = &p->domino[p->count - 1];
    domq_real at = 0;
    a->columns = columns;
    a->rows = true;
    a->csv.units = file;
    a->style.errors = false;
    answer_leave_out(a, p->has_masses ? "relative" : "mass");
    if (file)
        answer_leave_out(a, "at");
    if (file || p->hollow)
        answer_leave_out(a, "volume");
    if (file || !p->hollow)
        answer_leave_out(a, "surface");
    answer_largest(a, "height", last->height);
    answer_largest(a, "thickness", last->thickness);
    answer_largest(a, "gap", last->gap);
    answer_largest(a, "at", last->height);
    for (size_t k = 0; k < p->count && !answer_lost(a); k++) {
        const struct domq_domino *d = &p->domino[k];
        struct cell cells[] = {cell_count((domq_real)k + 1),
                               cell_real(d->height),
                               cell_real(d->thickness),
                               cell_real(d->gap),
                               cell_real(at += d->gap),
                               cell_real(d->mass),
                               cell_real(d->mass / p->domino[0].mass),
                               cell_real(plan_material(p, d)),
                               cell_real(plan_material(p, d))};
        for (int i = 1; i < 9; i++)
            cells[i].digits = 4;
        answer_row(a, cells, NULL);
        at += d->thickness;
    }
}

/* Writes the row with the numbers of a design. If no design fits the wishes, `p` is NULL and `reason` says
 * why. */
static void design_row(struct answer *a, const struct plan *p, const struct domq_design *d,
                       const char *reason)
{
    const struct cell none = cell_real(DOMQ_NAN);
    domq_real mass = 0, material = 0;
    for (size_t k = 0; p && k < p->count; k++) {
        mass += p->domino[k].mass;
        material += plan_material(p, &p->domino[k]);
    }
    answer_row(a,
               ROW(cell_real(d->s), cell_bound(d->r, DOMQ_NAN), p ? cell_count((domq_real)d->steps) : none,
                   cell_narrow(d->feet, 5), cell_narrow(d->length, 5),
                   p && p->has_masses ? cell_narrow(mass, 5) : none,
                   p && p->hollow ? cell_narrow(material, 5) : none,
                   p && !p->hollow ? cell_narrow(material, 5) : none, cell_narrow(d->row, 5),
                   d->weakest > 0 ? cell_count((domq_real)d->weakest) : none, cell_narrow(d->train, 5),
                   cell_narrow(d->seconds, 5)),
               reason);
}

/* ---- What would make a wish possible ---- */

/* Returns the largest ratio of kinetic energy to barrier that equal dominoes with friction mu reach at any
 * separation from 0.01 to 1. */
static domq_real equal_ratio(const struct query *query, domq_real mu)
{
    struct domq_train train = query->scene->train;
    struct domq_barrier b;
    domq_real most = 0;
    train.mu = mu;
    train.r = 1;
    for (int k = 1; k <= 100; k++) {
        train.s = (domq_real)k / 100;
        enum dom_status status = domq_barrier_find(&train, &query->scene->compute, &b);
        if ((status == DOM_OK || status == DOM_STOPS) && b.kinetic / b.barrier > most)
            most = b.kinetic / b.barrier;
    }
    return most;
}

/* Returns the largest friction below that of the scene with which equal dominoes have this safety, to three
 * digits. Returns 0 if there is none. */
static domq_real friction_most(const struct query *query, domq_real safety)
{
    domq_real low = 0, high = query->scene->train.mu;
    if (!(high > 0) || equal_ratio(query, 0) < safety)
        return 0;
    while (high - low > high / 2000) {
        domq_real middle = (low + high) / 2;
        *(equal_ratio(query, middle) >= safety ? &low : &high) = middle;
    }
    return low;
}

/* Returns the push in rad/s above which the first domino is lifted off the floor, and thrown. */
static domq_real push_most(const struct domq_wish *wish)
{
    return quad(sqrt)(2 * wish->g / wish->first);
}

/* Returns a push that is stronger than the one in the wish, but does not lift the first domino. Returns NaN
 * if the push in the wish is already too close to this limit. */
static domq_real push_stronger(const struct domq_wish *wish)
{
    const domq_real most = push_most(wish) * 9 / 10;
    return !(wish->push > most / 2) ? most * 2 / 3 : wish->push < most * 9 / 10 ? most : DOMQ_NAN;
}

/* Returns a push as the speed of the upper edge of the first domino, which people can judge. */
static struct measured push_speed(const struct domq_wish *wish, domq_real push)
{
    return measured(push * wish->first, "m/s", 2);
}

/* Reports that the search failed, and which effect to turn off because it makes the search hard. Returns
 * false. */
static bool search_failed(const struct scene *scene, const struct domq_design *d, struct problem *problem)
{
    const struct domq_train *t = &scene->train;
    const char *with = t->rho > 0 && t->mu > 0 ? "with friction and rounded edges "
                       : t->rho > 0            ? "with rounded edges "
                       : t->mu > 0             ? "with friction "
                                               : "";
    const char *off = t->rho > 0 ? ", or 'effect edges off'" : t->mu > 0 ? ", or 'effect friction off'" : "";
    return problem_no_answer(problem,
                             "no row was found: %sthe search failed at s = %.2g; try another thickness%s",
                             with, (double)d->needs, off);
}

/* Writes why no row fits the wish, and which change would make one possible. */
static void infeasible_text(const struct query *query, const struct domq_wish *wish,
                            const struct domq_design *d, char *text, size_t size)
{
    const struct measured safety = measured(wish->safety, "", 6);
    char more[192] = "";
    if (d->limit == DOM_DESIGN_HALL) {
        snprintf(text, size,
                 "infeasible: the shortest row with safety %s is %s m long with its last domino fallen; "
                 "'hall %s m' would do",
                 safety.text, measured(d->needs, "", 4).text,
                 measured(round_digits(d->needs, 4, true), "", 4).text);
    } else if (d->limit == DOM_DESIGN_START && d->needs > push_most(wish)) {
        snprintf(text, size,
                 "infeasible: the start is too weak for safety %s at the next domino; it would need a push "
                 "of %s at "
                 "the top of domino 1, and one of more than %s throws it instead; enter a smaller safety",
                 safety.text, push_speed(wish, d->needs).text, push_speed(wish, push_most(wish)).text);
    } else if (d->limit == DOM_DESIGN_START && isfinite(d->needs)) {
        const struct measured push = measured(round_digits(d->needs, 3, true), "", 3);
        snprintf(
            text, size,
            "infeasible: the start is too weak for safety %s at the next domino, and a push of %.40s rad/s, "
            "which is %.40s at its top, would do: first enter 'effect row 2; effect push %.40s'",
            safety.text, push.text, push_speed(wish, d->needs).text, push.text);
    } else if (d->limit == DOM_DESIGN_START) {
        snprintf(text, size,
                 "infeasible: the start is too weak for safety %s, and no push that was tried is enough; try "
                 "a smaller safety",
                 safety.text);
    } else if (d->limit == DOM_DESIGN_ENGINE) {
        domq_real push = push_stronger(wish);
        if (isfinite(push))
            snprintf(more, sizeof more, "a stronger push may help: first enter 'effect push %.40s'",
                     measured(round_digits(push, 2, false), "", 2).text);
        else
            snprintf(more, sizeof more, "another thickness may help");
        snprintf(text, size,
                 "infeasible: rows with safety %s fall by the model, in which feet are hinges, but none that "
                 "was tried falls in the rigid-body engine, which runs rows because %s; %s",
                 safety.text, scene_engine_why(query->scene), more);
    } else {
        domq_real mu = friction_most(query, wish->safety);
        if (mu > 0)
            snprintf(more, sizeof more, "; with a friction up to %.40s safety %.40s is possible",
                     measured(round_digits(mu, 3, false), "", 3).text, safety.text);
        if (d->needs > 1)
            snprintf(text, size,
                     "infeasible: no growth gives safety %s here; a safety below %s is possible%s",
                     safety.text, measured(round_digits(d->needs, 4, false), "", 4).text, more);
        else
            snprintf(text, size, "infeasible: not even equal dominoes keep falling here at any gap%s", more);
    }
}

/* ---- The answer ---- */

/* Checks that the wish does not contradict itself. If it does, sets *problem and returns false. */
static bool wish_check(struct problem *problem, const struct domq_wish *w)
{
    if (!(w->height > w->first))
        return problem_no_answer(
            problem,
            "H = %s is not taller than the first domino, h = %s; enter a larger H, or another h with 'set h'",
            measured(w->height, "m", 6).text, measured(w->first, "m", 6).text);
    if (!(w->safety > 1))
        return problem_no_answer(
            problem, "safety %s is not above 1, with which a domino just falls; 'safety 2' is usual",
            quad_shown(w->safety).text);
    return w->hall > w->height ||
           problem_no_answer(problem,
                             "a hall of %s has no room for the last domino, which is %s long when it has "
                             "fallen; enter a longer hall or a smaller H",
                             measured(w->hall, "m", 6).text, measured(w->height, "m", 6).text);
}

/* Finds the design. If the scene runs rows in the rigid-body engine, the row of the design must fall there,
 * too. */
static bool design_find(const struct query *query, struct domq_wish *wish, struct scene_engine *engine,
                        struct domq_design *d, struct problem *problem)
{
    struct scene with_row = *query->scene;
    with_row.effect[DOM_EFFECT_row].on = true;
    if (scene_has_engine(&with_row)) {
        if (!scene_engine_make(&with_row, 1, engine, problem))
            return false;
        wish->engine = &engine->engine;
    }
    enum dom_status status = domq_design_find(&query->scene->train, wish, &query->scene->compute, d);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    if (d->limit == DOM_DESIGN_FAILED)
        return search_failed(query->scene, d, problem);
    /* Check now that the engine can run a row of this length. */
    return !wish->engine || scene_engine_make(&with_row, d->steps + 1, engine, problem);
}

/* Prints how safe the design is, and a list of its dominoes. */
static void design_say(const struct query *query, struct answer *a, const struct domq_wish *wish,
                       const struct domq_design *d, const struct plan *plan)
{
    char least[160] = "", engine[120] = "";
    if (isfinite(d->row))
        snprintf(least, sizeof least,
                 " Every domino after the first has at least %.0f %% of the energy that it needs%s.",
                 floor(100 * (double)d->row), wish->engine ? ", by the model, in which feet are hinges" : "");
    if (wish->engine)
        snprintf(engine, sizeof engine,
                 " All fall in the rigid-body engine, too, which runs rows because %s.",
                 scene_engine_why(query->scene));
    answer_say(a, "\n%zu dominoes, each %.4g times as large as the one before; the last is %s tall.%s%s\n",
               plan->count, (double)d->r, measured(wish->height, "m", 4).text, least, engine);
    struct answer list = {.out = a->out, .style = a->style};
    plan_write(&list, plan, false);
}

/* Makes the design the row of the session. Does nothing if the command only gives the value of an expression:
 * then query->next is NULL. */
static bool design_keep(const struct query *query, struct problem *problem, struct answer *a,
                        const struct domq_design *d)
{
    const domq_real count = (domq_real)d->steps + 1;
    struct state *next = query->next;
    if (!next)
        return true;
    if (!parameter_set(next, parameter_find("row"), &count, 1, problem) ||
        !parameter_set(next, parameter_find("s"), &d->s, 1, problem) ||
        !parameter_set(next, parameter_find("r"), &d->r, 1, problem))
        return false;
    answer_say(
        a, "\nThis is the session's row now, with its s and r: 'fall' runs it, 'row > hall.csv' writes it, "
           "'effect row off' ends it.");
    return true;
}

bool run_design(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct wishes *w = query->given->bound ? query->given->bound : &usual_wishes;
    const struct effect_state *push = &query->scene->effect[DOM_EFFECT_push];
    const bool file = a->path && !a->style.format->for_people;
    struct domq_wish wish = {.first = query->scene->scale.h,
                             .height = query->given->number[0],
                             .safety = w->safety,
                             .hall = w->hall,
                             .g = query->scene->scale.g,
                             .push = push->on ? push->value[0] : DOMQ_NAN,
                             .least = w->least};
    struct domq_design d;
    struct plan plan;
    char reason[640];
    struct scene_engine engine;
    if (!wish_check(problem, &wish) || !design_find(query, &wish, &engine, &d, problem))
        return false;
    answer_holds(a, d.limit == DOM_DESIGN_FITS);
    if (d.limit != DOM_DESIGN_FITS) {
        infeasible_text(query, &wish, &d, reason, sizeof reason);
        if (file)
            return problem_no_answer(problem, "%s", reason);
        answer_say(a, "%s.", reason);
        if (!answer_for_people(a))
            design_row(a, NULL, &d, reason);
        return true;
    }
    if (!plan_make(query, problem, &d, wish.height, &plan))
        return false;
    if (file)
        plan_write(a, &plan, true);
    else
        design_row(a, &plan, &d, NULL);
    if (answer_for_people(a))
        design_say(query, a, &wish, &d, &plan);
    free(plan.domino);
    return !a->out || a->sink || design_keep(query, problem, a, &d);
}
