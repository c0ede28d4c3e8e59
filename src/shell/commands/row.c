/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A finite row: what it is, how it falls, and what to change where it does not. */
#include "commands/falling.h"
#include "commands/tables.h"
#include "commands/walk.h"
#include "language/quad.h"
#include <stdlib.h>

/* ---- row ---- */

static const struct column row_columns[] = {
    {"domino", "", "its number, from 1", 6},
    {"height", "m", "", 0},
    {"thickness", "m", "", 0},
    {"gap", "m", "free, to the one before it", 0},
    {"mass", "kg", "where it is known", 0},
    {"relative", "", "where it is not: mass over that of the first", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_row(struct session *session, const struct call *call)
{
    struct scene_row scene;
    if (!scene_row_make(session, &scene))
        return false;
    bool weighed = scene_weighed(session);
    answer_leave_out(call->answer, weighed ? "relative" : "mass");
    call->answer->units = true;
    call->answer->style.errors = false; /* its columns are those that 'effect row FILE' reads */
    for (size_t k = 0; k < scene.row.count && !answer_lost(call->answer); k++) {
        const struct domq_domino *d = &scene.domino[k];
        answer_cells(call->answer, cell_count((domq_real)k + 1), cell_real(d->height),
                     cell_real(d->thickness), cell_real(d->gap),
                     cell_real(weighed ? d->mass : d->mass / scene.domino[0].mass));
    }
    free(scene.domino);
    return true;
}

/* ---- fall ---- */

static const struct column fall_columns[] = {
    {"domino", "", "its number, from 1", 6},
    {"height", "m", "", 6},
    {"hit", "s", "when it is hit; the clock starts with the push, or else with the first hit", 7},
    {"falls", "s", "when it hits the next, or lies on the floor", 7},
    {"omega", "rad/s", "angular velocity just after it was hit", 6},
    {"kinetic", "mgh/2", "energy of all that move, then; in J where a mass is known", 9},
    {"barrier", "mgh/2", "what of that it takes to go on", 9},
    {"margin", "mgh/2", "kinetic - barrier", 9},
    {"floor", "", "friction that the floor needs; with 'effect floor'", 5},
    {NULL, NULL, NULL, 0},
};

/* A hinge that needs the floor's friction: whose, in the collision of which domino or while that falls. */
struct slip {
    domq_real needs;
    size_t domino, head;
    bool hit;
};

struct falling {
    struct session *session;
    struct answer *answer;
    const struct scene_row *scene;
    struct slip most, first; /* first: that the floor's friction does not meet; head = 0: none yet */
};

static struct slip slip_of(const struct domq_fall *f, bool hit)
{
    return hit ? (struct slip){f->floor_hit, f->floor_hit_domino, f->domino, true}
               : (struct slip){f->floor_motion, f->floor_domino, f->domino, false};
}

/* The larger of what a domino's motion and its collision need of the floor. */
static struct slip slip_most(const struct domq_fall *f)
{
    return slip_of(f, f->floor_hit > f->floor_motion);
}

static void floor_seen(struct falling *c, const struct domq_fall *f)
{
    domq_real floor = c->session->effect[DOM_EFFECT_floor].value[0];
    struct slip most = slip_most(f);
    if (most.needs > c->most.needs)
        c->most = most;
    if (c->first.head == 0 && most.needs > floor)
        c->first = slip_of(f, f->floor_hit > floor); /* that comes first */
}

static bool floor_visit(const struct domq_fall *f, void *context)
{
    floor_seen(context, f);
    return true;
}

static const char lifted[] = "a domino is lifted off the floor: no friction holds it";

/* NaN where friction locks farther on, and no energy is enough. */
static domq_real enough(domq_real energy)
{
    return isfinite(energy) ? energy : DOMQ_NAN;
}

static bool fall_row(const struct domq_fall *f, void *context)
{
    struct falling *c = context;
    floor_seen(c, f);
    answer_row(
        c->answer,
        ROW(cell_count((domq_real)f->domino), cell_narrow(c->scene->domino[f->domino - 1].height, 4),
            cell_narrow(f->time, 4), cell_narrow(f->time + f->duration, 4), cell_narrow(f->omega, 4),
            cell_narrow(f->kinetic, 4), cell_narrow(enough(f->barrier), 4), cell_narrow(enough(f->margin), 4),
            cell_narrow(c->scene->row.floor ? slip_most(f).needs : DOMQ_NAN, 3)),
        !answer_for_people(c->answer) && slip_most(f).needs > 0 && !isfinite(slip_most(f).needs) ? lifted
                                                                                                 : NULL);
    return !answer_lost(c->answer);
}

/* "when domino 3 is hit". */
static const char *slip_when(const struct slip *slip, char text[64])
{
    snprintf(text, 64, slip->hit ? "when domino %zu is hit" : "while domino %zu falls", slip->head);
    return text;
}

/* "0.43", or that no friction is enough. */
static const char *needs_text(domq_real needs, char text[WIDE_TEXT])
{
    if (!isfinite(needs))
        return "more than any friction, since it is lifted off";
    return quad_text(needs, 4, text);
}

static void floor_say(const struct session *session, struct answer *a, const struct falling *c)
{
    char when[64], needs[WIDE_TEXT];
    double floor = (double)session->effect[DOM_EFFECT_floor].value[0];
    if (c->first.head == 0)
        answer_say(a, "A floor with %.4g holds every hinge, as far as the row goes.", floor);
    else
        answer_say(a,
                   "On a floor with %.4g domino %zu is the first to slip, %s: it needs %s. The answer holds "
                   "up to there.",
                   floor, c->first.domino, slip_when(&c->first, when), needs_text(c->first.needs, needs));
    if (c->most.head > 0)
        answer_say(a, "The most that is needed: %s, under domino %zu %s.", needs_text(c->most.needs, needs),
                   c->most.domino, slip_when(&c->most, when));
}

/* Has the model an answer?  PASSES and PARTS are none. */
static bool verdict_known(struct session *session, const struct domq_verdict *v)
{
    return (v->end != DOM_ROW_PASSES && v->end != DOM_ROW_PARTS) ||
           session_no_answer(session, "domino %zu: %s; what comes behind it is not known", v->domino,
                             dom_row_end_text(v->end));
}

static bool run_fall(struct session *session, const struct call *call)
{
    struct scene_row scene;
    struct domq_verdict verdict;
    struct answer *a = call->answer;
    if (!scene_row_make(session, &scene))
        return false;
    struct falling c = {.session = session, .answer = a, .scene = &scene};
    if (!scene.row.floor)
        answer_leave_out(a, "floor");
    if (scene_weighed(session))
        columns_in_joules(a);
    enum dom_status status = domq_row_run(&scene.row, &scene.compute, true, fall_row, &c, &verdict);
    answer_holds(a, status == DOM_OK && verdict.end == DOM_ROW_FALLS);
    if (status == DOM_OK) {
        verdict_say(session, a, &scene, &verdict, true);
        if (scene.row.floor)
            floor_say(session, a, &c);
    }
    free(scene.domino);
    return status == DOM_OK ? verdict_known(session, &verdict) : row_status(session, status);
}

/* ---- verdict ---- */

static const struct column verdict_columns[] = {
    {"verdict", "", "falls, stops, or why it ends otherwise", 12},
    {"domino", "", "the last that was hit", 0},
    {"short_by", "mgh/2", "energy that is missing there, in J where a mass is known", 0},
    {"seconds", "s", "until the last lies; counted as in 'fall'", 0},
    {"weakest", "", "of those that go on, the domino with the least to spare", 0},
    {"spare", "", "margin over barrier there", 0},
    {NULL, NULL, NULL, 0},
};

static const char *end_word(enum dom_row_end end)
{
    static const char *const words[] = {
        [DOM_ROW_FALLS] = "all fall",      [DOM_ROW_STOPS] = "stops", [DOM_ROW_MISSES] = "misses",
        [DOM_ROW_PASSES] = "passes above", [DOM_ROW_LEANS] = "leans", [DOM_ROW_PARTS] = "parts",
        [DOM_ROW_LOCKS] = "locks"};
    return words[end];
}

static bool run_verdict(struct session *session, const struct call *call)
{
    struct scene_row scene;
    struct domq_verdict v;
    struct answer *a = call->answer;
    if (!scene_row_make(session, &scene))
        return false;
    struct falling c = {.session = session};
    enum dom_status status = domq_row_run(&scene.row, &scene.compute, true, floor_visit, &c, &v);
    free(scene.domino);
    if (status != DOM_OK)
        return row_status(session, status);
    if (!verdict_known(session, &v))
        return false;
    answer_holds(a, v.end == DOM_ROW_FALLS);
    if (scene_weighed(session))
        columns_in_joules(a);
    answer_row(a,
               ROW(cell_word(end_word(v.end)), cell_count((domq_real)v.domino),
                   cell_bound(enough(v.short_by), DOMQ_NAN),
                   cell_bound(v.end == DOM_ROW_FALLS ? v.seconds : DOMQ_NAN, DOMQ_NAN),
                   v.weakest ? cell_count((domq_real)v.weakest) : cell_real(DOMQ_NAN),
                   cell_bound(v.spare, DOMQ_NAN)),
               v.end == DOM_ROW_FALLS ? NULL
               : isfinite(v.short_by) ? dom_row_end_text(v.end)
                                      : locks_farther_on);
    if (session->effect[DOM_EFFECT_floor].on)
        floor_say(session, a, &c);
    return true;
}

/* ---- place ---- */

static bool run_place(struct session *session, const struct call *call)
{
    return scene_row_place(session, (size_t)call->number[0], call->number[1]);
}

/* ---- rowmax: the largest growth of a finite row ---- */

static const struct column rowmax_columns[] = {
    {"s", "h", "separation", 0},
    {"count", "", "dominoes in the row", 0},
    {"r_max", "", "largest growth at which all of them fall", 0},
    {"r_train", "", "that of the endless train", 0},
    {NULL, NULL, NULL, 0},
};

/* Makes the row that the scene has at the growth r: what was placed stays. */
static void row_at(domq_real r, struct domq_domino *domino, size_t count, void *context)
{
    struct session scene = *(const struct session *)context;
    scene.train.r = r;
    scene_row_fill(&scene, domino, count);
}

static bool run_rowmax(struct session *session, const struct call *call)
{
    struct domq_row_growth growth;
    struct domq_limit limit;
    struct scene_row scene;
    if (!scene_row_make(session, &scene))
        return false;
    free(scene.domino);
    if (session->listed.domino)
        return session_error(session,
                             "the row is from a file: it has no growth r; 'effect row N' is a row with one");
    enum dom_status status =
        domq_row_rmax(&scene.row, &scene.compute, 1 / session->train.s, row_at, session, &growth);
    if (status == DOM_OK)
        status = domq_limit_rmax(&session->train, &session->compute, &limit);
    if (status != DOM_OK)
        return row_status(session, status);
    return answer_row(call->answer,
                      ROW(cell_real(session->train.s), cell_count((domq_real)scene.row.count),
                          cell_bound(growth.r_max, DOMQ_NAN), cell_bound(limit.r_max, DOMQ_NAN)),
                      isnan(growth.r_max) ? "already equal dominoes (r = 1) do not all fall: 'fall' says why"
                                          : NULL);
}

const struct command row_commands[] = {
    {.name = "fall",
     .synonyms = "simulate simulation run topple time speed",
     .summary = "run the row, domino by domino, to its verdict",
     .help = "Of each domino that is hit: when, when it hits the next, how fast it starts, and what energy "
             "that leaves over its barrier. 'effect row' says which row.",
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
     .help = "For each gap up to where the row ends, the nearest value with which all fall, the smallest "
             "change first; and before them the push, where that is what is missing. Each is looked for in "
             "40 steps, and then halved down; a window narrower than a step may be missed.",
     .see = "fall place budget",
     .rows = true,
     ANSWER(mend)},
    {.name = "place",
     .synonyms = "move spacing distance gap",
     .argument = {{.name = "K", .kind = ARGUMENT_COUNT}, {.name = "GAP", .kind = ARGUMENT_LENGTH}},
     .summary = "change the gap before domino K of the row",
     .help = "The change stays until another row is taken; 'save' keeps it, and so does 'row > FILE.csv'.",
     .example = "effect row 5; place 3 25 mm; fall",
     .see = "row fall mend",
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
     .help = "Of the row of N dominoes that 'effect row N' makes of s, d, q and h, as it starts. A first "
             "domino that just tips over, or a weak push, may end it at the second; where that is not so, a "
             "long row tends to the endless train, 'rmax'.",
     .example = "set q hollow; effect row 8; rowmax",
     .see = "rmax effect",
     .echo = "s",
     .principal = "r_max",
     ANSWER(rowmax)},
    {.name = NULL},
};
