/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands row and rowmax, and the table of all commands about a row. */
#include "commands/rows/change.h"
#include "commands/rows/rows.h"
#include "commands/tables.h"
#include "language/quad.h"
#include <stdlib.h>

/* ---- row ---- */

static const struct column row_columns[] = {
    {"domino", "", "number of the domino, from 1", 6},
    {"height", "m", "height of the domino", 0},
    {"thickness", "m", "thickness of the domino", 0},
    {"gap", "m", "free distance to the domino before it", 0},
    {"mass", "kg", "mass of the domino, if masses are known", 0},
    {"relative", "", "mass divided by the mass of the first domino, if masses are not known", 0},
    {"radius", "m", "radius of the edges, if the file has radii; used with 'effect edges'", 0},
    {"lean", "m", "how far the top is off plumb, if the file has leans (negative: backwards)", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_row(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    bool has_radii = false, has_leans = false;
    if (!scene_row_list(query->scene, &scene, problem))
        return false;
    for (size_t k = 0; k < scene.row.count; k++) {
        has_radii = has_radii || scene.domino[k].radius > 0;
        has_leans = has_leans || scene.domino[k].lean != 0;
    }
    answer_leave_out(a, scene_has_masses(query->scene) ? "relative" : "mass");
    if (!has_radii)
        answer_leave_out(a, "radius");
    if (!has_leans)
        answer_leave_out(a, "lean");
    a->csv.units = true;
    a->style.errors = false; /* 'effect row FILE' cannot read columns with error bounds */
    a->csv.extra = a->path ? query->scene->listed.others : NULL;
    for (int writes = 0; writes < 2; writes++) /* the first pass only chooses the units of the columns */
        for (size_t k = 0; k < scene.row.count && !answer_lost(a); k++) {
            const struct domq_domino *d = &scene.domino[k];
            const struct cell cells[] = {
                cell_count((domq_real)k + 1), cell_real(d->height),
                cell_real(d->thickness),      cell_real(d->gap),
                cell_real(d->mass),           cell_real(d->mass / scene.domino[0].mass),
                cell_real(d->radius),         cell_real(d->height * quad(sin)(d->lean))};
            for (int i = 1; i < 8 && !writes; i++)
                answer_largest(a, row_columns[i].key, cells[i].number);
            if (writes)
                answer_row(a, cells, NULL);
        }
    free(scene.domino);
    if (query->next && a->path)
        query->next->scene.listed.saved = true;
    return true;
}

/* ---- rowmax ---- */

static const struct column rowmax_columns[] = {
    {"s", "h", "the separation", 0},
    {"count", "", "the number of dominoes in the row", 0},
    {"r_max", "", "the largest growth at which all dominoes fall", 0},
    {"r_train", "", "the largest growth of the endless train", 0},
    {NULL, NULL, NULL, 0},
};

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
        domq_row_rmax(&scene.row, &scene.compute, reach, row_grow, (void *)query->scene, &growth);
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
                   "All dominoes fall from r = %.6g on; with a smaller growth the row ends earlier, as 'set "
                   "r 1; fall' shows.",
                   (double)growth.r_min);
    return more;
}

