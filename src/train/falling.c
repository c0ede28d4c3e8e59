/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/quad.h"
#include "train/train.h"
#include <float.h>
#include <stdlib.h>

void row_grow(domq_real r, struct domq_domino *domino, size_t count, const struct scene *scene)
{
    struct scene grown = *scene;
    grown.train.r = r;
    scene_row_fill(&grown, domino, count);
}

/* ---- Words and numbers ---- */

struct cell cell_narrow(domq_real value, int digits)
{
    struct cell cell = cell_computed(value);
    cell.digits = digits;
    return cell;
}

domq_real round_digits(domq_real value, int digits, bool up)
{
    if (!(value > 0))
        return value;
    domq_real unit = quad(pow)(10, quad(floor)(quad(log10)(value)) - digits + 1);
    return (up ? quad(ceil)(value / unit) : quad(floor)(value / unit)) * unit;
}

struct words energy_words(domq_real share)
{
    struct words words = {"has more than 100 times the energy that it needs"};
    if (share < 100)
        snprintf(words.text, sizeof words.text, "%s %s of the energy that it %s", share < 1 ? "has" : "needs",
                 measured_share(share < 1 ? share : 1 / share, 2).text, share < 1 ? "needs" : "has");
    return words;
}

struct words dominoes_words(domq_real q, const char *noun)
{
    const char *word = parameter_word(parameter_find("q"), q);
    struct words words;
    if (word)
        snprintf(words.text, sizeof words.text, "%s %s", word, noun);
    else
        snprintf(words.text, sizeof words.text, "%s with q = %s", noun, quad_text(q, 6));
    return words;
}

struct words limit_words(domq_real limit, int digits)
{
    struct words words;
    while (limit > 1 && strcmp(quad_limit(limit, digits), "1") == 0 && digits < WIDE_DIGITS)
        digits++;
    snprintf(words.text, sizeof words.text, "%s", quad_limit(limit, digits));
    return words;
}

struct words release_words(domq_real release)
{
    struct words words = {""};
    if (isinf(release))
        snprintf(words.text, sizeof words.text, "against the second");
    else if (release > 0)
        snprintf(words.text, sizeof words.text, "at %s deg", quad_text(release * (180 / QUAD_PI), 6));
    return words;
}

bool row_status(const struct query *query, struct problem *problem, enum dom_status status)
{
    const bool engine = scene_has_engine(query->scene);
    enum precision precision = query->scene->compute.precision;
    if (status == DOM_NOT_CONVERGED && engine)
        return problem_no_answer(
            problem, "the rigid-body engine cannot decide this row, because the row does not come to rest or "
                     "the verdict depends on the time step; try a slightly different row");
    if (status == DOM_NO_LEAN)
        return problem_no_answer(problem,
                                 "a domino of this row leans, but %s needs upright dominoes; turn it off, or "
                                 "set all dominoes upright: 'change all lean = 0 mm'",
                                 engine ? "the rigid-body engine" : "the effect 'edges'");
    if (status == DOM_NO_MARGIN)
        return problem_no_answer(problem, "one domino almost stops, so later times cannot be computed");
    /* The statuses from DOM_BAD_COUNT to DOM_BAD_MASS are about the dominoes, their gaps and their masses. */
    if (status < DOM_BAD_COUNT || status > DOM_BAD_MASS)
        return query_status(query, problem, status);
    if (engine)
        return problem_no_answer(
            problem,
            "the size or the mass of a domino in this row is so small that double precision rounds it to 0");
    return problem_no_answer(
        problem,
        "the dominoes of this row become larger or smaller than %s precision can represent; "
        "use fewer dominoes or a smaller r%s",
        any_arithmetic(precision).name, precision == IN_QUAD ? "" : ", or 'set precision quad'");
}

