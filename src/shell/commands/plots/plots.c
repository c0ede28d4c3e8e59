/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/plots/plots.h"

double plot_angle(const struct session *session, domq_real theta)
{
    return (double)style_angle(&session->style, theta);
}

const char *plot_length(double longest, double *metres)
{
    *metres = longest < 0.2 ? 0.001 : longest < 3 ? 0.01 : 1;
    return longest < 0.2 ? "mm" : longest < 3 ? "cm" : "m";
}
