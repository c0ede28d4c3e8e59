/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'row' and 'rowmax', and the table of all commands about a row. */
#include "interpreter/command.h"
#include "language/quad.h"
#include "rows/rows.h"
#include "train/train.h"
#include <stdlib.h>
#include <string.h>

/* ---- row ---- */

static const struct column row_columns[] = {
    {"domino", "", "number of the domino, from 1", 6},
    {"height", "m", "height of the domino", 0},
    {"thickness", "m", "thickness of the domino", 0},
    {"gap", "m", "clear distance to the domino before it", 0},
    {"mass", "kg", "mass of the domino, if masses are known", 0},
    {"relative", "", "mass relative to domino 1, if only ratios of masses are known", 0},
    {"radius", "m", "radius of the edges, if any domino has its own radius; used only with 'set edges'", 0},
    {"lean", "m", "how far the top is off plumb, if any domino leans (negative: backwards)", 0},
    {"width", "m", "width of the domino (left out if every domino is half as wide as it is tall)", 0},
    {NULL, NULL, NULL, 0},
};

/* Writes the dominoes from index `from` to before `to`. */
static void dominoes_write(const struct query *query, struct answer *a, const struct scene_row *scene,
                           size_t from, size_t to)
{
    const bool has_masses = scene_has_masses(query->scene);
    bool has_radii = false, has_leans = false, has_widths = false;
    domq_real sum = 0;
    for (size_t k = from; k < to; k++) {
        const struct domq_domino *d = &scene->domino[k];
        sum += d->mass;
        has_radii = has_radii || d->radius > 0;
        has_leans = has_leans || d->lean != 0;
        has_widths = has_widths || d->width != d->height / 2;
    }
    a->columns = row_columns;
    a->rows = true;
    answer_leave_out(a, has_masses ? "relative" : "mass");
    answer_leave_out(a, has_radii ? "" : "radius");
    answer_leave_out(a, has_leans ? "" : "lean");
    answer_leave_out(a, has_widths ? "" : "width");
    a->csv.units = true;
    a->style.errors = 0; /* 'set row FILE' cannot read columns with errors */
    /* First all numbers are announced, so that the columns get their units. */
    for (int writes = 0; writes < 2; writes++)
        for (size_t k = from; k < to && !answer_lost(a); k++) {
            const struct domq_domino *d = &scene->domino[k];
            const struct cell cells[] = {
                cell_count((domq_real)k + 1), cell_real(d->height),
                cell_real(d->thickness),      cell_real(d->gap),
                cell_real(d->mass),           cell_real(d->mass / scene->domino[0].mass),
                cell_real(d->radius),         cell_real(lean_offset(d)),
                cell_real(d->width)};
            for (int i = 1; i < 9 && !writes; i++)
                answer_announce(a, row_columns[i].key, cells[i].number);
            if (writes)
                answer_row(a, cells, NULL);
        }
    if (has_masses && to - from > 1 && answer_for_people(a))
        answer_say(a, "All %zu weigh %s.", to, measured(sum, "kg", 5).text);
}

bool row_list(const struct query *query, size_t only, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct problem no_room = {.kind = PROBLEM_NONE};
    if (!scene_row_list(query->scene, &scene, problem))
        return false;
    const size_t count = scene.row.count, from = only > 0 ? only - 1 : 0, to = only > 0 ? only : count;
    const bool good =
        to <= count || problem_error(problem, "the row has %zu domino%s", count, count == 1 ? "" : "es");
    if (good) {
        dominoes_write(query, a, &scene, from, to);
        if (!scene_walls_fit(query->scene, &scene, &no_room) && answer_for_people(a))
            answer_say(a, "This row has no answer yet: %s.", no_room.text);
    }
    free(scene.domino);
    return good;
}

static bool run_row(const struct query *query, struct answer *a, struct problem *problem)
{
    return row_list(query, query->given->count > 0 ? (size_t)query->given->number[0] : 0, a, problem);
}

/* ---- rowmax ---- */

