/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "train/row_start.h"
#include "language/quad.h"
#include <stdlib.h>

/* A very long row need not be run to its end. If the endless train keeps falling, and a row of this many
 * dominoes falls, then any longer row also falls, because a row forgets its start: in the model, the energy
 * of a cycle is a linear function of the energy of the cycle before it, with a slope below 1. */
enum { START_DOMINOES = 64 };

/* A search first runs this many dominoes, which often decide the verdict. */
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

/* Halves the row if a size or a mass is out of range. The dropped dominoes are too far away to affect the
 * start. */
static bool row_shorten(struct domq_row *row, enum dom_status status)
{
    const bool shorter = status >= DOM_BAD_COUNT && status <= DOM_BAD_MASS && row->count > 2;
    row->count /= shorter ? 2 : 1;
    return shorter;
}

/* Finds the weakest push up to `strongest`, in double. */
static enum dom_status push_find(const struct scene_row *row, domq_real strongest, domq_real *push)
{
    struct double_row made;
    double found = DOM_NAN;
    enum dom_status status = scene_row_in_double(row, &made);
    if (status == DOM_OK)
        status = dom_row_weakest_push(&made.row, &made.compute, (double)strongest, &found);
    free(made.domino);
    *push = quad_decimal(found);
    return status;
}

/* A run of the first dominoes of a row. */
struct plain_run {
    struct scene_row made; /* the caller frees made.domino */
    struct domq_verdict verdict;
    double spare;   /* the smallest margin / barrier of the dominoes */
    bool is_pushed; /* if false, the first domino just tips over, with a margin of 0 */
};

static bool spare_visit(const struct domq_fall *fall, void *context)
{
    struct plain_run *run = context;
    if (fall->barrier > 0 && (fall->domino > 1 || run->is_pushed))
        run->spare = fmin(run->spare, (double)(fall->margin / fall->barrier));
    return true;
}

/* Runs a row of at most START_DOMINOES dominoes. If the scene has no such row, sets *problem, which may be
 * NULL, and run->made.domino to NULL. */
static enum dom_status plain_run(const struct scene *scene, struct plain_run *run, struct problem *problem)
{
    struct problem ignored = {.kind = PROBLEM_NONE};
    enum dom_status status;
    if (!scene_row_make(scene, &run->made, problem ? problem : &ignored)) {
        run->made.domino = NULL;
        return DOM_OK;
    }
    run->made.row.floor = false;
    run->is_pushed = !isnan(run->made.row.push);
    do {
        run->spare = HUGE_VAL;
        status = any_row_run(&run->made.row, &run->made.compute, false, spare_visit, run, &run->verdict);
    } while (row_shorten(&run->made.row, status));
    return status;
}

static size_t plain_count(domq_real dominoes)
{
    return dominoes < START_DOMINOES ? (size_t)dominoes : START_DOMINOES;
}

bool start_find(const struct query *query, const struct domq_train *train, domq_real dominoes,
                struct start *start, struct problem *problem)
{
    struct plain_run run;
    const struct scene scene = start_scene(query, train, plain_count(dominoes));
    enum dom_status status = plain_run(&scene, &run, problem);
    const struct domq_row *row = &run.made.row;
    if (!run.made.domino)
        return false;
    *start = (struct start){
        .count = row->count, .push = DOMQ_NAN, .engine = row->engine ? scene_engine_why(&scene) : NULL};
    start->falls = status == DOM_OK && run.verdict.end == DOM_ROW_FALLS;
    if (status == DOM_OK && !start->falls) {
        start->end = run.verdict.end;
        start->stops_at = run.verdict.domino;
        /* The centre of a falling domino moves on a circle. If omega^2 h/2 > g, its weight is too small to
         * keep it on the circle, and the domino lifts off the floor. */
        const domq_real lifting = quad(sqrt)(2 * row->g / run.made.domino[0].height);
        if (!start->engine)
            status = push_find(&run.made, lifting, &start->push);
    }
    free(run.made.domino);
    return row_status(query, problem, status);
}

double start_row_spare(const struct query *query, const struct domq_train *train, domq_real dominoes,
                       enum dom_status *status)
{
    struct plain_run run;
    const size_t count = plain_count(dominoes);
    const struct scene scene = start_scene(query, train, count);
    const enum dom_status ran = plain_run(&scene, &run, NULL);
    if (!run.made.domino)
        return (double)-INFINITY;
    free(run.made.domino);
    if (ran == DOM_NO_MEMORY || ran == DOM_INTERRUPTED)
        *status = ran;
    /* If sizes are out of range, only the first dominoes are run. They must be enough to decide. */
    const bool is_short = run.made.row.count < count && run.made.row.count < FEW;
    if (ran != DOM_OK || is_short || (run.verdict.end != DOM_ROW_FALLS && run.verdict.end != DOM_ROW_STOPS))
        return (double)-INFINITY;
    if (run.verdict.end == DOM_ROW_STOPS)
        return fmin(run.spare, 0) - (double)(count - run.verdict.domino);
    return dominoes > START_DOMINOES ? fmin(run.spare, start_train_spare(query, train)) : run.spare;
}

