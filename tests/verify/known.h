/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Largest growths that are known of rows on real floors. */
#ifndef VERIFY_KNOWN_H
#define VERIFY_KNOWN_H

/* Compares the engine with the known growths, prints both, and returns how many differ. */
int known_compare(void);

#endif