bool problem_limit(struct problem *problem, const struct scene *scene, enum dom_status status,
                   const struct domq_limit *limit)
{
    if (status != DOM_OPEN)
        return problem_status(problem, scene, status);
    return problem_no_answer(
        problem,
        "r_max is open: at the growth %s the margin is 0 within rounding errors, even in "
        "quad; if a train passes this growth, r_max is %s",
        quad_text(limit->open, 12),
        limit->ends == DOM_END_NONE ? "still unknown" : quad_limit(limit->r_max, 12));
}

/* ---- Whether a row that is at rest starts to fall ---- */

/* This many dominoes often decide. A row whose sizes are out of range after fewer of them decides nothing. */
enum { FEW = 8 };

/* The search for the largest growth runs this many dominoes of a row, or fewer if these decide. */
enum { START_SEARCHED = 24 };

/* The smallest relative tolerance of the search for a growth. The result of the search is rounded down to
 * START_DIGITS digits. */
#define START_TOL ((domq_real)1e-9)
enum { START_DIGITS = 9 };

/* Two growths count as equal if their relative difference is below this number, or below 4 times the
 * tolerance of the search if that is larger. At exactly the largest growth the margin is 0, and rounding
 * errors would otherwise decide whether the row falls. */
#define START_SAME ((domq_real)1e-8)

struct scene start_scene(const struct query *query, const struct domq_train *train, size_t count)
{
    struct scene scene = *query->scene;
    scene.train = *train;
    effect_put(&scene, DOM_EFFECT_row, (domq_real)count, NULL);
    return scene;
}

/* ---- A row that starts at rest ---- */

/* A run of the first dominoes of a row. */
struct plain_run {
    struct scene_row made; /* the caller frees made.domino */
    struct domq_verdict verdict;
    double spare; /* the smallest margin / barrier of the dominoes, below 0 if the row stops */
    /* Unless this is 0, the run ends once it shows that a row of so many dominoes, which have all the same
     * proportions, falls. */
    size_t most;
    bool is_settled; /* it has shown this */
    double share[3]; /* margin / kinetic energy of the last dominoes, beginning with the last */
};

/*
 * Visits a domino. In a train, margin / kinetic energy changes less and less from domino to domino. To be on
 * the safe side, this test assumes that it decreases at every further domino, and each time by the size of
 * its last change. If more than half of it would still be left at the end of the row, all dominoes fall.
 */
static bool spare_visit(const struct domq_fall *fall, void *context)
{
    struct plain_run *run = context;
    /* A first domino that just tips over has a margin of 0. */
    if (fall->domino == 1 && isnan(run->made.row.push))
        return true;
    if (fall->barrier > 0)
        run->spare = fmin(run->spare, (double)(fall->margin / fall->barrier));
    /* The last domino hits no other, so it may need less energy. */
    if (run->most == 0 || fall->domino == run->made.row.count)
        return true;
    double *share = run->share;
    share[2] = share[1];
    share[1] = share[0];
    share[0] = (double)(fall->margin / fall->kinetic);
    const double change = fabs(share[0] - share[1]);
    run->is_settled = change <= fabs(share[1] - share[2]) &&
                      (double)(run->most - fall->domino) * change < fmin(share[0], share[1]) / 2;
    return !run->is_settled;
}

/* Runs a row, or only its first part if sizes or masses become too large or too small, which are too far away
 * to affect the start. */
static enum dom_status plain_run(struct plain_run *run)
{
    struct domq_row *row = &run->made.row;
    for (;;) {
        run->spare = HUGE_VAL;
        run->is_settled = false;
        run->share[0] = run->share[1] = (double)NAN;
        const enum dom_status status =
            any_row_run(row, &run->made.compute, false, spare_visit, run, &run->verdict);
        if (status < DOM_BAD_COUNT || status > DOM_BAD_MASS || row->count <= 2)
            return status;
        row->count /= 2;
    }
}

