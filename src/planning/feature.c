/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'improve', which changes the session's row to make it more likely to fall, and the table of the
 * commands design, plan and improve. */
#include "chance/chance.h"
#include "interpreter/command.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "parallel/workers.h"
#include "planning/planning.h"
#include "rows/rows.h"
#include "train/train.h"
#include <stdlib.h>

/* ---- improve ---- */

static const struct column improve_columns[] = {
    {"before", "share", "the share of the rows that fell before the changes", 0},
    {"before_low", "share", "the lower end of the 95 % interval before the changes", 0},
    {"before_high", "share", "the upper end of the 95 % interval before the changes", 0},
    {"probability", "share", "the share of the rows that fall after the changes", 0},
    {"low", "share", "the lower end of the 95 % interval of the probability", 0},
    {"high", "share", "the upper end of the 95 % interval of the probability", 0},
    {"rows", "",
     "the number of random rows from which each of the two probabilities was computed; the search itself "
     "used other random rows",
     0},
    {"changed", "", "the number of dominoes that have changed", 0},
    {"length", "m", "the length of the row, including its fallen last domino", 0},
    {NULL, NULL, NULL, 0},
};

/* How many random rows are run to estimate a probability. A row takes hundreds of times as long in the
 * engine. */
enum { ROWS = 2000, ROWS_OF_ENGINE = 100 };

/* A row and its improvement. */
struct improvement {
    struct trials before; /* the row before the changes, and its random errors */
    size_t count;
    struct dom_domino *domino;
    struct dom_limits limits;
    struct dom_study study[2];
    /* the length of the row in m, including its fallen last domino, before and after the changes */
    double from, to;
    size_t changed;
};

static double length_of(const struct dom_domino *d, size_t count)
{
    double length = d[count - 1].height;
    for (size_t k = 0; k < count; k++)
        length += d[k].thickness + d[k].gap;
    return length;
}

/* Sets up the row, the limits of the changes and the random errors. The caller frees the memory, even after a
 * failure. */
static bool improvement_make(const struct query *query, const struct wishes *w, struct problem *problem,
                             struct improvement *i)
{
    struct trials *t = &i->before;
    if (!trials_make(query, problem, ROWS, false, t))
        return false;
    const size_t count = i->count = t->row.row.count;
    t->placement.first = 1;
    t->placement.rows = t->row.row.engine ? ROWS_OF_ENGINE : ROWS;
    i->domino = malloc(count * sizeof *i->domino);
    if (!i->domino)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    i->from = length_of(t->row.domino, count);
    i->limits = (struct dom_limits){.sizes = w->sizes,
                                    .q = (double)query->scene->train.q,
                                    .hall = isfinite(w->hall) ? (double)w->hall : i->from,
                                    .grid = (double)w->grid,
                                    .board = w->board,
                                    .boards = w->boards};
    if (!t->has_errors)
        return problem_no_errors(problem, "this command");
    if (!w->sizes && w->boards > 0)
        return problem_error(problem,
                             "without 'sizes', only gaps change, not thicknesses; enter 'improve sizes ...'");
    return grid_check(w->grid, quad_decimal(t->row.domino[0].height), problem);
}

/* ---- The answer of improve ---- */

static void improvement_say(const struct query *query, struct answer *a, const struct improvement *i,
                            bool interrupted)
{
    const struct dom_study *study = i->study;
    if (interrupted)
        answer_say(a, "Interrupted; this is the best row so far.");
    if (i->changed > 0)
        answer_say(a, "Without the changes, %s; with them, %s, with 95 %% confidence.",
                   study_words(&study[0]).text, study_words(&study[1]).text);
    else
        answer_say(a, "%s For the present row, %s, with 95 %% confidence.%s",
                   study[0].fall == study[0].rows ? "There is nothing to improve."
                                                  : "No better row was found.",
                   study_words(&study[0]).text,
                   study[0].fall == 0 ? " 'mend' looks for a change that makes the row fall."
                   : study[0].fall < study[0].rows && !i->limits.sizes
                       ? " 'improve sizes' also changes the sizes of the dominoes."
                       : "");
    if (i->before.row.row.engine)
        answer_detail(
            a,
            "The search used the model, which treats feet as hinges. The probability comes from the "
            "rigid-body engine, which is used because %s.",
            scene_engine(query->scene));
    if (i->changed == 0)
        return;
    if (study[1].fall < study[0].fall)
        answer_say(a, "The old row was outside these limits.");
    answer_detail(a, "The search itself used other random rows.\n");
    answer_say(a, "Including the fallen last domino, the row is %s long; before, it was %s.%s",
               measured(i->to, "m", 4).text, measured(i->from, "m", 4).text,
               query->next ? " 'row' lists the row, and 'undo' reverts the changes." : "");
}

