/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A picture of dominoes. A stage holds the dominoes as they stand, lean or lie at one moment, with a caption
 * and a ruler. For a row, lengths are in m. For the endless train, they are in heights of the head, which is
 * domino 0. Two painters can draw a stage: one with characters, and one as a gnuplot script, which is also
 * used for each frame of a film.
 */
#ifndef SHELL_STAGE_H
#define SHELL_STAGE_H

#include "answer/measure.h"
#include "domino_quad.h"
#include "picture/canvas.h"

enum {
    CORNERS = 4,
    ARC = 5, /* the number of points on a rounded edge */
    /* the maximum number of points of an outline, whose lower back edge is always sharp */
    OUTLINE = 3 * ARC + 1,
};

struct point {
    double x, y;
};

/* The state of a domino, which determines its colour. */
enum part { STANDS, FALLS, HEAD, WEAKEST, ENDS, PARTS };

/* Special values of drawn.number. NUMBER_NEXT is the domino in front of the head of a train, and NUMBER_NONE
 * is a domino without a label. NUMBER_TOWER and NUMBER_PERSON stand for a silhouette of a tower or a person,
 * which is drawn instead of the domino. */
enum { NUMBER_NEXT = -1, NUMBER_NONE = -2, NUMBER_TOWER = -3, NUMBER_PERSON = -4 };

struct drawn {
    /* the number of the domino: in a row, counted from 1; in a train, 0 is the head, and 1, 2, ... are its
     * followers */
    int number;
    enum part part;
    double height, thickness, theta;
    double foot;   /* the position of the hinge, which is the lower front edge of an upright domino */
    double radius; /* the radius of the rounded edges, or 0 for sharp edges */
    /* The corners that the domino would have with sharp edges: front foot, front top, back top and back
     * foot. */
    struct point corner[CORNERS];
    bool touched;         /* the follower of this domino touches it */
    struct point contact; /* where the follower touches the domino; NaN without contact */
    /* The push at the contact: `force` is relative to the weight of the head, and `of_own` to the weight of
     * this domino. Both are NaN if the push is not known. */
    double force, of_own;
};

enum { CAPTION = 1024 };

struct stage {
    struct drawn *domino; /* the dominoes, each of which is drawn over all later ones */
    size_t count;
    double left, right, top; /* the limits of the visible part */
    /* the unit of lengths: "h", or NULL for m; lengths in m are shown in mm, cm or m */
    const char *unit;
    const char *ruler; /* what the ruler measures */
    /* the sizes of the dominoes, which are written where there is room, or NULL to write no sizes */
    const struct domq_domino *row;
    bool forces;           /* the picture shows the forces that are known */
    char caption[CAPTION]; /* caption of one or more lines */
};

/* The words with which a caption explains how the painter marks dominoes. */
struct marks {
    const char *theta, *weakest, *ends;
    const char *contacts; /* explains the marks at contacts in a picture of a train */
    /* explains the arrows for forces, or NULL if the caption lists the forces instead */
    const char *forces;
};

/* Returns the point at a given distance from a point in the direction (x, y). */
static inline struct point along(struct point from, double distance, double x, double y)
{
    return (struct point){from.x + distance * x, from.y + distance * y};
}

/* Computes the corners of a domino from its dimensions, its foot and its tilt. A domino with rounded edges
 * rolls away from its foot as it tilts. */
void drawn_stand(struct drawn *domino);

/* Writes the points of the outline of a domino. Returns the number of points. */
int drawn_outline(const struct drawn *domino, struct point outline[OUTLINE]);

/* Returns true if the shape of a domino covers a point. `up` is the height of the point as a fraction of the
 * domino's height. `back` is its distance from the front as a fraction of the thickness. A domino covers its
 * whole rectangle, and a silhouette only a part of it. */
bool drawn_covers(const struct drawn *domino, double up, double back);

/* Writes the text below a domino: its number, "next", "tower", "person" or nothing. Returns the length of the
 * text. */
enum { DRAWN_NAME = 16 };
int drawn_name(const struct drawn *domino, char name[DRAWN_NAME]);

/* Returns true for a domino that is touched at its hinge (r s = 1), so that no push can turn it. */
bool drawn_locked(const struct drawn *domino);

/* Returns true for the weakest domino, and for the domino at which a row ends. */
static inline bool drawn_marked(const struct drawn *domino)
{
    return domino->part == WEAKEST || domino->part == ENDS;
}

/* Returns the k-th domino from the front, counted from 0. The front is the end towards which the dominoes
 * fall. */
const struct drawn *stage_front(const struct stage *stage, size_t k);

/*
 * Makes a stage that shows the train at the tilt `theta`, where 0 <= theta <= theta_c: the next domino in
 * front, the head, and the followers. The picture extends to `behind` times the head's height behind the
 * head. If `behind` is 0, it shows as many followers as fit. The stage has room for 30 more dominoes. The
 * caller frees the stage, even after an error.
 */
enum dom_status stage_train(struct stage *stage, const struct domq_train *train,
                            const struct domq_compute *compute, domq_real theta, double behind);

/* Adds the contact forces to a train on a stage. Returns the status of domq_cycle_forces. */
enum dom_status stage_forces(struct stage *stage, const struct domq_train *train,
                             const struct domq_compute *compute, domq_real theta);

/* Makes an empty stage with room for `room` dominoes. Returns false if memory runs out. */
bool stage_make(struct stage *stage, size_t room);
void stage_free(struct stage *stage);

/* Returns the unit of the ruler, and the size of this unit in the unit of the stage. `across` is the visible
 * width. */
struct axis_unit stage_unit(const struct stage *stage, double across);

/* ---- In characters ---- */

struct marks text_marks(struct look look);

/* Draws a stage with its caption in at most `width` columns and `height` rows. With braille, dominoes are
 * drawn as outlines, and marked dominoes are filled. Returns false if memory runs out. */
bool stage_text(const struct stage *stage, struct look look, int width, int height, FILE *out);

/* ---- By gnuplot ---- */

enum { SHEET_WIDTH = 640, CAPTION_COLUMNS = 76 };

/* The part of the stage that a picture shows, and the size of the picture in dots. A picture is SHEET_WIDTH
 * dots wide. */
struct sheet {
    double width, height, below, above; /* `below` and `above` are margins outside the axes */
    double head, indent;                /* the space above the caption, and the space to its left */
    double left, right, low, high;      /* the visible part of the stage; low < 0 leaves room for numbers */
    double dot;                         /* the size of a dot, in the unit of the stage */
};

extern const struct marks script_marks;

/* Returns the sheet for a stage, with a height between `least` and `most` dots. */
struct sheet sheet_of(const struct stage *stage, double least, double most);

/* Shows another part of the stage: the position `at` near the middle, and heights up to `tall`. */
void sheet_follow(struct sheet *sheet, double at, double tall);

/* Writes the gnuplot terminal setting for a file with this extension. */
void sheet_terminal(const struct sheet *sheet, const char *path, char *terminal, size_t size);

/* A gif has only the colours of its first frame, so this function draws a dot of each colour into a corner,
 * and covers the dots with white. gnuplot omits a frame that is equal to the previous one. To avoid this,
 * pass 0 and 1 alternately as `shift`: 1 makes the white slightly darker. */
void sheet_palette(const struct sheet *sheet, int shift, FILE *script);

/* Writes the commands with which gnuplot draws a stage on a sheet. */
void stage_script(const struct stage *stage, const struct sheet *sheet, FILE *script);

#endif
