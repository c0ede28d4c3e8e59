/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The words and values that follow 'draw' and 'animate FILE'. */
#ifndef SHELL_DRAW_WORDS_H
#define SHELL_DRAW_WORDS_H

#include "interpreter/question.h"

enum draw_value {
    DRAW_TIME,   /* the moment of the row, in s */
    DRAW_DOMINO, /* the domino that is hit at the moment of the row; not checked */
    DRAW_TILT,   /* the tilt of the train */
    DRAW_CYCLES, /* the number of cycles of the train; not checked */
    DRAW_SPEED,  /* 1 is real time */
    DRAW_RATE,   /* frames in a second */
    DRAW_VALUES
};

struct draw_what {
    bool train;            /* the endless train, even if there is a row */
    bool forces, end;      /* the words 'forces' and 'at end' are given */
    bool has[DRAW_VALUES]; /* the value is given */
    domq_real value[DRAW_VALUES];
    int column; /* where the moment or the number of cycles stands in the line */
};

/* Returns what the words of a bound question ask for. */
const struct draw_what *draw_what(const struct query *query);

/* Returns true for a moment of the row: 'draw at'. */
static inline bool draw_at(const struct draw_what *what)
{
    return what->end || what->has[DRAW_TIME] || what->has[DRAW_DOMINO];
}

/* Parse the words of 'draw' and of 'animate', and bind those of both. */
bool draw_parse(struct reader *reader, struct question *question);
bool film_parse(struct reader *reader, struct question *question);
bool draw_bind(const struct question *question, const struct query *query, struct arguments *given,
               struct problem *problem);

#endif
