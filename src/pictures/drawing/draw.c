/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'draw', which shows the row or the train at a given moment, to scale. */
#include "language/quad.h"
#include "language/text.h"
#include "pictures/drawing/falling_row.h"
#include "pictures/plots/plots.h"
#include "train/train.h"
#include <float.h>
#include <stdlib.h>
#include <string.h>

static const struct column draw_columns[] = {
    {"i", "", "number of the domino: in a train 0 is the head, and -1 the next domino", 5},
    {"height", "h", "height of the domino; h is the height of the head", 0},
    {"x", "h", "horizontal position of the hinge, which is the lower front edge", 0},
    {"theta", "rad", "tilt of the domino", 0},
    {"top_front_x", "h", "horizontal position of the upper front corner", 0},
    {"top_front_z", "h", "height of the upper front corner", 0},
    {"top_back_x", "h", "horizontal position of the upper back corner", 0},
    {"top_back_z", "h", "height of the upper back corner", 0},
    {"foot_back_x", "h", "horizontal position of the lower back corner", 0},
    {"foot_back_z", "h", "height of the lower back corner", 0},
    {"contact_x", "h", "horizontal position where the follower touches the back face", 0},
    {"contact_z", "h", "height at which the follower touches the back face", 0},
    {"force", "m g", "push at the contact, perpendicular to the face; m is the mass of the head", 0},
    {"of_own", "m g", "the same push, but m is the mass of this domino", 0},
    {NULL, NULL, NULL, 0},
};

/* ---- The words of the command ---- */

/* The words that were typed, as bits of question->parsed. The number beside them, if there is one, is the
 * command's argument. */
enum {
    DRAW_AT = 1,
    DRAW_DOMINO = 2,
    DRAW_END = 4,
    DRAW_TOWER = 8,
    DRAW_TRAIN = 16,
    DRAW_FORCES = 32,
    DRAW_TILT = 64
};

/* Parses what follows 'at'. */
static bool moment_parse(struct reader *r, struct item *item, unsigned *words)
{
    static const struct argument time = {.name = "the time", .kind = ARGUMENT_ANY},
                                 domino = {.name = "N", .kind = ARGUMENT_NUMBER};
    item->at = r->at;
    if (reader_takes(r, "domino"))
        *words |= DRAW_DOMINO;
    else if (reader_takes(r, "end"))
        *words |= DRAW_END;
    reader_place(r, r->at);
    return (*words & DRAW_END) ||
           (reader_ends(r) ? problem_error(r->problem, "'at' needs a time, 'domino N' or 'end'")
                           : item_parse(r, *words & DRAW_DOMINO ? &domino : &time, item));
}

static bool words_parse(struct reader *r, struct item *item, unsigned *words)
{
    static const struct argument tilt = {.name = "T", .kind = ARGUMENT_TILT};
    if (reader_takes(r, "at")) {
        *words = DRAW_AT;
        return moment_parse(r, item, words);
    }
    if (reader_takes(r, "tower")) {
        *words = DRAW_TOWER;
        return true;
    }
    while (!reader_ends(r)) {
        reader_place(r, r->at);
        if (!(*words & DRAW_TRAIN) && reader_takes(r, "train"))
            *words |= DRAW_TRAIN;
        else if (!(*words & DRAW_FORCES) && reader_takes(r, "forces"))
            *words |= DRAW_FORCES;
        else if (*words & DRAW_TILT)
            break;
        else if (!item_parse(r, &tilt, item))
            return false;
        else
            *words |= DRAW_TILT;
    }
    return true;
}

static bool draw_parse(struct reader *r, struct question *q)
{
    static const char usage[] = "; usage: draw, draw at 2.5 s, draw at domino 8, draw at end, draw train, "
                                "draw 0.3 forces, draw tower";
    unsigned *words = q->parsed = reader_memory(r, sizeof *words);
    bool good = words && words_parse(r, &q->item[0], words);
    if (good && !reader_ends(r)) {
        reader_place(r, r->at);
        const char *word = read_word(r, WORD_BARE);
        good = problem_error(r->problem, "'%s' does not fit here", names_shown(word ? word : ""));
    }
    if (!good)
        text_add(r->problem->text, sizeof r->problem->text, "%s", usage);
    return good;
}

