/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arguments of 'draw' and 'animate': keywords such as 'at' and 'train', and values. */
#ifndef SHELL_DRAW_WORDS_H
#define SHELL_DRAW_WORDS_H

#include "interpreter/question.h"

enum draw_value {
    DRAW_TIME,   /* the time at which to show the row, in s */
    DRAW_DOMINO, /* show the row when the domino with this number is hit; the number may be out of range */
    DRAW_TILT,   /* the tilt of the head at which to show the train */
    DRAW_CYCLES, /* the number of cycles to show; may be out of range */
    DRAW_SPEED,  /* the speed of the film, where 1 is real time */
    DRAW_RATE,   /* the number of frames per second */
    DRAW_VALUES
};

/* The arguments, with values instead of expressions. */
struct draw_options {
    bool train;            /* draw the endless train, even if there is a row */
    bool tower;            /* draw the row that the last 'count' found, beside a tower */
    bool slow;             /* animate more slowly */
    bool forces, end;      /* the user typed 'forces', or 'at end' */
    bool has[DRAW_VALUES]; /* true for each value that the user typed */
    domq_real value[DRAW_VALUES];
    int column; /* where the moment or the number of cycles begins in the typed line, for error messages */
};

/* Returns the arguments of 'draw' or 'animate', with defaults for missing arguments. */
const struct draw_options *draw_options_of(const struct query *query);

/* Returns true if the arguments request a moment of the row, as in 'draw at 2.5 s'. */
static inline bool draw_at(const struct draw_options *options)
{
    return options->end || options->has[DRAW_TIME] || options->has[DRAW_DOMINO];
}

bool draw_parse(struct reader *reader, struct question *question);

/* Parses the arguments of 'animate'. The file of the film may come first, without a '>'. */
bool film_parse(struct reader *reader, struct question *question);

/* Evaluates the expressions in the arguments of 'draw' or 'animate'. */
bool draw_bind(const struct question *question, const struct query *query, struct arguments *given,
               struct problem *problem);

#endif
