/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planning: the row that a height, a safety and a hall ask for; and the table of the commands that plan. */
#include "answer/format.h"
#include "commands/planning/inquiry.h"
#include "commands/planning/plan.h"
#include "commands/planning/planning.h"
#include "commands/rows/falling.h"
#include "commands/tables.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

/* ---- What the builder wishes ---- */

struct wishes {
    domq_real safety, hall;
    enum dom_least least;
};

static const struct wishes usual = {.safety = 2, .hall = (domq_real)HUGE_VAL, .least = DOM_LEAST_DOMINOES};

static const char *wish_names(const void *context, int k)
{
    static const char *const names[] = {"safety", "hall", "minimise", NULL};
    (void)context;
    return names[k];
}

static const char *least_names(const void *context, int k)
{
    static const char *const names[] = {
        [DOM_LEAST_DOMINOES] = "dominoes", [DOM_LEAST_LENGTH] = "length", [DOM_LEAST_MASS] = "mass", NULL};
    (void)context;
    return names[k];
}

static const struct argument safety_argument = {.name = "safety", .kind = ARGUMENT_ANY},
                             hall_argument = {.name = "hall", .kind = ARGUMENT_HEIGHT};

/* The wishes as they were parsed. */
struct wishes_parsed {
    struct item safety, hall;
    enum dom_least least;
};

/* Finds a name of a list; -1 after an error, which says what would be right. */
static int name_parse(struct reader *r, names_list *list, const char *what, const char *right)
{
    char message[NAMES_MESSAGE] = "out of memory";
    offer_names(r, list, NULL);
    const char *word = read_word(r, false);
    int k = word ? names_find(list, NULL, what, word, message) : -1;
    if (k < 0)
        problem_error(r->problem, "%s; %s", message, right);
    return k;
}

static bool wish_parse(struct reader *r, struct wishes_parsed *w)
{
    static const char form[] = "wishes are 'safety 2', 'hall 20 m' and 'minimise dominoes'";
    int k = name_parse(r, wish_names, "wish", form);
    if (k < 0)
        return false;
    r->at = skip_blanks(r->at);
    reader_place(r, r->at);
    if (reader_ends(r))
        return problem_error(r->problem, "the value of '%s' is missing; %s", wish_names(NULL, k), form);
    if (k == 2) {
        int least = name_parse(r, least_names, "thing to minimise",
                               "'minimise dominoes', 'minimise length' or 'minimise mass'");
        w->least = least < 0 ? w->least : (enum dom_least)least;
        return least >= 0;
    }
    return k == 0 ? item_parse(r, &safety_argument, &w->safety) : item_parse(r, &hall_argument, &w->hall);
}

static bool wishes_parse(struct reader *r, struct question *q)
{
    struct wishes_parsed *w = q->own = arena_take(r->arena, sizeof *w);
    if (!w)
        return problem_error(r->problem, "out of memory");
    w->least = usual.least;
    r->last = false;
    while (!reader_ends(r)) {
        reader_place(r, r->at);
        if (!wish_parse(r, w))
            return false;
    }
    return true;
}

static bool wishes_bind(const struct question *q, const struct query *query, struct arguments *given,
                        struct problem *problem)
{
    const struct wishes_parsed *parsed = q->own;
    struct quantity safety = {.value = 0};
    struct wishes *w = malloc(sizeof *w);
    if (!w)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    given->own = w;
    given->own_free = free;
    *w = usual;
    w->least = parsed->least;
    if ((parsed->safety.value && !item_bind(&parsed->safety, q->text, query, &safety, &w->safety, problem)) ||
        (parsed->hall.value && !item_bind(&parsed->hall, q->text, query, NULL, &w->hall, problem)))
        return false;
    return quantity_bare(safety) ||
           problem_error(problem, "the safety is a number, such as 2: times the energy that is needed");
}

/* ---- The answer ---- */

