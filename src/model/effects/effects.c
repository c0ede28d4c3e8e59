/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The descriptions of all effects, and functions for the values of the effects that are on. */
#include "effects/effects.h"

const struct dom_effect dom_energy_balance = {
    .name = "energy balance",
    .adds = "no effect: contacts without friction take no energy",
    .help = "Kinetic energy and height are kept through a cycle (21; c3), and the collision keeps "
            "angular momentum (22; c4), so a train that repeats itself has its kinetic energy in closed form "
            "(24; c6).",
    .source = "J. M. J. van Leeuwen, Domino Magnification",
    .plan = "energy balance (21; c3) (22; c4) (24; c6), not integrated",
};

/* The words of struct dom_error.uniform. */
static const char *const distributions[] = {"normal", "uniform", NULL};

const struct dom_effect dom_effects[DOM_EFFECT_COUNT] = {
    [DOM_EFFECT_friction] =
        {
            .name = "friction",
            .synonyms = "mu rub rough sandpaper slippery coefficient",
            .adds = "Coulomb friction between dominoes, also in the collision",
            .help =
                "Wood on wood has 0.2 to 0.5; 0 is the paper's model. The tip of each follower slides down "
                "the "
                "face of its leader; there the force mu N acts along the face, where N is the contact force. "
                "The "
                "arms of a contact become a = Y/r - L x - mu d on the leader and b = (Y + mu X)/r on the "
                "follower. The torques add up with S_0 = 1, S_{i+1} = S_i a_i/b_i. For w = tau^2 omega^2 the "
                "equation of motion is (A/2) dw/dtheta + B w = C, with A = sum r^-(q+1)i S_i theta_i', B = "
                "sum "
                "r^-(q+1)i S_i theta_i'', C = 1/2 sum r^-qi S_i (x_i - d y_i). The collision keeps (A(0) - "
                "1)/A(0) of the angular velocity. The barrier is the kinetic energy that the train needs to "
                "come "
                "over the hardest tilt. The verdict 'locks' exists with friction only: near r s = 1 the "
                "force on "
                "the struck domino passes on the wrong side of its hinge and cannot turn it. 'fuel paper' "
                "cannot "
                "be combined with friction: there is no closed form of the fuel.",
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
            .adds = "a floor that slopes, downhill where ALPHA > 0",
            .help =
                "An upright domino stands only where |ALPHA| is below theta_u, the angle at which it tips "
                "over, "
                "tan theta_u = d. One degree changes r_max by 5 to 8 %. Tilts are measured from the normal "
                "of "
                "the floor. The potential energy of a domino is then h(theta) = cos(theta + alpha) + d "
                "sin(theta "
                "+ alpha), in H, in the fuel P, in the barrier and in the forces; with friction C = 1/2 sum "
                "r^-qi S_i (sin(theta_i + alpha) - d cos(theta_i + alpha)). 'fuel paper' cannot be combined "
                "with "
                "a slope: there is no closed form of the fuel.",
            .source = "the potential energy of a block on an inclined plane",
            .plan = "the potential energy turned by alpha",
            .argument = {{.name = "ALPHA",
                          .unit = "rad",
                          .meaning = "angle by which the floor falls in the direction of the train",
                          .lowest = (dom_real)-1.5,
                          .highest = (dom_real)1.5,
                          .usual = (dom_real)0.0174532925199432957692}},
        },
    [DOM_EFFECT_walls] =
        {
            .name = "walls",
            .synonyms = "box hollow boards plywood inertia shell",
            .adds = "the moment of inertia of boxes of six walls",
            .help =
                "Without it a domino is a solid block, also where 'q' is hollow. A train has dominoes of one "
                "shape, "
                "each with walls of the same share of its height: only times change, since the moment of "
                "inertia is "
                "in tau alone; thin walls take 2.8 % longer. In a row all dominoes are boxes of the same "
                "boards, of "
                "THICKNESS times the height of the first domino, or of a length such as 'effect walls 12 "
                "mm': "
                "inertia and masses that follow from a density are those of the boxes. Walls of half of the "
                "thickness make a solid block. A domino is half as wide as tall. The moment of inertia about "
                "the "
                "lower edge is that of a solid block of the same mass, times 1 + v (1 - u)/(4 (1 - v)), with "
                "the "
                "volume of the hollow v = (1 - 2 t)(1 - 2 t/d)(1 - 4 t), and u = ((1 - 2 t)^2 + (d - 2 "
                "t)^2)/(1 + "
                "d^2).",
            .source = "moments of inertia of two blocks, one cut out of the other; the parallel axis",
            .plan = "one factor of the moment of inertia, in closed form",
            .argument = {{.name = "THICKNESS",
                          .unit = "h",
                          .meaning = "thickness of the walls over the height of the domino, or a length",
                          .lowest = (dom_real)1 / 1000000000,
                          .highest = 1,
                          .usual = (dom_real)1 / 48}},
            .cancels = true,
        },
    [DOM_EFFECT_edges] =
        {
            .name = "edges",
            .synonyms = "rho rounded round radius corner bevel rolling foot",
            .adds = "edges rounded with a radius, which roll on the floor",
            .help =
                "The radius of the edges is RADIUS times the height, the same share for each domino of a "
                "train; "
                "a file of a row may give each domino a radius of its own. It is at most half of the "
                "thickness. "
                "Edges rounded by 1 % of the height, as dominoes on sale have them, raise r_max by about 7 "
                "%. "
                "The foot rolls on the floor without slipping, and the round upper edge of a follower slides "
                "down the flat back of its leader. With l = 1 - 2 rho the potential energy of a domino is "
                "h(theta) = 2 rho + l cos theta + (d - 2 rho) sin theta. The inertia is that about the line "
                "of "
                "contact with the floor: J = sum r^-(q+1)i i(theta_i) theta_i'^2, and the collision keeps "
                "(J(0) "
                "- i(0))/J(0) of the angular velocity. The head hits the next domino where rho theta_c + l "
                "sin "
                "theta_c = r s. No error bounds are known, and growths are sampled, as with friction. 'fuel "
                "paper' cannot be combined with rounded edges: there is no closed form of the fuel.",
            .source = "rigid bodies that roll and slide, after J. M. J. van Leeuwen, Domino Magnification",
            .plan = "contacts by Newton's method, inertia i(theta)",
            .argument = {{.name = "RADIUS",
                          .unit = "h",
                          .meaning = "radius of the edges over the height",
                          .lowest = 0,
                          .highest = (dom_real)0.49,
                          .usual = (dom_real)0.01}},
        },
    [DOM_EFFECT_row] =
        {
            .name = "row",
            .synonyms = "file csv load measurements list finite spacing",
            .adds = "a finite row of dominoes, equal or not, instead of the endless train",
            .help = "With N, domino k is h r^(k-1) tall; its gap is s times its own height, and its mass is "
                    "what q says. "
                    "FILE is a csv file with a line for each domino and the columns height, thickness, gap "
                    "and, if "
                    "known, mass or density; units are in its first line, as in 'height (mm)', or in its "
                    "cells. The row "
                    "starts with a push ('effect push'), or with its first domino tipped over its edge. "
                    "'fall' runs it. "
                    "Domino j leans on k = j + 1, where h_j sin(theta_j - theta_k) = (gap_k + d_k) cos "
                    "theta_k - d_k. "
                    "The energy is H = sum m g (h cos theta + d sin theta)/2, the inertia is sum I theta'^2, "
                    "and the "
                    "collision is that of the train with these sums. The model ends, and the answer says so, "
                    "where an "
                    "upper edge would pass above the next domino and where a contact would have to pull.",
            .source =
                "energy balance and collision of the paper, (19; c1) to (22; c4), with sizes for each domino",
            .plan = "for each head: kinetic energy against the top of H",
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
            .adds = "a push of the first domino, which then starts upright",
            .help = "Without a push the first domino starts on its edge, where it just tips over (tan "
                    "theta_u = d), "
                    "and is let go; the clock starts when it hits the second domino. With a push it starts "
                    "upright, "
                    "and the clock starts with the push. A standard domino needs about 2.5 rad/s to tip "
                    "over; with a "
                    "weaker push the verdict is that the row stops at domino 1. A row whose first domino "
                    "touches the "
                    "second before it tips over needs a push.",
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
            .adds = "random errors of the gaps, and of the heights if HEIGHTS is given",
            .help =
                "The row is set up again and again. Each gap has a normal error of its own with the standard "
                "deviation SIGMA, which is a length; each height has a relative error with the standard "
                "deviation HEIGHTS. If LIMITS is 'uniform', SIGMA and HEIGHTS are limits, and all errors "
                "within them are equally likely. Dominoes that would overlap touch. 'placement' counts how "
                "often all dominoes fall, with the exact 95 % interval of Clopper and Pearson, and reports "
                "where rows stop. 'budget' finds the SIGMA that a probability allows. Row number i is the "
                "same "
                "for the same 'seed', with any number of 'threads'. More errors are effects of their own: "
                "error_place, error_thickness, error_mass, error_lean and error_radius of each domino, and "
                "error_friction, error_slope, error_floor and error_push of the whole row.",
            .source = "C. J. Clopper and E. S. Pearson, Biometrika 26, 404 (1934), for the interval; "
                      "generators of GSL",
            .plan = "many rows, verdicts only, on all processors",
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
                          .meaning = "whether errors are normal or uniform within limits",
                          .lowest = 0,
                          .highest = 1,
                          .usual = 0,
                          .optional = true,
                          .words = distributions}},
            .needs = 1U << DOM_EFFECT_row,
        },
    [DOM_EFFECT_floor] =
        {
            .name = "floor",
            .synonyms = "feet foot slip slide slippery ground",
            .adds = "the friction that the floor needs so that no foot slips",
            .help = "With it, 'fall' and 'slip' report the friction coefficient that the floor needs so that "
                    "no foot "
                    "slips. The motion is computed for feet that do not slip: the answer says where a domino "
                    "would first "
                    "slip on a floor with MU. Newton's law for the centre of each block gives the force R of "
                    "the floor "
                    "at its hinge: mass times acceleration, minus gravity and the forces of the contacts. "
                    "The hinge "
                    "holds while |R_x|/R_z is below MU. In the collision the same holds for the impulses; "
                    "for the struck "
                    "domino the ratio is |1/2 - (1 + d^2)/(3 a)|/(d/2), which is 0 if the domino is hit at "
                    "its centre of "
                    "percussion. A domino that would be lifted needs more friction than any floor has.",
            .source = "Newton's law for a hinged block; the centre of percussion is textbook mechanics",
            .plan = "forces at samples, closer around the largest",
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

const struct dom_effect *dom_dynamics(const struct dom_train *train)
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
