/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tells which dominoes of a row are boxes with walls, and how much wood they have. */
#pragma once

#include "numerics/api.h"
#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_study.h"
#pragma GCC visibility pop

static inline double width_of(const struct dom_domino *domino)
{
    return domino->width > 0 ? domino->width : domino->height / 2;
}

/* Returns the thickness of the walls of a domino in m, or 0 if the domino is solid. */
static inline double walls_of(const struct dom_row *row, double height)
{
    return height > row->boxes_above ? row->walls : 0;
}

/* Returns the allowed height that is closest to `height`, for a domino that has had the height `before`. A
 * solid domino must stay solid, and a box must stay a box. (A domino taller than row->boxes_above is a
 * box.) */
static inline double height_of_kind(const struct dom_row *row, double before, double height)
{
    const double most = row->boxes_above, least = most * (1 + 1.0 / 1000000);
    if (before <= most)
        return height < most ? height : most;
    return height > least ? height : least < before ? least : before;
}

/* Returns the volume of the wood in a domino, or 0 if its walls do not fit. */
static inline double wood_volume(const struct dom_row *row, const struct dom_domino *d)
{
    const double walls = walls_of(row, d->height), volume = d->height * width_of(d) * d->thickness;
    struct dom_box box;
    return walls == 0                                                                  ? volume
           : dom_box_find(d->height, d->thickness, width_of(d), walls, &box) == DOM_OK ? volume * box.filled
                                                                                       : 0;
}

/* Returns the factor by which the mass of a domino changes if the domino is resized from `before` to `after`
 * and its wood keeps its density. If the row has no boxes, or if the walls do not fit, returns `solid`. */
static inline double wood_factor(const struct dom_row *row, const struct dom_domino *before,
                                 const struct dom_domino *after, double solid)
{
    const double old = row->walls > 0 ? wood_volume(row, before) : 0,
                 changed = old > 0 ? wood_volume(row, after) : 0;
    return changed > 0 ? changed / old : solid;
}