static const struct column design_columns[] = {
    {"s", "h", "gap over height", 0},
    {"r", "", "growth from domino to domino", 0},
    {"steps", "", "n, with h r^n = H: n + 1 dominoes", 0},
    {"feet", "m", "length, from the first domino's back to the last one's front", 0},
    {"length", "m", "length with the last one fallen", 0},
    {"mass", "kg", "of all, where one is known", 0},
    {"surface", "m^2", "of all; q = 3: their walls", 0},
    {"volume", "m^3", "of all; other q: their blocks", 0},
    {"safety", "", "least energy of a domino over what it needs", 0},
    {"weakest", "", "the domino with that", 0},
    {"train", "", "the same of the endless train", 0},
    {"seconds", "s", "until the last lies, counted as in 'fall'", 0},
    {NULL, NULL, NULL, 0},
};

static void plan_row(struct answer *a, const struct plan *p, const struct domq_design *d, const char *reason)
{
    domq_real mass = 0, of = 0;
    for (size_t k = 0; p && k < p->count; k++) {
        mass += p->domino[k].mass;
        of += plan_material(p, &p->domino[k]);
    }
    struct cell none = cell_real(DOMQ_NAN);
    answer_row(a,
               ROW(cell_real(d->s), cell_bound(d->r, DOMQ_NAN), p ? cell_count((domq_real)d->steps) : none,
                   cell_narrow(d->feet, 5), cell_narrow(d->length, 5),
                   p && p->mass > 0 ? cell_narrow(mass, 5) : none, p && p->hollow ? cell_narrow(of, 5) : none,
                   p && !p->hollow ? cell_narrow(of, 5) : none, cell_narrow(d->row, 5),
                   d->weakest > 0 ? cell_count((domq_real)d->weakest) : none, cell_narrow(d->train, 5),
                   cell_narrow(d->seconds, 5)),
               reason);
}

/* ---- What would make a wish possible ---- */

/* Returns the largest kinetic energy over barrier that equal dominoes have at any separation. */
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

/* Returns the largest friction, to three digits, with which equal dominoes have the safety; 0: none. */
static domq_real friction_most(const struct query *query, domq_real safety)
{
    domq_real lo = 0, hi = query->scene->train.mu;
    if (!(hi > 0) || equal_ratio(query, 0) < safety)
        return 0;
    while (hi - lo > hi / 2000) {
        domq_real middle = (lo + hi) / 2;
        *(equal_ratio(query, middle) >= safety ? &lo : &hi) = middle;
    }
    return lo;
}

/* Rounds to so many digits, up or down. */
static domq_real rounded(domq_real value, int digits, bool up)
{
    domq_real unit = quad(pow)(10, quad(floor)(quad(log10)(value)) - digits + 1);
    return (up ? quad(ceil)(value / unit) : quad(floor)(value / unit)) * unit;
}

/* Returns a push that is stronger than that of the wish, or NaN: sqrt(2 g/h) lifts the first domino. */
static domq_real push_stronger(const struct domq_wish *wish)
{
    const domq_real most = quad(sqrt)(2 * wish->g / wish->first) * 9 / 10;
    return !(wish->push > most / 2) ? most * 2 / 3 : wish->push < most * 9 / 10 ? most : DOMQ_NAN;
}

/* Says which effects make the numerics hard, and which of them to leave out. Returns false. */
static bool design_failed(const struct scene *scene, const struct domq_design *d, struct problem *problem)
{
    const struct domq_train *t = &scene->train;
    const char *with = t->rho > 0 && t->mu > 0 ? "with friction and rounded edges "
                       : t->rho > 0            ? "with rounded edges "
                       : t->mu > 0             ? "with friction "
                                               : "";
    char off[64] = "";
    if (*with)
        snprintf(off, sizeof off, ", or 'effect %s off'", t->rho > 0 ? "edges" : "friction");
    return problem_no_answer(problem,
                             "no row was found: %sthe search failed at s = %.2g; try another thickness%s",
                             with, (double)d->needs, off);
}

