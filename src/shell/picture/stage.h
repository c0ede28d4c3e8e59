/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A picture of dominoes. A stage holds the dominoes as they stand, lean or lie at one moment, with a caption
 * and a ruler. Lengths are in m for a row, and in heights of the head, which is domino 0, for the endless
 * train. Two painters draw a stage: one with characters, and one as a gnuplot script, which is also used for
 * each frame of a film.
 */
#ifndef SHELL_STAGE_H
#define SHELL_STAGE_H

#include "answer/measure.h"
#include "domino_quad.h"
#include "picture/canvas.h"

enum {
    CORNERS = 4,
    ARC = 5,               /* points of a rounded edge */
    OUTLINE = 3 * ARC + 1, /* most points of an outline, in which the lower back edge is always sharp */
};

struct point {
    double x, y;
};

/* The state of a domino, which decides its colour. */
enum part { STANDS, FALLS, HEAD, WEAKEST, ENDS, PARTS };

/* The values of drawn.number for the dominoes in front of the head: the next one, and those beyond it, which
 * have no label. */
/* NUMBER_TOWER and NUMBER_PERSON make a domino the silhouette of a tower or of a person, as tall as the
 * domino. */
enum { NUMBER_NEXT = -1, NUMBER_NONE = -2, NUMBER_TOWER = -3, NUMBER_PERSON = -4 };

/* A domino on a stage. */
struct drawn {
    int number; /* the number of the domino: from 1 in a row; in a train, 0 is the head, and 1, 2, ... are its
                   followers */
    enum part part;
    double height, thickness, theta;
    double foot;   /* position of the hinge, its lower front edge while it stands */
    double radius; /* radius of the rounded edges; 0 for sharp edges */
    /* The corners as if edges were sharp: front foot, front top, back top and back foot. */
    struct point corner[CORNERS];
    bool touched; /* its follower touches it at `contact`; otherwise `contact` is NaN */
    struct point contact;
    /* The push at the contact, divided by the weight of the head, and divided by the weight of this domino.
     * NaN if unknown. */
    double force, of_own;
};

enum { CAPTION = 1024 };

struct stage {
    struct drawn *domino; /* the dominoes; earlier ones are drawn over later ones */
    size_t count;
    double left, right, top;       /* limits of the visible part */
    const char *unit;              /* unit of lengths: "h", or NULL for m, shown in mm, cm or m */
    const char *ruler;             /* what the ruler measures */
    const struct domq_domino *row; /* if not NULL, the sizes to write where there is room */
    bool forces;                   /* show the forces that are known */
    char caption[CAPTION];         /* caption of one or more lines */
};

/* The words with which captions explain how a painter marks dominoes. */
struct marks {
    const char *theta, *weakest, *ends;
    const char *contacts; /* explains the marks in a picture of a train */
    const char *forces;   /* explains the arrows for forces; NULL if the caption lists the forces instead */
};

/* Returns the point at a distance in the direction (x, y). */
static inline struct point along(struct point from, double distance, double x, double y)
{
    return (struct point){from.x + distance * x, from.y + distance * y};
}

/* Computes the corners of a domino from its sizes, its foot and its tilt. A domino with rounded edges rolls
 * away from its foot as it tilts. */
void drawn_stand(struct drawn *domino);

/* Writes the points of the outline of a domino. Returns the number of points. */
int drawn_outline(const struct drawn *domino, struct point outline[OUTLINE]);

/* Returns true if a silhouette covers a point: `up` is the height of the point as a fraction of its
 * height, and `back` is its distance from the front as a fraction of its width. Every other domino
 * covers all points of its rectangle. */
bool drawn_covers(const struct drawn *domino, double up, double back);

/* Writes the text below a domino: its number, "next", "tower" or nothing. Returns the length of the text. */
enum { DRAWN_NAME = 16 };
int drawn_name(const struct drawn *domino, char name[DRAWN_NAME]);

/* Returns true for a domino that is touched at its hinge (r s = 1), where no push, however large, turns it.
 */
bool drawn_locked(const struct drawn *domino);

/* Returns true for the weakest domino, and for the one at which a row ends. */
static inline bool drawn_marked(const struct drawn *domino)
{
    return domino->part == WEAKEST || domino->part == ENDS;
}

/* Returns domino k, counted from 0 at the front, the end towards which the dominoes fall. */
const struct drawn *stage_front(const struct stage *stage, size_t k);

/*
 * Makes a stage with the train at one tilt, 0 <= theta <= theta_c: the next domino in front, the head, and
 * its followers up to `behind` heights of the head back or, if `behind` is 0, as many as fit into a picture.
 * The stage has room for 30 more dominoes. The caller frees the stage, even after an error.
 */
enum dom_status stage_train(struct stage *stage, const struct domq_train *train,
                            const struct domq_compute *compute, domq_real theta, double behind);

/* Adds the contact forces to a train on a stage. Returns the status of domq_cycle_forces. */
enum dom_status stage_forces(struct stage *stage, const struct domq_train *train,
                             const struct domq_compute *compute, domq_real theta);

/* Makes an empty stage with room for `room` dominoes. Returns false if memory runs out. */
bool stage_make(struct stage *stage, size_t room);
void stage_free(struct stage *stage);

/* Returns the unit of the ruler, and its size in the unit of the stage. `across` is the visible width. */
struct axis_unit stage_unit(const struct stage *stage, double across);

/* ---- In characters ---- */

struct marks text_marks(struct look look);

/* Draws a stage with its caption in at most `width` columns and `height` rows. With braille, dominoes are
 * drawn as outlines, and marked ones are filled. Returns false if memory runs out. */
bool stage_text(const struct stage *stage, struct look look, int width, int height, FILE *out);

/* ---- By gnuplot ---- */

enum { SHEET_WIDTH = 640, CAPTION_COLUMNS = 76 };

/* The size of a picture in dots, where its width is SHEET_WIDTH, and the part of the stage that the picture
 * shows. */
struct sheet {
    double width, height, below, above; /* below and above are margins outside the axes */
    double head, indent;                /* space above the caption, and to its left */
    double left, right, low, high;      /* visible part of the stage; low < 0 leaves room for numbers */
    double dot;                         /* length of a dot, in the unit of the stage */
};

extern const struct marks script_marks;

/* Returns the sheet for a stage, with a height between `least` and `most` dots. */
struct sheet sheet_of(const struct stage *stage, double least, double most);

/* Shows another part of the stage: the position `at` near the middle, and everything up to the height `tall`.
 */
void sheet_follow(struct sheet *sheet, double at, double tall);

/* Writes the gnuplot terminal, with its options, that suits the extension of the file. */
void sheet_terminal(const struct sheet *sheet, const char *path, char *terminal, size_t size);

/*
 * Draws a dot of each colour into a corner and covers the dots with white, because a gif has only the colours
 * of its first frame. gnuplot leaves out a frame that is equal to the one before; if `shift` is alternately 0
 * and 1, this does not happen, because 1 makes the white slightly darker.
 */
void sheet_palette(const struct sheet *sheet, int shift, FILE *script);

/* Writes the commands with which gnuplot draws a stage on a sheet. */
void stage_script(const struct stage *stage, const struct sheet *sheet, FILE *script);

#endif
