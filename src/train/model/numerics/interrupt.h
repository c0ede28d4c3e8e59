/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The check for an interrupt. Every loop of the model that may take long calls this function at least once in
 * CHECK_EVERY dominoes. It is a function, not the inline dom_raised, so that a test can put its own in its
 * place and raise the flag at the k-th check. */
#pragma once

#include <signal.h>
#include <stdbool.h>

enum { CHECK_EVERY = 4096 };

/* Returns true if the flag is raised. `flag` may be NULL. */
bool dom_interrupted(const volatile sig_atomic_t *flag);