const struct command row_commands[] = {
    {.name = "fall",
     .synonyms = "simulate simulation run topple time speed",
     .summary = "run the row, domino by domino",
     .help = "Shows for each domino when it is hit, when it hits the next one, how fast it starts, and how "
             "its energy compares with the energy that it needs. 'effect row' enters a row.",
     .example = "effect row 5; fall",
     .see = "verdict mend row effect",
     .rows = true,
     .holds = "all dominoes fall",
     ANSWER(fall)},
    {.name = "verdict",
     .shortest = "v",
     .synonyms = "result success topple stop",
     .summary = "whether the whole row falls, and which domino is weakest",
     .example = "effect row 5; verdict",
     .see = "fall mend",
     .principal = "seconds",
     .holds = "all dominoes fall",
     ANSWER(verdict)},
    {.name = "mend",
     .synonyms = "repair fix spacing rescue",
     .summary = "the smallest change of one gap that saves a row",
     .help = "For each gap up to the domino at which the row ends, 'mend' finds the nearest value with which "
             "all dominoes fall, and lists the smallest change first. If the row needs a push, the answer "
             "says so. The search tries 40 smaller and 40 larger values of each gap and then bisects; it can "
             "miss a range of gaps that is narrower than one step.",
     .see = "fall tolerance change budget",
     .rows = true,
     ANSWER(mend)},
    {.name = "tolerance",
     .synonyms = "window precision error plumb measure tape spacing height",
     .summary = "how far each domino may be off while all still fall",
     .help =
         "Finds windows for the place of each domino, for the gap before it, for its height and thickness "
         "and for the friction between dominoes. All dominoes fall with every value in a window, if the rest "
         "of the row stays as it is. A place is measured along a tape from the back of domino 1; when a "
         "place changes, only that domino moves. When a gap changes, all dominoes after it move along. A "
         "domino whose height changes keeps its density and the angle of its lean. A domino that is not set "
         "up plumb leans about its front edge, and a window says how far its top may be off, backwards or "
         "forwards. With rounded edges, and in the engine, the program does not compute how far a domino may "
         "lean. The dominoes with the least room are marked. If the row does not fall, the windows show "
         "which single changes save it. The search takes the same steps as 'mend'.",
     .example = "effect row 5; tolerance",
     .see = "mend change budget",
     .rows = true,
     ANSWER(tolerance)},
    {.name = "change",
     .synonyms = "modify edit adjust alter thickness height mass radius lean",
     .argument = {{.name = "K", .kind = ARGUMENT_WORDS, .parse = change_parse_dominoes},
                  {.name = "MEASURE", .kind = ARGUMENT_CHOICE, .of = "measure", .choices = row_measure_names},
                  {.name = "X", .kind = ARGUMENT_WORDS, .parse = change_parse_value, .bind = change_bind}},
     .summary = "change the height, gap, mass or another measure of dominoes",
     .help =
         "K is the number of a domino, several numbers as in 4,5 or 3-7, or 'all'. MEASURE is height, "
         "thickness, gap (the gap before the domino), mass, radius (of the edges) or lean (how far the top "
         "is off plumb, or an angle; a negative lean is backwards). X is the new value. An X with a sign is "
         "added to the old value, as in 'change 4 gap +1 cm', or changes it by a share, as in 'change 4,5 "
         "thickness +10 %'. 'change 4 lean = -2 mm' sets a negative value. A domino that becomes taller or "
         "thicker keeps the gaps beside it and its density, so that it becomes heavier. The change lasts "
         "until another row is entered; 'save FILE' and 'row > FILE.csv' keep it.",
     .example = "effect row 5; change 2,3 thickness +10 %; change 3-5 gap 25 mm; verdict",
     .see = "row place mend tolerance",
     .changes = true,
     .run = run_change},
    {.name = "place",
     .synonyms = "move spacing distance gap",
     .argument = {{.name = "K", .kind = ARGUMENT_WORDS, .parse = change_parse_dominoes},
                  {.name = "GAP", .kind = ARGUMENT_WORDS, .parse = change_parse_value, .bind = change_bind}},
     .summary = "change the gap before domino K of the row",
     .help = "'place 3 25 mm' is short for 'change 3 gap 25 mm': all dominoes after the gap move with it. "
             "'place 3 +1 cm' widens the gap by 1 cm.",
     .example = "effect row 5; place 3 25 mm; fall",
     .see = "change row mend",
     .changes = true,
     .run = run_change},
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
         "The row is the one that 'effect row N' makes from s, d, q and h, and 'effect push' starts it. If "
         "the first domino just tips over, or its push is weak, the row can stop at the second domino. "
         "Otherwise the answer for a long row approaches the largest growth of the endless train, 'rmax'.",
     .example = "set q hollow; effect row 8; rowmax",
     .see = "rmax effect",
     .echo = "s",
     .principal = "r_max",
     ANSWER(rowmax)},
    {.name = NULL},
};
