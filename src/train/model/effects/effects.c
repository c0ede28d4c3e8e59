/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The descriptions of all effects, and the functions of effects.h. */
#include "effects/effects.h"

const struct dom_effect dom_energy_balance = {
    .name = "energy balance",
    .adds = "no effect: contacts without friction dissipate no energy",
    .help = "The sum of kinetic and potential energy is constant during a cycle (21; c3), and the collision "
            "conserves angular momentum (22; c4). This gives a closed form for the kinetic energy of a train "
            "whose cycles repeat (24; c6).",
    .source = "J. M. J. van Leeuwen, Domino Magnification",
    .plan = "energy balance (21; c3) (22; c4) (24; c6), not integrated",
};

/* The words for the distribution of errors, indexed by the member `uniform` of struct dom_random_error. */
static const char *const distributions[] = {"normal", "uniform", NULL};

const struct dom_effect dom_effects[DOM_EFFECT_COUNT] = {
    [DOM_EFFECT_friction] =
        {
            .name = "friction",
            .synonyms = "mu rub rough sandpaper slippery coefficient",
            .adds = "Coulomb friction between dominoes, in motion and in the collision",
            .help =
                "MU is the friction coefficient: 0.2 to 0.5 for wood on wood, and 0 in the paper's model. "
                "The tip of each follower slides down the face of its leader, and a friction force mu N acts "
                "along the face, where N is the contact force. The lever arms of a contact become a = Y/r - "
                "L x - mu d on the leader and b = (Y + mu X)/r on the follower. In the sum of the torques, "
                "domino i has the weight S_i, where S_0 = 1 and S_(i+1) = S_i a_i/b_i. For w = tau^2 omega^2 "
                "the equation of motion is (A/2) dw/dtheta + B w = C, with A = sum r^(-(q+1) i) S_i "
                "theta_i', B "
                "= sum r^(-(q+1) i) S_i theta_i'', C = 1/2 sum r^(-q i) S_i (x_i - d y_i). In the collision "
                "the "
                "angular velocity is multiplied by (A(0) - 1)/A(0). The barrier is the kinetic energy that "
                "the train needs to pass every tilt of the cycle. The verdict 'locks' is possible only with "
                "friction: near r s = 1 the force on the struck domino passes on the wrong side of its hinge "
                "and cannot turn it. 'fuel paper' cannot be combined with friction: the paper's closed form "
                "of the fuel does not include this effect.",
            .source = "J. M. J. van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010)",
            .plan = "equation of motion, linear in omega^2: Chebyshev series",
            .dissipates = true,
            .argument = {{.name = "MU",
                          .unit = "",
                          .meaning = "friction coefficient",
                          .lowest = 0,
                          .highest = DOM_MU_HIGHEST,
                          .usual = (dom_real)0.2}},
        },
    [DOM_EFFECT_slope] =
        {
            .name = "slope",
            .synonyms = "alpha hill incline ramp tilt downhill uphill",
            .adds = "a sloping floor, downhill if ALPHA > 0",
            .help =
                "A domino can stand upright only if |ALPHA| is less than theta_u, the angle at which it "
                "tips over (tan theta_u = d with sharp edges). At separations from 0.2 to 0.4, one "
                "degree downhill raises "
                "r_max by 4 to 8 %, and one degree uphill lowers it by 3 to 6 %. Tilts are "
                "measured from the normal to the floor. The potential energy of a domino is then "
                "h(theta) = cos(theta + alpha) + d sin(theta + alpha). This changes H, the fuel P, the "
                "barrier and the forces. With friction, C = 1/2 sum r^(-q i) S_i (sin(theta_i + alpha) - d "
                "cos(theta_i + alpha)). 'fuel paper' cannot be combined with a slope: the paper's closed "
                "form of the fuel does not include this effect.",
            .source = "the potential energy of a block on an inclined plane",
            .plan = "the potential energy, with the tilt increased by alpha",
            .argument = {{.name = "ALPHA",
                          .unit = "rad",
                          .meaning =
                              "angle of the floor, positive if it slopes down in the direction of the train",
                          .lowest = (dom_real)-1.5,
                          .highest = (dom_real)1.5,
                          .usual = (dom_real)0.0174532925199432957692}},
        },
    [DOM_EFFECT_walls] =
        {
            .name = "walls",
            .synonyms = "box hollow boards plywood inertia shell",
            .adds = "the moment of inertia of boxes made of six walls",
            .help = "Without this effect the moment of inertia is that of a solid block, even if 'q' "
                    "is hollow. In a train, the thickness of the walls is the same fraction of the "
                    "height for every domino. The walls then change only tau, the unit of time, and "
                    "the friction that the floor needs. For the standard domino with thin walls, all "
                    "times are 2.8 % longer.\n\n"
                    "In a row, all dominoes are boxes made of the same "
                    "boards, whose thickness is THICKNESS times the height of the first domino, or a "
                    "length as in 'set walls 12 mm'. With ABOVE, as in 'set walls 12 mm 30 cm', "
                    "only the dominoes of a row that are taller than ABOVE are boxes, and all others "
                    "are solid. The endless train then consists of solid dominoes. If ABOVE is given "
                    "and the row does not come from a file, masses follow from the volumes of the "
                    "blocks and boxes, and 'q' has no effect.\n\n"
                    "The moments of inertia of boxes, and "
                    "masses computed from a density, take the walls into account. Walls half as thick "
                    "as the domino make a solid block. 'set width', a file or 'change' gives the width of "
                    "a domino; by default it is half of the height.\n\n"
                    "The moment of inertia about the lower edge "
                    "is that of a solid block of the same mass, times 1 + v (1 - u)/(4 (1 - v)), "
                    "where the hollow has the volume v = (1 - 2 t)(1 - 2 t/d)(1 - 4 t), and u = ((1 - "
                    "2 t)^2 + (d - 2 t)^2)/(1 + d^2).",
            .source =
                "moment of inertia of a block with a smaller block cut out, and the parallel-axis theorem",
            .plan = "moment of inertia of a box, in closed form",
            .argument = {{.name = "THICKNESS",
                          .unit = "h",
                          .meaning =
                              "thickness of the walls divided by the height of the domino, or a length",
                          .lowest = (dom_real)1 / 1000000000,
                          .highest = 1,
                          .usual = (dom_real)1 / 48},
                         {.name = "ABOVE",
                          .unit = "m",
                          .meaning = "height; in a row, only taller dominoes are boxes",
                          .lowest = 0,
                          .highest = (dom_real)1e9,
                          .usual = 0,
                          .optional = true}},
            .cancels = true,
        },
    [DOM_EFFECT_edges] =
        {
            .name = "edges",
            .synonyms = "rho rounded round radius corner bevel rolling foot",
            .adds = "rounded edges, on which dominoes roll as they tip over",
            .help = "The radius of the edges is RADIUS times the height, for every domino of a train; in a "
                    "row from a file each domino can have a radius of its own. The radius is at most half of "
                    "the thickness. Edges rounded by 1 % of the height, like those of shop-bought dominoes, "
                    "raise r_max by 4 to 8 % at separations from 0.2 to 0.4. The foot rolls on the floor "
                    "without slipping, and the round "
                    "upper edge of a follower slides down the flat back of its leader. With l = 1 - 2 rho "
                    "the potential energy of a domino is h(theta) = 2 rho + l cos theta + (d - 2 rho) sin "
                    "theta. The moment of inertia is taken about the line of contact with the floor: J = sum "
                    "r^-(q+1)i i(theta_i) theta_i'^2, and in the collision the angular velocity is "
                    "multiplied by (J(0) - i(0))/J(0). The head hits the next domino at the tilt theta_c, "
                    "with rho theta_c + l sin theta_c = r s. No error bounds are known, and r_max is found "
                    "from samples of the growth, as with friction. 'fuel paper' cannot be combined with "
                    "rounded edges: the paper's closed form of the fuel does not include this effect.",
            .source = "rigid bodies that roll and slide, after J. M. J. van Leeuwen, Domino Magnification",
            .plan = "contacts by Halley's method, inertia i(theta)",
            .argument = {{.name = "RADIUS",
                          .unit = "h",
                          .meaning = "radius of the edges divided by the height",
                          .lowest = 0,
                          .highest = (dom_real)0.49,
                          .usual = (dom_real)0.01}},
        },
    [DOM_EFFECT_row] =
        {
            .name = "row",
            .synonyms = "file csv load measurements list finite spacing",
            .adds = "a finite row of dominoes, equal or not, instead of the endless train",
            .help = "With a number N, domino k is h r^(k-1) tall, the gap before it is s times its height, "
                    "and its mass follows from q. FILE is a csv file with a line for each domino and the "
                    "columns height, thickness, gap and, if known, mass or density. Units are written in the "
                    "first line, as in 'height (mm)', or in the cells. The row starts with a push ('set "
                    "push'), or with its first domino at the point of tipping over. 'fall' runs the row. "
                    "Domino j leans on domino k = j + 1. Their tilts satisfy h_j sin(theta_j - theta_k) = "
                    "(gap_k + d_k) cos theta_k - d_k. The energy is H = sum m g (h cos theta + d sin "
                    "theta)/2, the inertia is sum I theta'^2, and the collision is that of the train, "
                    "computed with these sums. If an upper edge would pass above the next domino, or if a "
                    "contact would have to pull, the "
                    "model does not apply, and the output ends with a message.",
            .source =
                "energy balance and collision of the paper, (19; c1) to (22; c4), for dominoes of any sizes",
            .plan = "for each head: kinetic energy compared with the maximum of H",
            .argument = {{.name = "N",
                          .unit = "",
                          .meaning = "number of dominoes",
                          .lowest = 1,
                          .highest = 100000,
                          .usual = 20,
                          .whole = true,
                          .or_file = "a csv file of dominoes"}},
        },
    [DOM_EFFECT_push] =
        {
            .name = "push",
            .synonyms = "start finger kick speed velocity",
            .adds = "a push on the first domino, which then starts upright",
            .help = "Without a push the first domino is let go at the angle at which it begins to tip over "
                    "(tan theta_u = d), and the clock starts when it hits the second domino. With a push the "
                    "first domino starts upright, and the clock starts with the push. A standard domino "
                    "needs about 2.5 rad/s to tip over; with a weaker push the row stops at domino 1. If the "
                    "first domino touches the second before it tips over, the row needs a push.",
            .source = "energy of a single domino, (6; b2) and (9; b5)",
            .plan = "omega^2 of the first domino",
            .argument = {{.name = "OMEGA",
                          .unit = "rad/s",
                          .meaning = "angular velocity of the first domino",
                          .lowest = 0,
                          .highest = (dom_real)1e6,
                          .usual = 5}},
            .needs = 1U << DOM_EFFECT_row,
        },
    [DOM_EFFECT_placement] =
        {
            .name = "placement",
            .synonyms = "probability chance errors precision accuracy error_gap error_height gaps heights",
            .adds = "random errors in the gaps, and in the heights if HEIGHTS is given",
            .help = "The row is set up many times. Each gap has a normally distributed error with the "
                    "standard deviation SIGMA, which is a length, and each height has a relative error with "
                    "the standard deviation HEIGHTS. If LIMITS is 'uniform', SIGMA and HEIGHTS are limits, "
                    "and all errors within them are equally likely. Dominoes that would overlap are moved "
                    "until they touch. 'placement' counts how often all dominoes fall, gives the exact 95 "
                    "% interval of Clopper and Pearson, and reports where rows stop. 'budget' finds the "
                    "SIGMA at which a given share of the rows falls. With the same 'seed', row number i "
                    "is always the same, with any number of 'threads'. Other errors have separate "
                    "effects: error_place, error_thickness, error_mass, error_lean and error_radius for "
                    "each domino, and error_friction, error_slope, error_floor and error_push for the "
                    "whole row.",
            .source = "C. J. Clopper and E. S. Pearson, Biometrika 26, 404 (1934), for the interval; "
                      "pseudo-random numbers from GSL",
            .plan = "verdicts on many random rows, computed on all processors",
            .argument = {{.name = "SIGMA",
                          .unit = "m",
                          .meaning = "standard deviation of every gap",
                          .lowest = 0,
                          .highest = (dom_real)1e9,
                          .usual = (dom_real)1 / 1000},
                         {.name = "HEIGHTS",
                          .unit = "",
                          .meaning = "relative standard deviation of every height",
                          .lowest = 0,
                          .highest = 1,
                          .usual = 0,
                          .optional = true},
                         {.name = "LIMITS",
                          .unit = "",
                          .meaning = "distribution of the errors: normal, or uniform within limits",
                          .lowest = 0,
                          .highest = 1,
                          .usual = 0,
                          .optional = true,
                          .words = distributions}},
        },
    [DOM_EFFECT_floor] =
        {
            .name = "floor",
            .synonyms = "feet foot slip slide slippery ground",
            .adds = "the friction that the floor needs so that no foot slips",
            .help = "With this effect, 'fall' and 'slip' report the friction coefficient that the floor "
                    "needs so that no foot slips, and which domino would slip first on a floor with the "
                    "friction coefficient MU. The motion is computed for feet that do not slip. Newton's law "
                    "for the centre of each block gives the force R of the floor on its foot: mass times "
                    "acceleration, minus gravity and the contact forces. The foot does not slip while "
                    "|R_x|/R_z is below MU. In the collision the same holds for the impulses; for the struck "
                    "domino the ratio is |1/2 - (1 + d^2)/(3 a)|/(d/2), which is 0 if the domino is hit at "
                    "its centre of percussion. If a domino would be lifted off the floor, no amount of "
                    "friction is enough.",
            .source = "Newton's law for a hinged block; the centre of percussion is textbook mechanics",
            .plan = "forces at sampled tilts, with denser samples where the required friction is largest",
            .argument = {{.name = "MU",
                          .unit = "",
                          .meaning = "friction coefficient of the floor",
                          .lowest = 0,
                          .highest = (dom_real)1e6,
                          .usual = (dom_real)0.5}},
        },
};

