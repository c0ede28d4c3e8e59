/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parameters and effects by the other words that people use for them: mu, separation, height.
 */
#ifndef SHELL_MEANT_H
#define SHELL_MEANT_H

#include "session/parameters.h"

/*
 * Returns the parameter or effect that has the word among its synonyms, the one in whose list the word comes
 * first; NULL: none.  *usual: the word is the first of the list, what most people call the parameter.
 */
const struct parameter *parameter_meant(const char *word, bool *usual);

/* Returns true if the word is one of the synonyms, which stand between blanks; NULL: there are none. */
bool synonyms_have(const char *synonyms, const char *word);

/* Writes after a message how the parameter is entered: "; did you mean 's'? 's = VALUE' ...".  Returns false
 * if no parameter has this synonym. */
bool parameter_hint(const char *word, char *message, size_t size);

#endif
