/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hard cases, each with a name for its difficulty. */
#ifndef HARD_CASES_H
#define HARD_CASES_H

#include "reference.h"

enum { CASE_CHECKS = 6 };

/* Marks a tilt as f theta_c, with theta_c from the library. */
#define PART_OF_C(f) (-(f))

struct hard_case {
    const char *name, *trap;
    double s, r, d, q, tilt;
    bool paper;
    double units;                         /* allowed error of the library in units; 0: 16 */
    bool lengthy;                         /* tens of thousands of dominoes: run in double precision only */
    enum ref_quantity check[CASE_CHECKS]; /* ends with REF_COUNT */
};

extern const struct hard_case hard_cases[];
extern const int hard_cases_number;

#endif
