/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands about a finite row: its dominoes, how they fall, and how to save the row. */
#include "commands/rows/falling.h"
#include "commands/rows/feet.h"
#include "commands/rows/listing.h"
#include "commands/rows/slid.h"
#include "commands/tables.h"
#include "commands/walk.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

/* ---- fall ---- */

static const struct column fall_columns[] = {
    {"domino", "", "its number, from 1", 6},
    {"height", "m", "its height", 6},
    {"hit", "s", "when it is hit; the clock starts with the push, or with the first hit", 7},
    {"falls", "s", "when it hits the next domino, or lies on the floor", 7},
    {"omega", "rad/s", "its angular velocity just after it is hit", 6},
    {"kinetic", "mgh/2", "energy of all dominoes that move then; in J if masses are known", 9},
    {"barrier", "mgh/2", "the energy that it needs to go on", 9},
    {"margin", "mgh/2", "kinetic - barrier", 9},
    {"energy", "share", "kinetic / barrier: at 100 % it just goes on", 6},
    {"floor", "", "friction that feet need while it falls; with 'effect floor'", 5},
    {"floor_hit", "", "the same in the instant when it is hit; no foot has to hold for longer", 9},
    {"slid", "m", "how far its foot has slid, backwards if negative; with 'effect feet'", 7},
    {NULL, NULL, NULL, 0},
};

struct falling {
    struct answer *answer;
    const struct scene_row *scene;
    struct feet feet;
    struct domq_fall last; /* the last domino that was hit */
};

/* Keeps the domino, and what feet need of the floor. */
static void fall_seen(struct falling *c, const struct domq_fall *f)
{
    c->last = *f;
    feet_add(&c->feet, f);
}

static bool fall_visit(const struct domq_fall *f, void *context)
{
    fall_seen(context, f);
    return true;
}

static const char lifted[] = "a domino is lifted off the floor, which no friction prevents";

/* Returns NaN if no energy is enough, since friction locks farther on. */
static domq_real enough(domq_real energy)
{
    return isfinite(energy) ? energy : DOMQ_NAN;
}

static bool fall_row(const struct domq_fall *f, void *context)
{
    struct falling *c = context;
    bool lifts = isinf(f->floor_motion) || isinf(f->floor_hit);
    struct cell cells[] = {cell_count((domq_real)f->domino),
                           cell_narrow(c->scene->domino[f->domino - 1].height, 4),
                           cell_narrow(f->time, 4),
                           cell_narrow(f->time + f->duration, 4),
                           cell_narrow(f->omega, 4),
                           cell_narrow(f->kinetic, 4),
                           cell_narrow(enough(f->barrier), 4),
                           cell_narrow(enough(f->margin), 4),
                           cell_narrow(fall_share(f), 4),
                           cell_narrow(f->floor_motion, 3),
                           cell_narrow(f->floor_hit, 3),
                           cell_narrow(report_slid(c->scene, f->domino - 1), 3)};
    fall_seen(c, f);
    answer_row(c->answer, cells, lifts && !answer_for_people(c->answer) ? lifted : NULL);
    return !answer_lost(c->answer);
}

/* Reports an error if the model cannot follow the row to its end. */
static bool verdict_known(struct problem *problem, const struct domq_verdict *v)
{
    return (v->end != DOM_ROW_PASSES && v->end != DOM_ROW_PARTS) ||
           problem_no_answer(problem, "there is no verdict after domino %zu: %s", v->domino,
                             dom_row_end_text(v->end));
}

/* Leaves out columns: people read energies in percent, and in J if masses are known. */
static void fall_choose(const struct query *query, struct answer *a, const struct scene_row *scene)
{
    bool people = answer_for_people(a), weighed = scene_weighed(query->scene);
    if (weighed)
        columns_in_joules(a);
    if (people && !weighed)
        answer_leave_out(a, "kinetic");
    if (people && !weighed)
        answer_leave_out(a, "barrier");
    if (people)
        answer_leave_out(a, "margin");
    if (!scene->row.floor)
        answer_leave_out(a, "floor");
    if (!scene->row.floor)
        answer_leave_out(a, "floor_hit");
    if (!feet_slide(scene))
        answer_leave_out(a, "slid");
    if (people && scene->row.engine) /* the engine computes no barrier */
        answer_leave_out(a, "energy");
}

static bool run_fall(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct domq_verdict verdict;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    struct falling c = {.answer = a, .scene = &scene, .feet = feet_begin(query)};
    if (!report_begin(query, problem, &scene)) {
        free(scene.domino);
        return false;
    }
    fall_choose(query, a, &scene);
    row_largest(a, &scene);
    enum dom_status status = domq_row_run(&scene.row, &scene.compute, true, fall_row, &c, &verdict);
    answer_holds(a, status == DOM_OK && verdict.end == DOM_ROW_FALLS);
    if (status == DOM_OK) {
        verdict_say(a, &scene, &verdict, &c.last, true);
        if (scene.row.floor)
            feet_say(a, &c.feet, scene.row.count);
        report_say(a, &scene, &verdict);
    }
    report_end(&scene);
    free(scene.domino);
    return status == DOM_OK ? verdict_known(problem, &verdict) : row_status(query, problem, status);
}

