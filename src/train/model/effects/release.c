/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "effects/effects.h"

const struct dom_effect dom_effect_release = {
    .name = "release",
    .synonyms = "slanted tilted tilt start angle lean held rest let go",
    .adds = "a first domino that is held at a tilt and released",
    .help =
        "The first domino is held at the tilt ANGLE and let go; it starts at rest, unless 'set push' gives "
        "it an angular velocity there. The clock starts at the release. 'set release touch' holds the "
        "domino against the second one, just at the contact: then both start at rest, and the weight of "
        "the first domino alone has to push the second one over. ANGLE must not be larger than the tilt "
        "at which the two touch. If ANGLE is smaller than the tilt at which the domino tips over "
        "(tan theta_u = d with sharp edges on a level floor), it falls back.",
    .source = "energy balance from a first domino at rest, as in (9; b5)",
    .plan = "height of the first domino at its tilt",
    .argument = {{.name = "ANGLE",
                  .unit = "rad",
                  .meaning = "tilt of the first domino when it is released",
                  .lowest = 0,
                  .highest = (dom_real)1.5707963267948966,
                  .usual = (dom_real)0.3490658503988659}},
    .needs = 1U << DOM_EFFECT_row,
};
