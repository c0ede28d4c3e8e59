/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planning/plan_tables.h"
#include <math.h>
#include <stdlib.h>

const struct dom_window *plan_window(const struct plan *p, enum dom_window_of kind, size_t k)
{
    return &p->windows.kind[kind][k];
}

/* ---- Texts ---- */

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
 * limits of all dominoes, for this kind of window. If `is_any` is true, there is no lower limit. */
static void window_put(const struct plan *p, enum dom_window_of kind, size_t k, domq_real now, bool is_any)
{
    const struct dom_window *w = plan_window(p, kind, k);
    const bool is_critical = p->windows.critical[kind] == k + 1;
    FILE *out = p->paper.out;
    mm(out, now, 0, is_critical);
    if (is_any)
        fprintf(out, "|any%s", is_critical ? "!" : "");
    else
        mm(out, w->low, 1, is_critical);
    mm(out, w->high, -1, is_critical);
}

/* A box is empty inside if its thickness is more than this above that of two walls, in m. */
#define THIN ((domq_real)1 / 5000)

static bool is_box(const struct plan *p, size_t k)
{
    const struct domq_row *row = &p->row.run.scene.row;
    return row->walls > 0 && p->row.run.scene.domino[k].height > row->boxes_above;
}

bool plan_has_leans(const struct plan *p)
{
    bool has_leans = false;
    for (size_t k = 0; k < p->row.run.scene.row.count; k++)
        has_leans = has_leans || p->row.run.scene.domino[k].lean != 0;
    return has_leans;
}

void plan_tape_table(const struct plan *p)
{
    const struct scene_row *scene = &p->row.run.scene;
    const bool has_leans = plan_has_leans(p);
    FILE *out = p->paper.out;
    fprintf(out,
            "# For the hall: where the dominoes stand\nIn mm, on a tape whose zero is at the back of domino "
            "1. If only one domino is moved, and its back stays between 'least' and 'most', all dominoes "
            "still fall.%s\n|domino|back|least|most|front|gap%s\n",
            has_leans ? " 'lean' is how far the top is off plumb; a negative lean is backwards." : "",
            has_leans ? "|lean" : "");
    for (size_t k = 0; k < scene->row.count; k++) {
        const struct domq_domino *d = &scene->domino[k];
        fprintf(out, "|%zu", k + 1);
        window_put(p, DOM_WINDOW_PLACE, k, (domq_real)p->back[k], false);
        mm(out, (domq_real)p->back[k] + d->thickness, 0, false);
        mm(out, k > 0 ? d->gap : DOMQ_NAN, 0, false);
        if (has_leans)
            mm(out, lean_offset(d), 0, false);
        putc('\n', out);
    }
}

void plan_size_table(const struct plan *p, const struct scene *of)
{
    const struct scene_row *scene = &p->row.run.scene;
    const bool has_boxes = scene->row.walls > 0, has_masses = scene_has_masses(of);
    domq_real heaviest = 0;
    FILE *out = p->paper.out;
    for (size_t k = 0; k < scene->row.count; k++)
        heaviest = scene->domino[k].mass > heaviest ? scene->domino[k].mass : heaviest;
    const struct measure unit = scene_mass_measure(of, heaviest);
    fputs("# For the workshop: the sizes of the dominoes\n", out);
    if (has_masses)
        fprintf(out, "In mm and %s.", unit.unit);
    else
        fputs("Lengths are in mm, and masses are divided by the mass of domino 1.", out);
    fprintf(out,
            " If only one height or thickness changes, and stays between 'least' and 'most', all dominoes "
            "still fall.%s\n|domino|height|least|most|thickness|least|most|width|%s\n",
            has_boxes ? " 'any': as thin as the boards allow." : "", has_masses ? "mass" : "relative");
    for (size_t k = 0; k < scene->row.count; k++) {
        const struct domq_domino *d = &scene->domino[k];
        fprintf(out, "|%zu", k + 1);
        window_put(p, DOM_WINDOW_HEIGHT, k, d->height, false);
        window_put(p, DOM_WINDOW_THICKNESS, k, d->thickness,
                   is_box(p, k) &&
                       plan_window(p, DOM_WINDOW_THICKNESS, k)->low < 2 * scene->row.walls + THIN);
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

bool plan_board_table(const struct plan *p)
{
    const struct domq_row *row = &p->row.run.scene.row;
    const size_t count = row->count;
    FILE *out = p->paper.out;
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