/* ---- Data ---- */

/* Rounding errors become 0. */
static struct cell cell_place(double value, const struct drawn *k)
{
    double least = 4 * DBL_EPSILON * (fabs(k->foot) + k->height);
    return cell_real(fabs(value) < least ? 0 : (domq_real)value);
}

/* Writes a line of data for each domino. `forces` is the status of the computation of the forces. */
static void stage_rows(const struct stage *stage, enum dom_status forces, struct answer *a)
{
    a->style.errors = 0; /* a picture shows no errors */
    a->in_double = a->style.precision == IN_QUAD;
    for (size_t n = 0; n < stage->count && !answer_lost(a); n++) {
        const struct drawn *k = &stage->domino[n];
        const struct point *p = k->corner;
        answer_row(
            a,
            ROW(cell_count((domq_real)k->number), cell_real((domq_real)k->height),
                cell_real((domq_real)k->foot), cell_real((domq_real)k->theta), cell_place(p[1].x, k),
                cell_place(p[1].y, k), cell_place(p[2].x, k), cell_place(p[2].y, k), cell_place(p[3].x, k),
                cell_place(p[3].y, k), cell_place(k->contact.x, k), cell_place(k->contact.y, k),
                cell_real((domq_real)k->force), cell_real((domq_real)k->of_own)),
            !drawn_locked(k)   ? NULL
            : forces == DOM_OK ? "the contact is at the hinge: no push, however large, turns this domino"
                               : dom_status_text(forces));
    }
}

/* ---- The row ---- */

/* Fails if the row has no such moment, or if the domino is never hit. */
static bool moment_time(struct problem *problem, unsigned words, const struct arguments *given,
                        const struct falling_row *row, domq_real *time)
{
    const struct quantity typed = given->quantity[0];
    const size_t count = row->stage.count, end = row->run.verdict.domino;
    const char *start = falling_row_start(row);
    problem->place = given->column[0];
    *time = words & DRAW_END ? (domq_real)HUGE_VAL : typed.value;
    if (words & DRAW_DOMINO) {
        const bool is_there =
            typed.value >= 1 && typed.value <= (domq_real)count && typed.value == quad(floor)(typed.value);
        *time = is_there ? (domq_real)falling_row_hit(row, (size_t)typed.value - 1) : DOMQ_NAN;
        return !isnan(*time) || (is_there && (size_t)typed.value <= end) ||
               problem_no_answer(
                   problem,
                   "domino %s is never hit: this row has %zu, and the fall ends at domino %zu; 'draw "
                   "at end' shows how far the row falls",
                   quad_text(typed.value, 10), count, end);
    }
    if (!quantity_is_dimensionless(typed) && !quantity_alike(typed, (struct quantity){.time = 1}))
        return problem_error(problem, "this needs a time such as 2.5 s, not %s", expression_kind(typed));
    if (*time < 0)
        return problem_no_answer(
            problem, "times count from the %s and cannot be negative; 'draw at 0' shows the row at the %s",
            start, start);
    /* An end time that the user copied from an answer may have been rounded up. */
    return isinf(*time) || !((double)*time > row->end * 1.005) ||
           problem_no_answer(problem, "the motion ends at %s; 'draw at end' shows the row at this time",
                             measured((domq_real)row->end, "s", 4).text);
}

