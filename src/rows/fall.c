/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'fall', which lists the dominoes, 'verdict', which prints only the result, and 'slip', which
 * says how much friction the feet of an endless train need. */
#include "language/quad.h"
#include "rows/rows.h"
#include "train/train.h"
#include <stdlib.h>

const struct column fall_columns[] = {
    {"domino", "", "number of the domino, from 1", 6},
    {"height", "m", "height of the domino", 6},
    {"hit", "s",
     "time at which the domino is hit, counted from the push or the release or, without either, from the "
     "first hit",
     7},
    {"falls", "s", "time at which the domino hits the next one, or lies on the floor", 7},
    {"omega", "rad/s", "angular velocity of the domino just after it is hit", 6},
    {"kinetic", "mgh/2",
     "kinetic energy of all moving dominoes just after this domino is hit; in J if masses are known", 9},
    {"barrier", "mgh/2", "energy that is needed to tip this domino over", 9},
    {"margin", "mgh/2", "kinetic - barrier", 9},
    {"energy", "share", "kinetic / barrier; the domino tips over if this is at least 100 %", 6},
    {"floor", "",
     "friction that the floor needs so that no foot slips while this domino falls (only with 'set floor')",
     5},
    {"floor_hit", "",
     "friction that the floor needs so that no foot slips when this domino is hit (only with 'set floor')",
     9},
    {"slid", "m", "how far the foot of the domino has slid (negative: backwards); only with 'set feet'", 7},
    {NULL, NULL, NULL, 0},
};

const struct column verdict_columns[] = {
    {"verdict", "", "how the fall ends: 'all fall', 'stops' or another outcome", 12},
    {"domino", "", "the last domino that is hit", 0},
    {"short_by", "mgh/2", "the energy that the last domino lacks; in J if masses are known", 0},
    {"seconds", "s", "the time until the last domino lies on the floor, as 'fall' measures it", 0},
    {"weakest", "", "the domino with the least energy to spare, among the dominoes that tip over", 0},
    {"spare", "share", "the spare energy of the weakest domino, divided by the energy that it needs", 0},
    {NULL, NULL, NULL, 0},
};

int floor_number;

/* ---- A run of the row ---- */