double start_train_spare(const struct query *query, const struct domq_train *train)
{
    struct domq_barrier barrier;
    const enum dom_status status = any_barrier_find(train, query_compute(query), &barrier);
    if (status != DOM_OK && status != DOM_STOPS)
        return (double)-INFINITY;
    const double share = (double)(barrier.margin / barrier.barrier);
    return status == DOM_OK ? fmin(share, HUGE_VAL) : fmin(share, -0.0);
}

/* ---- The largest growth ---- */

/* A search for the largest growth. Its rows are parts of trains. */
struct search {
    const struct scene *scene;
    struct scene_row made;
    size_t most; /* a row that falls up to this domino counts as falling */
    /* The first `count` dominoes are run. Often they decide, and dominoes after them would only take time. */
    size_t count;
    bool settles; /* the first dominoes may decide, because all dominoes have the same proportions */
    enum dom_status status;
    /* ---- The last run ---- */
    double share[3]; /* margin / kinetic energy of the last dominoes, beginning with the last */
    bool settled;    /* the dominoes that were run show that all others fall, too */
    /* Smallest margin / barrier, below 0 if the row stops. NaN if the fall ends in another way. */
    double spare;
};

/*
 * Visits a domino. In a train, margin / kinetic energy changes less and less from domino to domino. To be on
 * the safe side, this test assumes that it decreases at every further domino, and each time by the size of
 * its last change. If more than half of it would still be left at the end of the row, all dominoes fall.
 */
static bool search_visit(const struct domq_fall *fall, void *context)
{
    struct search *s = context;
    if (fall->domino == 1 && isnan(s->made.row.push))
        return true;
    if (fall->barrier > 0)
        s->spare = fmin(s->spare, (double)(fall->margin / fall->barrier));
    /* The last domino hits no other, so it may need less energy. */
    if (!s->settles || fall->domino == s->made.row.count)
        return true;
    s->share[2] = s->share[1];
    s->share[1] = s->share[0];
    s->share[0] = (double)(fall->margin / fall->kinetic);
    const double change = fabs(s->share[0] - s->share[1]);
    s->settled = change <= fabs(s->share[1] - s->share[2]) &&
                 (double)(s->most - fall->domino) * change < fmin(s->share[0], s->share[1]) / 2;
    return !s->settled;
}

/* Returns true if all dominoes fall at the growth r. */
static bool search_falls(struct search *s, domq_real r)
{
    struct domq_verdict verdict = {.end = DOM_ROW_STOPS};
    struct domq_row *row = &s->made.row;
    size_t count = s->count, most = s->most;
    bool decided = false;
    while (!decided && s->status == DOM_OK) {
        row->count = count;
        row_grow(r, s->made.domino, count, s->scene);
        s->settled = false;
        s->spare = HUGE_VAL;
        for (int k = 0; k < 3; k++)
            s->share[k] = (double)NAN;
        s->status = any_row_run(row, &s->made.compute, false, search_visit, s, &verdict);
        if (row_shorten(row, s->status)) {
            count = most = row->count;
            s->status = DOM_OK;
            continue;
        }
        decided = count == most || s->settled || (verdict.end != DOM_ROW_FALLS && verdict.domino < count);
        if (!decided)
            count = s->count = most;
    }
    if (verdict.end != DOM_ROW_FALLS && verdict.end != DOM_ROW_STOPS)
        s->spare = (double)NAN;
    return s->status == DOM_OK && verdict.end == DOM_ROW_FALLS;
}

/* A growth and the energy to spare there. */
struct tried {
    domq_real r;
    double spare;
};

/* Returns the growth at which the secant through two points is 0, or NaN. */
static domq_real secant(const struct tried *a, const struct tried *b)
{
    const double part = a->spare / (a->spare - b->spare);
    return isfinite(part) ? a->r + (b->r - a->r) * (domq_real)part : DOMQ_NAN;
}

/*
 * Lowers the growth from *bad, where the row does not fall, until it falls. Returns false if it does not fall
 * at any of the growths that are tried, the last of which is 1. The first step is 2 %. If `hurries` is true,
 * each step is twice as large as the one before, or goes where the secant leads. Otherwise, all steps are
 * 2 %, so that only narrower intervals of growths can be missed.
 */