/* Draws a moment of the fall or, if `moment` is NULL, the row before it falls. */
static bool moment_show(const struct dom_moment *moment, void *context)
{
    struct falling_row *row = context;
    const struct domq_row *r = &row->run.scene.row;
    char *const caption = row->stage.caption, first[SENTENCE], verdict[SENTENCE], weakest[SENTENCE];
    falling_row_verdict(row, verdict);
    falling_row_weakest(row, weakest);
    if (moment) {
        falling_row_pose(row, moment);
        falling_row_reach(row, true);
        falling_row_moment(row, moment, first);
    } else {
        falling_row_summary(row, first);
    }
    snprintf(caption, CAPTION, "%s", first);
    if (!moment && r->rho != 0)
        text_add(caption, CAPTION, ", edges rounded by %.4g of the height", (double)r->rho);
    if (!moment)
        text_add(caption, CAPTION, ", on %s of floor%s.", measured((domq_real)row->stage.right, "m", 3).text,
                 r->alpha != 0 ? " that slopes (drawn level)" : "");
    text_add(caption, CAPTION, "\n%s%s%s", verdict, *weakest ? "\n" : "", weakest);
    return true;
}

static bool draw_row(const struct query *query, struct answer *a, struct problem *problem, unsigned words)
{
    struct falling_row row;
    domq_real time = 0;
    a->note = NULL; /* no note about the train, because the picture shows the row */
    if (!falling_row_make(query, problem, (words & DRAW_TOWER) && answer_for_people(a), &row))
        return false;
    const bool is_timed = (words & DRAW_AT) != 0;
    bool good = is_timed ? moment_time(problem, words, query->given, &row, &time) : moment_show(NULL, &row);
    enum dom_status status = DOM_OK;
    if (good && is_timed)
        status = falling_row_watch(&row, (const double[]){(double)time}, 1, moment_show, &row);
    problem->place = 0;
    if (status != DOM_OK) {
        good = row_status(query, problem, status);
    } else if (good && answer_for_people(a)) {
        good = stage_show(&row.stage, a, problem);
    } else if (good) {
        for (struct column *c = answer_columns(a, a->columns); c->key; c++)
            c->unit = strcmp(c->unit, "h") == 0 ? "m" : c->unit;
        answer_leave_out(a, "contact_x contact_z force of_own");
        stage_rows(&row.stage, DOM_OK, a);
    }
    falling_row_free(&row);
    return good;
}

/* ---- The train ---- */

/* The maximum number of forces in a caption. Dominoes farther back can hardly be seen. */
enum { FORCES_MOST = 6 };

/* Lists the forces if no arrows show them. */
static void train_caption(const struct query *query, struct stage *stage, domq_real theta,
                          const struct answer *a)
{
    const struct domq_train *t = &query->scene->train;
    const struct walk *walk = walk_now(query);
    struct walk_units units = walk_units(query, walk ? walk->cycle : 1);
    const bool is_filed = picture_is_filed(a);
    snprintf(stage->caption, CAPTION, "%s = %.4g rad (%.4g deg), s = %.4g, r = %.4g, d = %.4g, h = %.4g mm, ",
             is_filed ? "\u03b8" : "theta", (double)theta, (double)(theta * (180 / QUAD_PI)), (double)t->s,
             (double)t->r, (double)t->d, (double)(1000 * units.height));
    if (t->rho != 0)
        text_add(stage->caption, CAPTION, "edges %.4g h", (double)t->rho);
    text_add(stage->caption, CAPTION, "%s\n0: head; 1, 2, ...: its followers%s",
             t->rho != 0 ? "" : "to scale",
             is_filed                     ? "; dots: contacts"
             : display_of(a->out).braille ? ""
                                          : "; #: the next; @: contact");
    if (stage->domino[0].height > stage->top)
        text_add(stage->caption, CAPTION, "; the next domino is %.4g h tall", stage->domino[0].height);
    if (!stage->forces)
        return;
    text_add(stage->caption, CAPTION, "\n%s",
             is_filed ? "arrows: the push at each contact, divided by the weight of the pushed domino"
                      : "contact forces, divided by the pushed domino's weight:");
    for (size_t k = 1; !is_filed && k <= FORCES_MOST && k < stage->count && stage->domino[k].touched; k++) {
        const struct drawn *d = &stage->domino[k];
        text_add(stage->caption, CAPTION, drawn_locked(d) ? "%s %d: no force is enough" : "%s %d: %.3g",
                 k > 1 ? "," : "", d->number, d->of_own);
    }
}