/* ---- verdict ---- */

static const struct column verdict_columns[] = {
    {"verdict", "", "all fall, stops, or another end of the row", 12},
    {"domino", "", "the last domino that is hit", 0},
    {"short_by", "mgh/2", "energy that it lacks; in J if masses are known", 0},
    {"seconds", "s", "until the last domino lies; the clock is that of 'fall'", 0},
    {"weakest", "", "of the dominoes that go on, the one with the least to spare", 0},
    {"spare", "share", "energy that it has to spare, over the energy that it needs", 0},
    {NULL, NULL, NULL, 0},
};

static const char *end_word(enum dom_row_end end)
{
    static const char *const words[] = {
        [DOM_ROW_FALLS] = "all fall",      [DOM_ROW_STOPS] = "stops",   [DOM_ROW_MISSES] = "misses",
        [DOM_ROW_PASSES] = "passes above", [DOM_ROW_LEANS] = "leans",   [DOM_ROW_PARTS] = "parts",
        [DOM_ROW_LOCKS] = "locks",         [DOM_ROW_SKEWED] = "touches"};
    return words[end];
}

/* Writes how the row ends. */
static void verdict_answer(const struct query *query, struct answer *a, const struct scene_row *scene,
                           const struct domq_verdict *v, const struct falling *c)
{
    char reason[ANSWER_REASON];
    answer_holds(a, v->end == DOM_ROW_FALLS);
    if (scene_weighed(query->scene))
        columns_in_joules(a);
    const struct cell cells[] = {
        cell_word(end_word(v->end)),
        cell_count((domq_real)v->domino),
        cell_bound(enough(v->short_by), DOMQ_NAN),
        cell_bound(v->end == DOM_ROW_FALLS ? v->seconds : DOMQ_NAN, report_time_error(scene)),
        v->weakest ? cell_count((domq_real)v->weakest) : cell_real(DOMQ_NAN),
        cell_bound(v->spare, DOMQ_NAN)};
    snprintf(reason, sizeof reason, "domino %zu: %s", v->domino,
             isinf(v->short_by) ? locks_farther_on : report_why(scene, v));
    if (answer_for_people(a)) {
        answer_keep(a, cells);
        verdict_say(a, scene, v, &c->last, true);
        report_say(a, scene, v);
    } else
        answer_row(a, cells, v->end == DOM_ROW_FALLS ? NULL : reason);
    if (query->scene->effect[DOM_EFFECT_floor].on)
        feet_say(a, &c->feet, scene->row.count);
}

static bool run_verdict(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct domq_verdict v;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    struct falling c = {.feet = feet_begin(query)};
    if (!report_begin(query, problem, &scene)) {
        free(scene.domino);
        return false;
    }
    enum dom_status status = domq_row_run(&scene.row, &scene.compute, true, fall_visit, &c, &v);
    bool known = status == DOM_OK ? verdict_known(problem, &v) : row_status(query, problem, status);
    if (known)
        verdict_answer(query, a, &scene, &v, &c);
    report_end(&scene);
    free(scene.domino);
    return known;
}

/* ---- place ---- */

static bool run_place(const struct query *query, struct answer *a, struct problem *problem)
{
    (void)a;
    const size_t k = (size_t)query->given->number[0];
    const domq_real gap = query->given->number[1];
    struct scene_row scene;
    if (query->given->quantity[1].length == 0 && gap > 0) {
        if (!scene_row_make(query->scene, &scene, problem))
            return false;
        bool there = k >= 2 && k <= scene.row.count; /* else scene_row_place reports it */
        domq_real before = there ? scene.domino[k - 2].height : gap,
                  own = there ? scene.domino[k - 1].height : gap;
        free(scene.domino);
        if (gap > before && gap > own)
            return problem_error(problem,
                                 "a gap of %s without a unit would be %s, but domino %zu is %s tall; write "
                                 "'place %zu %s mm', or the unit that you mean",
                                 quad_shown(gap).text, measured(gap, "m", 6).text, k - 1,
                                 measured(before, "m", 4).text, k, quad_shown(gap).text);
    }
    return !query->next || scene_row_place(&query->next->scene, k, gap, problem);
}

/* ---- rowmax: the largest growth of a finite row ---- */

static const struct column rowmax_columns[] = {
    {"s", "h", "separation", 0},
    {"count", "", "dominoes in the row", 0},
    {"r_max", "", "largest growth at which all of them fall", 0},
    {"r_train", "", "largest growth of the endless train", 0},
    {NULL, NULL, NULL, 0},
};

/* Writes the row of the scene at the growth r, with the gaps that were changed. */
static void row_at(domq_real r, struct domq_domino *domino, size_t count, void *context)
{
    struct scene scene = *(const struct scene *)context;
    scene.train.r = r;
    scene_row_fill(&scene, domino, count);
}

