/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "chance/chance.h"

extern const struct command study_commands[];

static const struct command_group groups[] = {
    {"Rows with random errors", "chances", study_commands},
    {NULL, NULL, NULL},
};

/* Runs one row with random errors. */
static bool row_answer(const struct scene *scene, const struct domq_row *row,
                       const struct domq_compute *compute, enum dom_status *status)
{
    struct domq_placement placement = {.seed = 1, .rows = 1};
    struct domq_study study;
    const bool has_errors = scene_errors(scene, placement.error);
    if (has_errors)
        *status = domq_placement_study(row, compute, &placement, &study, NULL);
    return has_errors;
}

const struct feature chance_feature = {.name = "chance",
                                       .groups = groups,
                                       .parameter = error_parameter,
                                       .check = errors_check,
                                       .row_answer = row_answer};
