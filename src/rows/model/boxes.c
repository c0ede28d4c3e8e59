/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rows/model/boxes.h"

double wood_volume(const struct dom_row *row, const struct dom_domino *d)
{
    const double walls = walls_of(row, d->height), volume = d->height * width_of(d) * d->thickness;
    struct dom_box box;
    return walls == 0                                                                  ? volume
           : dom_box_find(d->height, d->thickness, width_of(d), walls, &box) == DOM_OK ? volume * box.filled
                                                                                       : 0;
}

double wood_factor(const struct dom_row *row, const struct dom_domino *before, const struct dom_domino *after,
                   double solid)
{
    const double old = row->walls > 0 ? wood_volume(row, before) : 0,
                 changed = old > 0 ? wood_volume(row, after) : 0;
    return changed > 0 ? changed / old : solid;
}
