/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The words that follow 'draw' and 'animate FILE', each with its value. */
#ifndef SHELL_DRAW_WORDS_H
#define SHELL_DRAW_WORDS_H

#include "interpreter/question.h"

/* What 'draw' is to show. */
struct draw_what {
    bool train;  /* of the endless train, though a row is on */
    bool forces; /* with its forces */
    bool tilted; /* at the tilt theta */
    domq_real theta;
    enum { ROW_STANDS, ROW_AT_TIME, ROW_AT_DOMINO, ROW_AT_END } at; /* the row's moment */
    domq_real time;                                                 /* s */
    domq_real domino;
    int column; /* of the moment in the line, for messages */
};

/* How 'animate' is to run. */
struct film_what {
    bool train;
    bool counted;
    domq_real cycles; /* of the train, if they are counted; not checked */
    int column;       /* where that stands */
    domq_real speed;  /* 1: real time */
    domq_real rate;   /* frames in a second */
    bool timed;       /* speed or rate is given */
};

/* Parse and bind the words; given->own is a struct draw_what or a struct film_what. */
bool draw_parse(struct reader *reader, struct question *question);
bool draw_bind(const struct question *question, const struct query *query, struct arguments *given,
               struct problem *problem);
bool film_parse(struct reader *reader, struct question *question);
bool film_bind(const struct question *question, const struct query *query, struct arguments *given,
               struct problem *problem);

#endif
