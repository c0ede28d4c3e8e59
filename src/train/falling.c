/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "train/falling.h"
#include "language/quad.h"
#include <stdlib.h>

/* ---- A run of the row ---- */

bool row_run_begin(const struct query *query, struct problem *problem, struct row_run *run)
{
    struct scene_row *scene = &run->scene;
    *run = (struct row_run){.hits = 0};
    if (!scene_row_make(query->scene, scene, problem))
        return false;
    if (!scene->row.engine)
        return true;
    scene->engine.report = &scene->report;
    scene->report.slid = malloc(scene->row.count * sizeof *scene->report.slid);
    if (scene->report.slid)
        return true;
    row_run_free(run);
    (void)query_status(query, problem, DOM_NO_MEMORY);
    return false;
}

static bool fall_keep(const struct domq_fall *fall, void *context)
{
    struct row_run *run = context;
    run->fall[run->hits++] = *fall;
    return true;
}

bool row_run(const struct query *query, struct problem *problem, bool timed, struct row_run *run)
{
    if (!row_run_begin(query, problem, run))
        return false;
    run->fall = calloc(run->scene.row.count, sizeof *run->fall);
    enum dom_status status =
        run->fall ? any_row_run(&run->scene.row, &run->scene.compute, timed, fall_keep, run, &run->verdict)
                  : DOM_NO_MEMORY;
    run->timeless = timed && status == DOM_NO_MARGIN; /* the verdict is known, but some times are not */
    if (status == DOM_OK || run->timeless)
        return true;
    row_run_free(run);
    return row_status(query, problem, status);
}

void row_run_free(struct row_run *run)
{
    free(run->scene.report.slid);
    free(run->scene.domino);
    free(run->fall);
}

void row_grow(domq_real r, struct domq_domino *domino, size_t count, const struct scene *scene)
{
    struct scene grown = *scene;
    grown.train.r = r;
    scene_row_fill(&grown, domino, count);
}

bool row_run_tipped(const struct row_run *run, size_t k)
{
    return k == 0 && isnan(run->scene.row.push);
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

struct words all_fall_words(size_t count)
{
    struct words words;
    snprintf(words.text, sizeof words.text, "%s", count == 2 ? "Both fall" : "It falls");
    if (count > 2)
        snprintf(words.text, sizeof words.text, "All %zu fall", count);
    return words;
}

domq_real fall_share(const struct domq_fall *f)
{
    return f->barrier > 0 && isfinite(f->barrier) ? f->kinetic / f->barrier : DOMQ_NAN;
}

bool row_status(const struct query *query, struct problem *problem, enum dom_status status)
{
    const bool engine = scene_has_engine(query->scene);
    enum precision precision = query->scene->compute.precision;
    if (status == DOM_NOT_CONVERGED && engine)
        return problem_no_answer(
            problem, "the rigid-body engine cannot decide this row, because the row does not come to rest or "
                     "the verdict depends on the time step; try a slightly different row");
    if (status == DOM_NO_LEAN && engine)
        return problem_no_answer(
            problem,
            "a domino of this row leans, but the rigid-body engine needs upright dominoes (the engine runs "
            "this row because %s); turn the engine off, or set all dominoes upright: 'change all lean = 0 "
            "mm'",
            scene_engine_why(query->scene));
    if (status == DOM_NO_LEAN)
        return problem_no_answer(problem,
                                 "a domino of this row leans, but rounded edges need upright dominoes; enter "
                                 "'set edges off', or set all dominoes upright: 'change all lean = 0 mm'");
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
