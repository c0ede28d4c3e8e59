/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/quad.h"
#include "train/train.h"
#include <float.h>
#include <stdlib.h>
#include <string.h>

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
    if (!(share < 100))
        return words;
    const domq_real part = share < 1 ? share : 1 / share;
    struct measured percent = measured(part, "share", 2);
    for (int digits = 3; part != 1 && strcmp(percent.text, "100 %") == 0 && digits <= 15; digits++)
        percent = measured(part, "share", digits); /* such as 99.97 % */
    snprintf(words.text, sizeof words.text, "%s %s of the energy that it %s", share < 1 ? "has" : "needs",
             percent.text, share < 1 ? "needs" : "has");
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

struct words limit_words(const struct answer *a, domq_real limit, int most)
{
    struct words words;
    int digits = style_tol_digits(&a->style, most);
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

const char engine_undecided[] =
    "the rigid-body engine cannot decide this row, because the row does not come to rest or the verdict "
    "depends on the time step; try a slightly different row";

/* The search for the largest growth runs this many dominoes of a row, or a few if these decide. */
enum { START_FEW = 8, START_SEARCHED = 24 };

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

/* A run of the first dominoes of a row. */
struct plain_run {
    struct scene_row made; /* the caller frees made.domino */
    struct domq_verdict verdict;
    enum dom_status status;
    double spare;    /* the smallest margin / barrier of the dominoes, below 0 if the row stops */
    bool may_settle; /* all dominoes have the same proportions */
    bool is_settled; /* the run has ended early, since START_SEARCHED dominoes would fall */
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
    if (!run->may_settle || fall->domino == run->made.row.count)
        return true;
    double *share = run->share;
    share[2] = share[1];
    share[1] = share[0];
    share[0] = (double)(fall->margin / fall->kinetic);
    const double change = fabs(share[0] - share[1]);
    run->is_settled = change <= fabs(share[1] - share[2]) &&
                      (double)(START_SEARCHED - fall->domino) * change < fmin(share[0], share[1]) / 2;
    return !run->is_settled;
}

/* Runs a row, or only its first part if sizes or masses become too large or too small, which are too far away
 * to affect the start. */
static void plain_run(struct plain_run *run)
{
    struct domq_row *row = &run->made.row;
    for (;; row->count /= 2) {
        run->spare = HUGE_VAL;
        run->is_settled = false;
        run->share[0] = run->share[1] = (double)NAN;
        run->status = any_row_run(row, &run->made.compute, false, spare_visit, run, &run->verdict);
        if (run->status < DOM_BAD_COUNT || run->status > DOM_BAD_MASS || row->count <= 2)
            return;
    }
}

enum dom_status push_find(const struct dom_row *row, const struct dom_compute *compute, double *push)
{
    /* The centre of a falling domino moves on a circle. If omega^2 h/2 > g, its weight is too small to keep
     * it on the circle, and the domino lifts off the floor. */
    return dom_row_weakest_push(row, compute, sqrt(2 * row->g / row->domino[0].height), push);
}

bool start_run(const struct query *query, const struct domq_train *train, domq_real dominoes, bool seeks_push,
               struct start *start, struct problem *problem)
{
    struct plain_run run = {.may_settle = false};
    struct double_row in_double;
    const struct scene scene =
        start_scene(query, train, (size_t)quad_smaller(dominoes, (domq_real)START_DOMINOES));
    const struct domq_row *row = &run.made.row;
    *start = (struct start){.push = DOMQ_NAN};
    if (!train_row_make(&scene, &run.made, problem))
        return false;
    plain_run(&run);
    enum dom_status status = start->status = run.status;
    start->count = row->count;
    start->engine = scene_engine(&scene);
    start->end = run.verdict.end;
    start->stops_at = run.verdict.domino;
    start->spare = run.spare;
    start->falls = status == DOM_OK && run.verdict.end == DOM_ROW_FALLS;
    if (seeks_push && status == DOM_OK && !start->falls && !start->engine) {
        double push = (double)NAN;
        status = scene_row_in_double(&run.made, &in_double);
        if (status == DOM_OK) {
            status = push_find(&in_double.row, &in_double.compute, &push);
            free(in_double.domino);
        }
        start->push = quad_decimal(push);
    }
    free(run.made.domino);
    if (status == DOM_NOT_CONVERGED && start->engine)
        return problem_no_answer(problem, "%s", engine_undecided);
    return query_status(query, problem, status);
}

/* ---- The largest growth ---- */

struct search {
    struct scene scene;
    struct plain_run run; /* its row is a part of a train */
    bool lacks_memory;    /* for one of the growths, which is then not known to be too large */
};

/* Returns margin / barrier of the row with growth r: at least 0 if all dominoes fall, below 0 if the row
 * stops, and NaN if the fall ends in another way. */
static double growth_spare(double r, void *context)
{
    struct search *s = context;
    struct plain_run *run = &s->run;
    const struct domq_verdict *v = &run->verdict;
    size_t *count = &run->made.row.count;
    bool is_decided = false;
    for (size_t most = START_FEW; !is_decided; most = START_SEARCHED) {
        *count = most;
        s->scene.train.r = (domq_real)r;
        train_row_fill(&s->scene, run->made.domino, most);
        plain_run(run);
        s->lacks_memory = s->lacks_memory || run->status == DOM_NO_MEMORY;
        is_decided = run->status != DOM_OK || run->is_settled || *count < most || most == START_SEARCHED ||
                     (v->end != DOM_ROW_FALLS && v->domino < most);
    }
    return run->status != DOM_OK     ? (double)NAN
           : v->end == DOM_ROW_FALLS ? fmax(run->spare, 0)
           : v->end == DOM_ROW_STOPS ? fmin(run->spare, -DBL_MIN)
                                     : (double)NAN;
}

bool start_growths_find(const struct query *query, const struct domq_train *train, domq_real highest,
                        struct start_growths *growths, struct problem *problem)
{
    struct search s = {.scene = start_scene(query, train, 2)};
    struct scene_row *made = &s.run.made;
    *growths = (struct start_growths){DOMQ_NAN, DOMQ_NAN, scene_engine(&s.scene)};
    if (growths->is_too_slow)
        return true;
    /* The dominoes of a train lean and stand alike, so two equal ones show whether they stand. The first
     * domino may have too little room for its tilt at this growth. */
    s.scene.train.r = 1;
    if (s.scene.effect[DOM_EFFECT_release].on)
        s.scene.effect[DOM_EFFECT_release].value[0] = RELEASE_TOUCH;
    if (!train_row_make(&s.scene, made, problem))
        return false;
    free(made->domino);
    made->row.domino = made->domino = malloc(START_SEARCHED * sizeof *made->domino);
    if (!made->domino)
        return query_status(query, problem, DOM_NO_MEMORY);
    struct any_compute *compute = &made->compute;
    made->row.release = scene_release(query->scene);
    compute->tol = quad_larger(compute->tol, START_TOL);
    s.run.may_settle = made->row.walls == 0;
    const domq_real same = quad_larger(START_SAME, 4 * compute->tol);
    /* The train's r_max limits the growth from above and is close to it in most cases. So the search goes
     * down from there, in steps of 2 %: narrower intervals of growths may be missed. */
    struct spot good = {.x = (double)quad_larger(highest * (1 - same), 1)}, bad;
    const double top = good.x;
    good.value = growth_spare(top, &s);
    for (bad = good; !(good.value >= 0) && good.x > 1 && s.run.status == DOM_OK;) {
        bad = good;
        good.x = fmax(1, bad.x - bad.x / 50);
        good.value = growth_spare(good.x, &s);
    }
    if (good.value >= 0 && good.x == top) {
        *growths = (struct start_growths){highest, same * highest, false};
    } else if (good.value >= 0) {
        seek_edge(growth_spare, &s, &good, &bad, (double)compute->tol / 8 * good.x);
        growths->r_max = round_digits((domq_real)good.x, START_DIGITS, false);
        /* The edge is known to an eighth of the tolerance, and each run has an error within the tolerance,
         * too. */
        growths->uncertainty = (domq_real)good.x - growths->r_max + 2 * compute->tol * (domq_real)good.x;
    }
    free(made->domino);
    return query_status(query, problem, s.lacks_memory ? DOM_NO_MEMORY : s.run.status);
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
