/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sweep.h"

#define STANDARD (7.0 / 48)
/* r s = 1 - u */
#define REACH(s, u) ((1 - (u)) / (s))

const struct hard_case hard_cases[] = {
    /* H and H(0) are infinite sums for r = 1: only their difference is finite. */
    {"equal", 0.3, 1, STANDARD, 4, 0.2, .asks = TILT},
    {"equal, wide", 0.9, 1, STANDARD, 3, 0.2, .asks = TILT},
    {"equal, thick", 0.2, 1, 0.5, 3, 0.1, .asks = TILT},
    {"equal, close: a thousand dominoes matter", 0.01, 1, STANDARD, 3, 0.005, .asks = TILT},
    {"equal, very close: fourteen thousand dominoes", 1e-4, 1, STANDARD, 3, 5e-5, .asks = TILT},
    {"equal, paper thin: d = 1e-8, r = 1", 0.01, 1, 1e-8, 3, 5e-3, .asks = TILT},
    {"equal + 1e-12: nearly divergent H", 0.3, 1 + 1e-12, STANDARD, 3, 0.2, .asks = TILT},
    {"close + 1e-12: nearly divergent H, 4000 dominoes", 1e-3, 1 + 1e-12, STANDARD, 3, 2e-4, .asks = TILT},
    {"equal + ulp: r = 1 + 2^-52", 0.2, 1 + 0x1p-52, 0.5, 3, 0.1, .asks = TILT},
    {"close, q = 10: r = 1 + 1e-6", 0.01, 1 + 1e-6, 0.01, 10, 0.001, .asks = TOP},
    {"close, r = 1.0001: 14000 dominoes", 1e-3, 1.0001, 0.01, 10, 0.001, .asks = TILT},

    /* r s -> 1: 1 - r s, 1 - X and 1 - sin theta_f cancel; followers detach at once. */
    {"reach - 1e-15: 1 - r s", 0.3, REACH(0.3, 1e-15), STANDARD, 3, 1e-8, .asks = TOP},
    {"reach - 1e-15, s = 1/2: the follower leaves at 7e-8", 0.5, REACH(0.5, 1e-15), STANDARD, 3, 1e-8,
     .asks = TOP},
    {"reach - 1e-12: x never exceeds x_f", 0.9, REACH(0.9, 1e-12), STANDARD, 3, 1e-8, .asks = TIME},
    {"reach - 1e-6: 1 - r s", 0.7, REACH(0.7, 1e-6), STANDARD, 4, 1e-3, .asks = TOP},
    {"reach, rounded up: r s > 1 by rounding alone", 0.3, 1 / 0.3, STANDARD, 3, 0.1, .asks = TOP},
    {"reach, exactly", 0.5, 2, STANDARD, 3, 0.1, .asks = TOP},
    {"reach, s = 1", 1, 1, STANDARD, 3, 0.1, .asks = TIME},
    {"reach, s = 1e-6: 1 - r s, T = 1e-24", 1e-6, REACH(1e-6, 1e-15), STANDARD, 3, PART_OF_C(0.5),
     .asks = TOP},

    /* J(0) - 1 = r^-(q+1) ... is lost in J(0). */
    {"large r: T = 1e-12", 1e-3, 900, STANDARD, 3, PART_OF_C(0.5), .asks = TOP},
    {"large r, close to reach: T = 1e-12", 0.01, 99, STANDARD, 5, PART_OF_C(0.5), .asks = TOP},
    {"large r, far from reach: T = 1e-23", 1e-6, 5e5, STANDARD, 3, PART_OF_C(0.5), .asks = TOP},
    {"large q: T = 1e-13", 0.2, 2.1, STANDARD, 40, 0.1, .asks = TOP},
    {"q = 100: T = 1e-31", 0.4, 2, STANDARD, 100, 0.1, .asks = TOP},

    /* A follower detaches: x never exceeds x_f, so the sum never meets the paper's condition for its end. */
    {"q = 1/3: detaching, heavy followers", 0.45, 2, STANDARD, 1 / 3.0, 0.3, .asks = TOP},
    {"q = pi: detaching, real q", 0.4, 2, STANDARD, 3.141592653589793, 0.1, .asks = TOP},
    {"q = 3: detaching", 0.45, 2, STANDARD, 3, 0.3, .asks = TIME},
    {"q = 4: detaching", 0.9, 1.1, STANDARD, 4, 0.3, .asks = TIME},
    {"beyond theta_leave: no follower at this tilt", 0.5, 1.9, STANDARD, 3, 0.7, .asks = TOP},
    {"at theta_c: no follower at theta_c", 0.5, 1.9, STANDARD, 3, PART_OF_C(1), .asks = TILT},
    {"beside theta_c: no follower beside theta_c", 0.8, 1.2, STANDARD, 3, PART_OF_C(1 - 1e-15), .asks = TILT},
    {"just detaching: where theta_f meets theta_inf", 0.5, 1.5896, STANDARD, 3, PART_OF_C(0.9), .asks = TILT},
    {"edge of (A17), close: theta_f = theta_inf = theta_leave, small angles", 1e-4, 100, 0.49995, 3,
     PART_OF_C(0.5), .asks = TILT},
    {"edge of (A17), thick: theta_f = theta_inf = theta_leave", 0.01, 1, 49.995, 3, PART_OF_C(0.5),
     .asks = TOP},

    /* Thin and thick dominoes. */
    {"thin: d = 1e-8: dH = 1e-9", 0.4, 2, 1e-8, 3, 1e-8, .asks = TILT},
    {"thin, alone: d = 1e-8: the barrier is 5e-17", 0.4, 2.3, 1e-8, 30, 1e-8, .asks = TOP},
    {"thin, at the reach: d = 1e-8, r s = 1", 0.3, 1 / 0.3, 1e-8, 3, 1e-8, .asks = TOP},
    {"thin, near the reach: a and b differ by d", 0.3, REACH(0.3, 1e-6), 1e-4, 3, 0.05, .asks = TOP},
    {"thinner, near the reach: a and b differ by d", 0.3, REACH(0.3, 1e-10), 1e-8, 3, 0.005, .asks = TOP},
    {"d = 1.5: no fuel, the maximum is at theta_c", 0.3, 1.1, 1.5, 3, 0.05, .asks = TOP},
    {"d = 3: no fuel, the maximum is at theta_c", 0.9, 1, 3, 3, PART_OF_C(0.5), .asks = TOP},
    {"d = 3, growing: no fuel, detaching", 0.1, 5, 3, 3, PART_OF_C(0.5), .asks = TOP},
    {"d = 100: no fuel, small angles", 1e-3, 1, 100, 3, PART_OF_C(0.5), .asks = TILT},

    /* P -> 0+ */
    {"fuel 2e-7", 0.0063378, 1, STANDARD, 3, PART_OF_C(0.5), .asks = TILT},
    {"fuel 1e-12", 0.00633776, 1, STANDARD, 3, PART_OF_C(0.5), .asks = TILT},

    /* margin -> 0+ */
    {"margin 1e-6: duration diverges", 0.4, 1.6442, STANDARD, 4, 0.1, .asks = TIME},
    {"margin 1e-12: duration diverges", 0.4, 1.64422903953, STANDARD, 4, 0.1, .asks = TIME},
    {"margin 1e-9, detaching: duration diverges", 0.4, 2.06377177, STANDARD, 3, 0.1, .asks = TIME},
    {"slow launch: rounding errors of the distance count at the launch", 0.052010575617230437,
     19.226858892691848, 2.2493188156625961e-06, 4, 0, .asks = TIME},

    /* Difficult maxima of H. */
    {"two maxima: H falls first, rises later", 0.54, 1.8515, STANDARD, 3, 0.1, .asks = TIME},
    {"two maxima, at rest: H falls first, rises later", 0.5, 1.999, STANDARD, 3, 0.1, .asks = TOP},
    {"maximum at 0: after the follower detaches, H must not rise again", 0.54, 1.8318, STANDARD, 3, 0.1,
     .asks = TIME},
    {"maximum beside 0: H rises by 1e-11 only", 0.4, 1.5, STANDARD, 3.42071, 0.1, .asks = TOP},
    {"thin, two maxima: H dips within 1e-8, then rises by 4e-18", 0.0029027851676659763, 344.4967306361371,
     2.0823454055730516e-08, 3, 1e-8, .asks = TOP, .paper = true},
    {"maximum at theta_c: close, with the paper's fuel", 0.05, 1.53, STANDARD, 3, PART_OF_C(1), .asks = TOP,
     .paper = true},

    /* Small tilts. */
    {"tilt 1e-15: H(theta) - H(0)", 0.4, 1.5, STANDARD, 3, 1e-15, .asks = TILT},
    {"tilt 1e-30: H(theta) - H(0)", 0.4, 1.5, STANDARD, 3, 1e-30, .asks = TILT},

    /* The first r at which the train stops. */
    {"r_max, detaching: x never exceeds x_f", 0.4, 1, STANDARD, 3, 0, .asks = GROWTH},
    {"r_max, near the reach: the margin falls within 1e-3", 0.5, 1, STANDARD, 3, 0, .asks = GROWTH | PAIR},
    {"r_max, beside the reach: two maxima", 0.6, 1, STANDARD, 4, 0, .asks = GROWTH | PAIR},
    {"r_max, thin: a window of 1e-5 before the reach", 0.327, 1, 0.015, 3.7, 0, .asks = GROWTH | PAIR},
    {"r_max, thin, paper: a window before the reach", 0.3, 1, 0.015, 3.7, 0, .asks = GROWTH, .paper = true},
    {"r_max, close: trains of hundreds", 0.02, 1, STANDARD, 4, 0, .asks = GROWTH},
    {"r_max, q = 1/2: heavy followers; in quad, r_max has 32 units", 0.1, 1, STANDARD, 0.5, 0,
     .asks = GROWTH | PAIR, .units = 40},
    {"r_max, a band: equal dominoes fail, larger ones do not", 0.1, 1, 0.25, 0.5, 0, .asks = PAIR},
    {"r_max, a band up to the reach: equal dominoes fail, larger ones do not", 0.25, 1, 0.2, 0.5, 0,
     .asks = PAIR},
};
const int hard_cases_number = sizeof hard_cases / sizeof *hard_cases;