static void infeasible(const struct query *query, const struct domq_wish *wish, const struct domq_design *d,
                       char *text, size_t size)
{
    char number[WIDE_TEXT], least[WIDE_TEXT], safety[WIDE_TEXT], more[96] = "";
    domq_real needs = d->needs;
    quad_text(wish->safety, 6, safety);
    if (d->limit == DOM_DESIGN_HALL) {
        snprintf(text, size,
                 "infeasible: the shortest row with safety %s is %s m long with its last domino fallen; "
                 "'hall %s m' would do",
                 safety, quad_text(needs, 4, number), quad_text(rounded(needs, 4, true), 4, least));
        return;
    }
    if (d->limit == DOM_DESIGN_START) {
        if (isfinite(needs))
            snprintf(text, size,
                     "infeasible: the start is too weak for safety %s at the next domino; a push of %s rad/s "
                     "would do: 'effect row 2; effect push %s' before",
                     safety, quad_text(rounded(needs, 3, true), 3, number), number);
        else
            snprintf(text, size,
                     "infeasible: the start is too weak for safety %s, and no push that was tried "
                     "would do; a smaller safety may",
                     safety);
        return;
    }
    if (d->limit == DOM_DESIGN_ENGINE) {
        domq_real push = push_stronger(wish);
        if (isfinite(push))
            snprintf(more, sizeof more, "a stronger push may help: 'effect push %s' before",
                     quad_text(rounded(push, 2, false), 2, number));
        else
            snprintf(more, sizeof more, "another thickness may help");
        snprintf(
            text, size,
            "infeasible: rows with safety %s fall by the model, in which feet are hinges, but none that was "
            "tried falls in the rigid-body engine, which runs rows since %s; %s",
            safety, scene_engine_why(query->scene), more);
        return;
    }
    domq_real mu = friction_most(query, wish->safety);
    if (mu > 0)
        snprintf(more, sizeof more, "; with a friction up to %s safety %s is possible",
                 quad_text(rounded(mu, 3, false), 3, least), safety);
    if (needs > 1)
        snprintf(text, size, "infeasible: no growth has safety %s here; a safety below %s has one%s", safety,
                 quad_text(rounded(needs, 4, false), 4, number), more);
    else
        snprintf(text, size, "infeasible: not even equal dominoes keep falling here at any gap%s", more);
}

/* ---- design ---- */

/* Reports an error for what no row can meet. */
static bool wish_check(struct problem *problem, const struct domq_wish *w)
{
    if (!(w->height > w->first))
        return problem_no_answer(problem,
                                 "H = %s is not taller than the first domino, h = %s; a larger H, or 'set h'",
                                 measured(w->height, "m", 6).text, measured(w->first, "m", 6).text);
    if (!(w->safety > 1))
        return problem_no_answer(problem,
                                 "safety %s is not above 1: at 1 a domino just falls; 'safety 2' is usual",
                                 quad_shown(w->safety).text);
    return w->hall > w->height ||
           problem_no_answer(problem,
                             "a hall of %s has no room for the last domino, which is %s long when it has "
                             "fallen; a longer hall, or a smaller H",
                             measured(w->hall, "m", 6).text, measured(w->height, "m", 6).text);
}

/* Makes the design the row of the session. */
static bool design_keep(const struct query *query, struct problem *problem, struct answer *a,
                        const struct domq_design *d)
{
    const domq_real count = (domq_real)d->steps + 1;
    struct state *next = query->next;
    if (!next)
        return true;
    if (!parameter_set(next, parameter_find("row"), &count, 1, NULL, query->means, problem) ||
        !parameter_set(next, parameter_find("s"), &d->s, 1, NULL, query->means, problem) ||
        !parameter_set(next, parameter_find("r"), &d->r, 1, NULL, query->means, problem))
        return false;
    answer_say(
        a, "\nThis is the session's row now, with its s and r: 'fall' runs it, 'row > hall.csv' writes it, "
           "'effect row off' ends it.");
    return true;
}

/* Finds the design. If the engine would run that row, the wish gets the engine. */
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
        return design_failed(query->scene, d, problem);
    /* A row that is too long for the engine is an error here already. */
    return !wish->engine || scene_engine_make(&with_row, d->steps + 1, engine, problem);
}

