/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "effects/effects.h"

const struct dom_effect dom_effect_row = {
    .name = "row",
    .synonyms = "file csv load measurements list finite spacing",
    .adds = "a finite row of dominoes, equal or not, instead of the endless train",
    .help =
        "With a number N, domino k is h r^(k-1) tall, the gap before it is s times its height, "
        "and its mass follows from q. FILE is a csv file with a line for each domino and the "
        "columns height, thickness, gap (or pitch, or position) and, if known, mass or density. Units "
        "are written in the first line, as in 'height (mm)', or in the cells. The row starts with a "
        "push ('set push'), from a tilt ('set release'), or with its first domino at the point of tipping "
        "over. 'fall' runs the row. "
        "Domino j leans on domino k = j + 1. If an upper edge would pass above the next domino, or if a "
        "contact would have to pull, the model does not apply, and the output ends with a message.",
    .source = "energy balance and collision of the paper, (19; c1) to (22; c4), for dominoes of any sizes",
    .plan = "for each head: kinetic energy compared with the maximum of H",
    .equations =
        (const char *const[]){"h_j sin(theta_j - theta_k) = (gap_k + d_k) cos theta_k - d_k",
                              "H = sum m g (h cos theta + d sin theta)/2", "J = sum I theta'^2",
                              "omega_k(0) = omega_j T/(1 + T), T = J of the dominoes before k / I_k", NULL},
    .argument = {{.name = "N",
                  .unit = "",
                  .meaning = "number of dominoes",
                  .lowest = 1,
                  .highest = 100000,
                  .usual = 20,
                  .whole = true,
                  .or_file = "a csv file of dominoes"}},
};
