/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The library's answers under the names that the reference has for them. */
#ifndef HARD_LIBRARY_H
#define HARD_LIBRARY_H

#include "reference.h"

struct answers {
    enum dom_status status[REF_COUNT]; /* of the function that gives it */
    domq_real value[REF_COUNT];        /* NaN where it gave none */
    domq_real error[REF_COUNT];        /* its bound */
    bool detaches;
    enum dom_end ends; /* of the last growth asked for */
    enum dom_status why;
    size_t link, links; /* the link that was looked at, of how many */
};

struct asked library_train(const struct ref_input *input, enum dom_precision precision);

/* The precision's unit roundoff; its smallest tolerance. */
double library_unit(enum dom_precision precision);
double library_floor(enum dom_precision precision);

void library_nothing(struct answers *answers);
/* Of the function that gives this quantity everything, other quantities included. */
void library_ask(const struct asked *asked, domq_real tilt, enum ref_quantity quantity,
                 struct answers *answers);
/* LINK_...: of the given domino, counted from the end where it is negative. */
void library_link(const struct asked *asked, domq_real tilt, size_t link, struct answers *answers);

#endif
