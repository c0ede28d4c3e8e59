/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'plan', which writes a guide for building the row. */
#include "chance/chance.h"
#include "io/io.h"
#include "language/quad.h"
#include "pictures/drawing/falling_row.h"
#include "planning/planning.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct column plan_columns[] = {
    {"domino", "", "number of the domino, from 1", 6},
    {"back", "m", "distance from the back of domino 1 to the back of this domino", 0},
    {"front", "m", "distance from the back of domino 1 to the front of this domino", 0},
    {"back_low", "m",
     "the smallest value of 'back' at which all dominoes still fall, if only this domino is moved", 0},
    {"back_high", "m",
     "the largest value of 'back' at which all dominoes still fall, if only this domino is moved", 0},
    {"gap", "m", "clear distance to the domino before it", 0},
    {"height", "m", "height of the domino", 0},
    {"height_low", "m", "the smallest height at which all dominoes still fall, if only this height changes",
     0},
    {"height_high", "m", "the largest height at which all dominoes still fall, if only this height changes",
     0},
    {"thickness", "m", "thickness of the domino", 0},
    {"thickness_low", "m",
     "the smallest thickness at which all dominoes still fall, if only this thickness changes", 0},
    {"thickness_high", "m",
     "the largest thickness at which all dominoes still fall, if only this thickness changes", 0},
    {"width", "m", "width of the domino", 0},
    {"lean", "m", "how far the top is off plumb, if the dominoes lean (negative: backwards)", 0},
    {"mass", "kg", "mass of the domino, if masses are known", 0},
    {NULL, NULL, NULL, 0},
};

bool plan_parse(struct reader *r, struct question *q)
{
    const char **title = q->parsed = reader_memory(r, sizeof *title);
    if (!title)
        return false;
    if (!reader_takes(r, "title"))
        return reader_ends(r) || problem_error(r->problem, "write a title as in 'plan title \"The hall\"'");
    reader_place(r, r->at);
    if (reader_ends(r))
        return problem_error(r->problem,
                             "the title is missing; write, for example, 'plan title \"The hall\"'");
    *title = read_word(r, WORD_TYPED);
    return *title != NULL;
}

/* A row that falls, and what a builder must know about it. */
struct plan {
    struct falling_row row;
    struct windows windows;
    double *back; /* positions of the dominoes' back edges on the tape measure, in m */
    bool is_thin; /* the dominoes are hollow, and the thickness of their walls is not known */
    bool has_leans;
    struct dom_study study;
    struct dom_random_error error[DOM_ERROR_COUNT];
    char *paper; /* the tables of the guide, in the markup of paper_draw, which are written to `out` */
    FILE *out;
};

/* ---- The numbers ---- */

/* The number of random rows. A row takes hundreds of times as long in the engine as in the model. */
enum { STUDY_ROWS = 2000, STUDY_ROWS_OF_ENGINE = 50 };

static void plan_free(struct plan *p)
{
    free(p->paper);
    free(p->windows.kind[0]);
    free(p->back);
    falling_row_free(&p->row);
}

/* After a failure nothing needs to be freed. */
static bool plan_make(const struct query *query, struct problem *problem, struct plan *p)
{
    const struct scene *of = query->scene;
    *p = (struct plan){.is_thin = !row_has_file(of) && of->train.q < 4 && scene_walls(of) == 0};
    if (!falling_row_make(query, problem, false, &p->row))
        return false;
    struct scene_row *scene = &p->row.run.scene;
    const struct domq_verdict *v = &p->row.run.verdict;
    const size_t count = scene->row.count;
    if (v->end != DOM_ROW_FALLS) {
        problem_no_answer(problem,
                          "the fall ends at domino %zu, so there is nothing to build yet; 'mend' looks for a "
                          "change that saves the row",
                          v->domino);
        falling_row_free(&p->row);
        return false;
    }
    p->back = malloc(count * sizeof *p->back);
    const enum dom_status status = p->back ? windows_find(query, scene, &p->windows) : DOM_NO_MEMORY;
    for (size_t k = 0; k < count && p->back; k++) {
        p->back[k] =
            k > 0 ? p->back[k - 1] + (double)(scene->domino[k - 1].thickness + scene->domino[k].gap) : 0;
        p->has_leans = p->has_leans || scene->domino[k].lean != 0;
    }
    const size_t rows = scene->row.engine ? STUDY_ROWS_OF_ENGINE : STUDY_ROWS;
    const bool good =
        row_status(query, problem, status) && study_run(query, problem, rows, &p->study, p->error);
    if (!good)
        plan_free(p);
    return good;
}

