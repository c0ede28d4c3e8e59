# SPDX-License-Identifier: GPL-3.0-or-later
# Prints when each domino of a row of n equal blocks is hit, without friction, and then when the last one lies on the
# floor. All lengths are in m. Call: awk -v n=20 -v h=0.044 -v d=0.007 -v gap=0.018 -v push=5 -f row.awk
# It is a plain sum of energies: domino k turns about its lower front edge, those behind it lean on each other, energy is
# conserved until a collision, and a collision keeps the momentum at the contact. Nothing here comes from the program.
function asin(x) { return atan2(x, sqrt(1 - x * x)) }
# The energy of position, per m g, and J, the kinetic energy as a moment of inertia of the head, per m.
function chain(k, theta,   j, turn, above, slope) {
    J = H = 0
    turn = 1
    for (j = k; j >= 1; j--) {
        H += (h * cos(theta) + d * sin(theta)) / 2
        J += (h * h + d * d) / 3 * turn * turn
        above = ((gap + d) * cos(theta) - d) / h
        slope = 1 - (gap + d) * sin(theta) / h / sqrt(1 - above * above)
        theta += asin(above)
        turn *= slope
    }
}
# 1/omega of the head at the angle theta, if its energy is E.
function slowness(k, theta, E) { chain(k, theta); return 1 / sqrt(2 * (E - 9.81 * H) / J) }
BEGIN {
    omega = push
    steps = 400
    for (k = 1; k <= n; k++) {
        if (k > 1) printf "%.9f\n", time
        chain(k, 0)
        E = J * omega * omega / 2 + 9.81 * H
        end = k < n ? asin(gap / h) : atan2(1, 0)
        sum = 0
        for (i = 0; i <= steps; i++) sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * slowness(k, end * i / steps, E)
        time += sum * end / steps / 3
        T = 3 * J / (h * h + d * d)
        omega = 1 / slowness(k, end, E) * T / (1 + T)
    }
    printf "%.9f\n", time
}
