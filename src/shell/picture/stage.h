/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a picture of dominoes shows: a stage on which they stand, lean and lie at one moment, with a caption
 * and a ruler. A row stands on it in m; the endless train in heights of its head, which is domino 0. Two
 * painters draw a stage: in characters, and as a script of gnuplot, of which a film takes one for each frame.
 */
#ifndef SHELL_STAGE_H
#define SHELL_STAGE_H

#include "answer/measure.h"
#include "domino_quad.h"
#include "picture/canvas.h"

enum {
    CORNERS = 4,
    ARC = 5,               /* points of a rounded edge */
    OUTLINE = 3 * ARC + 1, /* the lower edge at the back is sharp */
};

struct point {
    double x, y;
};

/* What a domino does, which decides its colour. */
enum part { STANDS, FALLS, HEAD, WEAKEST, ENDS, PARTS };

/* Numbers of dominoes of the train that are none of its followers: the next one, and those that wait beyond.
 */
enum { NUMBER_NEXT = -1, NUMBER_NONE = -2 };

struct drawn {
    int number; /* of a row from 1; in the train 0 is the head, and 1, 2, ... are its followers */
    enum part part;
    double height, thickness, foot, theta; /* foot: its hinge, where its lower front edge stands upright */
    double radius;                         /* of its edges */
    struct point corner[CORNERS]; /* front foot, front top, back top, back foot, as if edges were sharp */
    bool touched;                 /* by its follower, at contact, else NaN */
    struct point contact;
    double force, of_own; /* of that contact, in m g of the head and of this domino; NaN: not known */
};

enum { CAPTION = 1024 };

struct stage {
    struct drawn *domino; /* of the stage; the first ones are drawn over the others */
    size_t count;
    double left, right, top; /* what is to be seen */
    const char *unit;        /* of lengths: "h"; NULL: they are in m, and the ruler chooses mm, cm or m */
    const char *ruler;       /* what the ruler measures */
    /* Dominoes whose heights and gaps are written where there is room; NULL: none. */
    const struct domq_domino *row;
    bool forces;           /* forces are shown where they are known */
    char caption[CAPTION]; /* lines */
};

/* How a painter marks dominoes, for captions. */
struct marks {
    const char *theta, *weakest, *ends;
    const char *contacts; /* "dots: contacts"; and what else is to be explained of a train */
    const char *forces;   /* of the arrows at contacts; NULL: their numbers are in the caption */
};

/* A step of this length in the direction (x, y). */
static inline struct point along(struct point from, double length, double x, double y)
{
    return (struct point){from.x + length * x, from.y + length * y};
}

/* Sets the corners of a domino whose sizes, foot and tilt are set; with a radius, it has rolled from its
 * foot. */
void drawn_stand(struct drawn *domino);

/* Returns the domino with coordinates for people: 0 where only rounding errors are left of one. */
struct drawn drawn_for_people(const struct drawn *domino);

/* Writes the corners of its outline, with points along rounded edges. Returns how many. */
int drawn_outline(const struct drawn *domino, struct point outline[OUTLINE]);

/* Writes what stands below a domino: its number, "next" or "". Returns its length. */
enum { DRAWN_NAME = 16 };
int drawn_name(const struct drawn *domino, char name[DRAWN_NAME]);

/* Returns true where a domino is touched at its hinge (r s = 1): no push there, however large, turns it. */
bool drawn_locked(const struct drawn *domino);

/* Returns true for a domino that is marked: the weakest one, or the one at which a row ends. */
static inline bool drawn_marked(const struct drawn *domino)
{
    return domino->part == WEAKEST || domino->part == ENDS;
}

/* Returns the k-th domino from the front, to which the others fall. */
const struct drawn *stage_front(const struct stage *stage, size_t k);

/*
 * Makes a stage with the train at one tilt: the next domino in front, the head, its followers, as far back as
 * `behind` heights of the head; 0 for what fits a picture. 0 <= theta <= theta_c. The stage has room for 30
 * dominoes more. The caller frees it, also after an error.
 */
enum dom_status stage_train(struct stage *stage, const struct domq_train *train,
                            const struct domq_compute *compute, domq_real theta, double behind);

/* Adds the contact forces to a train on a stage. Statuses as domq_cycle_forces. */
enum dom_status stage_forces(struct stage *stage, const struct domq_train *train,
                             const struct domq_compute *compute, domq_real theta);

/* Makes a stage with room for so many dominoes; false: out of memory. */
bool stage_make(struct stage *stage, size_t room);
void stage_free(struct stage *stage);

/* Returns the unit in which the stage's ruler counts, and its size in the unit of the stage's lengths. */
struct axis_unit stage_unit(const struct stage *stage, double across);

/* Returns 1, 2 or 5 times a power of ten, the least that is not below this: a step of a ruler. */
double ruler_step(double least);

/* ---- In characters ---- */

/* Returns the marks of a picture on a terminal that can show this. */
struct marks text_marks(struct look look);

/* Draws a stage with its caption, in so many columns and at most so many lines. In braille, dominoes are
 * outlines, and marked ones are filled. False: out of memory. */
bool stage_text(const struct stage *stage, struct look look, int width, int height, FILE *out);

/* ---- By gnuplot ---- */

enum { SHEET_WIDTH = 640, CAPTION_COLUMNS = 76 };

/* A sheet, its size in dots, and the part of the stage that it shows, to scale. */
struct sheet {
    double width, height, below, above; /* margins: below and above the axes */
    double left, right, low, high, dot; /* of the stage; low < 0: room for the numbers below the ground */
};

extern const struct marks script_marks;

/* Returns the sheet for a stage; its height has these limits. */
struct sheet sheet_of(const struct stage *stage, double least, double most);

/* Shows another part of the stage: `at` at 0.45 of the width, and what is so tall. */
void sheet_follow(struct sheet *sheet, double at, double tall);

/* Writes gnuplot's terminal for a file of this name. */
void sheet_terminal(const struct sheet *sheet, const char *path, char *terminal, size_t size);

/*
 * Puts a dot of each colour into a corner, and white over them: a gif has the colours of its first frame.
 * gnuplot leaves out a frame that is the same as the one before, so the white is a trace darker where `shift`
 * is 1.
 */
void sheet_palette(const struct sheet *sheet, int shift, FILE *script);

/* Draws a stage. */
void stage_script(const struct stage *stage, const struct sheet *sheet, FILE *script);

#endif
