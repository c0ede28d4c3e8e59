/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of the command 'design'. They make and list the dominoes, and find how many dominoes a row needs to
 * fall with a given probability. */
#ifndef SHELL_DESIGNS_H
#define SHELL_DESIGNS_H

#include "interpreter/command.h"

struct designed_row {
    struct domq_domino *domino;
    size_t count;
    bool has_masses; /* true if masses are in kg, and false if they are relative to the first domino's mass */
    const struct scene *scene; /* the scene, for the walls of boxes */
    bool hollow;               /* the dominoes are hollow, and the thickness of their walls is not known */
    bool is_improved; /* true if 'improve sizes' has changed the dominoes: they no longer grow by a constant
                         factor */
    const struct domq_limits
        *limits; /* the sizes that the dominoes may have, or NULL if any size is allowed */
};

/* Makes the dominoes of a design. Sets *problem and returns false if memory runs out; otherwise the caller
 * frees plan->domino. */
bool designed_make(const struct query *query, struct problem *problem, const struct domq_wish *wish,
                   const struct domq_limits *limits, const struct domq_design *design,
                   struct designed_row *plan);

/* Returns the mass of all dominoes in kg or, if masses are not known, relative to the first domino. */
domq_real designed_mass(const struct designed_row *plan);

/* Lists the dominoes. If `file` is true, the list has the columns that 'effect row FILE' reads. Otherwise it
 * has the sizes to saw and the positions of the dominoes. */
void designed_list(struct answer *a, const struct designed_row *plan, bool file);

/* Leaves out the columns about random rows unless `falls` is true. */
void design_columns_choose(struct answer *a, bool falls);

/* Writes the row with the numbers of a design. If no design fits the wishes, `plan` is NULL and `reason` says
 * why. `study` counts the random rows that fall, or is NULL. */
void design_row(struct answer *a, const struct designed_row *plan, const struct domq_design *design,
                const struct domq_study *study, const char *reason);

/* Makes a scene whose row is the design. Call listed_free(&scene->listed) afterwards, even after a failure.
 */
bool design_scene(const struct scene *from, const struct domq_design *design, const struct designed_row *plan,
                  struct scene *scene, struct problem *problem);

enum { REASON = 640 };

/* Finds the design with the fewest dominoes that falls with at least the probability `falls` under the random
 * errors of the scene. The lower end of the 95 % interval of the probability must reach `falls`. Unless the
 * output is csv or json, prints a table of all numbers of dominoes that were tried. If there is no such
 * design, design->limit is not DOM_DESIGN_FITS, and `reason` says why. Sets *problem and returns false if
 * rows cannot be run. */
bool design_falls(const struct query *query, struct answer *a, const struct domq_wish *wish,
                  const struct domq_limits *limits, domq_real falls, struct domq_design *design,
                  struct domq_study *study, char reason[REASON], struct problem *problem);

#endif