/* Prints for people what was designed, and what it is good for. */
static void design_say(const struct query *query, struct answer *a, const struct domq_wish *wish,
                       const struct domq_design *d, const struct plan *plan)
{
    char least[160] = "", judge[120] = "";
    if (isfinite(d->row))
        snprintf(least, sizeof least,
                 " Every domino after the first has at least %.0f %% of the energy that it needs%s.",
                 floor(100 * (double)d->row), wish->engine ? ", by the model, in which feet are hinges" : "");
    if (wish->engine)
        snprintf(judge, sizeof judge, " All fall in the rigid-body engine, too, which runs rows since %s.",
                 scene_engine_why(query->scene));
    answer_say(a, "\n%zu dominoes, each %.4g times as large as the one before; the last is %s tall.%s%s\n",
               plan->count, (double)d->r, measured(wish->height, "m", 4).text, least, judge);
    plan_list(a, plan);
}

static bool run_design(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct wishes *w = query->given->own ? query->given->own : &usual;
    const struct effect_state *push = &query->scene->effect[DOM_EFFECT_push];
    struct domq_wish wish = {.first = query->scene->scale.h,
                             .height = query->given->number[0],
                             .safety = w->safety,
                             .hall = w->hall,
                             .g = query->scene->scale.g,
                             .push = push->on ? push->value[0] : DOMQ_NAN,
                             .least = w->least};
    struct domq_design d;
    struct plan plan;
    char reason[400];
    struct scene_engine engine;
    if (!wish_check(problem, &wish) || !design_find(query, &wish, &engine, &d, problem))
        return false;
    answer_holds(a, d.limit == DOM_DESIGN_FITS);
    if (d.limit != DOM_DESIGN_FITS) {
        infeasible(query, &wish, &d, reason, sizeof reason);
        if (a->path && !a->style.format->for_people)
            return problem_no_answer(problem, "%s", reason);
        if (answer_for_people(a))
            answer_say(a, "%s.", reason);
        else
            plan_row(a, NULL, &d, reason);
        return true;
    }
    if (!plan_make(query, problem, &d, wish.height, &plan))
        return false;
    bool file = a->path && !a->style.format->for_people, done = true;
    if (file)
        plan_file(a, &plan);
    else
        plan_row(a, &plan, &d, NULL);
    if (answer_for_people(a))
        design_say(query, a, &wish, &d, &plan);
    if (a->out && !a->point)
        done = design_keep(query, problem, a, &d);
    free(plan.domino);
    return done;
}

