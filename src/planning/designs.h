/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of the command 'design': the dominoes, and designs that fall with a given probability. */
#ifndef SHELL_DESIGNS_H
#define SHELL_DESIGNS_H

#include "interpreter/command.h"

struct designed_row {
    struct domq_domino *domino;
    size_t count;
    bool has_masses;           /* true if masses are in kg, false if relative to the first domino */
    const struct scene *scene; /* gives the thickness of the walls of boxes */
    bool walls_unknown;        /* the dominoes are hollow, and the thickness of their walls is not known */
    bool is_improved;          /* true if 'improve sizes' has changed the dominoes */
    const struct dom_limits
        *limits; /* the sizes that the dominoes may have, or NULL if any size is allowed */
};

/* Makes the dominoes of a design. The caller frees plan->domino. */
bool designed_make(const struct query *query, struct problem *problem, const struct dom_wish *wish,
                   const struct dom_limits *limits, const struct dom_design *design,
                   struct designed_row *plan);

/* Returns the total mass in kg or, if masses are not known, relative to the first domino. */
domq_real designed_mass(const struct designed_row *plan);

/* Leaves out the columns about random rows unless `is_random` is true. */
void design_columns_choose(struct answer *a, bool is_random);

/* Writes the numbers of a design. If there is no design, `plan` is NULL and `reason` says why. `study` has
 * the results of the random rows, or is NULL. */
void design_row(struct answer *a, const struct designed_row *plan, const struct dom_design *design,
                const struct dom_study *study, const char *reason);

/* Returns the growth of a train that begins with the height h and ends with the last height of the plan. */
domq_real design_growth(const struct scene *scene, const struct designed_row *plan);

/* Makes a scene whose row is the design. Call listed_free(&scene->listed) afterwards, even on failure. */
bool design_scene(const struct scene *from, const struct dom_design *design, const struct designed_row *plan,
                  struct scene *scene, struct problem *problem);

enum { REASON = 640 };

/* Finds the design with the fewest dominoes among the designs that fall with the given probability. The
 * probability is measured with random rows, so it is known only to within a 95 % interval. The lower end of
 * this interval must reach `probability`. Prints a table of the designs that were tried. If no design reaches
 * the probability, `reason` says why, and design->limit is not DOM_DESIGN_FITS. */
bool design_falls(const struct query *query, struct answer *a, const struct dom_wish *wish,
                  const struct dom_limits *limits, domq_real probability, struct dom_design *design,
                  struct dom_study *study, char reason[REASON], struct problem *problem);

#endif
