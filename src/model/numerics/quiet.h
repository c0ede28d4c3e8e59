/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Turn off GSL's error handler, which would end the program. There is one handler for the whole process, and
 * answers are computed in parallel: the first call turns it off, and the last one restores it.
 */
#ifndef DOM_QUIET_H
#define DOM_QUIET_H

/* Both are hidden: only the library uses them, from several of its objects. */
__attribute__((visibility("hidden"))) void dom_quiet_begin(void);
__attribute__((visibility("hidden"))) void dom_quiet_end(void);

#endif
