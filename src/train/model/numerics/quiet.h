/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * These two functions switch off and restore GSL's error handler, which would abort the program. All threads
 * of a process share one handler, so calls are counted: the first dom_quiet_begin switches the handler off,
 * and the last dom_quiet_end restores it.
 */
#pragma once

void dom_quiet_begin(void);
void dom_quiet_end(void);
