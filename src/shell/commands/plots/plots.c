/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/plots/plots.h"

double plot_angle(const struct query *query, domq_real theta)
{
    return (double)style_angle(&query->state->settings.style, theta);
}
