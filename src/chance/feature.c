/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "chance/chance.h"
#include "train/fewest.h"
#include <stdlib.h>

extern const struct command study_commands[];

static const struct command_group groups[] = {
    {"Rows with random errors", "chances", study_commands},
    {NULL, NULL, NULL},
};

/* Adds the share of the rows that fall to a row of 'count H fewest'. */
static void fewest_share(const struct query *query, struct answer *a, void *context)
{
    (void)a;
    struct fewest_row *row = context;
    struct query with_row = *query;
    struct dom_study study;
    struct dom_random_error error[DOM_ERROR_COUNT];
    with_row.scene = &row->scene;
    if (study_run(&with_row, row->problem, FEWEST_ROWS, &study, error) && study.rows > 0)
        row->share = (double)study.fall / (double)study.rows;
}

static const struct feature_extension extensions[] = {{.command = "fewest", .add = fewest_share},
                                                      {.command = NULL}};

const struct feature chance_feature = {
    .name = "chance", .groups = groups, .extension = extensions, .parameter = error_parameter};
