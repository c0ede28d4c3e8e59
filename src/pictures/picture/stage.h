/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A stage is a picture of dominoes at one moment, with a caption and a ruler. If it shows a row, lengths are
 * in m. If it shows the endless train, the unit of length is the height of the head, which is domino 0. A
 * stage can be drawn with characters, or written as a gnuplot script. */
#pragma once

#include "answer/cell.h"
#include "pictures/picture/picture.h"
#include "precision/any.h"

enum {
    CORNERS = 4,
    ARC = 5, /* the number of points on a rounded edge */
    /* The maximum number of points of an outline. Three edges of a domino can be rounded, and an arc has ARC
     * points. The lower back edge is always sharp. */
    OUTLINE = 3 * ARC + 1,
};

struct point {
    double x, y;
};

/* The state of a domino, which determines its colour. */
enum part { STANDS, FALLS, HEAD, WEAKEST, ENDS, PARTS };

/* Special values of drawn.number. */
enum {
    NUMBER_NEXT = -1, /* the domino in front of the head of a train */
    NUMBER_TOWER = -2 /* the silhouette of a tower */
};

struct drawn {
    /* the number of the domino; the first domino of a row is 1, and the head of a train is 0 */
    int number;
    enum part part;
    double height, thickness, theta;
    double foot;   /* the position of the hinge, the lower front edge of the upright domino */
    double radius; /* the radius of the rounded edges, or 0 for sharp edges */
    /* The corners without rounding: front foot, front top, back top and back foot. */
    struct point corner[CORNERS];
    bool touched;         /* the follower of this domino touches it */
    struct point contact; /* where the follower touches the domino; valid only if `touched` is true */
    /* In a train: the push at the contact, in units of the weight of the head (`force`) and of this domino
     * (`of_own`). NaN if the push is not known. */
    double force, of_own;
};

enum { CAPTION = 1024 };

struct stage {
    struct drawn *domino; /* a row begins with domino 1, and a train with the foremost domino */
    size_t count;
    double left, right, top; /* the limits of the visible part */
    /* A film can follow the fall. The visible part then has the height `tall`, and `at` is near its middle.
     * If `tall` is 0, the limits above apply. */
    double at, tall;
    /* The unit of all lengths. For a train, it is "h". For a row, the pointer is NULL: lengths are in m, and
     * the ruler shows them in mm, cm or m. */
    const char *unit;
    const char *ruler;     /* what the ruler measures */
    bool forces;           /* the picture shows the forces that are known */
    char caption[CAPTION]; /* caption of one or more lines */
};

/* Returns the point at a given distance from a point in the direction (x, y). */
static inline struct point along(struct point from, double distance, double x, double y)
{
    return (struct point){from.x + distance * x, from.y + distance * y};
}

/* Computes the corners of a domino from its size, foot and tilt. A rounded domino rolls as it tilts. */
void drawn_corners(struct drawn *domino);

/* Writes the points of the outline of a domino. Returns the number of points. */
int drawn_outline(const struct drawn *domino, struct point outline[OUTLINE]);

/* The name of a domino below it: its number, "next", "tower" or "person"; and what the name covers. */
struct drawn_name {
    char text[16];
    double from, to;
    bool is_weakest;
};

/* Finds the names for which there is room between `left` and `right`, in letters of this width, with the
 * space `apart` between names. If `snaps` is true, each letter has a column of its own. Marked dominoes come
 * first. Then come the dominoes at the front, where the largest ones usually are. Returns the number of
 * names. */
enum { NAMES = 256 };
int stage_names(const struct stage *stage, double letter, double apart, bool snaps, double left, double right,
                struct drawn_name name[NAMES]);

/* Returns true if a domino is touched at its hinge, which happens if r s = 1. No push can turn such a domino.
 * Valid only after stage_forces. */
bool drawn_locked(const struct drawn *domino);

/* Returns true for the weakest domino, and for the domino at which the fall ends. */
static inline bool drawn_marked(const struct drawn *domino)
{
    return domino->part == WEAKEST || domino->part == ENDS;
}

/* Returns domino k, counted from 0 at the end towards which the dominoes fall. */
const struct drawn *stage_front(const struct stage *stage, size_t k);

/* Makes a stage that shows the train when its head is at the tilt `theta`, 0 <= theta <= theta_c. Even after
 * an error, the caller must free stage->domino. */
enum dom_status stage_train(struct stage *stage, const struct domq_train *train,
                            const struct any_compute *compute, domq_real theta);

/* Adds the contact forces to a train on a stage. Returns the status of dom_cycle_forces. */
enum dom_status stage_forces(struct stage *stage, const struct domq_train *train,
                             const struct any_compute *compute, domq_real theta);

/* Returns the unit that the ruler shows. For a train, this is h, the height of its head, with the size 1. For
 * a row, it is a metric unit that suits `across`, the width of the visible part of the stage. */
struct axis_unit stage_unit(const struct stage *stage, double across);

/* Draws a stage to the destination of the answer. A terminal shows it in characters. */
bool stage_show(const struct stage *stage, const struct answer *a, struct problem *problem);

/* ---- In characters ---- */

/* Draws a stage with its caption in at most `width` columns and `height` rows. Returns false if memory runs
 * out. */
bool stage_text(const struct stage *stage, struct display display, int width, int height, FILE *out);

/* ---- By gnuplot ---- */

/* The part of the stage that a picture shows, and the height of the picture in dots. */
struct sheet {
    double height, below, above; /* `below` and `above` are margins outside the axes */
    double head, indent;         /* the space above the caption, and the space to its left */
    /* The visible part of the stage. Labels of the dominoes are below the ground. */
    double left, right, high;
    double dot; /* the size of a dot, in the unit of the stage */
};

/* Returns the sheet for a stage, with a height between `least` and `most` dots. */
struct sheet sheet_of(const struct stage *stage, double least, double most);

/* Draws a dot in each colour into a frame. A gif has only the colours of its first frame, so this frame
 * must contain all colours. The last dot is white and covers the others. `shift` changes this white slightly.
 * It must alternate between 0 and 1, because gnuplot omits a frame that equals the previous one. */
void sheet_palette(const struct sheet *sheet, int shift, FILE *script);

/* Writes the commands with which gnuplot draws a stage on a sheet. In a film that follows the fall, the
 * height stage->tall includes the strip for labels below the ground. */
void stage_script(const struct stage *stage, const struct sheet *sheet, FILE *script);

/* ---- Pages for printing (paper.c): a stage at the top, with text and tables below it ---- */

/* A paper is a document in a simple markup, in lines:
 * - "# HEADING" begins a part, which stays on one page if it fits.
 * - "|CELL|CELL" is a row of a table, whose first row is its head. An empty cell has room for handwriting; a
 *   cell with a blank does not.
 * - "\f" begins a new page.
 * - Any other line is text, which is broken into lines that fit. */

/* Writes a paper as plain text. */
void paper_write(const char *paper, FILE *out);

/* Draws a title (or NULL), a stage and a paper into the file of the answer. A .pdf file has A4
 * pages, like the .pdf file that a .gp script draws. Other pictures have one long page. On failure, sets
 * *problem and returns false. */
bool paper_draw(const char *paper, const char *title, const struct stage *stage, const struct answer *a,
                struct problem *problem);
