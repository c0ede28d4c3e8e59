/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A picture of dominoes: a stage on which they stand, lean and lie at one moment, with a caption and a ruler.
 * A row stands on it in m; the endless train in heights of its head, which is domino 0. Two painters draw a
 * stage: one in characters, and one as a script of gnuplot, of which a film takes one for each frame.
 */
#ifndef SHELL_STAGE_H
#define SHELL_STAGE_H

#include "answer/measure.h"
#include "domino_quad.h"
#include "picture/canvas.h"

enum {
    CORNERS = 4,
    ARC = 5,               /* points of a rounded edge */
    OUTLINE = 3 * ARC + 1, /* points of an outline; the lower edge at the back is always sharp */
};

struct point {
    double x, y;
};

/* What a domino does, which decides its colour. */
enum part { STANDS, FALLS, HEAD, WEAKEST, ENDS, PARTS };

/* Numbers of the dominoes in front of the head: the next one, and those beyond it, which show no number. */
enum { NUMBER_NEXT = -1, NUMBER_NONE = -2 };

struct drawn {
    int number; /* of a row from 1; of the train 0 is the head, and 1, 2, ... are its followers */
    enum part part;
    double height, thickness, theta;
    double foot;                  /* the place of its hinge: where its lower front edge is while it stands */
    double radius;                /* radius of its rounded edges; 0 for sharp ones */
    struct point corner[CORNERS]; /* front foot, front top, back top, back foot, as if edges were sharp */
    bool touched;                 /* its follower touches it at `contact`, which else is NaN */
    struct point contact;
    double force, of_own; /* push at the contact in m g of the head, and of this domino; NaN if unknown */
};

enum { CAPTION = 1024 };

struct stage {
    struct drawn *domino; /* the first ones are drawn over the others */
    size_t count;
    double left, right, top;       /* the ends of what is seen */
    const char *unit;              /* of lengths: "h"; NULL for m, which the ruler shows in mm, cm or m */
    const char *ruler;             /* what the ruler measures */
    const struct domq_domino *row; /* unless NULL, sizes that are written where there is room */
    bool forces;                   /* the forces that are known are shown */
    char caption[CAPTION];         /* one or more lines */
};

/* How a painter marks dominoes, for captions. */
struct marks {
    const char *theta, *weakest, *ends;
    const char *contacts; /* explains the marks in a picture of a train */
    const char *forces;   /* explains arrows; NULL if there are none, and the caption has the numbers */
};

/* Returns the point at a distance in the direction (x, y). */
static inline struct point along(struct point from, double distance, double x, double y)
{
    return (struct point){from.x + distance * x, from.y + distance * y};
}

/* Sets the corners of a domino from its sizes, its foot and its tilt. A domino with rounded edges has rolled
 * from its foot. */
void drawn_stand(struct drawn *domino);

/* Writes the points of its outline. Returns how many there are. */
int drawn_outline(const struct drawn *domino, struct point outline[OUTLINE]);

/* Writes what stands below a domino: its number, "next" or nothing. Returns the length. */
enum { DRAWN_NAME = 16 };
int drawn_name(const struct drawn *domino, char name[DRAWN_NAME]);

/* Returns true for a domino that is touched at its hinge (r s = 1): no push there, however large, turns it.
 */
bool drawn_locked(const struct drawn *domino);

/* Returns true for the weakest domino, and for the one at which a row ends. */
static inline bool drawn_marked(const struct drawn *domino)
{
    return domino->part == WEAKEST || domino->part == ENDS;
}

/* Returns the k-th domino from the front, to which the others fall. */
const struct drawn *stage_front(const struct stage *stage, size_t k);

/*
 * Makes a stage with the train at one tilt, 0 <= theta <= theta_c: the next domino in front, the head, and
 * its followers as far back as `behind` heights of the head, or as fits a picture if that is 0. The stage has
 * room for 30 dominoes more. The caller frees it, also after an error.
 */
enum dom_status stage_train(struct stage *stage, const struct domq_train *train,
                            const struct domq_compute *compute, domq_real theta, double behind);

/* Adds the contact forces to a train on a stage. Statuses are those of domq_cycle_forces. */
enum dom_status stage_forces(struct stage *stage, const struct domq_train *train,
                             const struct domq_compute *compute, domq_real theta);

/* Makes a stage with room for so many dominoes. Returns false if there is no memory. */
bool stage_make(struct stage *stage, size_t room);
void stage_free(struct stage *stage);

/* Returns the unit in which the ruler counts, and its size in the stage's own unit. */
struct axis_unit stage_unit(const struct stage *stage, double across);

/* ---- In characters ---- */

struct marks text_marks(struct look look);

/* Draws a stage with its caption in at most so many columns and rows. With braille, dominoes are outlines,
 * and marked ones are filled. Returns false if there is no memory. */
bool stage_text(const struct stage *stage, struct look look, int width, int height, FILE *out);

/* ---- By gnuplot ---- */

enum { SHEET_WIDTH = 640, CAPTION_COLUMNS = 76 };

/* The size of a picture in dots, and the part of the stage that it shows. */
struct sheet {
    double width, height, below, above; /* below and above are margins at the axes */
    double left, right, low, high;      /* of the stage; low < 0 leaves room for numbers below the ground */
    double dot;                         /* the length of a dot on the stage */
};

extern const struct marks script_marks;

/* Returns the sheet for a stage. Its height has these limits. */
struct sheet sheet_of(const struct stage *stage, double least, double most);

/* Shows another part of the stage: the place `at` in the middle, and what is so tall. */
void sheet_follow(struct sheet *sheet, double at, double tall);

/* Writes gnuplot's terminal for a file of this name. */
void sheet_terminal(const struct sheet *sheet, const char *path, char *terminal, size_t size);

/*
 * Puts a dot of each colour into a corner, and white over them, since a gif has the colours of its first
 * frame only. gnuplot leaves out a frame that equals the one before: where `shift` is 1, the white is a trace
 * darker.
 */
void sheet_palette(const struct sheet *sheet, int shift, FILE *script);

/* Draws a stage. */
void stage_script(const struct stage *stage, const struct sheet *sheet, FILE *script);

#endif
