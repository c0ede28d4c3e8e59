/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hard cases, each with the trap that it stands for. */
#ifndef HARD_CASES_H
#define HARD_CASES_H

#include "reference.h"

enum { CASE_CHECKS = 6 };

/* The tilt f theta_c, theta_c as the library gives it. */
#define PART_OF_C(f) (-(f))

struct hard_case {
    const char *name, *trap;
    double s, r, d, q, tilt;
    bool paper;
    double units;                         /* what the library may be wrong by; 0: 16 */
    bool lengthy;                         /* tens of thousands of dominoes: in double precision only */
    enum ref_quantity check[CASE_CHECKS]; /* ends with REF_COUNT */
};

extern const struct hard_case hard_cases[];
extern const int hard_cases_number;

/* What is no train, or no tilt, and what the library has to say about it. */
struct refusal {
    const char *name;
    double s, r, d, q, tilt;
    enum ref_quantity asked;
    enum dom_status status;
};

extern const struct refusal refusals[];
extern const int refusals_number;

/* Trains without any trap, which the naive code gets right. */
extern const struct hard_case friendly_cases[];
extern const int friendly_cases_number;

#endif