/* ---- The caption ---- */

static void caption_write(struct plan *p)
{
    char errors[ERRORS_TEXT], summary[SENTENCE], verdict[SENTENCE], weakest[SENTENCE], start[SENTENCE];
    struct stage *stage = &p->row.stage;
    const struct dom_study *s = &p->study;
    const size_t *critical = p->windows.critical;
    falling_row_summary(&p->row, summary);
    falling_row_verdict(&p->row, verdict);
    falling_row_weakest(&p->row, weakest);
    errors_text(p->error, true, errors);
    falling_row_begin(&p->row, start);
    int at = snprintf(stage->caption, CAPTION, "%s, on %s of floor. %s %s%s%s", summary,
                      measured((domq_real)stage->right, "m", 3).text, start, verdict, *weakest ? " " : "",
                      weakest);
    char *text = stage->caption + at;
    const size_t room = CAPTION - (size_t)at;
    if (s->rows > 0)
        at = snprintf(text, room,
                      " With errors (%s), %zu of %zu rows fall; the probability is %.1f to %.1f %%, with 95 "
                      "%% confidence.",
                      errors, s->fall, s->rows, floor(1000 * s->low) / 10, ceil(1000 * s->high) / 10);
    else
        at = snprintf(text, room,
                      " To see how likely the row is to fall, turn on random errors, for example with 'set "
                      "placement 2 mm'.");
    if (p->windows.count > 1 && at < (int)room)
        snprintf(
            text + at, room - (size_t)at,
            " What matters most (! in the tables): the place of domino %zu, the height of domino %zu and "
            "the thickness of domino %zu.",
            critical[DOM_WINDOW_PLACE], critical[DOM_WINDOW_HEIGHT], critical[DOM_WINDOW_THICKNESS]);
}

/* ---- The tables ---- */

/* Writes a cell with a length in mm with one decimal, rounded down if `round` is -1, up if it is 1, and to
 * the nearest if it is 0. A '!' marks a length that `is_critical`. */
static void mm(FILE *out, domq_real metres, int round, bool is_critical)
{
    double tenths = 10000 * (double)metres;
    tenths = round < 0 ? floor(tenths + 1e-6) : round > 0 ? ceil(tenths - 1e-6) : rint(tenths);
    if (isfinite(tenths))
        fprintf(out, "|%.1f%s", tenths / 10, is_critical ? "!" : "");
    else
        fputs("| ", out);
}

/* Writes cells with a value and the limits of its window. They are marked if the domino has the tightest
 * limits of all dominoes, for this kind of window. */
static void window_put(const struct plan *p, enum dom_window_of kind, size_t k, domq_real now)
{
    const struct dom_window *w = &p->windows.kind[kind][k];
    const bool is_critical = p->windows.critical[kind] == k + 1;
    FILE *out = p->out;
    mm(out, now, 0, is_critical);
    mm(out, w->low, 1, is_critical);
    mm(out, w->high, -1, is_critical);
}

static void plan_tape_table(const struct plan *p)
{
    const struct scene_row *scene = &p->row.run.scene;
    FILE *out = p->out;
    fprintf(out,
            "# For the hall: where the dominoes stand\nIn mm, on a tape whose zero is at the back of domino "
            "1. If only one domino is moved, and its back stays between 'least' and 'most', all dominoes "
            "still fall.%s\n|domino|back|least|most|front|gap%s\n",
            p->has_leans ? " 'lean' is how far the top is off plumb; a negative lean is backwards." : "",
            p->has_leans ? "|lean" : "");
    for (size_t k = 0; k < scene->row.count; k++) {
        const struct domq_domino *d = &scene->domino[k];
        fprintf(out, "|%zu", k + 1);
        window_put(p, DOM_WINDOW_PLACE, k, (domq_real)p->back[k]);
        mm(out, (domq_real)p->back[k] + d->thickness, 0, false);
        mm(out, k > 0 ? d->gap : DOMQ_NAN, 0, false);
        if (p->has_leans)
            mm(out, lean_offset(d), 0, false);
        putc('\n', out);
    }
}

