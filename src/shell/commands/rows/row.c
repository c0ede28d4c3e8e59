/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands about a finite row: its dominoes, how they fall, and how to save the row. */
#include "commands/rows/falling.h"
#include "commands/tables.h"
#include "commands/walk.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

/* ---- row ---- */

static const struct column row_columns[] = {
    {"domino", "", "its number, from 1", 6},
    {"height", "m", "its height", 0},
    {"thickness", "m", "its thickness", 0},
    {"gap", "m", "free distance to the domino before it", 0},
    {"mass", "kg", "its mass, if masses are known", 0},
    {"relative", "", "its mass over that of the first, if they are not known", 0},
    {NULL, NULL, NULL, 0},
};

/* Chooses the units of lengths and masses by the largest domino. */
static void row_largest(struct answer *a, const struct scene_row *scene)
{
    domq_real height = 0, thickness = 0, gap = 0, mass = 0;
    for (size_t k = 0; k < scene->row.count; k++) {
        height = quad_larger(height, scene->domino[k].height);
        thickness = quad_larger(thickness, scene->domino[k].thickness);
        gap = quad_larger(gap, scene->domino[k].gap);
        mass = quad_larger(mass, scene->domino[k].mass);
    }
    answer_largest(a, "height", height);
    answer_largest(a, "thickness", thickness);
    answer_largest(a, "gap", gap);
    answer_largest(a, "mass", mass);
}

static bool run_row(struct session *session, const struct call *call)
{
    struct scene_row scene;
    if (!scene_row_make(session, &scene))
        return false;
    bool weighed = scene_weighed(session);
    answer_leave_out(call->answer, weighed ? "relative" : "mass");
    call->answer->units = true;
    call->answer->style.errors = false; /* its columns are those that 'effect row FILE' reads */
    row_largest(call->answer, &scene);
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
    {"height", "m", "its height", 6},
    {"hit", "s", "when it is hit; the clock starts with the push, or with the first hit", 7},
    {"falls", "s", "when it hits the next domino, or lies on the floor", 7},
    {"omega", "rad/s", "its angular velocity just after it is hit", 6},
    {"kinetic", "mgh/2", "energy of all dominoes that move then; in J if masses are known", 9},
    {"barrier", "mgh/2", "the energy that it needs to go on", 9},
    {"margin", "mgh/2", "kinetic - barrier", 9},
    {"energy", "share", "kinetic / barrier: at 100 % it just goes on", 6},
    {"floor", "", "friction that the floor needs; with 'effect floor'", 5},
    {NULL, NULL, NULL, 0},
};

/* The friction that a foot needs: when the domino `head` is hit, or while it falls. */
struct slip {
    domq_real needs;
    size_t domino, head;
    bool hit;
};

struct falling {
    struct session *session;
    struct answer *answer;
    const struct scene_row *scene;
    struct slip most, first; /* the largest, and the first above the friction of the floor; head = 0: none */
    struct domq_fall last;   /* the last domino that was hit */
};

static struct slip slip_of(const struct domq_fall *f, bool hit)
{
    return hit ? (struct slip){f->floor_hit, f->floor_hit_domino, f->domino, true}
               : (struct slip){f->floor_motion, f->floor_domino, f->domino, false};
}

/* Returns the larger of what motion and collision of a domino need of the floor. */
static struct slip slip_most(const struct domq_fall *f)
{
    return slip_of(f, f->floor_hit > f->floor_motion);
}

