/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * GSL's handler of errors, which ends the program, off: it is one for the whole process, and answers are
 * computed side by side.  The first to come turns it off, and the last to leave brings it back.
 */
#ifndef DOM_QUIET_H
#define DOM_QUIET_H

/* Both are hidden: the library alone uses them, from more than one of its objects. */
__attribute__((visibility("hidden"))) void dom_quiet_begin(void);
__attribute__((visibility("hidden"))) void dom_quiet_end(void);

#endif
