/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Friction between dominoes: what it is; how it is computed stands in friction.c of the model. */
#include "numerics/api.h"

const struct dom_effect effect_friction = {
    .name = "friction",
    .adds = "Coulomb friction between dominoes, also in the collision",
    .help =
        "The tip of each follower slides down its leader's face, with the force mu N against it. The arms of "
        "a "
        "contact are then a = Y/r - L x - mu d on the leader and b = (Y + mu X)/r on the follower, and the "
        "torques add up with S_0 = 1, S_{i+1} = S_i a_i/b_i: (A/2) dw/dtheta + B w = C for w = tau^2 "
        "omega^2, "
        "A = sum r^-(q+1)i S_i theta_i', B = sum r^-(q+1)i S_i theta_i'', C = 1/2 sum r^-qi S_i (x_i - d "
        "y_i). "
        "The collision keeps (A(0) - 1)/A(0) of the angular velocity. The barrier is what kinetic energy it "
        "takes to come over the hardest tilt. mu = 0 is the paper. Wood on wood has 0.2 to 0.5. "
        "The verdict 'locks' is new: near r s = 1 the force on the struck domino passes behind its hinge and "
        "cannot turn it. There is no closed form of the fuel: 'set fuel paper' excludes friction.",
    .source = "J. M. J. van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010)",
    .plan = "the motion, linear in omega^2: Chebyshev series",
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient",
                  .lowest = 0,
                  .highest = DOM_MU_HIGHEST,
                  .usual = (dom_real)0.2}},
};
