/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dominoes of a train as they stand and lean: hinges, corners, contacts, and how gnuplot draws them. */
#ifndef SHELL_STAGE_H
#define SHELL_STAGE_H

#include "domino_quad.h"
#include <stdio.h>

enum {
    DOMINOES = 200,
    CORNERS = 4,
    ARC = 5,               /* points of a rounded edge */
    OUTLINE = 3 * ARC + 1, /* the lower edge at the back is sharp */
};

struct point {
    double x, y;
};

/* A domino as it is drawn, in heights of the head. */
struct drawn {
    int number; /* 0 = head; 1, 2, ... its followers; -1 = the next, upright domino */
    double height, foot, theta;
    double radius;                /* of its edges */
    struct point corner[CORNERS]; /* front foot, front top, back top, back foot, as if edges were sharp */
    bool touched;                 /* by its follower, at contact, else NaN */
    struct point contact;
    double force, of_own; /* of that contact, in m g of the head and of this domino; NaN: not known */
};

struct stage {
    struct drawn domino[DOMINOES]; /* the next one, the head, its followers */
    int count;
    double left, right, top; /* of the view */
};

/* A step of this length in the direction (x, y). */
static inline struct point along(struct point from, double length, double x, double y)
{
    return (struct point){from.x + length * x, from.y + length * y};
}

/* A domino with its hinge at (foot, 0), or, with a radius, one that has rolled from there; d is its thickness
 * over its height. */
struct drawn drawn_at(int number, double height, double foot, double theta, double d, double radius);

/* Returns the domino with coordinates for people: 0 where only rounding errors are left of one. */
struct drawn drawn_for_people(const struct drawn *domino);

/* Writes the corners of its outline, with points along rounded edges. Returns how many. */
int drawn_outline(const struct drawn *domino, struct point outline[OUTLINE]);

/*
 * The train at one tilt, with the next domino in front; as far back as `behind` heights, 0 for what fits a
 * picture.  0 <= theta <= theta_c.
 */
enum dom_status stage_make(const struct domq_train *train, const struct domq_compute *compute,
                           domq_real theta, double behind, struct stage *scene);

/* Adds the contact forces to the scene. Statuses as domq_cycle_forces. */
enum dom_status scene_forces(const struct domq_train *train, const struct domq_compute *compute,
                             domq_real theta, struct stage *scene);

/* Where a scene is in the picture, and how large: an animation's heads grow and go on. */
struct place {
    double scale, shift;
};

/* One domino as an object of gnuplot, with its contact, and its number where that is right of `from`. */
void script_domino(FILE *script, const struct drawn *domino, struct place at, double from);

/* Both axes to the same scale. */
void script_axes(FILE *script, double left, double right, double top);

#endif