/* Writes the answer. If the command can change the session, the improved row becomes its row. */
static bool improvement_answer(const struct query *query, struct answer *a, struct improvement *i,
                               bool interrupted, struct problem *problem)
{
    const struct dom_study *s = i->study;
    i->to = length_of(i->domino, i->count);
    for (size_t k = 0; k < i->count; k++) {
        const struct dom_domino *old = &i->before.row.domino[k], *new = &i->domino[k];
        i->changed += old->height != new->height || old->thickness != new->thickness ||
                      old->gap != new->gap || old->mass != new->mass;
    }
    if (answer_for_people(a))
        improvement_say(query, a, i, interrupted);
    const bool keeps = query->next && !a->sink.take && i->changed > 0;
    struct domq_domino *const domino = calloc(i->count + 1, sizeof *domino);
    for (size_t k = 0; k < i->count && domino; k++)
        domino[k] = domino_from_double(&i->domino[k]);
    bool good = domino
                    ? !keeps || scene_row_set(&query->next->scene, domino, i->count, i->limits.sizes, problem)
                    : problem_status(problem, query->scene, DOM_NO_MEMORY);
    free(domino);
    struct answer list = {.out = answer_rest(a), .style = a->style};
    if (good && list.out && keeps) { /* the details list the new row */
        struct query after = *query;
        after.scene = &query->next->scene;
        good = row_list(&after, 0, &list, problem);
    }
#define SHARE(value) cell_computed((domq_real)(value))
    if (good)
        answer_row(a,
                   ROW(SHARE((double)s[0].fall / (double)s[0].rows), SHARE(s[0].low), SHARE(s[0].high),
                       SHARE((double)s[1].fall / (double)s[1].rows), SHARE(s[1].low), SHARE(s[1].high),
                       cell_count((domq_real)s[1].rows), cell_count((domq_real)i->changed),
                       cell_narrow(i->to, 5)),
                   interrupted ? "interrupted: the best row so far" : NULL);
#undef SHARE
    return good;
}

static bool run_improve(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct wishes *w = wishes_of(query);
    struct improvement i = {.domino = NULL};
    const struct dom_study *s = i.study;
    bool good = improvement_make(query, w, problem, &i);
    const enum dom_status status =
        good ? dom_row_improve(&i.before.row.row, &i.before.row.compute, &i.before.placement, &i.limits,
                               progress_count, NULL, i.domino, i.study)
             : DOM_OK;
    const bool interrupted = status == DOM_INTERRUPTED && s[1].rows > 0 && !a->sink.take;
    if (good && status == DOM_BAD_HALL)
        good = problem_no_answer(problem,
                                 "a hall of %s has no room for %s, even without gaps; enter a longer hall%s",
                                 measured(i.limits.hall, "m", 6).text,
                                 w->boards > 0 ? "dominoes of these boards" : "these dominoes",
                                 w->boards > 0 ? ", or thinner boards" : "");
    else if (good && status == DOM_OK && (s[1].rows == 0 || (s[1].fall == 0 && s[0].fall > 0)))
        good = problem_no_answer(problem, "no row that falls was found within these limits; enter other "
                                          "values of 'hall', 'grid' or 'boards', or leave some of them out");
    if (good && (status == DOM_OK || interrupted))
        good = improvement_answer(query, a, &i, interrupted, problem);
    free(i.domino);
    free(i.before.row.domino);
    return good && row_status(query, problem, status);
}

/* ---- The feature ---- */

