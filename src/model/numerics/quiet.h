/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * These two functions switch GSL's error handler off and on again. The handler would abort the program. A
 * process has only one handler, but several threads may compute. So the calls are counted: only the first
 * begin and the last end change the handler.
 */
#ifndef DOM_QUIET_H
#define DOM_QUIET_H

void dom_quiet_begin(void);
void dom_quiet_end(void);

#endif
