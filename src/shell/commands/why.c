/* SPDX-License-Identifier: GPL-3.0-or-later */
/* why: the term that decides. */
#include "commands/walk.h"
#include "interpreter/command.h"
#include "language/quad.h"
#include <string.h>

const struct column why_columns[] = {
    {"verdict", "", "goes on, stops, or no fuel", 7},
    {"fuel", "mgh/2", "P, set free by one cycle (c7)", 0},
    {"J0", "", "J(0): the collision keeps the share 1 - 1/J(0) (c4)", 0},
    {"kinetic", "mgh/2", "K after the collision, P T/(r^q (1+T) - T), T = J(0) - 1 (c6)", 0},
    {"barrier", "mgh/2", "B, to climb (c8)", 0},
    {"margin", "mgh/2", "K - B", 0},
    {"r_max", "", "largest growth at this s: there K = B, or r s = 1", 0},
    {NULL, NULL, NULL, 0},
};

/* The same where dominoes rub. */
static const struct column why_rubbing_columns[] = {
    {"verdict", "", "goes on, stops, or no fuel", 7},
    {"fuel", "mgh/2", "P, set free by one cycle (c7), less what friction takes of it", 0},
    {"J0", "", "J(0), inertia of the train (d8, corrected)", 0},
    {"kinetic", "mgh/2", "K after the collision, of cycles that are alike", 0},
    {"barrier", "mgh/2", "B, the kinetic energy that it takes to come over theta_m", 0},
    {"margin", "mgh/2", "K - B", 0},
    {"r_max", "", "largest growth at this s: there K = B", 0},
    {NULL, NULL, NULL, 0},
};

static void why_say(const struct session *session, struct answer *a, enum dom_status verdict,
                    const struct domq_barrier *b, const struct domq_limit *limit)
{
    const struct domq_train *t = &session->train;
    if (verdict == DOM_NO_FUEL) {
        answer_say(
            a,
            "No cycle begins: (c7) decides. The fuel P = H(0) - H(theta_c) is not positive, so a cycle sets "
            "no energy free: the dominoes that lean down the train lie no lower than they stood, or the "
            "larger one in front takes up more than the smaller ones behind give.");
    } else if (b->barrier == 0) {
        answer_say(a, "It goes on: there is no barrier (c8), H falls from the first moment on, and any K > 0 "
                      "is enough.");
    } else {
        bool goes = verdict == DOM_OK;
        answer_say(
            a,
            "It %s: (c8) decides, K %s B. After the collision the train has %.4g times the energy that it "
            "needs to climb to theta_m = %.6g %s; K - B is %.3g times B.",
            goes ? "goes on" : "stops", goes ? ">=" : "<", (double)(b->kinetic / b->barrier),
            (double)style_angle(&session->style, b->theta_m), style_angle_unit(&session->style),
            (double)(b->margin / b->barrier));
    }
    if (domq_law(t)->dissipates && verdict != DOM_NO_FUEL)
        answer_say(a,
                   "Friction of %.6g between dominoes is in K and in B: B is the kinetic energy that it "
                   "takes to come "
                   "over theta_m.",
                   (double)t->mu);
    if (limit->ends == DOM_END_NONE)
        answer_say(a, "At s = %.6g no growth r >= 1 is possible.", (double)t->s);
    else if (limit->ends == DOM_END_REACH)
        answer_say(a,
                   "At s = %.6g growth ends by reach: beyond r = 1/s = %.6g the head falls past the next "
                   "domino (a2).",
                   (double)t->s, (double)limit->r_max);
    else
        answer_say(a,
                   "At s = %.6g K falls below B at r_max = %.10g: a larger r weighs the head against a "
                   "lighter train.",
                   (double)t->s, (double)limit->r_max);
}

/* The paper's assumption along the cycle. */
static void contact_say(const struct session *session, struct answer *a, const struct domq_least_force *c)
{
    bool holds = c->force > 0 && c->impulse > 0;
    if (!isfinite(c->force) || !isfinite(c->impulse))
        answer_say(
            a, "Contact: at r s = 1 the head is hit at its own hinge, the arm of the contact is 0 (b10), and "
               "the model's impulse has no bound: there its assumption fails.");
    else
        answer_say(
            a,
            "%s: on the way the smallest contact force is %.4g of the weight of domino %zu, which it pushes, "
            "at "
            "theta = %.4g %s, and every impulse of the collision pushes. So the paper's assumption, dominoes "
            "stay in contact, %s.",
            holds ? "Contact holds" : "Contact is lost", (double)c->force, c->domino,
            (double)style_angle(&session->style, c->theta), style_angle_unit(&session->style),
            holds ? "is met" : "fails there");
}

bool why_run(struct session *session, const struct call *call)
{
    const struct domq_compute compute = session_compute(session);
    struct walk_units u = walk_units(session, 1);
    struct domq_launch l;
    struct domq_barrier b;
    struct domq_limit limit;
    struct answer *a = call->answer;
    enum dom_status verdict = domq_barrier_find(&session->train, &compute, &b), status = verdict;
    if (verdict == DOM_OK || verdict == DOM_STOPS || verdict == DOM_NO_FUEL)
        status = domq_launch_find(&session->train, &compute, &l);
    if (status == DOM_OK || status == DOM_NO_FUEL)
        status = domq_limit_rmax(&session->train, &compute, &limit);
    if (status != DOM_OK)
        return session_status(session, status);
    why_say(session, a, verdict, &b, &limit);
    struct domq_least_force contact;
    if (answer_for_people(a) &&
        domq_cycle_least_force(&session->train, &session->compute, &contact) == DOM_OK)
        contact_say(session, a, &contact);
    if (domq_law(&session->train)->dissipates)
        a->columns = why_rubbing_columns;
    walk_columns_in(session, a);
    answer_row(a,
               ROW(cell_word(verdict == DOM_OK      ? "goes on"
                             : verdict == DOM_STOPS ? "stops"
                                                    : "no fuel"),
                   CELL_TIMES(l, fuel, u.energy), CELL_OF(l, J0), CELL_TIMES(b, kinetic, u.energy),
                   CELL_TIMES(b, barrier, u.energy), CELL_TIMES(b, margin, u.energy), CELL_OF(limit, r_max)),
               NULL);
    return true;
}
