/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conversions between the structures of <domino_quad.h> and those of <domino.h>. */
#ifndef DOM_NARROW_H
#define DOM_NARROW_H

#include "dispatch/dispatch.h"
#include "members.h" /* made by the build: the members of each structure */

/* Define the conversions of a structure from <domino_quad.h> to <domino.h>, and back. */
#define TO_NARROW(member)          to->member = (dom_real)from->member;
#define TO_WIDE(member)            to->member = from->member;
#define AS_IT_IS(member)           to->member = from->member;
#define PART_OF(member, structure) narrow_##structure(&to->member, &from->member);
#define NARROW(structure)                                                                                    \
    static void narrow_##structure(struct dom_##structure *to, const struct domq_##structure *from)          \
    {                                                                                                        \
        DOM_MEMBERS_##structure(TO_NARROW, AS_IT_IS, PART_OF)                                                \
    }

/* Initializes a member of a train or a row with the value of an effect in a request. */
#define EFFECT(effect_, member, status) .member = q->effect[DOM_EFFECT_##effect_],

/* Returns the tolerance for <domino_quad.h>. The smallest tolerance that a precision allows has a slightly
 * different value in double than in quad. */
static inline domq_real wide_tol(dom_real tol, enum dom_precision precision)
{
    const domq_real least = domq_arithmetic(precision)->tol_floor;
    return tol >= dom_arithmetic(precision)->tol_floor && tol < least ? least : tol;
}

/* The functions of the kernel about rows. */
enum dom_status narrow_row_run(const struct row_request *q, bool times, dom_fall_visit *visit, void *context,
                               struct dom_verdict *verdict);
enum dom_status narrow_row_watch(const struct row_request *q, const dom_real *times, size_t count,
                                 dom_moment_visit *visit, void *context, struct dom_verdict *verdict);
enum dom_status narrow_row_course(const struct row_request *q, struct course **course,
                                  struct dom_verdict *verdict);
enum dom_status narrow_row_again(struct course *course, const struct dom_domino *domino, size_t first,
                                 size_t last, struct dom_verdict *verdict);
enum dom_status narrow_row_course_end(struct course *course);
enum dom_status narrow_row_sample(const struct row_request *q, struct random_row **sample);
enum dom_status narrow_row_sampled(struct random_row *sample, const struct dom_row *row, bool gaps,
                                   struct dom_verdict *verdict);
enum dom_status narrow_row_sample_end(struct random_row *sample);

#endif
