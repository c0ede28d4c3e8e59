/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_COLLISION_H
#define DOM_COLLISION_H

#include "energy.h"

/* (c6) as it stands: where P <= 0 the squares come out negative, and no error is raised. */
enum dom_status collision_launch(const struct lean *lean, enum dom_fuel fuel, struct dom_launch *launch);

#endif
