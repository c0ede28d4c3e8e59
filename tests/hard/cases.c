/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cases.h"

#define STANDARD (7.0 / 48)
#define END      REF_COUNT
/* r s = 1 - u */
#define REACH(s, u) ((1 - (u)) / (s))

const struct hard_case hard_cases[] = {
    /* H and H(0) are sums without end for r = 1: only their difference is finite. */
    {"equal", "H diverges", 0.3, 1, STANDARD, 4, 0.2, .check = {REF_FUEL_EXACT, END}},
    {"equal, wide", "H diverges", 0.9, 1, STANDARD, 3, 0.2,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_KINETIC, END}},
    {"equal, thick", "H diverges", 0.2, 1, 0.5, 3, 0.1, .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"equal, close", "a thousand dominoes matter", 0.01, 1, STANDARD, 3, 0.005,
     .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"equal, very close", "fourteen thousand dominoes", 1e-4, 1, STANDARD, 3, 5e-5,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, END}},
    {"equal, touching", "s = 1e-6, a hundred thousand dominoes", 1e-6, 1, STANDARD, 3, 5e-7, .units = 2000,
     .lengthy = true, .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, END}},
    {"equal, paper thin", "d = 1e-8, r = 1", 0.01, 1, 1e-8, 3, 5e-3,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, END}},
    {"equal + 1e-12", "nearly divergent H", 0.3, 1 + 1e-12, STANDARD, 3, 0.2,
     .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"close + 1e-12", "nearly divergent H, 4000 dominoes", 1e-3, 1 + 1e-12, STANDARD, 3, 2e-4,
     .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"equal + ulp", "r = 1 + 2^-52", 0.2, 1 + 0x1p-52, 0.5, 3, 0.1, .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"close, q = 10", "r = 1 + 1e-6", 0.01, 1 + 1e-6, 0.01, 10, 0.001,
     .check = {REF_DH, REF_FUEL_EXACT, REF_KINETIC, REF_MARGIN, END}},
    {"close, r = 1.0001", "14000 dominoes", 1e-3, 1.0001, 0.01, 10, 0.001,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_KINETIC, END}},

    /* r s -> 1: 1 - r s, 1 - X and 1 - sin theta_f cancel; followers leave at once. */
    {"reach - 1e-15", "1 - r s", 0.3, REACH(0.3, 1e-15), STANDARD, 3, 1e-8,
     .check = {REF_THETA_C, REF_THETA_LEAVE, REF_THETA_F, REF_SLOPE, REF_ARM_B, END}},
    {"reach - 1e-15, energy", "1 - r s", 0.3, REACH(0.3, 1e-15), STANDARD, 3, 1e-8,
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_FUEL_PAPER, REF_BARRIER, REF_MARGIN}},
    {"reach - 1e-15, s = 1/2", "1 - r s", 0.5, REACH(0.5, 1e-15), STANDARD, 3, 1e-8,
     .check = {REF_THETA_LEAVE, REF_THETA_F, REF_SLOPE, REF_ARM_A, REF_ARM_B, END}},
    {"reach - 1e-15, s = 1/2, energy", "the follower leaves at 7e-8", 0.5, REACH(0.5, 1e-15), STANDARD, 3,
     1e-8, .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN, END}},
    {"reach - 1e-12", "1 - r s", 0.9, REACH(0.9, 1e-12), STANDARD, 3, 1e-8,
     .check = {REF_THETA_C, REF_THETA_LEAVE, REF_THETA_F, REF_SLOPE, REF_ARM_B, END}},
    {"reach - 1e-12, energy", "x exceeds x_f never", 0.9, REACH(0.9, 1e-12), STANDARD, 3, 1e-8,
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN, REF_DURATION}},
    {"reach - 1e-6", "1 - r s", 0.7, REACH(0.7, 1e-6), STANDARD, 4, 1e-3,
     .check = {REF_THETA_LEAVE, REF_THETA_F, REF_DH, REF_SLOPE, REF_BARRIER, END}},
    {"reach, rounded up", "r s > 1 by rounding alone", 0.3, 1 / 0.3, STANDARD, 3, 0.1,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN}},
    {"reach, exactly", "r s = 1", 0.5, 2, STANDARD, 3, 0.1,
     .check = {REF_THETA_F, REF_DH, REF_J0, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN}},
    {"reach, s = 1", "r = s = 1", 1, 1, STANDARD, 3, 0.1,
     .check = {REF_DH, REF_J0, REF_FUEL_EXACT, REF_OMEGASQ, REF_DURATION, END}},
    {"reach, s = 1e-6", "1 - r s, T = 1e-24", 1e-6, REACH(1e-6, 1e-15), STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_FUEL_EXACT, REF_KINETIC, REF_BARRIER, REF_MARGIN, REF_THETA_F, REF_STOP}},

    /* J(0) - 1 = r^-(q+1) ... is lost in J(0). */
    {"large r", "T = 1e-12", 1e-3, 900, STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_DH, REF_KINETIC, REF_FUEL_EXACT, REF_BARRIER, REF_THETA_F, REF_STOP}},
    {"large r, close to reach", "T = 1e-12", 0.01, 99, STANDARD, 5, PART_OF_C(0.5),
     .check = {REF_DH, REF_LAUNCH_OMEGASQ, REF_KINETIC, REF_FUEL_EXACT, REF_BARRIER, REF_STOP}},
    {"large r, far from reach", "T = 1e-23", 1e-6, 5e5, STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_LAUNCH_OMEGASQ, REF_KINETIC, REF_BARRIER, REF_THETA_F, REF_STOP, END}},
    {"large q", "T = 1e-13", 0.2, 2.1, STANDARD, 40, 0.1,
     .check = {REF_LAUNCH_OMEGASQ, REF_KINETIC, REF_BARRIER, REF_MARGIN, REF_STOP, END}},
    {"q = 100", "T = 1e-31", 0.4, 2, STANDARD, 100, 0.1,
     .check = {REF_LAUNCH_OMEGASQ, REF_KINETIC, REF_BARRIER, REF_STOP, END}},

    /* A follower leaves; x never exceeds x_f, and the rest of the train is made up. */
    {"q = 1/3", "falling off, heavy followers", 0.45, 2, STANDARD, 1 / 3.0, 0.3,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_KINETIC, REF_MARGIN}},
    {"q = pi", "falling off, real q", 0.4, 2, STANDARD, 3.141592653589793, 0.1,
     .check = {REF_DH, REF_KINETIC, REF_FUEL_EXACT, REF_BARRIER, REF_MARGIN, REF_J}},
    {"q = 3", "falling off", 0.45, 2, STANDARD, 3, 0.3,
     .check = {REF_DH, REF_J0, REF_FUEL_EXACT, REF_BARRIER, REF_OMEGASQ, REF_DURATION}},
    {"q = 4", "falling off", 0.9, 1.1, STANDARD, 4, 0.3,
     .check = {REF_DH, REF_J, REF_J0, REF_FUEL_EXACT, REF_OMEGASQ, REF_DURATION}},
    {"beyond leaving", "no follower at this tilt", 0.5, 1.9, STANDARD, 3, 0.7,
     .check = {REF_DH, REF_J, REF_THETA_1, REF_SLOPE, REF_OMEGASQ, REF_MARGIN}},
    {"at theta_c", "no follower at theta_c", 0.5, 1.9, STANDARD, 3, PART_OF_C(1),
     .check = {REF_DH, REF_J, REF_THETA_1, REF_SLOPE, REF_OMEGASQ, END}},
    {"beside theta_c", "no follower beside theta_c", 0.8, 1.2, STANDARD, 3, PART_OF_C(1 - 1e-15),
     .check = {REF_DH, REF_J, REF_THETA_1, REF_SLOPE, REF_OMEGASQ, END}},
    {"just falling off", "where theta_f meets theta_inf", 0.5, 1.5896, STANDARD, 3, PART_OF_C(0.9),
     .check = {REF_DH, REF_FUEL_EXACT, END}},
    {"edge of (A17), close", "theta_f = theta_inf = theta_leave, small angles", 1e-4, 100, 0.49995, 3,
     PART_OF_C(0.5), .check = {REF_DH, REF_FUEL_EXACT, REF_THETA_F, REF_THETA_INF, END}},
    {"edge of (A17), thick", "theta_f = theta_inf = theta_leave", 0.01, 1, 49.995, 3, PART_OF_C(0.5),
     .check = {REF_DH, REF_J0, REF_FUEL_EXACT, REF_BARRIER, REF_THETA_F, REF_THETA_INF}},

    /* Thin and thick. */
    {"thin", "d = 1e-8: dH = 1e-9", 0.4, 2, 1e-8, 3, 1e-8, .check = {REF_DH, END}},
    {"thin, alone", "d = 1e-8: the barrier is 5e-17", 0.4, 2.3, 1e-8, 30, 1e-8,
     .check = {REF_DH, REF_KINETIC, REF_THETA_M, REF_BARRIER, REF_MARGIN, END}},
    {"thin, at the reach", "d = 1e-8, r s = 1", 0.3, 1 / 0.3, 1e-8, 3, 1e-8,
     .check = {REF_DH, REF_KINETIC, REF_BARRIER, REF_MARGIN, END}},
    {"thin, near the reach", "a and b differ by d", 0.3, REACH(0.3, 1e-6), 1e-4, 3, 0.05,
     .check = {REF_DH, REF_SLOPE, REF_ARM_A, REF_MARGIN, END}},
    {"thinner, near the reach", "a and b differ by d", 0.3, REACH(0.3, 1e-10), 1e-8, 3, 0.005,
     .check = {REF_DH, REF_SLOPE, REF_ARM_A, REF_MARGIN, END}},
    {"d = 1.5", "no fuel, the maximum is at theta_c", 0.3, 1.1, 1.5, 3, 0.05,
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, END}},
    {"d = 3", "no fuel, the maximum is at theta_c", 0.9, 1, 3, 3, PART_OF_C(0.5),
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, END}},
    {"d = 3, growing", "no fuel, falling off", 0.1, 5, 3, 3, PART_OF_C(0.5),
     .check = {REF_DH, REF_J, REF_FUEL_EXACT, REF_BARRIER, END}},
    {"d = 100", "no fuel, small angles", 1e-3, 1, 100, 3, PART_OF_C(0.5),
     .check = {REF_THETA_INF, REF_DH, REF_J0, REF_FUEL_EXACT, END}},

    /* P -> 0+ */
    {"fuel 2e-7", "P -> 0", 0.0063378, 1, STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_FUEL_EXACT, REF_KINETIC, REF_DH, END}},
    {"fuel 1e-12", "P -> 0", 0.00633776, 1, STANDARD, 3, PART_OF_C(0.5),
     .check = {REF_FUEL_EXACT, REF_DH, END}},

    /* margin -> 0+ */
    {"margin 1e-6", "duration diverges", 0.4, 1.6442, STANDARD, 4, 0.1, .check = {REF_DURATION, END}},
    {"margin 1e-12", "duration diverges", 0.4, 1.64422903953, STANDARD, 4, 0.1, .check = {REF_DURATION, END}},
    {"margin 1e-9, falling off", "duration diverges", 0.4, 2.06377177, STANDARD, 3, 0.1,
     .check = {REF_DURATION, REF_MARGIN, END}},

    /* Where H has its maximum. */
    {"two maxima", "H falls first, rises later", 0.54, 1.8515, STANDARD, 3, 0.1,
     .check = {REF_THETA_M, REF_BARRIER, REF_MARGIN, REF_DURATION, END}},
    {"two maxima, at rest", "H falls first, rises later", 0.5, 1.999, STANDARD, 3, 0.1,
     .check = {REF_BARRIER, REF_MARGIN, REF_STOP, END}},
    {"maximum at 0", "beyond leaving H must not rise again", 0.54, 1.8318, STANDARD, 3, 0.1,
     .check = {REF_MARGIN, REF_DH, REF_DURATION, END}},
    {"maximum beside 0", "H rises by 1e-11 only", 0.4, 1.5, STANDARD, 3.42071, 0.1,
     .check = {REF_BARRIER, END}},
    {"maximum at theta_c", "close, with the paper's fuel", 0.05, 1.53, STANDARD, 3, PART_OF_C(1),
     .paper = true, .check = {REF_BARRIER, END}},

    /* Small tilts. */
    {"tilt 1e-15", "H(theta) - H(0)", 0.4, 1.5, STANDARD, 3, 1e-15, .check = {REF_DH, END}},
    {"tilt 1e-30", "H(theta) - H(0)", 0.4, 1.5, STANDARD, 3, 1e-30, .check = {REF_DH, END}},

    /* The first r that stops. */
    {"r_max, falling off", "x exceeds x_f never", 0.4, 1, STANDARD, 3, 0, .check = {REF_R_MAX, END}},
    {"r_max, near the reach", "the margin falls within 1e-3", 0.5, 1, STANDARD, 3, 0,
     .check = {REF_R_MAX, REF_PAIR, END}},
    {"r_max, beside the reach", "two maxima", 0.6, 1, STANDARD, 4, 0, .check = {REF_R_MAX, REF_PAIR, END}},
    {"r_max, thin", "a window of 1e-5 before the reach", 0.327, 1, 0.015, 3.7, 0,
     .check = {REF_R_MAX, REF_PAIR, END}},
    {"r_max, thin, paper", "a window before the reach", 0.3, 1, 0.015, 3.7, 0, .paper = true,
     .check = {REF_R_MAX, END}},
    {"r_max, close", "trains of hundreds", 0.02, 1, STANDARD, 4, 0, .check = {REF_R_MAX, END}},
    {"r_max, q = 1/2", "heavy followers", 0.1, 1, STANDARD, 0.5, 0, .check = {REF_R_MAX, REF_PAIR, END}},
    {"r_max, a band", "equal dominoes fail, larger ones do not", 0.1, 1, 0.25, 0.5, 0,
     .check = {REF_PAIR, END}},
    {"r_max, a band to the reach", "equal dominoes fail, larger ones do not", 0.25, 1, 0.2, 0.5, 0,
     .check = {REF_PAIR, END}},
};
const int hard_cases_number = sizeof hard_cases / sizeof *hard_cases;

