/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/meant.h"
#include "session/effects.h"
#include <stdio.h>
#include <string.h>

/* Returns the place of the word in a list of words between blanks, from 0; -1: it is not there. */
static int place_in(const char *list, const char *word)
{
    const size_t length = strlen(word);
    int place = 0;
    for (const char *c = list; c && *c; place++) {
        size_t n = strcspn(c, " ");
        if (n == length && strncmp(c, word, n) == 0)
            return place;
        c += n + strspn(c + n, " ");
    }
    return -1;
}

const struct parameter *parameter_meant(const char *word, bool *usual)
{
    const struct parameter *meant = NULL;
    int first = -1;
    for (const struct parameter *p = session_parameters; p->name && *word; p++) {
        int place = place_in(parameter_synonyms(p), word);
        if (place >= 0 && (!meant || place < first)) {
            meant = p;
            first = place;
        }
    }
    *usual = first == 0;
    return meant;
}

bool synonyms_have(const char *synonyms, const char *word)
{
    return *word && place_in(synonyms, word) >= 0;
}

bool parameter_hint(const char *word, char *message, size_t size)
{
    char usage[EFFECT_USAGE];
    bool usual;
    const struct parameter *p = parameter_meant(word, &usual);
    size_t used = strlen(message);
    if (!p)
        return false;
    if (p->effect)
        snprintf(message + used, size - used, "; did you mean 'effect %s'?",
                 effect_usage(names_exact(effect_names, NULL, p->name), usage));
    else
        snprintf(message + used, size - used, "; did you mean '%s'? '%s = VALUE' gives it a value", p->name,
                 p->name);
    return true;
}