const struct command design_commands[] = {
    {.name = "design",
     .argument = {{.name = "H", .kind = ARGUMENT_HEIGHT},
                  {.name = "WISHES",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = wishes_parse,
                   .bind = wishes_bind,
                   .choices = wish_names}},
     .summary = "a row whose last domino is H tall, with safety",
     .help =
         "Finds the gaps and the growth with which each cycle has at least 'safety' times the energy that it "
         "needs, in the endless train and at each domino of the row after the first; with the scene's h, d, "
         "q, "
         "friction, slope and push. WISHES are 'safety 2' (if left out), 'hall 20 m', which the row with its "
         "last domino fallen must not exceed, and 'minimise dominoes' (if left out), 'length' or 'mass', in "
         "any order. The fewest dominoes weigh least. Where the rigid-body engine runs rows ('effect feet', "
         "'effect bounce', 'set method engine'), all dominoes of the row also fall in the engine; 'safety' "
         "is that of the model, in which feet are hinges. The row becomes the session's; 'design ... > "
         "hall.csv' "
         "writes it, for 'effect row hall.csv'.",
     .example = "set q hollow; effect friction 0.3; design 8 m",
     .see = "verdict fall row assert solve",
     .principal = "steps",
     .holds = "a row fits the wishes",
     .changes = true,
     ANSWER(design)},
    {.name = "solve",
     .argument =
         {{.name = "NAME", .kind = ARGUMENT_GRID, .parse = solve_parse_parameter, .choices = solve_names},
          {.name = ": ANSWER",
           .kind = ARGUMENT_COMMAND,
           .parse = solve_parse_answer,
           .bind = solve_bind,
           .choices = question_names}},
     .summary = "where an answer takes a value, along a parameter",
     .help =
         "The form is 'solve NAME : ANSWER = VALUE', as in 'solve d : rmax = 5/3'. Finds the values of the "
         "parameter NAME at which ANSWER has this VALUE, and whether it rises or falls there. ANSWER is a "
         "command, or an expression with commands as names: 'solve s : rmax(s) - pair(s) = 0.1'. A range "
         "may follow the name: 'solve d 0.05 0.3 : rmax = 5/3'. Without '= VALUE', and with a command that "
         "'assert' takes, finds where its verdict changes: 'solve friction : verdict'. It looks at 241 "
         "values, and between them; a dip that is narrower can be missed.",
     .example = "solve d : rmax = 5/3; solve friction : barrier",
     .see = "sensitivity sweep assert",
     .unswept = "it varies a parameter itself",
     .rows = true,
     ANSWER(solve)},
    {.name = "watch",
     .synonyms = "interactive slider live keys explore",
     .argument =
         {{.name = "NAME", .kind = ARGUMENT_GRID, .parse = solve_parse_parameter, .choices = solve_names},
          {.name = ": ANSWER",
           .kind = ARGUMENT_COMMAND,
           .parse = watch_parse_answer,
           .bind = solve_bind,
           .choices = question_names}},
     .summary = "keys change a parameter; its answer follows on a curve",
     .help = "For example 'watch s 0.1 0.9 : rmax'. The left and right arrows take large steps, up and down "
             "small ones. Enter keeps the value; q and ^C leave the parameter as it was.",
     .see = "solve sweep plot",
     .changes = true,
     .act = run_watch},
    {.name = "sensitivity",
     .argument = {{.name = "COMMAND",
                   .kind = ARGUMENT_COMMAND,
                   .parse = sensitivity_parse,
                   .choices = question_names}},
     .summary = "how much each parameter changes the number of COMMAND",
     .help =
         "Changes each parameter of the model down and up, by 1 %; friction by 0.01 and slope by 1 degree, "
         "also where they are off. Answers the change of the number in percent, the largest first. COMMAND "
         "may have arguments and a key, 'sensitivity rmax 0.3', 'sensitivity barrier.margin', or be an "
         "expression, 'sensitivity h*r^10'.",
     .example = "effect friction 0.2; sensitivity rmax",
     .see = "solve sweep",
     .unswept = "it varies the parameters itself",
     .rows = true,
     ANSWER(sensitivity)},
    {.name = "fit",
     .argument = {{.name = "friction", .kind = ARGUMENT_CHOICE, .of = "thing to fit", .choices = fit_names},
                  {.name = "FILE", .kind = ARGUMENT_FILE}},
     .summary = "the friction that explains measured speeds best",
     .help =
         "FILE is csv with the columns 'gap (mm)' and 'speed (m/s)', and 'error (m/s)' if it is known: one "
         "row of equal dominoes a line, with the scene's h and d. Finds the friction with the least squares "
         "of the residuals, each over its error, or if there are none, over the speed; its standard "
         "deviation; and the residuals.",
     .see = "solve duration",
     .files = true,
     .rows = true,
     ANSWER(fit)},
    {.name = "assert",
     .argument = {{.name = "COMMAND",
                   .kind = ARGUMENT_COMMAND,
                   .of = "command with a verdict",
                   .parse = assert_parse,
                   .choices = assert_names}},
     .summary = "an error unless what COMMAND decides is true",
     .help = "Runs the command, and ends it with an error if its answer is no: the row does not fall, no row "
             "fits. A script then ends at once with exit status 1; standard input goes on. COMMAND is "
             "verdict, fall, design, barrier, count or prove; or it is a condition, as in 'assert rmax(0.4) "
             "< 1.7'.",
     .example = "effect row 5; assert verdict",
     .see = "verdict design barrier count",
     .unswept = "it asks one scene",
     .runs = true,
     .run = run_assert},
    {.name = NULL},
};
