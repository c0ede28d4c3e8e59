/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hard cases. */
#ifndef HARD_CASES_H
#define HARD_CASES_H

#include "reference.h"

/* Stands for the tilt f theta_c, where theta_c comes from the library. */
#define PART_OF_C(f) (-(f))

enum { CASE_CHECKS = 6 };

struct hard_case {
    const char *name, *trap; /* `trap` says what makes the case difficult */
    double s, r, d, q, tilt;
    bool paper;
    double units; /* allowed error of the library in units (reference.h); 0 means 16 */
    enum ref_quantity check[CASE_CHECKS]; /* quantities to check; REF_COUNT ends the list */
};

extern const struct hard_case hard_cases[];
extern const int hard_cases_number;

#endif