const struct hard_case friendly_cases[] = {
    {"hollow", "", 0.4, 1.5, STANDARD, 3, 0.1,
     .check = {REF_J, REF_J0, REF_FUEL_EXACT, REF_KINETIC, REF_OMEGASQ, REF_DURATION}},
    {"massive", "", 0.4, 1.5, STANDARD, 4, 0.1,
     .check = {REF_DH, REF_J0, REF_THETA_M, REF_BARRIER, REF_MARGIN, REF_R_MAX}},
    {"paper", "", 0.3, 1.2, STANDARD, 3, 0.2, .paper = true,
     .check = {REF_DH, REF_FUEL_PAPER, REF_KINETIC, REF_OMEGASQ, REF_THETA_1, REF_SLOPE}},
    {"pair", "", 0.4, 1.5, STANDARD, 3, 0.2,
     .check = {REF_PAIR, REF_THETA_C, REF_THETA_F, REF_THETA_INF, REF_ARM_A, REF_ARM_B}},
};
const int friendly_cases_number = sizeof friendly_cases / sizeof *friendly_cases;

#define NONE   ((double)NAN)
#define INF    ((double)INFINITY)
#define OF(q_) 0.4, 1.5, STANDARD, 3, q_

const struct refusal refusals[] = {
    {"r s > 1", 0.7, 1.5, STANDARD, 3, 0, REF_THETA_C, DOM_OUT_OF_REACH},
    {"r s > 1 by two roundings", 0.3, 1 / 0.3 * (1 + 4e-16), STANDARD, 3, 0, REF_FUEL_EXACT,
     DOM_OUT_OF_REACH},
    {"s = 0", 0, 1.5, STANDARD, 3, 0, REF_THETA_C, DOM_BAD_PARAMETER},
    {"s < 0", -0.1, 1.5, STANDARD, 3, 0, REF_DH, DOM_BAD_PARAMETER},
    {"s too small", 9.99e-7, 1.5, STANDARD, 3, 0, REF_R_MAX, DOM_BAD_PARAMETER},
    {"s > 1", 1.001, 1, STANDARD, 3, 0, REF_PAIR, DOM_BAD_PARAMETER},
    {"s is no number", NONE, 1, STANDARD, 3, 0, REF_KINETIC, DOM_BAD_PARAMETER},
    {"r < 1", 0.4, 1 - 0x1p-53, STANDARD, 3, 0, REF_MARGIN, DOM_BAD_PARAMETER},
    {"r too large", 1e-6, 1.001e6, STANDARD, 3, 0, REF_THETA_C, DOM_BAD_PARAMETER},
    {"r is infinite", 0.4, INF, STANDARD, 3, 0, REF_THETA_C, DOM_BAD_PARAMETER},
    {"d = 0", 0.4, 1.5, 0, 3, 0, REF_BARRIER, DOM_BAD_PARAMETER},
    {"d too small", 0.4, 1.5, 9.99e-13, 3, 0, REF_BARRIER, DOM_BAD_PARAMETER},
    {"d too large", 0.4, 1.5, 100.1, 3, 0, REF_BEST_S, DOM_BAD_PARAMETER},
    {"d is no number", 0.4, 1.5, NONE, 3, 0, REF_DURATION, DOM_BAD_PARAMETER},
    {"q = 0", 0.4, 1.5, STANDARD, 0, 0, REF_J0, DOM_BAD_PARAMETER},
    {"q < 0", 0.4, 1.5, STANDARD, -3, 0, REF_STOP, DOM_BAD_PARAMETER},
    {"q too large", 0.4, 1.5, STANDARD, 100.1, 0, REF_OMEGASQ, DOM_BAD_PARAMETER},
    {"q is infinite", 0.4, 1.5, STANDARD, INF, 0, REF_LAUNCH_OMEGASQ, DOM_BAD_PARAMETER},
    {"tilt < 0", OF(-1e-300), REF_DH, DOM_BAD_TILT},
    {"tilt < 0, contact", OF(-0x1p-1074), REF_THETA_1, DOM_BAD_TILT},
    {"tilt < 0, cycle", OF(-1), REF_OMEGASQ, DOM_BAD_TILT},
    {"tilt beside theta_c", OF(PART_OF_C(1 + 1e-14)), REF_DH, DOM_BAD_TILT},
    {"tilt beside theta_c, contact", OF(PART_OF_C(1 + 1e-14)), REF_SLOPE, DOM_BAD_TILT},
    {"tilt beside theta_c, cycle", OF(PART_OF_C(1 + 1e-14)), REF_OMEGASQ, DOM_BAD_TILT},
    {"tilt beyond theta_c", OF(1.5), REF_J, DOM_BAD_TILT},
    {"tilt is no number", OF(NONE), REF_DH, DOM_BAD_TILT},
    {"tilt is infinite", OF(INF), REF_ARM_A, DOM_BAD_TILT},
    {"no fuel, launch", 0.3, 1.1, 1.5, 3, 0, REF_LAUNCH_OMEGASQ, DOM_NO_FUEL},
    {"no fuel, margin", 0.3, 1.1, 1.5, 3, 0, REF_MARGIN, DOM_NO_FUEL},
    {"no fuel, cycle", 0.3, 1.1, 1.5, 3, 0.1, REF_OMEGASQ, DOM_NO_FUEL},
    {"no fuel, stop", 0.3, 1.1, 1.5, 3, 0.1, REF_STOP, DOM_NO_FUEL},
    {"no fuel, duration", 0.3, 1.1, 1.5, 3, 0.1, REF_DURATION, DOM_NO_FUEL},
    {"fuel just below 0", 0.00633775, 1, STANDARD, 3, 0, REF_KINETIC, DOM_NO_FUEL},
    {"beyond the stop", 0.5, 1.999, STANDARD, 3, 0.1, REF_OMEGASQ, DOM_STOPS},
    {"behind the barrier", 0.5, 1.999, STANDARD, 3, 1.4, REF_OMEGASQ, DOM_STOPS},
    {"a cycle that stops", 0.5, 1.999, STANDARD, 3, 0, REF_DURATION, DOM_STOPS},
    {"no separation grows", 0.4, 1, 1.5, 3, 0, REF_BEST_R, DOM_NO_GROWTH},
    {"millions of dominoes", 1e-6, 1, 1e-12, 3, 0, REF_J0, DOM_TOO_LONG},
    {"r^(2q+1) too large", 1e-6, 1e6, STANDARD, 60, 0, REF_KINETIC, DOM_UNDERFLOW},
};
const int refusals_number = sizeof refusals / sizeof *refusals;