bool start_run(const struct query *query, const struct domq_train *train, domq_real dominoes, bool seeks_push,
               struct start *start, struct problem *problem)
{
    struct plain_run run = {.most = 0};
    struct double_row in_double;
    const struct scene scene =
        start_scene(query, train, (size_t)quad_smaller(dominoes, (domq_real)START_DOMINOES));
    const struct domq_row *row = &run.made.row;
    *start = (struct start){.push = DOMQ_NAN};
    if (!scene_row_make(&scene, &run.made, problem))
        return false;
    enum dom_status status = plain_run(&run);
    start->status = status;
    start->count = row->count;
    start->engine = row->engine ? scene_engine_why(&scene) : NULL;
    start->end = run.verdict.end;
    start->stops_at = run.verdict.domino;
    start->spare = run.spare;
    start->falls = status == DOM_OK && run.verdict.end == DOM_ROW_FALLS;
    if (seeks_push && status == DOM_OK && !start->falls && !start->engine) {
        /* The centre of a falling domino moves on a circle. If omega^2 h/2 > g, its weight is too small to
         * keep it on the circle, and the domino lifts off the floor. */
        const double lifting = (double)quad(sqrt)(2 * row->g / run.made.domino[0].height);
        double push = (double)NAN;
        status = scene_row_in_double(&run.made, &in_double);
        if (status == DOM_OK) {
            status = dom_row_weakest_push(&in_double.row, &in_double.compute, lifting, &push);
            free(in_double.domino);
        }
        start->push = quad_decimal(push);
    }
    free(run.made.domino);
    return row_status(query, problem, status);
}

/* ---- The largest growth ---- */

struct search {
    struct scene scene;
    struct plain_run run; /* its row is a part of a train */
    size_t count;         /* this many dominoes are run first */
    enum dom_status status;
};

/* Returns margin / barrier of the row with growth r: at least 0 if all dominoes fall, below 0 if the row
 * stops, and NaN if the fall ends in another way. */
static double growth_spare(double r, void *context)
{
    struct search *s = context;
    struct plain_run *run = &s->run;
    struct domq_row *row = &run->made.row;
    const struct domq_verdict *v = &run->verdict;
    bool is_decided = false;
    while (!is_decided && s->status == DOM_OK) {
        row->count = s->count;
        row_grow((domq_real)r, run->made.domino, row->count, &s->scene);
        s->status = plain_run(run);
        is_decided = row->count < s->count || row->count == START_SEARCHED || run->is_settled ||
                     (v->end != DOM_ROW_FALLS && v->domino < row->count);
        s->count = is_decided ? s->count : START_SEARCHED;
    }
    return s->status == DOM_OK && v->end == DOM_ROW_FALLS   ? fmax(run->spare, 0)
           : s->status == DOM_OK && v->end == DOM_ROW_STOPS ? fmin(run->spare, -DBL_MIN)
                                                            : (double)NAN;
}

/*
 * Lowers the growth from `from`, where the row does not fall, until it falls. Returns false if it does not
 * fall at any of the growths that are tried, the last of which is 1. The first step is 2 %. If `hurries` is
 * true, each step is twice as large as the one before, or goes where the secant leads. Otherwise, all steps
 * are 2 %, so that only narrower intervals of growths can be missed.
 */
static bool search_down(struct search *s, bool hurries, struct spot from, struct spot *bad, struct spot *good)
{
    struct spot before = {(double)NAN, (double)NAN};
    *bad = from;
    for (double step = bad->x / 50; bad->x > 1 && s->status == DOM_OK;
         step = hurries ? 2 * step : bad->x / 50) {
        const double zero = bad->x + (before.x - bad->x) * bad->value / (bad->value - before.value);
        /* go a little beyond the secant's zero, so that the row falls */
        const double beyond = zero - (bad->x - zero) / 16;
        const bool follows = hurries && zero < bad->x && beyond > bad->x - 8 * step;
        good->x = fmax(1, follows ? beyond : bad->x - step);
        good->value = growth_spare(good->x, s);
        if (good->value >= 0)
            return true;
        before = *bad;
        *bad = *good;
    }
    return false;
}