/* Keeps the domino, and what it needs of the floor. */
static void fall_seen(struct falling *c, const struct domq_fall *f)
{
    c->last = *f;
    domq_real floor = c->session->effect[DOM_EFFECT_floor].value[0];
    struct slip most = slip_most(f);
    if (most.needs > c->most.needs)
        c->most = most;
    if (c->first.head == 0 && most.needs > floor)
        c->first = slip_of(f, f->floor_hit > floor); /* the collision is first */
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

/* Removes the cells of columns that are left out of the answer. */
static void cells_leave_out(const struct answer *a, const struct column *all, struct cell *cells)
{
    int n = 0;
    for (int i = 0; all[i].key && a->columns[n].key; i++)
        if (strcmp(a->columns[n].key, all[i].key) == 0)
            cells[n++] = cells[i];
}

static bool fall_row(const struct domq_fall *f, void *context)
{
    struct falling *c = context;
    domq_real floor = c->scene->row.floor ? slip_most(f).needs : DOMQ_NAN;
    bool lifts = floor > 0 && !isfinite(floor);
    struct cell cells[] = {cell_count((domq_real)f->domino),
                           cell_narrow(c->scene->domino[f->domino - 1].height, 4),
                           cell_narrow(f->time, 4),
                           cell_narrow(f->time + f->duration, 4),
                           cell_narrow(f->omega, 4),
                           cell_narrow(f->kinetic, 4),
                           cell_narrow(enough(f->barrier), 4),
                           cell_narrow(enough(f->margin), 4),
                           cell_narrow(fall_share(f), 4),
                           cell_narrow(floor, 3)};
    fall_seen(c, f);
    cells_leave_out(c->answer, fall_columns, cells);
    answer_row(c->answer, cells, lifts && !answer_for_people(c->answer) ? lifted : NULL);
    return !answer_lost(c->answer);
}

/* Writes when a foot slips: "when domino 3 is hit". */
static const char *slip_when(const struct slip *slip, char text[64])
{
    if (slip->head == slip->domino)
        return slip->hit ? "when it is hit" : "while it falls";
    snprintf(text, 64, slip->hit ? "when domino %zu is hit" : "while domino %zu falls", slip->head);
    return text;
}

/* Writes "it needs 0.43", or that no friction is enough. */
static const char *needs_text(domq_real needs, char text[64])
{
    char number[WIDE_TEXT];
    snprintf(text, 64, "it needs %s", isfinite(needs) ? quad_text(needs, 4, number) : "");
    return isfinite(needs) ? text : "it is lifted off, which no friction prevents";
}

/* Prints which domino slips first on the floor, and which one needs the most friction. */
static void floor_say(const struct session *session, struct answer *a, const struct falling *c)
{
    char when[64], needs[64];
    double floor = (double)session->effect[DOM_EFFECT_floor].value[0];
    if (c->first.head == 0)
        answer_say(a, "On a floor with a friction of %.4g no foot slips, as far as the row falls.", floor);
    else
        answer_say(a,
                   "On a floor with a friction of %.4g the foot of domino %zu is the first to slip, %s: %s. "
                   "From there on feet slip, which this answer does not include.",
                   floor, c->first.domino, slip_when(&c->first, when), needs_text(c->first.needs, needs));
    if (c->most.head > 0)
        answer_say(a, "Domino %zu needs the most friction, %s: %s.", c->most.domino,
                   slip_when(&c->most, when), needs_text(c->most.needs, needs));
}

/* Reports an error if the model cannot follow the row to its end. */
static bool verdict_known(struct session *session, const struct domq_verdict *v)
{
    return (v->end != DOM_ROW_PASSES && v->end != DOM_ROW_PARTS) ||
           session_no_answer(session, "there is no verdict after domino %zu: %s", v->domino,
                             dom_row_end_text(v->end));
}

/* Leaves out columns: people read energies in percent, and in J if masses are known. */
static void fall_choose(const struct session *session, struct answer *a, bool floor)
{
    bool people = answer_for_people(a), weighed = scene_weighed(session);
    if (weighed)
        columns_in_joules(a);
    if (people && !weighed)
        answer_leave_out(a, "kinetic");
    if (people && !weighed)
        answer_leave_out(a, "barrier");
    if (people)
        answer_leave_out(a, "margin");
    if (!floor)
        answer_leave_out(a, "floor");
}

static bool run_fall(struct session *session, const struct call *call)
{
    struct scene_row scene;
    struct domq_verdict verdict;
    struct answer *a = call->answer;
    if (!scene_row_make(session, &scene))
        return false;
    struct falling c = {.session = session, .answer = a, .scene = &scene};
    fall_choose(session, a, scene.row.floor);
    row_largest(a, &scene);
    enum dom_status status = domq_row_run(&scene.row, &scene.compute, true, fall_row, &c, &verdict);
    answer_holds(a, status == DOM_OK && verdict.end == DOM_ROW_FALLS);
    if (status == DOM_OK) {
        verdict_say(a, &scene, &verdict, &c.last, true);
        if (scene.row.floor)
            floor_say(session, a, &c);
    }
    free(scene.domino);
    return status == DOM_OK ? verdict_known(session, &verdict) : row_status(session, status);
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
        [DOM_ROW_FALLS] = "all fall",      [DOM_ROW_STOPS] = "stops", [DOM_ROW_MISSES] = "misses",
        [DOM_ROW_PASSES] = "passes above", [DOM_ROW_LEANS] = "leans", [DOM_ROW_PARTS] = "parts",
        [DOM_ROW_LOCKS] = "locks"};
    return words[end];
}