static bool run_rowmax(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_row_growth growth;
    struct domq_limit limit;
    struct scene_row scene;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    free(scene.domino);
    if (query->scene->listed.domino)
        return problem_error(problem, "a row from a file has no growth r; first enter 'effect row N'");
    const domq_real reach = domq_train_reach(&query->scene->train);
    char reason[96];
    enum dom_status status =
        domq_row_rmax(&scene.row, &scene.compute, reach, row_at, (void *)query->scene, &growth);
    if (status == DOM_OK)
        status = domq_limit_rmax(&query->scene->train, &query->scene->compute, &limit);
    if (status != DOM_OK)
        return row_status(query, problem, status);
    snprintf(reason, sizeof reason,
             "at no growth from 1 to %.6g do all dominoes fall; 'set r 1; fall' shows why", (double)reach);
    bool more = answer_row(a,
                           ROW(cell_real(query->scene->train.s), cell_count((domq_real)scene.row.count),
                               cell_bound(growth.r_max, DOMQ_NAN), cell_bound(limit.r_max, DOMQ_NAN)),
                           isnan(growth.r_max) ? reason : NULL);
    if (growth.r_min > 1)
        answer_say(a,
                   "All fall from r = %.6g on; with a smaller growth the row ends earlier: 'set r 1; fall'.",
                   (double)growth.r_min);
    return more;
}

const struct command row_commands[] = {
    {.name = "fall",
     .synonyms = "simulate simulation run topple time speed",
     .summary = "run the row, domino by domino",
     .help =
         "For each domino that is hit: when it is hit, when it hits the next one, how fast it starts, and "
         "how much it has of the energy that it needs to go on. 'effect row' enters a row.",
     .example = "effect row 5; fall",
     .see = "verdict mend row effect",
     .rows = true,
     .holds = "all dominoes fall",
     ANSWER(fall)},
    {.name = "verdict",
     .synonyms = "result success topple stop",
     .summary = "whether the whole row falls, and where it is weakest",
     .example = "effect row 5; verdict",
     .see = "fall mend",
     .principal = "seconds",
     .holds = "all dominoes fall",
     ANSWER(verdict)},
    {.name = "mend",
     .synonyms = "repair fix spacing rescue",
     .summary = "the smallest change of one gap that saves a row",
     .help =
         "For each gap up to the end of the row, 'mend' finds the nearest gap with which all dominoes fall, "
         "and lists the smallest change first. If a push is missing, the answer says so. The search goes "
         "in 40 steps, and then by bisection; a range of gaps narrower than a step can be missed.",
     .see = "fall tolerance place budget",
     .rows = true,
     ANSWER(mend)},
    {.name = "tolerance",
     .synonyms = "window precision error plumb measure tape spacing height",
     .summary = "how far each domino may be off, so that all still fall",
     .help =
         "For each domino the window of its place, of the gap before it, of its height, and of the friction "
         "between dominoes: with each value in it all dominoes fall, if the rest of the row is as it is. A "
         "place is what a tape measure shows, from the back of domino 1; the domino alone moves. With "
         "another gap, all dominoes after it move along. A domino that is not set up plumb leans about its "
         "front edge: how far its top may be off, backwards or forwards. Another height keeps the angle of "
         "its "
         "lean, and its density. No leans are tried with edges, "
         "or "
         "with an engine. The first to fail are marked. If the row does not fall, the windows show which "
         "single changes save it. The search steps as that of 'mend'.",
     .example = "effect row 5; tolerance",
     .see = "mend place budget",
     .rows = true,
     ANSWER(tolerance)},
    {.name = "place",
     .synonyms = "move spacing distance gap",
     .argument = {{.name = "K", .kind = ARGUMENT_COUNT}, {.name = "GAP", .kind = ARGUMENT_LENGTH}},
     .summary = "change the gap before domino K of the row",
     .help =
         "A GAP without a unit is in metres, and an error if that is more than the dominoes beside it are "
         "tall. The change lasts until another row is entered; 'save FILE' keeps it, and so does 'row > "
         "FILE.csv'.",
     .example = "effect row 5; place 3 25 mm; fall",
     .see = "row fall mend",
     .changes = true,
     .run = run_place},
    {.name = "row",
     .synonyms = "list export csv spacing",
     .summary = "the dominoes of the row",
     .help = "'row > hall.csv' writes a file that 'effect row hall.csv' reads: its first line has the units.",
     .example = "effect row 3; row",
     .see = "effect fall",
     .rows = true,
     ANSWER(row)},
    {.name = "rowmax",
     .synonyms = "maximum ratio factor",
     .summary = "the largest growth r at which the whole row falls",
     .help =
         "The row is what 'effect row N' makes of s, d, q and h, and it starts with its push. If the first "
         "domino just tips over, or its push is weak, the row can stop at the second domino. Otherwise "
         "the answer for a long row approaches that of the endless train, 'rmax'.",
     .example = "set q hollow; effect row 8; rowmax",
     .see = "rmax effect",
     .echo = "s",
     .principal = "r_max",
     ANSWER(rowmax)},
    {.name = NULL},
};