bool start_growths_find(const struct query *query, const struct domq_train *train, domq_real highest,
                        struct start_growths *growths, struct problem *problem)
{
    struct search s = {.scene = start_scene(query, train, 2)};
    struct scene_row *made = &s.run.made;
    *growths = (struct start_growths){DOMQ_NAN, DOMQ_NAN, scene_has_engine(&s.scene)};
    if (growths->is_too_slow)
        return true;
    /* The dominoes of a train lean and stand alike, so two equal ones show whether they stand. The first
     * domino may have too little room for its tilt at this growth. */
    s.scene.train.r = 1;
    if (s.scene.effect[DOM_EFFECT_release].on)
        s.scene.effect[DOM_EFFECT_release].value[0] = RELEASE_TOUCH;
    if (!scene_row_make(&s.scene, &s.run.made, problem))
        return false;
    free(made->domino);
    made->row.domino = made->domino = malloc(START_SEARCHED * sizeof *made->domino);
    if (!made->domino)
        return query_status(query, problem, DOM_NO_MEMORY);
    struct any_compute *compute = &made->compute;
    made->row.release = scene_release(query->scene);
    compute->tol = quad_larger(compute->tol, START_TOL);
    s.run.most = made->row.walls == 0 ? START_SEARCHED : 0;
    s.count = made->row.walls == 0 ? FEW : START_SEARCHED;
    const domq_real same = quad_larger(START_SAME, 4 * compute->tol);
    /* The train's r_max limits the growth from above and is close to it in most cases, so the search goes
     * down from there. */
    const double top = (double)quad_larger(highest * (1 - same), 1);
    const struct spot from = {top, growth_spare(top, &s)};
    struct spot good, bad;
    if (from.value >= 0) {
        *growths = (struct start_growths){highest, same * highest, false};
    } else if (search_down(&s, true, from, &bad, &good) || search_down(&s, false, from, &bad, &good)) {
        seek_edge(growth_spare, &s, &good, &bad, (double)compute->tol / 8 * good.x);
        growths->r_max = round_digits((domq_real)good.x, START_DIGITS, false);
        /* The edge is known to an eighth of the tolerance, and each run has an error within the tolerance,
         * too. */
        growths->uncertainty = (domq_real)good.x - growths->r_max + 2 * compute->tol * (domq_real)good.x;
    }
    free(made->domino);
    return row_status(query, problem, s.status);
}

struct words start_words(const struct query *query)
{
    const domq_real push = scene_push(query->scene, query->scene->scale.h);
    struct words words = {"if its first domino just tips over"};
    const struct words tilt = release_words(scene_release(query->scene));
    if (push > 0 || (!isnan(push) && !*tilt.text))
        snprintf(words.text, sizeof words.text, "with a push of %.4g rad/s%s%.40s", (double)push,
                 *tilt.text ? " " : "", tilt.text);
    else if (*tilt.text)
        snprintf(words.text, sizeof words.text, "if its first domino is released %.40s", tilt.text);
    return words;
}

const char *start_problem(const struct query *query, const struct start *start, char text[START_TEXT])
{
    char push[80] = "";
    if (isfinite(start->push))
        snprintf(push, sizeof push, "; a push of %.4g rad/s is enough", (double)start->push);
    else if (!start->engine && start->end != DOM_ROW_MISSES)
        snprintf(push, sizeof push, "; no push that leaves the first domino on the floor is enough");
    snprintf(text, START_TEXT, "%s, the fall ends at domino %zu: %s%s", start_words(query).text,
             start->stops_at,
             start->end == DOM_ROW_LEANS ? "the first domino touches the second before it tips over"
                                         : dom_row_end_text(start->end),
             push);
    return text;
}