bool row_status(const struct query *query, struct problem *problem, enum dom_status status)
{
    const bool engine = scene_engine(query->scene);
    enum precision precision = query->scene->compute.precision;
    if (status == DOM_NOT_CONVERGED && engine)
        return problem_no_answer(problem, "%s", engine_undecided);
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

bool row_run_begin(const struct query *query, struct problem *problem, struct row_run *run)
{
    struct scene_row *scene = &run->scene;
    *run = (struct row_run){.hits = 0};
    if (!scene_row_make(query->scene, scene, problem))
        return false;
    if (!scene->row.engine)
        return true;
    scene->engine.report = &run->report;
    run->report.slid = malloc(scene->row.count * sizeof *run->report.slid);
    if (run->report.slid)
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
    free(run->report.slid);
    free(run->scene.domino);
    free(run->fall);
}

bool row_run_tipped(const struct row_run *run, size_t k)
{
    return k == 0 && isnan(run->scene.row.push);
}

struct words all_fall_words(size_t count)
{
    struct words words;
    snprintf(words.text, sizeof words.text, "%s", count == 2 ? "Both fall" : "It falls");
    if (count > 2)
        snprintf(words.text, sizeof words.text, "All %zu fall", count);
    return words;
}

void weakest_say(struct answer *a, const struct domq_verdict *v, bool as_detail)
{
    if (v->weakest > 0 && isfinite(v->spare))
        (as_detail ? answer_detail : answer_say)(
            a, "%s, domino %zu, %s.",
            v->end == DOM_ROW_FALLS ? "The weakest" : "The weakest of those that tip over", v->weakest,
            energy_words(v->spare + 1).text);
}

domq_real fall_share(const struct domq_fall *f)
{
    return f->barrier > 0 && isfinite(f->barrier) ? f->kinetic / f->barrier : DOMQ_NAN;
}

/* ---- The friction that feet need ---- */

static const char foot_lifted[] = "a domino is lifted off the floor, and no friction can prevent this";

/* The friction that feet need so that they do not slip: while dominoes fall, or when dominoes are hit. */
struct needs {
    domq_real most; /* the largest friction coefficient; infinite if a foot is lifted off the floor */
    size_t domino;  /* whose foot needs it, counted from 1 */
    size_t first;   /* whose foot slips first, or 0 if none slips */
    size_t head;    /* which domino falls or is hit at that time */
};

static void needs_add(struct needs *n, domq_real needs, size_t domino, size_t head, domq_real floor)
{
    if (needs > n->most) {
        n->most = needs;
        n->domino = domino;
    }
    if (n->first == 0 && needs > floor) {
        n->first = domino;
        n->head = head;
    }
}

static void needs_say(struct answer *a, const struct needs *n, bool in_motion, domq_real floor)
{
    const char *when = in_motion ? "While dominoes fall" : "When dominoes are hit";
    char slips[120] = "no foot slips";
    if (n->first > 0)
        snprintf(slips, sizeof slips, "the foot of domino %zu slips first, when domino %zu %s", n->first,
                 n->head, in_motion ? "falls" : "is hit");
    if (isinf(n->most))
        answer_say(a, "%s, the foot of domino %zu is lifted off the floor, and no friction can prevent this.",
                   when, n->domino);
    else if (n->domino > 0)
        answer_say(a,
                   "%s, feet need a friction coefficient of up to %s (domino %zu); on this floor, with %.4g, "
                   "%s.",
                   when, measured(n->most, "", 4).text, n->domino, (double)floor, slips);
}

/* Prints how slipping feet affect the answer. If `in_motion` is false, feet slip only in a collision. */
static void slip_matters_say(struct answer *a, bool in_motion)
{
    answer_say(a, in_motion
                      ? "This answer assumes that feet do not slip. If feet slip while dominoes fall, a "
                        "row can stop sooner than this answer says."
                      : "This answer assumes that feet do not slip. A slip at the moment of a hit "
                        "changes the largest growth by up to a tenth.");
}

struct falling {
    struct answer *answer;
    struct row_run run;
    domq_real mu;            /* the friction of the floor */
    struct dom_floor *floor; /* what the floor needs while each domino falls; NULL unless 'set floor' is on */
    struct needs motion, hit;
    struct domq_fall last; /* the last domino that was hit */
};

static void feet_say(struct answer *a, const struct falling *f)
{
    needs_say(a, &f->motion, true, f->mu);
    needs_say(a, &f->hit, false, f->mu);
    /* While the last domino falls, a slip does not matter. */
    const bool in_motion = f->motion.head > 0 && f->motion.head < f->run.scene.row.count;
    if (!in_motion && f->hit.first == 0)
        return;
    slip_matters_say(a, in_motion);
    answer_say(a,
               "Enter 'set floor off; set feet %.4g' to run the row on this floor in a rigid-body "
               "engine, where feet can slip.",
               (double)f->mu);
}

/* ---- In words ---- */

/* Returns a phrase that says why the fall ends early, such as "friction locks it". */
static const char *end_reason(const struct row_run *run)
{
    const struct domq_verdict *v = &run->verdict;
    if (run->scene.row.engine && v->end == DOM_ROW_STOPS && run->report.lies)
        return "this domino falls, and the next one stays upright";
    if (!run->scene.row.engine && v->end == DOM_ROW_STOPS && !isfinite(v->short_by))
        return "its energy is too small; with more energy, friction would lock the row at a larger tilt";
    return dom_row_end_text(v->end);
}

/* Says how the fall ends. The weakest domino goes into the details if the table of 'fall' is shown, or if the
 * row does not fall. */
static void verdict_say(struct answer *a, const struct falling *f, bool listed)
{
    const struct domq_verdict *v = &f->run.verdict;
    const size_t count = f->run.scene.row.count;
    if (v->end == DOM_ROW_FALLS && count == 1 && isnan(f->run.scene.row.push))
        answer_say(a, "%s.", all_fall_words(count).text);
    else if (v->end == DOM_ROW_FALLS && isfinite(v->seconds))
        answer_say(a, "%s in %s.", all_fall_words(count).text, measured(v->seconds, "s", 4).text);
    else if (v->end == DOM_ROW_FALLS)
        answer_say(a, "%s, but one domino almost stops, so the duration of the fall cannot be computed.",
                   all_fall_words(count).text);
    else if (v->end == DOM_ROW_STOPS && isfinite(v->short_by))
        answer_say(a, "The row stops at domino %zu of %zu, which %s.%s", v->domino, count,
                   energy_words(fall_share(&f->last)).text, count > 1 ? " 'mend' looks for a change." : "");
    else
        answer_say(a, "The fall ends at domino %zu of %zu: %s.", v->domino, count, end_reason(&f->run));
    weakest_say(a, v, listed || v->end != DOM_ROW_FALLS);
}

/* If the engine ran the row, prints how accurate it is. */
static void engine_say(struct answer *a, const struct row_run *run)
{
    const struct engine_report *s = &run->report;
    if (run->scene.row.engine)
        answer_detail(
            a,
            "Chipmunk %s, a rigid-body engine, ran the row with at least %g time steps per sqrt(h/g), where "
            "h is the height of the domino that was hit last. With half as many steps the verdict is the "
            "same, and times agree within %.2g %%.",
            s->version, s->steps, 100 * s->change);
}

/* ---- The run ---- */

static void columns_choose(struct answer *a, const struct falling *f, bool has_masses)
{
    if (answer_for_people(a)) {
        /* A table shows energies as percentages and, if the masses are known, also in J. */
        answer_leave_out(a, has_masses ? "margin" : "kinetic barrier margin");
        answer_leave_out(a, f->run.scene.row.engine ? "energy" : ""); /* the engine computes no barriers */
    }
    if (!f->floor)
        answer_leave_out(a, "floor floor_hit");
    if (!(f->run.scene.row.engine && isfinite(f->run.scene.engine.feet)))
        answer_leave_out(a, "slid");
}

static bool fall_note(const struct domq_fall *fall, void *context)
{
    struct falling *f = context;
    f->last = *fall;
    if (f->floor) {
        const struct dom_floor *floor = &f->floor[fall->domino - 1];
        needs_add(&f->motion, (domq_real)floor->motion, floor->domino, fall->domino, f->mu);
        needs_add(&f->hit, (domq_real)floor->hit, floor->hit_domino, fall->domino, f->mu);
    }
    return true;
}

/* Returns a cell for a number that is computed in double precision only. */
static struct cell cell_in_double(double value)
{
    struct cell cell = cell_without_error((domq_real)value);
    cell.digits = 3;
    cell.in_double = true;
    return cell;
}

static bool fall_row(const struct domq_fall *fall, void *context)
{
    struct falling *f = context;
    const struct scene_row *scene = &f->run.scene;
    const size_t k = fall->domino - 1;
    const struct dom_floor none = {.motion = DOM_NAN, .hit = DOM_NAN},
                           *floor = f->floor ? &f->floor[k] : &none;
    const bool lifted = isinf(floor->motion) || isinf(floor->hit), people = answer_for_people(f->answer);
    const domq_real share = fall_share(fall);
    /* For people, energies above 100 times what is needed are not distinguished, as in energy_words. */
    const bool has_plenty = share > 100 || (fall->barrier == 0 && fall->kinetic > 0);
    answer_row(f->answer,
               ROW(cell_count((domq_real)fall->domino), cell_narrow(scene->domino[k].height, 4),
                   cell_narrow(fall->time, 4), cell_narrow(fall->time + fall->duration, 4),
                   cell_narrow(fall->omega, 4), cell_narrow(fall->kinetic, 4), cell_narrow(fall->barrier, 4),
                   cell_narrow(fall->margin, 4),
                   has_plenty && people ? cell_word("> 10000") : cell_narrow(share, 4),
                   cell_in_double(floor->motion), cell_in_double(floor->hit),
                   cell_in_double(scene->row.engine ? f->run.report.slid[k] : (double)NAN)),
               lifted && !people ? foot_lifted : NULL);
    return fall_note(fall, context) && !answer_lost(f->answer);
}

static void verdict_row(struct answer *a, const struct row_run *run)
{
    static const char *const words[] = {
        [DOM_ROW_FALLS] = "all fall",      [DOM_ROW_STOPS] = "stops",    [DOM_ROW_MISSES] = "misses",
        [DOM_ROW_PASSES] = "passes above", [DOM_ROW_LEANS] = "leans",    [DOM_ROW_PARTS] = "parts",
        [DOM_ROW_LOCKS] = "locks",         [DOM_ROW_SKEWED] = "touches", [DOM_ROW_BACK] = "falls back"};
    char reason[ANSWER_REASON];
    const struct domq_verdict *v = &run->verdict;
    bool falls = v->end == DOM_ROW_FALLS;
    const struct cell cells[] = {cell_word(words[v->end]),
                                 cell_count((domq_real)v->domino),
                                 cell_computed(v->short_by),
                                 cell_uncertain(falls ? v->seconds : DOMQ_NAN,
                                                run->scene.row.engine
                                                    ? (domq_real)(run->report.change * (double)v->seconds)
                                                    : DOMQ_NAN),
                                 v->weakest ? cell_count((domq_real)v->weakest) : cell_real(DOMQ_NAN),
                                 cell_computed(v->spare)};
    snprintf(reason, sizeof reason, "domino %zu: %s", v->domino, end_reason(run));
    answer_row(a, cells, falls || answer_for_people(a) ? NULL : reason); /* sentences have the reason */
}

/* Finds what the floor needs, in double. */
static enum dom_status floor_find(struct falling *f)
{
    struct double_row made;
    f->floor = calloc(f->run.scene.row.count, sizeof *f->floor);
    if (!f->floor || !double_row_make(&f->run.scene.row, &f->run.scene.compute, &made))
        return DOM_NO_MEMORY;
    const enum dom_status status = dom_row_floor(&made.row, &made.compute, f->floor);
    free(made.domino);
    return status;
}

/* Runs the row and prints the answer: that of 'fall' if `listed` is true, and that of 'verdict' if it is
 * false. */
static bool row_answer(const struct query *query, struct answer *a, struct problem *problem, bool listed)
{
    struct falling f = {.answer = a, .mu = query->scene->effect[floor_number].value[0]};
    const struct domq_verdict *v = &f.run.verdict;
    const struct scene_row *scene = &f.run.scene;
    if (!row_run_begin(query, problem, &f.run))
        return false;
    a->in_double = scene->row.engine;
    if (scene_has_masses(query->scene))
        columns_in_joules(a);
    enum dom_status status = DOM_OK;
    if (query->scene->effect[floor_number].on)
        status = floor_find(&f);
    if (listed)
        columns_choose(a, &f, scene_has_masses(query->scene));
    for (size_t k = 0; k < scene->row.count && listed; k++)
        answer_announce(a, "height", scene->domino[k].height);
    if (status == DOM_OK)
        status = any_row_run(&scene->row, &scene->compute, true, listed ? fall_row : fall_note, &f,
                             &f.run.verdict);
    bool known = status == DOM_OK && v->end != DOM_ROW_PASSES && v->end != DOM_ROW_PARTS;
    answer_set_verdict(a, known && v->end == DOM_ROW_FALLS);
    if (known && !listed)
        verdict_row(a, &f.run);
    if (known || (status == DOM_OK && listed)) {
        verdict_say(a, &f, listed);
        if (f.floor)
            feet_say(a, &f);
        engine_say(a, &f.run);
    }
    bool leans = false;
    for (size_t k = 0; k < scene->row.count; k++)
        leans = leans || scene->domino[k].lean != 0;
    row_run_free(&f.run);
    free(f.floor);
    if (status != DOM_OK)
        return row_status(query, problem, status);
    return known ||
           problem_no_answer(problem, "there is no verdict after domino %zu: %s%s", v->domino,
                             dom_row_end_text(v->end),
                             leans ? "" : "; the rigid-body engine includes it: 'set method engine'");
}

bool run_fall(const struct query *query, struct answer *a, struct problem *problem)
{
    return row_answer(query, a, problem, true);
}

bool run_verdict(const struct query *query, struct answer *a, struct problem *problem)
{
    return row_answer(query, a, problem, false);
}

/* ---- slip ---- */

const struct column slip_columns[] = {
    {"motion", "",
     "the friction that the floor needs so that no foot slips while dominoes fall: the largest |R_x| / R_z",
     0},
    {"theta", "rad", "the tilt of the head at which a foot needs this friction", 0},
    {"domino", "", "the domino whose foot needs this friction: 0 = head, 1, 2, ... its followers", 0},
    {"hit", "",
     "the friction that the floor needs so that no foot slips in a collision: the largest ratio of impulses",
     0},
    {"hit_domino", "", "the domino whose foot needs this friction in a collision", 0},
    {"slips", "",
     "yes if a foot slips on the floor of 'set floor' while dominoes fall; empty without this effect", 0},
    {"slips_hit", "",
     "yes if a foot slips on the floor of 'set floor' in a collision; empty without this effect", 0},
    {NULL, NULL, NULL, 0},
};

bool run_slip(const struct query *query, struct answer *a, struct problem *problem)
{
    struct dom_floor f;
    const struct effect_state *floor = &query->scene->effect[floor_number];
    const struct dom_train train = train_in_double(&query->scene->train);
    const struct dom_compute compute = compute_in_double(&query->scene->compute);
    const enum dom_status status = dom_cycle_floor(&train, &compute, &f);
    if (status == DOM_NO_AIR && query->scene->effect[DOM_EFFECT_row].on)
        return problem_no_answer(problem, "%s; about the row: 'set floor 0.4; fall'",
                                 dom_status_text(status));
    if (!query_status(query, problem, status))
        return false;
    bool slips = f.motion > (double)floor->value[0], slips_hit = f.hit > (double)floor->value[0];
    a->in_double = true;
    answer_row(a,
               ROW(cell_narrow((domq_real)f.motion, 6), cell_computed((domq_real)f.theta),
                   cell_count((domq_real)f.domino), cell_computed((domq_real)f.hit),
                   cell_count((domq_real)f.hit_domino), floor->on ? cell_flag(slips) : cell_real(DOMQ_NAN),
                   floor->on ? cell_flag(slips_hit) : cell_real(DOMQ_NAN)),
               isfinite(f.motion) && isfinite(f.hit) ? NULL : foot_lifted);
    if (!floor->on)
        answer_say(a, "'set floor 0.5; slip' says whether feet slip on a floor with a friction of 0.5.");
    else
        answer_say(
            a,
            "On a floor with a friction coefficient of %.4g, %s while dominoes fall, and %s in a collision.",
            (double)floor->value[0], slips ? "feet slip" : "no foot slips",
            slips_hit ? "feet slip" : "no foot slips");
    if (floor->on && (slips || slips_hit))
        slip_matters_say(a, slips);
    return true;
}