static void plan_size_table(const struct plan *p, const struct scene *of)
{
    const struct scene_row *scene = &p->row.run.scene;
    const bool has_masses = scene_has_masses(of);
    domq_real heaviest = 0;
    FILE *out = p->out;
    for (size_t k = 0; k < scene->row.count; k++)
        heaviest = scene->domino[k].mass > heaviest ? scene->domino[k].mass : heaviest;
    const struct measure unit = measure_of("kg", heaviest);
    fputs("# For the workshop: the sizes of the dominoes\n", out);
    if (has_masses)
        fprintf(out, "In mm and %s.", unit.unit);
    else
        fputs("Lengths are in mm, and masses are divided by the mass of domino 1.", out);
    fprintf(out,
            " If only one height or thickness changes, and stays between 'least' and 'most', all dominoes "
            "still fall.\n|domino|height|least|most|thickness|least|most|width|%s\n",
            has_masses ? "mass" : "relative");
    for (size_t k = 0; k < scene->row.count; k++) {
        const struct domq_domino *d = &scene->domino[k];
        fprintf(out, "|%zu", k + 1);
        window_put(p, DOM_WINDOW_HEIGHT, k, d->height);
        window_put(p, DOM_WINDOW_THICKNESS, k, d->thickness);
        mm(out, d->width, 0, false);
        fprintf(out, "|%.4g\n",
                (double)(has_masses ? measure_number(unit, d->mass) : d->mass / scene->domino[0].mass));
    }
}

/* ---- Boards ---- */

/* Pieces of equal size that are cut from one board for one domino. */
struct piece {
    double board, length, width; /* m */
    size_t domino;
    int count;
};

/* Orders the pieces by the thickness of their boards, then by the number of the domino, and then by length,
 * with the longest piece first. */
static int piece_order(const void *one, const void *other)
{
    const struct piece *a = one, *b = other;
    return fabs(a->board - b->board) > 5e-5 ? (a->board < b->board ? -1 : 1)
           : a->domino != b->domino         ? (a->domino < b->domino ? -1 : 1)
                                            : (a->length > b->length ? -1 : 1);
}

/* Lists the pieces of wood for one domino. A solid block is one piece. A box consists of six boards: three
 * pairs of equal boards. Returns the number of different pieces, which is 1 or 3. */
static size_t pieces_of(const struct plan *p, size_t k, struct piece piece[3])
{
    const struct scene_row *scene = &p->row.run.scene;
    const struct domq_domino *d = &scene->domino[k];
    const struct domq_row *row = &scene->row;
    const double walls = d->height > row->boxes_above ? (double)row->walls : 0, height = (double)d->height,
                 thick = (double)d->thickness, width = (double)d->width, inside = thick - 2 * walls;
    if (!p->is_thin && !(walls > 0 && inside > 1e-6 && width - 2 * walls > 1e-6)) {
        piece[0] = (struct piece){thick, height, width, k + 1, 1};
        return 1;
    }
    piece[0] = (struct piece){walls, height, width, k + 1, 2};
    piece[1] = (struct piece){walls, height, inside, k + 1, 2};
    piece[2] = (struct piece){walls, width - 2 * walls, inside, k + 1, 2};
    return 3;
}

static bool plan_board_table(const struct plan *p)
{
    const struct domq_row *row = &p->row.run.scene.row;
    const size_t count = row->count;
    FILE *out = p->out;
    struct piece *piece = malloc(3 * count * sizeof *piece);
    size_t pieces = 0;
    if (!piece)
        return false;
    for (size_t k = 0; k < count; k++)
        pieces += pieces_of(p, k, piece + pieces);
    qsort(piece, pieces, sizeof *piece, piece_order);
    fprintf(out,
            "# For the workshop: boards to cut, by thickness\nIn mm. %s\n|board|domino|pieces|length|width\n",
            p->is_thin ? "The dominoes are hollow, with walls as thin as paper; 'set walls 12 mm' makes them "
                         "boxes of boards 12 mm thick."
            : row->boxes_above > 0 ? "A solid block is one piece. Each box has a front and a back, two sides "
                                     "between them, and a bottom and a top."
            : row->walls > 0
                ? "Each box has a front and a back, two sides between them, and a bottom and a top."
                : "A solid block is one piece.");
    for (size_t i = 0; i < pieces; i++) {
        const struct piece *of = &piece[i];
        const bool is_new = of->board > 0 && (i == 0 || fabs(of->board - of[-1].board) > 5e-5);
        mm(out, is_new ? (domq_real)of->board : DOMQ_NAN, 0, false);
        fprintf(out, "|%zu|%d", of->domino, of->count);
        mm(out, (domq_real)of->length, 0, false);
        mm(out, (domq_real)of->width, 0, false);
        putc('\n', out);
    }
    free(piece);
    return true;
}