const struct dom_effect *dom_effect(enum dom_effect_name name)
{
    return name < DOM_EFFECT_COUNT ? &dom_effects[name] : NULL;
}

int dynamics_first(const dom_real effect[DOM_DYNAMICS_COUNT])
{
    int k = 0;
    while (k < DOM_DYNAMICS_COUNT && (!dynamics_on(effect[k]) || dom_effects[k].cancels))
        k++;
    return k;
}

enum dom_status dynamics_check(const dom_real effect[DOM_DYNAMICS_COUNT])
{
#define STATUS(effect, member, status) status,
    static const enum dom_status bad[] = {DOM_DYNAMICS(STATUS)};
#undef STATUS
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++) {
        const struct dom_effect_argument *argument = dom_effects[k].argument;
        if (dynamics_on(effect[k]) && !(effect[k] >= argument->lowest && effect[k] <= argument->highest))
            return bad[k];
    }
    return DOM_OK;
}

#define VALUE(effect, member, status) train->member,

const struct dom_effect *dom_first_effect(const struct dom_train *train)
{
    const dom_real value[] = {DOM_DYNAMICS(VALUE)};
    int k = dynamics_first(value);
    return k < DOM_DYNAMICS_COUNT ? &dom_effects[k] : NULL;
}

const struct dom_effect *dom_law(const struct dom_train *train)
{
    const dom_real value[] = {DOM_DYNAMICS(VALUE)};
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        if (dynamics_on(value[k]) && dom_effects[k].dissipates)
            return &dom_effects[k];
    return &dom_energy_balance;
}