static bool search_down(struct search *s, bool hurries, struct tried *bad, struct tried *good)
{
    struct tried before = {DOMQ_NAN, (double)NAN};
    for (domq_real step = bad->r / 50; bad->r > 1 && s->status == DOM_OK;
         step = hurries ? 2 * step : bad->r / 50) {
        /* go a little beyond the secant's zero, so that the row falls */
        domq_real x = bad->r - step;
        const domq_real zero = secant(bad, &before), beyond = zero - (bad->r - zero) / 16;
        if (hurries && zero < bad->r && beyond > bad->r - 8 * step)
            x = beyond;
        *good = (struct tried){.r = quad_larger(x, 1)};
        if (search_falls(s, good->r)) {
            good->spare = s->spare;
            return true;
        }
        before = *bad;
        *bad = (struct tried){good->r, s->spare};
    }
    return false;
}

/* Finds the edge between two growths: at `good` the row falls, at `bad` it does not. */
static domq_real search_edge(struct search *s, struct tried good, struct tried bad, double tol)
{
    struct tried last = bad, before = good;
    domq_real width = bad.r - good.r, near;
    for (int k = 1; bad.r - good.r > (near = good.r * (domq_real)tol) && s->status == DOM_OK; k++) {
        const domq_real middle = good.r + (bad.r - good.r) / 2;
        domq_real x = secant(&last, &before);
        /* shift x towards the farther end, so that both ends approach the edge */
        x += x - good.r < bad.r - x ? 0.4 * near : -0.4 * near;
        if (!(x > good.r && x < bad.r))
            x = middle;
        if (k % 3 == 0) {
            x = bad.r - good.r > width / 2 ? middle : x;
            width = bad.r - good.r;
        }
        const bool falls = search_falls(s, x);
        before = last;
        last = (struct tried){x, s->spare};
        *(falls ? &good : &bad) = last;
    }
    return good.r;
}

static domq_real search_same(const struct search *s)
{
    return quad_larger(START_SAME, 4 * s->made.compute.tol);
}

/* Finds the largest growth up to `highest` at which the row falls, or NaN. The train's r_max limits it from
 * above and is close to it in most cases, so the search goes down from there. */
static domq_real search_run(struct search *s, domq_real highest)
{
    struct tried bad = {.r = quad_larger(highest * (1 - search_same(s)), 1)}, good;
    if (search_falls(s, bad.r))
        return highest;
    bad.spare = s->spare;
    const struct tried top = bad;
    if (!search_down(s, true, &bad, &good)) {
        bad = top;
        if (!search_down(s, false, &bad, &good))
            return DOMQ_NAN;
    }
    return search_edge(s, good, bad, (double)s->made.compute.tol / 8);
}

bool start_growths_find(const struct query *query, const struct domq_train *train, domq_real highest,
                        struct start_growths *growths, struct problem *problem)
{
    struct scene scene = start_scene(query, train, 2);
    /* The first domino may have too little room for its tilt at the growths that are tried first. */
    if (scene.effect[DOM_EFFECT_release].on)
        scene.effect[DOM_EFFECT_release].value[0] = RELEASE_TOUCH;
    struct search s = {.scene = &scene, .most = START_SEARCHED, .count = FEW};
    *growths = (struct start_growths){DOMQ_NAN, DOMQ_NAN, scene_has_engine(&scene)};
    scene.train.r = 1;
    if (growths->is_too_slow)
        return true;
    /* The dominoes of a train lean and stand alike, so a row of two shows whether they stand. */
    if (!scene_row_make(&scene, &s.made, problem))
        return false;
    free(s.made.domino);
    s.made.row.domino = s.made.domino = malloc(START_SEARCHED * sizeof *s.made.domino);
    s.made.row.floor = false;
    s.made.row.release = scene_release(query->scene);
    s.made.compute.tol = quad_larger(s.made.compute.tol, START_TOL);
    s.settles = s.made.row.walls == 0;
    if (!s.settles)
        s.count = s.most;
    s.status = s.made.domino ? DOM_OK : DOM_NO_MEMORY;
    const domq_real found = s.made.domino ? search_run(&s, highest) : DOMQ_NAN;
    free(s.made.domino);
    if (!row_status(query, problem, s.status))
        return false;
    growths->r_max = found >= highest ? highest : round_digits(found, START_DIGITS, false);
    /* The edge is known to an eighth of the tolerance, and each run has an error within the tolerance, too.
     */
    growths->uncertainty = found >= highest ? search_same(&s) * highest
                                            : found - growths->r_max + 2 * s.made.compute.tol * found;
    return true;
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
