/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Friction between dominoes. The tip of a follower slides down the face of its leader. The Coulomb force mu N
 * along the face brakes both dominoes. The lever arms of the contact are a = Y/r - L x - mu d and b = (Y + mu
 * X)/r. They change the factors S_i of the equation of motion (dynamics/dynamics.h).
 *
 * Source: van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010).
 */
#include "effects/effects.h"

KERNEL enum dom_status friction_apply(struct geometry *geometry, real value)
{
    geometry->mu = value;
    geometry->conservative = false;
    return DOM_OK;
}

const struct dom_effect dom_effect_friction = {
    .name = "friction",
    .synonyms = "mu rub rough sandpaper slippery coefficient",
    .adds = "Coulomb friction between dominoes, in motion and in the collision",
    .help = "MU is 0.2 to 0.5 for wood on wood, and 0 in the paper's model. The tip of each follower slides "
            "down the face of its leader, and the friction force mu N, where N is the contact force, changes "
            "the lever arms of the contact: a on the leader and b on the follower. The barrier is then the "
            "kinetic energy that the train needs to pass every tilt of the cycle. Only with friction can a "
            "train lock: near r s = 1 the force on the struck domino passes on the wrong side of its hinge "
            "and cannot turn it.",
    .source = "J. M. J. van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010)",
    .dissipates = "friction",
    .equations = (const char *const[]){"a = Y/r - L x - mu d", "b = (Y + mu X)/r", NULL},
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient",
                  .lowest = 0,
                  .highest = DOM_MU_HIGHEST,
                  .usual = (dom_real)0.2}},
};