/* ---- The answer ---- */

static void plan_rows(const struct plan *p, struct answer *a)
{
    const struct scene_row *scene = &p->row.run.scene;
    for (size_t k = 0; k < scene->row.count && !answer_lost(a); k++) {
        const struct domq_domino *d = &scene->domino[k];
        const struct dom_window *place = &p->windows.kind[DOM_WINDOW_PLACE][k],
                                *height = &p->windows.kind[DOM_WINDOW_HEIGHT][k],
                                *thickness = &p->windows.kind[DOM_WINDOW_THICKNESS][k];
        const domq_real back = (domq_real)p->back[k];
        answer_cells(a, cell_count((domq_real)k + 1), cell_real(back), cell_real(back + d->thickness),
                     cell_real(place->low), cell_real(place->high), cell_real(d->gap), cell_real(d->height),
                     cell_real(height->low), cell_real(height->high), cell_real(d->thickness),
                     cell_real(thickness->low), cell_real(thickness->high), cell_real(d->width),
                     cell_real(lean_offset(d)), cell_real(d->mass));
    }
}

enum { TEXT_WIDTH = 79, TEXT_HEIGHT = 30 }; /* the size of the drawing in characters */

/* Writes the guide as text into a file, or into the details of a short answer. */
static bool plan_text(const struct plan *p, const char *title, struct answer *a)
{
    const struct scene_row *scene = &p->row.run.scene;
    FILE *const out = a->path ? a->out : answer_rest(a);
    if (!out)
        return false;
    if (title)
        fprintf(out, "%s\n", title);
    if (!stage_text(&p->row.stage, display_of(out), TEXT_WIDTH, TEXT_HEIGHT, out))
        return false;
    paper_write(p->paper, out);
    fputs("\n'plan > hall.pdf' draws this guide for printing.\n", out);
    if (a->path)
        return true;
    answer_say(
        a, "%zu domino%s with feet on %s of floor: 'details' prints the guide, 'plan > hall.pdf' draws it.",
        scene->row.count, scene->row.count == 1 ? "" : "es",
        measured((domq_real)p->back[scene->row.count - 1] + scene->domino[scene->row.count - 1].thickness,
                 "m", 3)
            .text);
    return true;
}

static bool guide_write(struct plan *p, const struct scene *scene)
{
    size_t size;
    p->out = io_memory(&p->paper, &size);
    if (!p->out)
        return false;
    plan_tape_table(p);
    plan_size_table(p, scene);
    const bool is_complete = plan_board_table(p);
    return fclose(p->out) == 0 && is_complete;
}

bool run_plan(const struct query *query, struct answer *a, struct problem *problem)
{
    struct plan p;
    const char *const *title = query->given->bound;
    const bool has_masses = scene_has_masses(query->scene), people = answer_for_people(a),
               is_drawn = a->path && extension_of(a->path)->kind == EXTENSION_SHEET;
    if (!plan_make(query, problem, &p))
        return false;
    if (!has_masses)
        answer_leave_out(a, "mass");
    if (!p.has_leans)
        answer_leave_out(a, "lean");
    caption_write(&p);
    bool good = true;
    if (!people && !is_drawn)
        plan_rows(&p, a);
    else if (!guide_write(&p, query->scene))
        good = problem_status(problem, query->scene, DOM_NO_MEMORY);
    else if (is_drawn)
        good = paper_draw(p.paper, title ? *title : NULL, &p.row.stage, a, problem);
    else
        good =
            plan_text(&p, title ? *title : NULL, a) || problem_status(problem, query->scene, DOM_NO_MEMORY);
    plan_free(&p);
    return good;
}
