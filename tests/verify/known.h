/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Known largest growths of rows with feet that slip, slopes, rounded edges, and bounces. */
#ifndef VERIFY_KNOWN_H
#define VERIFY_KNOWN_H

/* Prints the growths of the engine next to the known ones. Returns how many of them differ. */
int known_compare(void);

#endif
