/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the rigid-body engine adds to the answers about a row: how far feet slide, and how sure its answer is.
 */
#ifndef SHELL_SLID_H
#define SHELL_SLID_H

#include "interpreter/command.h"

/* Makes room for what the engine finds in a run of the row, unless the model runs it. False: no memory. */
bool report_begin(const struct query *query, struct problem *problem, struct scene_row *scene);
void report_end(struct scene_row *scene);

/* Returns true if the feet of the row are no hinges. */
bool feet_slide(const struct scene_row *scene);

/* Return the bound of a time in s, from the last halving of the step; and how far the foot of domino k, from
 * 0, has slid, in m. NaN: not known. */
domq_real report_time_error(const struct scene_row *scene);
domq_real report_slid(const struct scene_row *scene, size_t k);

/* Prints how far feet slide, and how fine the steps are. */
void report_say(struct answer *answer, const struct scene_row *scene, const struct domq_verdict *verdict);

/* Returns why a row ends that has not fallen. */
const char *report_why(const struct scene_row *scene, const struct domq_verdict *verdict);

#endif
