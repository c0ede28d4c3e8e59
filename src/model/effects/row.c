/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A finite row in the place of the endless train: what it is; row.c of the model runs it. */
#include "numerics/api.h"

const struct dom_effect dom_effect_row = {
    .name = "row",
    .adds = "a finite row, alike or not, in place of the train",
    .help =
        "Domino j leans on k = j + 1 at h_j sin(theta_j - theta_k) = (gap_k + d_k) cos theta_k - d_k; the "
        "energy is "
        "H = sum m g (h cos theta + d sin theta)/2, the inertia sum I theta'^2, the collision that of the "
        "train "
        "with these. With N, domino k is h r^(k-1) tall, as far from the one before as s of its own height, "
        "and "
        "as heavy as q says. A file gives every domino of its own: a csv with the columns height, thickness, "
        "gap "
        "and, if known, mass or density, with units in its head, 'height (mm)', or in its cells. The row "
        "starts "
        "with a push "
        "('effect push') or with the first domino tipped over its edge. Where a tip would pass above the "
        "next "
        "domino, or a contact would have to pull, the model ends, and says so. 'fall' runs it.",
    .source = "energy balance and collision of the paper, (c1) to (c4), with sizes of their own",
    .plan = "each head: kinetic energy against the top of H",
    .argument = {{.name = "N",
                  .unit = "",
                  .meaning = "number of dominoes",
                  .lowest = 1,
                  .highest = 100000,
                  .usual = 20,
                  .whole = true,
                  .or_file = "a csv file of dominoes"}},
};