static bool draw_train(const struct query *query, struct answer *a, struct problem *problem, unsigned words)
{
    struct stage stage;
    /* If the user typed no tilt, the train is drawn at the current position of the walk. Without a walk it is
     * drawn at the launch. */
    const struct walk *walk = (words & DRAW_TILT) ? NULL : walk_now(query);
    const struct any_compute *compute = query_compute(query);
    const struct domq_train *train = &query->scene->train;
    domq_real theta = walk ? walk->theta : query->given->number[0];
    if (words & DRAW_TRAIN)
        a->note = NULL; /* a user who asked for the train needs no note that the picture shows the train */
    if (!walk && !train_comes_to(query, problem, theta))
        return false;
    bool people = answer_for_people(a), good = false;
    enum dom_status forces = DOM_OK, status = stage_train(&stage, train, compute, theta);
    /* Output for programs always includes the forces, unless the margin is too small to compute them. */
    if (status == DOM_OK && ((words & DRAW_FORCES) || !people))
        forces = stage_forces(&stage, train, compute, theta);
    if (status == DOM_OK && (words & DRAW_FORCES))
        status = forces;
    if (status != DOM_OK) {
        good = problem_status(problem, query->scene, status);
    } else if (people) {
        stage.forces = (words & DRAW_FORCES);
        train_caption(query, &stage, theta, a);
        good = stage_show(&stage, a, problem);
    } else {
        stage_rows(&stage, forces, a);
        good = true;
    }
    free(stage.domino);
    return good;
}

static bool run_draw(const struct query *query, struct answer *a, struct problem *problem)
{
    const unsigned *typed = query->given->bound, words = typed ? *typed : 0;
    bool row = query->scene->effect[DOM_EFFECT_row].on,
         train = words & (DRAW_TRAIN | DRAW_FORCES | DRAW_TILT);
    if ((words & DRAW_AT) && !row) {
        problem->place = query->given->column[0];
        return problem_error(
            problem,
            "'draw at' shows a row at a given time; first enter 'set row N', for example 'set row 10'");
    }
    if (words & DRAW_TOWER) {
        struct tower tower;
        const bool good = tower_make(query, &tower, problem) && draw_row(&tower.query, a, problem, words);
        tower_free(&tower);
        return good;
    }
    return row && !train ? draw_row(query, a, problem, words) : draw_train(query, a, problem, words);
}

const struct command draw_commands[] = {
    {.name = "draw",
     .synonyms = "picture image drawing figure svg png pdf show",
     .train = true,
     .argument = {{.name = "WHAT", .kind = ARGUMENT_WORDS, .optional = true, .parse = draw_parse}},
     .summary = "a picture of the row or the train, to scale",
     .help = "'draw' shows the row as it is set up, and marks the weakest domino and the one that stops the "
             "row. 'draw at 2.5 s', 'draw at domino 8' (when domino 8 is hit) and 'draw at end' show the row "
             "as it falls. A domino that has detached keeps the tilt at which it detached. Without a row, or "
             "with 'draw train', the endless train is drawn. 'draw 0.3' shows the train when its head has "
             "this tilt. Without a tilt, the train is shown at the tilt that 'step' has reached, or at the "
             "launch. 'draw 0.3 forces' and 'draw forces' add the contact forces. 'draw tower' after 'count "
             "112 m' shows the row of that answer with a tower of 112 m at its end. In the terminal the "
             "picture is made of characters. 'draw > row.svg' makes a file. The name of the file can also "
             "end in .png or .pdf "
             "(with gnuplot), in .gp (a script for gnuplot), or in .txt. csv and json have the corners of "
             "all dominoes (in m for a row). For a train they also have the contacts and forces.",
     .equation = "(12; b8) (27; A2)",
     .example = "draw 0.3",
     .see = "chain animate plot row fall",
     .sweep.refusal = "it draws",
     .writes = WRITES_PICTURES,
     .rows = true,
     ANSWER(draw)},
    {.name = NULL},
};
