/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Air. A plate of the height h and the width w that turns about its lower edge at omega meets a drag of rho
 * C w (omega y)^2 / 2 per unit length at the height y, where rho is the density of the air and C the drag
 * coefficient. The sum over the height is the torque rho C w h^4 omega^2 / 8. The air that moves along adds
 * the moment of inertia of strips of the mass rho pi w^2 / 4 per unit length: rho pi w^2 h^3 / 12. For a
 * domino of the mass m and the thickness d h, with the moment of inertia m h^2 (1 + d^2) / 3 and the density
 * m / (h^2 w d), both are multiples of the ratio of the two densities (effects.h). A domino that moves alone
 * keeps the part exp(-2 k D) of omega^2 while it turns by the angle D, apart from gravity, where k is `drag`
 * of struct geometry.
 *
 * Both are estimates: they leave out the flow of air between two dominoes.
 *
 * In an endless train of solid dominoes, the ratio of the densities is the same for all of them. Other trains
 * are not self-similar in air.
 */
#include "effects/effects.h"

KERNEL enum dom_status air_apply(struct geometry *geometry, real value)
{
    if (geometry->n == CHAIN_ENDLESS && geometry->q != 4)
        return DOM_NO_AIR;
    const real more = air_entrained(geometry->d, geometry->width, value), old = geometry->inertia_factor,
               factor = old + more;
    struct rounded *of = &geometry->rounded;
    if (of->rho != 0) {
        of->i.c = (of->i.c * old + more) / factor;
        of->i.x *= old / factor;
        of->i.y *= old / factor;
        geometry->upright_inertia = of->i.c + of->i.y;
    }
    geometry->inertia_factor = factor;
    geometry->entrained = more / factor;
    const real d = geometry->d; /* the torque divided by omega^2 and by the inertia of a solid block */
    geometry->drag = 3 * AIR_COEFFICIENT * value / (8 * d * (1 + d * d)) / factor;
    geometry->conservative = false;
    return DOM_OK;
}

KERNEL enum dom_status drag_apply(struct geometry *geometry, real value)
{
    geometry->drag *= value / AIR_COEFFICIENT;
    return DOM_OK;
}

const struct dom_effect dom_effect_air = {
    .name = "air",
    .synonyms = "atmosphere wind resistance drag fluid aerodynamic",
    .adds = "the drag of the air, and the inertia of the air that dominoes move",
    .help = "RHO is the density of the air. Light giants feel the air: a hollow domino of 8 m that weighs "
            "1,200 kg loses about a tenth of the energy that a cycle releases. Solid wood loses less than 1 "
            "% of it at any size. A row needs masses: 'set mass', 'set density', or a file. An endless train "
            "must be solid ('set q solid'), because other trains are not self-similar in air; ask about a "
            "row instead. Drag and inertia are estimates for a plate in still air: they leave out buoyancy "
            "and the flow between dominoes. 'set drag' changes the drag coefficient C of 1.2.",
    .source = "quasi-steady drag and added mass of a slender plate, strip by strip; textbook fluid mechanics",
    .dissipates = "the drag of the air",
    .equations = (const char *const[]){"B = sum r^(-(q+1) i) S_i (theta_i'' + k theta_i'^2)",
                                       "k I = rho C w h^4/8, the torque of the drag over omega^2",
                                       "I = m h^2 (1 + d^2)/3 + rho pi w^2 h^3/12, in tau and in collisions",
                                       "omega^2 falls by exp(-2 k D) in a turn by D, without gravity", NULL},
    .argument = {{.name = "RHO",
                  .unit = "kg/m^3",
                  .meaning = "density of the air",
                  .lowest = 0,
                  .highest = 100,
                  .usual = (dom_real)12 / 10}},
};

const struct dom_effect dom_effect_drag = {
    .name = "drag",
    .synonyms = "coefficient resistance air shape",
    .adds = "a drag coefficient other than 1.2",
    .help = "C is the drag coefficient of a domino in the air: 1.1 to 1.3 for plates that are 0.5 to 1 times "
            "as wide as tall, and 2 for an endless strip. If this effect is off, C is 1.2.",
    .source = "measured drag of flat plates across a flow; textbook fluid mechanics",
    .argument = {{.name = "C",
                  .unit = "",
                  .meaning = "drag coefficient",
                  .lowest = (dom_real)1 / 1000,
                  .highest = 100,
                  .usual = (dom_real)12 / 10}},
    .needs = 1U << DOM_EFFECT_air,
};