static bool run_verdict(struct session *session, const struct call *call)
{
    struct scene_row scene;
    struct domq_verdict v;
    char reason[ANSWER_REASON];
    struct answer *a = call->answer;
    if (!scene_row_make(session, &scene))
        return false;
    struct falling c = {.session = session};
    enum dom_status status = domq_row_run(&scene.row, &scene.compute, true, fall_visit, &c, &v);
    free(scene.domino);
    if (status != DOM_OK)
        return row_status(session, status);
    if (!verdict_known(session, &v))
        return false;
    answer_holds(a, v.end == DOM_ROW_FALLS);
    if (scene_weighed(session))
        columns_in_joules(a);
    const struct cell cells[] = {cell_word(end_word(v.end)),
                                 cell_count((domq_real)v.domino),
                                 cell_bound(enough(v.short_by), DOMQ_NAN),
                                 cell_bound(v.end == DOM_ROW_FALLS ? v.seconds : DOMQ_NAN, DOMQ_NAN),
                                 v.weakest ? cell_count((domq_real)v.weakest) : cell_real(DOMQ_NAN),
                                 cell_bound(v.spare, DOMQ_NAN)};
    snprintf(reason, sizeof reason, "domino %zu: %s", v.domino,
             isfinite(v.short_by) ? dom_row_end_text(v.end) : locks_farther_on);
    if (answer_for_people(a)) {
        answer_keep(a, cells);
        verdict_say(a, &scene, &v, &c.last, true);
    } else
        answer_row(a, cells, v.end == DOM_ROW_FALLS ? NULL : reason);
    if (session->effect[DOM_EFFECT_floor].on)
        floor_say(session, a, &c);
    return true;
}

/* ---- place ---- */

static bool run_place(struct session *session, const struct call *call)
{
    const size_t k = (size_t)call->number[0];
    const domq_real gap = call->number[1];
    struct scene_row scene;
    if (call->quantity[1].length == 0 && gap > 0) {
        if (!scene_row_make(session, &scene))
            return false;
        bool there = k >= 2 && k <= scene.row.count; /* else scene_row_place reports it */
        domq_real before = there ? scene.domino[k - 2].height : gap,
                  own = there ? scene.domino[k - 1].height : gap;
        free(scene.domino);
        if (gap > before && gap > own)
            return session_error(session,
                                 "a gap of %s without a unit would be %s, but domino %zu is %s tall; write "
                                 "'place %zu %s mm', or the unit that you mean",
                                 quad_shown(gap).text, measured(gap, "m", 6).text, k - 1,
                                 measured(before, "m", 4).text, k, quad_shown(gap).text);
    }
    return scene_row_place(session, k, gap);
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
        return session_error(session, "a row from a file has no growth r; first enter 'effect row N'");
    enum dom_status status =
        domq_row_rmax(&scene.row, &scene.compute, 1 / session->train.s, row_at, session, &growth);
    if (status == DOM_OK)
        status = domq_limit_rmax(&session->train, &session->compute, &limit);
    if (status != DOM_OK)
        return row_status(session, status);
    return answer_row(
        call->answer,
        ROW(cell_real(session->train.s), cell_count((domq_real)scene.row.count),
            cell_bound(growth.r_max, DOMQ_NAN), cell_bound(limit.r_max, DOMQ_NAN)),
        isnan(growth.r_max) ? "not even equal dominoes (r = 1) all fall; 'set r 1; fall' shows why" : NULL);
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
         "another gap, all dominoes after it move along. The first to fail are marked. If the row does not "
         "fall, the windows show which single changes save it. The search steps as that of 'mend'.",
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
