/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hard cases. `trap` says what makes a case difficult. */
#ifndef HARD_CASES_H
#define HARD_CASES_H

#include "reference.h"

enum { CASE_CHECKS = 6 };

/* Stands for the tilt f theta_c, where theta_c comes from the library. */
#define PART_OF_C(f) (-(f))

struct hard_case {
    const char *name, *trap;
    double s, r, d, q, tilt;
    bool paper;
    /* allowed error of the library in units (reference.h); 0 means 16 */
    double units;
    /* true if tens of thousands of dominoes matter; such a case runs only in double precision */
    bool lengthy;
    enum ref_quantity check[CASE_CHECKS]; /* quantities to check; REF_COUNT ends the list */
};

extern const struct hard_case hard_cases[];
extern const int hard_cases_number;

#endif
