/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * GSL's handler of errors, which ends the program, off: it is one for the whole process, and answers are
 * computed side by side.  The first to come turns it off, and the last to leave brings it back.
 */
#ifndef DOM_QUIET_H
#define DOM_QUIET_H

void quiet_begin(void);
void quiet_end(void);

#endif
