/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of one cycle, with its events, for the command plot; their columns are those of its table. */
#ifndef SHELL_PLOT_H
#define SHELL_PLOT_H

#include "interpreter/command.h"

bool plot_energy(struct session *session, const struct call *call);
bool plot_omega(struct session *session, const struct call *call);
bool plot_chain(struct session *session, const struct call *call);

#endif
