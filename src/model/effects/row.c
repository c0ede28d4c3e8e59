/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A finite row instead of the endless train: its help; row.c of the model runs it. */
#include "numerics/api.h"

const struct dom_effect dom_effect_row = {
    .name = "row",
    .synonyms = "file csv load measurements list finite spacing",
    .adds = "a finite row of dominoes, equal or not, instead of the endless train",
    .help =
        "With N, domino k is h r^(k-1) tall; its gap is s times its own height, and its mass is what q says. "
        "FILE is a csv file with a line for each domino and the columns height, thickness, gap and, if "
        "known, mass or density; units are in its first line, as in 'height (mm)', or in its cells. The row "
        "starts with a push ('effect push'), or with its first domino tipped over its edge. 'fall' runs it. "
        "Domino j leans on k = j + 1, where h_j sin(theta_j - theta_k) = (gap_k + d_k) cos theta_k - d_k. "
        "The energy is H = sum m g (h cos theta + d sin theta)/2, the inertia is sum I theta'^2, and the "
        "collision is that of the train with these sums. The model ends, and the answer says so, where an "
        "upper edge would pass above the next domino and where a contact would have to pull.",
    .source = "energy balance and collision of the paper, (19; c1) to (22; c4), with sizes for each domino",
    .plan = "for each head: kinetic energy against the top of H",
    .argument = {{.name = "N",
                  .unit = "",
                  .meaning = "number of dominoes",
                  .lowest = 1,
                  .highest = 100000,
                  .usual = 20,
                  .whole = true,
                  .or_file = "a csv file of dominoes"}},
};