static const struct command design_commands[] = {
    {.name = "design",
     .precision = PRECISION_DOUBLE,
     .argument = {{.name = "H", .kind = ARGUMENT_HEIGHT},
                  {.name = "WISHES",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = wishes_parse,
                   .bind = wishes_bind,
                   .choices = design_wishes}},
     .summary = "a safe row whose last domino is H tall",
     .help =
         "'design' finds a gap and a growth such that every domino after the first has at least 'safety' "
         "times the energy that it needs. This is true both in the endless train and in the row. The first "
         "domino, friction, slope and push come from the scene.\n\n"
         "WISHES can come in any order. 'safety 2' is the default. 'hall 20 m' is the greatest length "
         "of the row, including its fallen last domino. The row has as few dominoes as possible. "
         "'boards 9, 12, 15 mm' are the thicknesses to choose from; with 'set walls 12 mm 30 cm', a box "
         "can have any thickness. 'grid 1 mm' makes all gaps, heights and thicknesses multiples of 1 "
         "mm, except the first domino, the height H and the thicknesses of boards. The row still has "
         "the required safety. 'falls 99 %' adds dominoes until random rows with the errors of the "
         "scene fall with this probability; the lower end of its 95 % interval counts. 'improve sizes' "
         "then makes the row more likely to fall.\n\n"
         "The row becomes the session's row; 'design ... > "
         "hall.csv' writes a file for 'set row hall.csv'.",
     .example = "set q hollow; set friction 0.3; design 8 m",
     .see = "placement improve plan verdict row",
     .principal = "steps",
     .holds = "a row meets the wishes",
     .access.changes = true,
     .brief = "",
     ANSWER(design)},
    {.name = "plan",
     .precision = PRECISION_DOUBLE,
     .synonyms = "guide print sheet cut list boards tape workshop hall build",
     .argument = {{.name = "title TITLE", .kind = ARGUMENT_WORDS, .optional = true, .parse = plan_parse}},
     .summary = "a guide for building the row: sizes, boards, places",
     .help =
         "For the hall, the guide lists the places of the dominoes on a tape measure. For the workshop, it "
         "lists their sizes and the boards to cut. Beside each place, each height and each thickness, it "
         "shows the limits between which all dominoes fall, as 'tolerance' finds them. With errors such as "
         "'set placement 2 mm', the guide shows how likely the row is to fall. 'plan title \"The hall\" > "
         "hall.pdf' draws the guide on A4 pages. It shows the row to scale. "
         "As .svg or .png, the guide is one long page. csv and json have the numbers, in m.",
     .example = "set row 5; plan",
     .see = "row tolerance placement draw",
     .sweep.refusal = "it is a text",
     .writes = WRITES_PICTURES,
     .rows = true,
     .brief = "",
     ANSWER(plan)},
    {.name = "improve",
     .precision = PRECISION_DOUBLE,
     .synonyms = "optimise optimize best robust reliable",
     .argument = {{.name = "WISHES",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = wishes_parse,
                   .bind = wishes_bind,
                   .choices = improve_wishes}},
     .summary = "change the row to make it more likely to fall",
     .help =
         "'improve' changes the gaps of the row to make it more likely to fall in spite of the random "
         "errors of the scene. First enter 'set placement 3 mm', or other errors. WISHES can come in any "
         "order. 'sizes' also changes the sizes of all dominoes between the first and the last; their "
         "proportions stay fixed. 'hall 20 m' is the greatest length of the row, including its fallen last "
         "domino; the default is the present length. 'boards 9, 12, 15 mm' are the thicknesses to choose "
         "from; with 'set walls 12 mm 30 cm', a box can have any thickness. "
         "'grid 1 mm' makes all gaps, and the heights and thicknesses "
         "that change, multiples of 1 mm. A domino that becomes twice as large gets 2^(q-1) times the mass. "
         "The search uses random rows; the probabilities before and after the changes come from other "
         "random rows. A row within these limits is never replaced by a worse one. ^C ends the search with "
         "the best row so far. 'undo' reverts the changes. If the rigid-body engine runs rows, the search "
         "still uses the model, and the probabilities come from the engine.",
     .example = "set row 8; set friction 0.2; set r 1.3; set s 0.5; set placement 3 mm; improve",
     .see = "placement budget design change row",
     .principal = "probability",
     .access.changes = true,
     .brief = "",
     ANSWER(improve)},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"Planning a row", "planning", design_commands},
    {NULL, NULL, NULL},
};

const struct feature planning_feature = {.name = "planning", .groups = groups};
