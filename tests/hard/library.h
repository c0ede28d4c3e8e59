/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The results of the library, named as in the reference. */
#ifndef HARD_LIBRARY_H
#define HARD_LIBRARY_H

#include "reference.h"

struct answers {
    enum dom_status status[REF_COUNT]; /* status of the function that computes the value */
    domq_real value[REF_COUNT];        /* NaN if there is no value */
    domq_real best_s_uncertainty;      /* how far REF_BEST_S may be off, as the library says */
    bool detaches;
    enum dom_end ends; /* what limits the last growth that was found */
    enum dom_status why;
    size_t link, links; /* number of the link, and how many links were visited */
};

struct setup library_train(const struct ref_input *input, enum precision precision);

/* Returns the unit roundoff of the precision. */
double library_unit(enum precision precision);

void library_nothing(struct answers *answers);
/* Calls the function that computes this quantity and stores all quantities of its result. */
void library_ask(const struct setup *setup, domq_real tilt, enum ref_quantity quantity,
                 struct answers *answers);
/* Finds the LINK_... quantities of a domino. */
void library_link(const struct setup *setup, domq_real tilt, size_t link, struct answers *answers);

#endif