static const struct column rowmax_columns[] = {
    {"s", "h", "the separation", 0},
    {"count", "", "the number of dominoes in the row", 0},
    {"r_max", "", "the largest growth at which all dominoes fall", 0},
    {"r_train", "", "the largest growth of the endless train", 0},
    {NULL, NULL, NULL, 0},
};

/* A search for the growths at which a row falls. */
struct growths {
    const struct scene *scene;
    struct domq_domino *domino;
    struct double_row made;
    enum dom_status status;
};

/* Returns 1 if all dominoes of the row with the growth r fall, and -1 if not or after an error. */
static double falls_at(double r, void *context)
{
    struct growths *g = context;
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    struct scene grown = *g->scene;
    grown.train.r = (domq_real)r;
    scene_row_fill(&grown, g->domino, g->made.row.count);
    for (size_t k = 0; k < g->made.row.count; k++)
        g->made.domino[k] = domino_in_double(&g->domino[k]);
    if (g->status == DOM_OK)
        g->status = dom_row_run(&g->made.row, &g->made.compute, false, NULL, NULL, &verdict);
    return g->status == DOM_OK && verdict.end == DOM_ROW_FALLS ? 1 : -1;
}

/*
 * Finds growths from r_min, which is 1 if the row falls there, to r_max, at which all dominoes fall. Without
 * one, r_max is NaN. A row may fall only at growths above 1, for example if its gaps at r = 1 are too narrow
 * for the first domino to tip over. The growth rises by 2 % at a time, since bisection alone could miss the
 * first change. Until the row falls in an engine, which is slow, it rises by 10 %.
 */
static void growths_find(struct growths *g, double highest, double *r_min, double *r_max)
{
    struct spot last = {1, falls_at(1, g)}, next = last;
    *r_min = last.value > 0 ? 1 : DOM_NAN;
    for (; last.x < highest && isnan(*r_max) && g->status == DOM_OK; last = next) {
        next.x = fmin(last.x * (g->made.row.engine && last.value < 0 ? 1.1 : 1.02), highest);
        next.value = falls_at(next.x, g);
        if (next.value == last.value)
            continue;
        struct spot good = next.value > 0 ? next : last, bad = next.value > 0 ? last : next;
        seek_edge(falls_at, g, &good, &bad, g->made.compute.tol * good.x);
        *(next.value > 0 ? r_min : r_max) = good.x;
    }
    if (last.value > 0)
        *r_max = highest;
}

static bool run_rowmax(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_limit limit;
    struct scene_row scene;
    double r_min = DOM_NAN, r_max = DOM_NAN;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    struct growths g = {.scene = query->scene, .domino = scene.domino};
    const double reach = (double)domq_train_reach(&query->scene->train);
    char reason[96];
    if (row_has_file(query->scene)) {
        free(scene.domino);
        return problem_error(problem, "a row from a file has no growth r; first enter 'set row N'");
    }
    g.status = scene_row_in_double(&scene, &g.made);
    if (g.status == DOM_OK)
        growths_find(&g, reach, &r_min, &r_max);
    free(g.made.domino);
    free(scene.domino);
    if (g.status != DOM_OK)
        return row_status(query, problem, g.status);
    const enum dom_status status = any_limit_rmax(&query->scene->train, &query->scene->compute, &limit);
    if (status == DOM_OPEN)
        return problem_limit(problem, query->scene, status, &limit);
    const bool has_train = status != DOM_NO_AIR;
    if (!has_train)
        limit.r_max = DOMQ_NAN;
    else if (status != DOM_OK)
        return row_status(query, problem, status);
    snprintf(reason, sizeof reason,
             "there is no growth from 1 to %.6g at which all dominoes fall; 'set r 1; fall' shows why",
             reach);
    bool more =
        answer_row(a,
                   ROW(cell_real(query->scene->train.s), cell_count((domq_real)scene.row.count),
                       cell_limit(cell_computed((domq_real)r_max)), cell_limit(cell_computed(limit.r_max))),
                   isnan(r_max) ? reason
                   : has_train  ? NULL
                                : dom_status_text(DOM_NO_AIR));
    if (r_min > 1)
        answer_say(a,
                   "All dominoes fall if r is between %.6g and r_max, but not if r is smaller, as 'set r 1; "
                   "fall' shows.",
                   (double)round_digits((domq_real)r_min, 6, true));
    return more;
}

