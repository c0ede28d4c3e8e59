/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The quantities of a train, with their equations. */
#include "commands/explain/derivation.h"
#include <stddef.h>

/* Q makes the entry of a quantity that is derived, and GIVEN the entry of one that is given. */
#define Q(plain, letters, tex, with_, ends_, sum_, equation_, library_, unit_, reference_, words_)           \
    {                                                                                                        \
        {{plain, letters, tex}}, with_, ends_, sum_, equation_, library_, unit_, reference_, words_, false   \
    }
#define GIVEN(plain, letters, tex, library_, unit_, words_)                                                  \
    {                                                                                                        \
        {{plain, letters, tex}}, 0, 0, SUM_NONE, NULL, library_, unit_, "", words_, true                     \
    }

const struct derived derived_list[] = {
    GIVEN("r", "r", "r", "$r", "", "growth: each domino is r times as large as the one before"),
    GIVEN("s", "s", "s", "$s", "h", "separation: the gap divided by the height"),
    GIVEN("d", "d", "d", "$d", "h", "thickness divided by height"),
    GIVEN("q", "q", "q", "$q", "", "mass exponent: 4 for solid dominoes, 3 for hollow ones"),
    GIVEN("h", "h", "h", "$h", "m", "height of the head"),
    GIVEN("g", "g", "g", "$g", "m/s^2", "acceleration of gravity"),
    GIVEN("alpha", "α", "\\alpha", "$slope", "rad", "slope of the floor"),
    GIVEN("rho", "ρ", "\\rho", "$edges", "h", "radius of the edges divided by the height"),
    GIVEN("theta", "θ", "\\theta", "@", "rad", "tilt of the head"),
    GIVEN("H", "H", "H", "@", "m", "height of the domino to topple"),
    GIVEN("i", "i", "i", NULL, "", "number of a domino behind the head"),
    GIVEN("theta_i", "θ_i", "\\theta_i", NULL, "rad",
          "tilt of domino i; the function theta_1, which gives the tilt of a follower, is applied i times "
          "(27; A2)"),
    GIVEN(
        "slope_i", "θ'_i", "{\\theta'_i}", NULL, "",
        "how fast domino i tilts compared with the head: the product of all slopes up to domino i (33; A9)"),
    GIVEN("start_i", "θ_i(0)", "\\theta_i(0)", NULL, "rad",
          "tilt of domino i when the head is hit, at theta = 0"),
    GIVEN("next_i", "θ_i(θ_c)", "\\theta_i(\\theta_c)", NULL, "rad",
          "tilt of domino i when the head hits the next domino, at theta_c"),
    Q("L", "L", "L", 0, 0, SUM_NONE, "s + d", "s + d", "h", "", "distance from one domino to the next"),
    Q("theta_c", "θ_c", "\\theta_c", HAS_EDGES, HAS_EDGES, SUM_NONE, NULL, "thetac.theta_c", "rad", "",
      "tilt at which the head hits the next domino: rho theta_c + (1 - 2 rho) sin theta_c = r s"),
    Q("theta_c", "θ_c", "\\theta_c", 0, 0, SUM_NONE, "asin(r*s)", "thetac.theta_c", "rad", "2; a2",
      "tilt at which the head hits the next domino"),
    Q("theta_u", "θ_u", "\\theta_u", HAS_EDGES | HAS_SLOPE, 0, SUM_NONE,
      "atan((d - 2*rho)/(1 - 2*rho)) - alpha", "thetac.theta_u", "rad", "",
      "tilt at which a single domino tips over"),
    Q("theta_u", "θ_u", "\\theta_u", HAS_EDGES, 0, SUM_NONE, "atan((d - 2*rho)/(1 - 2*rho))",
      "thetac.theta_u", "rad", "", "tilt at which a single domino tips over"),
    Q("theta_u", "θ_u", "\\theta_u", HAS_SLOPE, 0, SUM_NONE, "asin(d/sqrt(1 + d^2)) - alpha",
      "thetac.theta_u", "rad", "4; b1", "tilt at which a single domino tips over"),
    Q("theta_u", "θ_u", "\\theta_u", 0, 0, SUM_NONE, "asin(d/sqrt(1 + d^2))", "thetac.theta_u", "rad",
      "4; b1", "tilt at which a single domino tips over"),
    Q("theta_inf", "θ_∞", "\\theta_\\infty", 0, HAS_EDGES, SUM_NONE, "acos(d/L)", "thetac.theta_inf", "rad",
      "40; A16", "stacking angle: the tilt of followers far behind"),
    Q("theta_f", "θ_f", "\\theta_f", HAS_EDGES, HAS_EDGES, SUM_NONE, NULL, "thetac.theta_f", "rad", "",
      "the largest tilt of a follower"),
    Q("theta_f", "θ_f", "\\theta_f", HAS_DETACHED, 0, SUM_NONE, "asin((1/r^2 + L^2 - d^2)/(2*L/r))",
      "thetac.theta_f", "rad", "42; A18",
      "the largest tilt of a follower, at which it slides off its leader"),
    Q("theta_f", "θ_f", "\\theta_f", 0, 0, SUM_NONE, "theta_inf", "thetac.theta_f", "rad", "41; A17",
      "the largest tilt of a follower, in a train whose followers never slide off"),
    Q("X", "X", "X", 0, 0, SUM_NONE, "r*(L*cos(theta) - d)", "sin(theta1(@).theta_1 - @)", "", "30; A5",
      "sine of the angle between the head and its follower"),
    Q("Y", "Y", "Y", 0, 0, SUM_NONE, "sqrt(1 - X^2)", "cos(theta1(@).theta_1 - @)", "", "30; A5",
      "cosine of the angle between the head and its follower"),
    Q("theta_1", "θ_1", "\\theta_1", HAS_DETACHED_AT_TILT, 0, SUM_NONE, "theta_f", "theta1(@).theta_1", "rad",
      "42; A18", "tilt of the follower, which has slid off the head"),
    Q("slope_1", "θ'_1", "{\\theta'_1}", HAS_DETACHED_AT_TILT, 0, SUM_NONE, NULL, "theta1(@).slope", "", "",
      "how fast the follower tilts compared with the head: not at all, because it has slid off the head"),
    Q("theta_1", "θ_1", "\\theta_1", 0, HAS_EDGES, SUM_NONE, "theta + asin(X)", "theta1(@).theta_1", "rad",
      "12; b8", "tilt of the follower that leans on the head"),
    Q("a", "a", "a", 0, 0, SUM_NONE, "Y/r - L*sin(theta)", "theta1(@).arm_a", "h", "14; b10",
      "lever arm of the contact force on the head"),
    Q("b", "b", "b", 0, 0, SUM_NONE, "Y/r", "theta1(@).arm_b", "h", "14; b10",
      "lever arm of the contact force on the follower"),
    Q("slope_1", "θ'_1", "{\\theta'_1}", 0, HAS_EDGES, SUM_NONE, "a/b", "theta1(@).slope", "", "14; b10",
      "how fast the follower tilts compared with the head"),
    Q("P", "P", "P", HAS_LOSS, HAS_LOSS, SUM_NONE, NULL, "fuel.fuel", "mgh/2", "",
      "fuel: the energy that a cycle releases, minus the energy that is lost on the way"),
    Q("P", "P", "P", HAS_PAPER, 0, SUM_NONE, "1 - cos(theta_f) - d*sin(theta_f)", "fuel.fuel", "mgh/2",
      "25; c7", "fuel: the energy that a cycle releases, in the paper's closed form"),
    Q("P", "P", "P", HAS_SLOPE, HAS_EDGES, SUM_LAUNCH,
      "r^(-q*i)*(cos(start_i + alpha) + d*sin(start_i + alpha) - cos(next_i + alpha) - d*sin(next_i + "
      "alpha))",
      "fuel.fuel", "mgh/2", "25; c7", "fuel: the energy that a cycle releases"),
    Q("P", "P", "P", 0, HAS_EDGES, SUM_LAUNCH,
      "r^(-q*i)*(cos(start_i) + d*sin(start_i) - cos(next_i) - d*sin(next_i))", "fuel.fuel", "mgh/2",
      "25; c7", "fuel: the energy that a cycle releases"),
    Q("J_0", "J(0)", "J(0)", 0, HAS_EDGES, SUM_LAUNCH, "r^(-(q + 1)*i)*slope_i^2", "launch.J0", "", "20; c2",
      "inertia of the train when the head is hit"),
    Q("w_0", "w(0)", "w(0)", 0, HAS_LOSS | HAS_EDGES, SUM_NONE, "P*(J_0 - 1)/(J_0*(r^q*J_0 - J_0 + 1))",
      "launch.omega0sq", "", "24; c6",
      "tau^2 omega(0)^2, where omega(0) is the angular velocity after the collision"),
    Q("tau", "τ", "\\tau", HAS_WALLS, 0, SUM_NONE, NULL, "duration.tau", "s", "",
      "unit of time of a domino; it is longer for a box made of six walls: 'help walls'"),
    Q("tau", "τ", "\\tau", 0, 0, SUM_NONE, "sqrt((h^2 + (d*h)^2)/(3*g*h))", "duration.tau", "s", "1; a1",
      "unit of time of a domino"),
    Q("omega_0", "ω(0)", "\\omega(0)", 0, 0, SUM_NONE, "sqrt(w_0)/tau", "launch.omega0", "rad/s", "",
      "angular velocity of the head after it is hit"),
    Q("K", "K", "K", 0, HAS_EDGES, SUM_NONE, "J_0*w_0", "launch.kinetic", "mgh/2", "26; c8",
      "kinetic energy of the train after the collision"),
    Q("theta_m", "θ_m", "\\theta_m", 0, 0, SUM_NONE, NULL, "barrier.theta_m", "rad", "26; c8",
      "tilt of the head at the top of the barrier; found by a search over all tilts from 0 to theta_c"),
    Q("B", "B", "B", HAS_LOSS, HAS_LOSS, SUM_NONE, NULL, "barrier.barrier", "mgh/2", "",
      "barrier: the energy that the train needs to go on"),
    Q("B", "B", "B", HAS_EDGES, HAS_EDGES, SUM_NONE, NULL, "barrier.barrier", "mgh/2", "",
      "barrier: the energy that the train needs to go on"),
    Q("B", "B", "B", HAS_SLOPE, 0, SUM_TOP,
      "r^(-q*i)*(cos(theta_i + alpha) + d*sin(theta_i + alpha) - cos(start_i + alpha) - d*sin(start_i + "
      "alpha))",
      "barrier.barrier", "mgh/2", "26; c8", "barrier: the energy that the train needs, H(theta_m) - H(0)"),
    Q("B", "B", "B", 0, 0, SUM_TOP,
      "r^(-q*i)*(cos(theta_i) + d*sin(theta_i) - cos(start_i) - d*sin(start_i))", "barrier.barrier", "mgh/2",
      "26; c8", "barrier: the energy that the train needs, H(theta_m) - H(0)"),
    Q("margin", "margin", "\\mathrm{margin}", 0, 0, SUM_NONE, "K - B", "barrier.margin", "mgh/2", "26; c8",
      "energy that is left at the top of the barrier: the train keeps falling if this is at least 0"),
    Q("dH", "ΔH", "\\Delta H", HAS_SLOPE, HAS_EDGES, SUM_TILT,
      "r^(-q*i)*(cos(theta_i + alpha) + d*sin(theta_i + alpha) - cos(start_i + alpha) - d*sin(start_i + "
      "alpha))",
      "energy(@).dH", "mgh/2", "19; c1", "potential energy of the train, H(theta) - H(0)"),
    Q("dH", "ΔH", "\\Delta H", 0, HAS_EDGES, SUM_TILT,
      "r^(-q*i)*(cos(theta_i) + d*sin(theta_i) - cos(start_i) - d*sin(start_i))", "energy(@).dH", "mgh/2",
      "19; c1", "potential energy of the train, H(theta) - H(0)"),
    Q("J", "J", "J", 0, HAS_EDGES, SUM_TILT, "r^(-(q + 1)*i)*slope_i^2", "energy(@).J", "", "20; c2",
      "inertia of the train"),
    Q("w", "w", "w", 0, HAS_LOSS, SUM_NONE, "(K - dH)/J", "omega(@).omegasq", "", "21; c3",
      "tau^2 omega^2, where omega is the angular velocity at this tilt"),
    Q("omega", "ω", "\\omega", 0, 0, SUM_NONE, "sqrt(w)/tau", "omega(@).omega", "rad/s", "",
      "angular velocity of the head"),
    Q("t_f", "t_f", "t_f", 0, 0, SUM_NONE, NULL, "duration.duration", "tau", "",
      "duration of a cycle: the integral of 1/(tau omega) from 0 to theta_c, by quadrature"),
    Q("seconds", "t", "t", 0, 0, SUM_NONE, "t_f*tau", "duration.seconds", "s", "", "duration of a cycle"),
    Q("speed", "v", "v", 0, 0, SUM_NONE, "(s + d)*r*h/seconds", "duration.speed", "m/s", "",
      "speed of the front during a cycle"),
    Q("r_max", "r_max", "r_{\\max}", HAS_REACH, 0, SUM_NONE, "1/s", "rmax.r_max", "", "2; a2",
      "the largest growth: with a larger one, the head misses the next domino"),
    Q("r_max", "r_max", "r_{\\max}", 0, 0, SUM_NONE, NULL, "rmax.r_max", "", "26; c8",
      "the largest growth, found by a search that raises r from 1 until no energy is left to spare. The "
      "lines "
      "below are for r = r_max"),
    Q("n_exact", "x", "x", 0, 0, SUM_NONE, "ln(H/h)/ln(r)", "count(@).exact", "", "",
      "the number of steps, before it is rounded up"),
    Q("n", "n", "n", 0, 0, SUM_NONE, "ceil(n_exact)", "count(@).dominoes", "", "",
      "the number of dominoes that it takes to topple one of height H"),
    Q("H_n", "H_n", "H_n", 0, 0, SUM_NONE, "h*r^n", "count(@).last_height", "m", "",
      "height of the domino that a row of n dominoes can topple"),
    /* Quantities of a row. */
    Q("margin_k", "margin_k", "\\mathrm{margin}_k", 0, 0, SUM_NONE, "K_k - B_k", "#margin", "mgh/2", "26; c8",
      "energy that is left at the top of the barrier: the row goes on from domino k if this is at least 0"),
    Q("K_k", "K_k", "K_k", 0, 0, SUM_NONE, "E_k - D_k", "#kinetic", "mgh/2", "22; c4",
      "kinetic energy of all moving dominoes just after domino k is hit"),
    Q("E_k", "E_k", "E_k", 0, 0, SUM_NONE, NULL, "#before", "mgh/2", "21; c3",
      "kinetic energy of the moving dominoes just before domino k is hit; it follows from the motion of "
      "dominoes 1 to k - 1, which 'fall' lists"),
    Q("D_k", "D_k", "D_k", 0, 0, SUM_NONE, NULL, "#lost", "mgh/2", "22; c4",
      "kinetic energy lost in the hit: the dominoes stay together, so the collision is fully inelastic"),
    Q("B_k", "B_k", "B_k", 0, 0, SUM_NONE, NULL, "#barrier", "mgh/2", "26; c8",
      "barrier: the energy that the row needs to go on from domino k, found by a search over all tilts of "
      "domino k"),
    {.names = {{NULL}}},
};

const struct explained explained_list[] = {
    {"thetac", NULL, "theta_c theta_u theta_f"},
    {"theta1", "theta", "theta_1 slope_1"},
    {"energy", "theta", "dH J"},
    {"fuel", NULL, "P"},
    {"launch", NULL, "omega_0 K"},
    {"omega", "theta", "omega"},
    {"barrier", NULL, "B theta_m"},
    {"duration", NULL, "seconds speed"},
    {"why", NULL, "margin"},
    {"verdict", NULL, "margin"},
    {"rmax", "s", "r_max margin"},
    {"count", "H", "n H_n"},
    {NULL, NULL, NULL},
};

const char *explained_names(const void *context, int k)
{
    (void)context;
    return explained_list[k].name;
}
