/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planning/plan_tables.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct dom_window *plan_window(const struct plan *p, enum dom_window_of kind, size_t k)
{
    return &p->windows.kind[kind][k];
}

/* ---- Texts ---- */

/* Writes a length in mm with one decimal, rounded down if `round` is -1, up if it is 1, and to the nearest if
 * it is 0. */
static void mm(char cell[GUIDE_CELL], domq_real metres, int round)
{
    double tenths = 10000 * (double)metres;
    tenths = round < 0 ? floor(tenths + 1e-6) : round > 0 ? ceil(tenths - 1e-6) : rint(tenths);
    if (isfinite(tenths))
        snprintf(cell, GUIDE_CELL, "%.1f", tenths / 10);
}

/* Writes a value into a cell, and the limits of its window into the next two cells. The three cells are bold
 * if the domino has the tightest limits of all dominoes, for this kind of window. */
static void window_put(struct guide_line *line, int at, const struct plan *p, enum dom_window_of kind,
                       size_t k, domq_real now)
{
    const struct dom_window *w = plan_window(p, kind, k);
    mm(line->cell[at], now, 0);
    mm(line->cell[at + 1], w->low, 1);
    mm(line->cell[at + 2], w->high, -1);
    for (int i = 0; i < 3; i++)
        line->bold[at + i] = p->windows.critical[kind] == k + 1;
}

/* A box is empty inside if its thickness is more than this above that of two walls, in m. */
#define THIN ((domq_real)1 / 5000)

static bool is_box(const struct plan *p, size_t k)
{
    const struct domq_row *row = &p->row.run.scene.row;
    return row->walls > 0 && p->row.run.scene.domino[k].height > row->boxes_above;
}

static struct guide_table *table_add(struct plan *p, const char *title, const char *note, size_t count)
{
    struct guide_table *table = &p->guide.table[p->guide.tables++];
    *table = (struct guide_table){
        .title = title, .note = note, .line = calloc(count, sizeof *table->line), .count = count};
    return table->line ? table : NULL;
}

#define TAPE                                                                                                 \
    "In mm, on a tape whose zero is at the back of domino 1. If only one domino is moved, and its back "     \
    "stays between 'least' and 'most', all dominoes still fall."

bool plan_has_leans(const struct plan *p)
{
    bool has_leans = false;
    for (size_t k = 0; k < p->row.run.scene.row.count; k++)
        has_leans = has_leans || p->row.run.scene.domino[k].lean != 0;
    return has_leans;
}

bool plan_tape_table(struct plan *p)
{
    const struct scene_row *scene = &p->row.run.scene;
    const bool has_leans = plan_has_leans(p);
    struct guide_table *table = table_add(
        p, "For the hall: where the dominoes stand",
        has_leans ? TAPE " 'lean' is how far the top is off plumb; a negative lean is backwards." : TAPE,
        scene->row.count);
    const char *const head[] = {"domino", "back", "least", "most", "front", "gap", has_leans ? "lean" : NULL};
    if (!table)
        return false;
    memcpy(table->head, head, sizeof head);
    for (size_t k = 0; k < table->count; k++) {
        struct guide_line *line = &table->line[k];
        snprintf(line->cell[0], GUIDE_CELL, "%zu", k + 1);
        window_put(line, 1, p, DOM_WINDOW_PLACE, k, (domq_real)p->back[k]);
        mm(line->cell[4], (domq_real)p->back[k] + scene->domino[k].thickness, 0);
        if (k > 0)
            mm(line->cell[5], scene->domino[k].gap, 0);
        if (has_leans)
            mm(line->cell[6], lean_offset(&scene->domino[k]), 0);
    }
    return true;
}

bool plan_size_table(struct plan *p, const struct scene *of)
{
    const struct scene_row *scene = &p->row.run.scene;
    const bool has_boxes = scene->row.walls > 0, has_masses = scene_has_masses(of);
    domq_real heaviest = 0;
    for (size_t k = 0; k < scene->row.count; k++)
        heaviest = scene->domino[k].mass > heaviest ? scene->domino[k].mass : heaviest;
    const struct measure unit = scene_mass_measure(of, heaviest);
    const char *masses = ", and masses are divided by the mass of domino 1";
    snprintf(p->sizes, sizeof p->sizes,
             "%s%s%s. If only one height or thickness changes, and stays between 'least' and 'most', all "
             "dominoes still fall.%s",
             has_masses ? "In mm" : "Lengths are in mm", has_masses ? " and " : masses,
             has_masses ? unit.unit : "", has_boxes ? " 'any': as thin as the boards allow." : "");
    struct guide_table *table =
        table_add(p, "For the workshop: the sizes of the dominoes", p->sizes, scene->row.count);
    const char *const head[] = {"domino", "height",    "least",
                                "most",   "thickness", "least",
                                "most",   "width",     has_masses ? "mass" : "relative"};
    if (!table)
        return false;
    memcpy(table->head, head, sizeof head);
    for (size_t k = 0; k < table->count; k++) {
        const struct domq_domino *d = &scene->domino[k];
        struct guide_line *line = &table->line[k];
        snprintf(line->cell[0], GUIDE_CELL, "%zu", k + 1);
        window_put(line, 1, p, DOM_WINDOW_HEIGHT, k, d->height);
        window_put(line, 4, p, DOM_WINDOW_THICKNESS, k, d->thickness);
        if (is_box(p, k) && plan_window(p, DOM_WINDOW_THICKNESS, k)->low < 2 * scene->row.walls + THIN)
            snprintf(line->cell[5], GUIDE_CELL, "any");
        mm(line->cell[7], d->width, 0);
        snprintf(line->cell[8], GUIDE_CELL, "%.4g",
                 (double)(has_masses ? measure_number(unit, d->mass) : d->mass / scene->domino[0].mass));
    }
    return true;
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

bool plan_board_table(struct plan *p)
{
    const size_t count = p->row.run.scene.row.count;
    struct piece *piece = malloc(3 * count * sizeof *piece);
    size_t pieces = 0;
    if (!piece)
        return false;
    for (size_t k = 0; k < count; k++)
        pieces += pieces_of(p, k, piece + pieces);
    qsort(piece, pieces, sizeof *piece, piece_order);
    struct guide_table *table = table_add(
        p, "For the workshop: boards to cut, by thickness",
        p->is_thin
            ? "In mm. The dominoes are hollow, with walls as thin as paper; 'set walls 12 mm' makes them "
              "boxes of boards 12 mm thick."
        : p->row.run.scene.row.boxes_above > 0 ? "In mm. A solid block is one piece. Each box has a front "
                                                 "and a back, two sides between them, and a bottom and a top."
        : p->row.run.scene.row.walls > 0
            ? "In mm. Each box has a front and a back, two sides between them, and a bottom and a top."
            : "In mm. A solid block is one piece.",
        pieces);
    static const char *const head[] = {"board", "domino", "pieces", "length", "width"};
    if (table) {
        memcpy(table->head, head, sizeof head);
        for (size_t i = 0; i < pieces; i++) {
            struct guide_line *line = &table->line[i];
            if (piece[i].board > 0 && (i == 0 || fabs(piece[i].board - piece[i - 1].board) > 5e-5))
                mm(line->cell[0], (domq_real)piece[i].board, 0);
            snprintf(line->cell[1], GUIDE_CELL, "%zu", piece[i].domino);
            snprintf(line->cell[2], GUIDE_CELL, "%d", piece[i].count);
            mm(line->cell[3], (domq_real)piece[i].length, 0);
            mm(line->cell[4], (domq_real)piece[i].width, 0);
        }
    }
    free(piece);
    return table;
}