static const struct command row_commands[] = {
    {.name = "fall",
     .in_joules = scene_has_masses,
     .precision = PRECISION_AS_SET,
     .synonyms = "simulate simulation run topple time speed",
     .summary = "run the row, domino by domino",
     .help = "Shows for each domino when it is hit, when it hits the next one, and how fast it starts. Also "
             "compares the energy of each domino with the energy that it needs to tip over. 'set row' "
             "enters a row.",
     .example = "set row 5; fall",
     .see = "verdict mend row effects",
     .rows = true,
     .holds = "all dominoes fall",
     .brief = "*",
     ANSWER(fall)},
    {.name = "verdict",
     .in_joules = scene_has_masses,
     .precision = PRECISION_AS_SET,
     .synonyms = "result success topple stop",
     .summary = "whether the whole row falls, and which domino is weakest",
     .example = "set row 5; verdict",
     .see = "fall mend",
     .principal = "seconds",
     .holds = "all dominoes fall",
     .brief = "",
     ANSWER(verdict)},
    {.name = "mend",
     .precision = PRECISION_DOUBLE,
     .synonyms = "repair fix spacing rescue",
     .summary = "the smallest change of one gap that saves a row",
     .help = "Tries the gap at which the row stops, and up to 30 gaps before it. If the row stops at a gap "
             "that is too wide to reach across, only this gap is tried. For each gap, 'mend' finds the "
             "nearest value at which all dominoes fall, and lists the smallest change first. If the row "
             "needs a push, the answer says so. The search tries up to 40 smaller and 40 larger values of "
             "each gap (10 in the rigid-body engine), and then bisects. It can miss a range of gaps that is "
             "narrower than one step.",
     .see = "fall tolerance change budget",
     .rows = true,
     .brief = "",
     ANSWER(mend)},
    {.name = "tolerance",
     .precision = PRECISION_DOUBLE,
     .synonyms = "window precision error plumb measure tape spacing height",
     .summary = "how inaccurate each domino may be before the row stops",
     .help = "A window is a range of values, for example of the height of a domino. All dominoes fall with "
             "any value in this range, as long as nothing else in the row changes. Each domino has windows "
             "for its place, the gap before it, its height, its thickness and its lean. The friction "
             "between dominoes has one window. A place is measured along a tape from the back of domino 1. "
             "When a place changes, only that domino moves. When a gap changes, all dominoes after it move, "
             "and the other gaps stay the same. A domino whose height changes keeps its density and the "
             "angle of its lean. A domino that is not set up plumb leans about its front edge. The window "
             "for its lean says how far its top may be off plumb, backwards or forwards. With rounded "
             "edges, and in the engine, the program does not compute how far a domino may lean. A height "
             "window also ends where the upper edge of the domino would pass above the next one, a contact "
             "that only the engine includes. The "
             "answer names the dominoes with the tightest limits. If the row does not fall, the windows show "
             "which single changes save it, for up to 31 dominoes before its end. The search takes the same "
             "steps as 'mend'.",
     .example = "set row 5; tolerance",
     .see = "mend change budget",
     .rows = true,
     .brief = "",
     ANSWER(tolerance)},
    {.name = "change",
     .synonyms = "modify edit adjust alter thickness height width mass radius lean",
     .argument =
         {{.name = "K", .kind = ARGUMENT_WORDS, .parse = change_parse_dominoes},
          {.name = "MEASURE", .kind = ARGUMENT_CHOICE, .noun = "measure", .choices = row_measure_names},
          {.name = "X", .kind = ARGUMENT_WORDS, .parse = change_parse_value, .bind = change_bind}},
     .summary = "change the height, gap, mass or another property of dominoes",
     .help = "K is the number of a domino, several numbers as in 4,5 or 3-7 (also 3:7 and 3..7), or 'all'. "
             "MEASURE is height, "
             "thickness, width, gap (before the domino), mass, radius (of the edges) or lean. A lean is an "
             "angle, or the distance of the top from plumb. A negative lean is backwards. X is the new "
             "value. An X with a sign is added to the old value, as in 'change 4 gap +1 cm'. A percentage "
             "with a sign changes the old value by this much, as in 'change 4,5 thickness +10 %'. 'change 4 "
             "lean = -2 mm' sets a negative value. A domino that becomes taller, thicker or wider becomes "
             "heavier, because it keeps its density. The gaps beside it and its other sizes stay the same. "
             "The change lasts until another row is entered; 'row > FILE.csv' keeps it.",
     .example = "set row 5; change 2,3 thickness +10 %; change 3-5 gap 25 mm; verdict",
     .see = "row insert remove place mend",
     .access.changes = true,
     .run = run_change},
    {.name = "place",
     .synonyms = "move spacing distance gap",
     .argument = {{.name = "K", .kind = ARGUMENT_WORDS, .parse = change_parse_dominoes},
                  {.name = "GAP", .kind = ARGUMENT_WORDS, .parse = change_parse_value, .bind = change_bind}},
     .summary = "change the gap before domino K of the row",
     .help = "'place 3 25 mm' is short for 'change 3 gap 25 mm'. All dominoes after the gap move, and "
             "the other gaps stay the same. A GAP with a sign changes the gap: 'place 3 +1 cm' widens "
             "it by 1 cm, and 'place 3 -1 cm' narrows it.",
     .example = "set row 5; place 3 25 mm; fall",
     .see = "change row mend",
     .access.changes = true,
     .run = run_change},
    {.name = "remove",
     .synonyms = "delete take out fewer shorten",
     .argument = {{.name = "K", .kind = ARGUMENT_WORDS, .parse = change_parse_dominoes, .bind = remove_bind}},
     .summary = "take dominoes out of the row",
     .help =
         "K is the number of a domino, or several numbers as in 4,5 or 3-7. The dominoes after them move up, "
         "and the gaps before these dominoes stay the same. 'undo' puts the dominoes back.",
     .example = "set row 5; remove 2,4; row",
     .see = "insert change row",
     .access.changes = true,
     .run = run_remove},
    {.name = "insert",
     .synonyms = "add append extend more copy",
     .argument = {{.name = "K", .kind = ARGUMENT_COUNT},
                  {.name = "SIZE",
                   .kind = ARGUMENT_CHOICE,
                   .noun = "size",
                   .optional = true,
                   .choices = insert_sizes},
                  {.name = "X", .kind = ARGUMENT_HEIGHT, .optional = true}},
     .summary = "put another domino into the row, as number K",
     .help =
         "The new domino is a copy of the one that was number K, with the same gap before it. With a "
         "height, as in 'insert 3 height 30 cm', its other sizes and its gap are in proportion, and it has "
         "the same density. The domino that was number K and those after it move on. If the row has 5 "
         "dominoes, 'insert 6' adds one at the end, like the last.",
     .example = "set row 5; insert 3 height 9 cm; row",
     .see = "remove change row",
     .access.changes = true,
     .run = run_insert},
    {.name = "row",
     .synonyms = "list export csv spacing mass weight",
     .argument = {{.name = "K", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "the dominoes of the row, or only domino K",
     .help = "If masses are known, the answer ends with the mass of all dominoes. 'row > hall.csv' writes a "
             "file that 'set row hall.csv' can read. The first line of the file "
             "has the units.",
     .example = "set row 3; row",
     .see = "effects fall",
     .rows = true,
     ANSWER(row)},
    {.name = "rowmax",
     .precision = PRECISION_DOUBLE,
     .synonyms = "maximum ratio factor",
     .summary = "the largest growth r at which the whole row falls",
     .help = "The row is the one that 'set row N' makes from s, d, q and h, and 'set push' starts it. "
             "If the first domino is tipped over without a push, or with a weak one, the row can stop at the "
             "second domino. Otherwise, the longer the row, the closer the answer comes to 'rmax', the "
             "largest growth of the endless train.",
     .example = "set q hollow; set row 8; rowmax",
     .see = "rmax effects",
     .sweep.echo = "s",
     .principal = "r_max",
     ANSWER(rowmax)},
    {.name = "fewest",
     .synonyms = "minimum least smallest",
     .argument = {{.name = "H", .kind = ARGUMENT_HEIGHT}},
     .summary = "gap and growth that need the fewest dominoes to topple one of height H",
     .help = "'count H fewest' is the same. For each kind of domino the answer has two lines: for a row "
             "whose first domino just tips over, or starts as 'set push' and 'set release' say, and for an "
             "endless train that is already moving. With n dominoes the growth must be (H/h)^(1/n). For n = "
             "1, 2, 3 and so on, the program searches for the gap at which a row with this growth has the "
             "most energy to spare, and stops at the first n with which all dominoes fall, the one of height "
             "H included; beyond 32 dominoes it bisects. It rounds the gap, and the growth upwards, and runs "
             "the row once more with exactly the numbers that it prints. Friction, slope and the other "
             "effects of the model apply.",
     .example = "count 112 m fewest; count 112 m 2.04 with s 0.35 q hollow",
     .see = "count best landmarks",
     .rows = true,
     .brief = "kind start dominoes r s",
     ANSWER(fewest)},
    {.name = "slip",
     .precision = PRECISION_DOUBLE,
     .synonyms = "foot feet slide slippery ground",
     .train = true,
     .summary = "the least friction of the floor at which no foot slips",
     .help = "Finds how much friction the floor needs so that no foot slips: one number for the time while "
             "dominoes fall, and one for the moment of a hit.",
     .example = "set floor 0.5; slip",
     .see = "effects fall",
     .principal = "motion",
     .brief = "motion hit slips slips_hit",
     ANSWER(slip)},
    {.name = NULL},
};

/* ---- The feature ---- */

static const struct command_group groups[] = {
    {"A row of dominoes", "rows", row_commands},
    {NULL, NULL, NULL},
};

static const struct domq_effect floor_effect = {
    .name = "floor",
    .synonyms = "feet foot slip slide slippery ground",
    .adds = "the friction that the floor needs so that no foot slips",
    .help = "With this effect, answers report the friction coefficient that the floor "
            "needs so that no foot slips, and which domino would slip first on a floor with the "
            "friction coefficient MU. The motion is computed for feet that do not slip. Newton's law "
            "for the centre of each block gives the force R of the floor on its foot: mass times "
            "acceleration, minus gravity and the contact forces. The foot does not slip while "
            "|R_x|/R_z is below MU. In the collision the same holds for the impulses; for the struck "
            "domino the ratio is |1/2 - (1 + d^2)/(3 a)|/(d/2), which is 0 if the domino is hit at "
            "its centre of percussion. If a domino would be lifted off the floor, no amount of "
            "friction is enough.",
    .source = "Newton's law for a hinged block; the centre of percussion is textbook mechanics",
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient of the floor",
                  .lowest = 0,
                  .highest = (domq_real)1e6,
                  .usual = (domq_real)0.5}},
};

static const struct parameter row_parameter = {.effect = &domq_effect_row,
                                               .which = DOM_EFFECT_row,
                                               .example = "set row 13; fall; set row off",
                                               .load = rowfile_load},
                              floor_parameter = {
                                  .effect = &floor_effect,
                                  .number = &floor_number,
                                  .example = "set row 5; set floor 0.4; fall; set floor off; set row off",
                                  .to = 3};

static const struct first_line first[] = {
    {6, "set row 12", "a row of 12 dominoes; 'set row FILE' reads your own", false},
    {8, "fall", "how each domino falls, and whether all do", false},
    {0, NULL, NULL, false},
};

const struct feature rows_feature = {
    .name = "rows",
    .groups = groups,
    .first = first,
    .row_note = "This answer is about the endless train with these parameters, not about the row. 'fall' "
                "runs the row.",
    .parameters = (const struct parameter *const[]){&row_parameter, &floor_parameter, NULL}};
