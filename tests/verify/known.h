/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Known largest growths of rows on real floors. */
#ifndef VERIFY_KNOWN_H
#define VERIFY_KNOWN_H

/* Compares the engine with the known growths and prints both. Returns how many of them differ. */
int known_compare(void);

#endif
