/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/names.h"
#include "language/text.h"
#include <stdio.h>
#include <string.h>
#include <strings.h>

int names_exact(names_list *list, const void *context, const char *text)
{
    const char *name;
    for (int k = 0; (name = list(context, k)) != NULL; k++)
        if (*name == *text && strcmp(name, text) == 0)
            return k;
    return -1;
}

int names_index(const char *list, char separator, const char *name)
{
    const size_t length = strlen(name);
    int index = 0;
    for (const char *next; list; list = next ? next + 1 : NULL, index++) {
        next = strchr(list, separator);
        if (strncmp(list, name, length) == 0 && (list[length] == separator || list[length] == '\0'))
            return index;
    }
    return -1;
}

const char *names_join(names_list *list, const void *context, const char *before, char text[NAMES_ALL])
{
    const char *name;
    text[0] = '\0';
    for (int k = 0; (name = list(context, k)) != NULL; k++) {
        const bool fits = strlen(text) + strlen(before) + strlen(name) + strlen(", , ...") < NAMES_ALL;
        text_add(text, NAMES_ALL, "%s%s%s", k ? ", " : "", fits ? before : "", fits ? name : "...");
        if (!fits)
            break;
    }
    return text;
}

/* Returns the edit distance between two words: the number of letters to insert, delete or replace. A swap of
 * neighbouring letters counts as one edit. If one of the words has more than 32 letters, returns 32. */
static size_t distance(const char *a, const char *b)
{
    enum { LONGEST = 32 };
    size_t n = strlen(a), m = strlen(b), row[3][LONGEST + 1] = {{0}};
    if (n > LONGEST || m > LONGEST)
        return LONGEST;
    for (size_t i = 0; i <= n; i++) {
        size_t *here = row[i % 3], *above = row[(i + 2) % 3], *twice = row[(i + 1) % 3];
        for (size_t j = 0; j <= m; j++) {
            if (i == 0 || j == 0) {
                here[j] = i + j;
                continue;
            }
            size_t best = above[j - 1] + (a[i - 1] != b[j - 1]);
            best = above[j] + 1 < best ? above[j] + 1 : best;
            best = here[j - 1] + 1 < best ? here[j - 1] + 1 : best;
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && twice[j - 2] + 1 < best)
                best = twice[j - 2] + 1;
            here[j] = best;
        }
    }
    return row[n % 3][m];
}

const char *names_closest(names_list *list, const void *context, const char *text)
{
    const char *name, *best = NULL;
    size_t least = (strlen(text) + 1) / 3; /* up to a third of the letters may be wrong */
    for (int k = 0; (name = list(context, k)) != NULL; k++) {
        size_t d = strcasecmp(text, name) == 0 ? 0 : distance(text, name);
        if (d <= least && d < strlen(name)) {
            least = d - (d > 0);
            best = name;
        }
    }
    return best;
}

bool name_absent(const char *name, char message[NAMES_MESSAGE])
{
    const struct absent_name *a = absent_names;
    while (a->name && strcmp(a->name, name) != 0)
        a++;
    if (a->name)
        snprintf(message, NAMES_MESSAGE, "'%s' belongs to the feature '%s', which this build leaves out",
                 name, a->feature);
    return a->name;
}

int names_find(names_list *list, const void *context, const char *what, const char *text,
               char message[NAMES_MESSAGE])
{
    int found = names_exact(list, context, text), matches = 0;
    if (found >= 0)
        return found;
    if (name_absent(text, message))
        return NAMES_ABSENT;
    char all[NAMES_MESSAGE / 2] = "";
    const char *name;
    for (int k = 0; *text && (name = list(context, k)) != NULL; k++) {
        if (strncmp(name, text, strlen(text)) != 0)
            continue;
        found = k;
        text_add(all, sizeof all, "%s%s", matches++ ? ", " : "", name);
    }
    /* in upper case or, if the name has at least three letters, in the plural */
    static const char *const endings[] = {"", "s", "es"};
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
        for (int k = 0; matches == 0 && found < 0 && (name = list(context, k)) != NULL; k++) {
            const size_t length = strlen(name);
            if ((i == 0 || length >= 3) && strncasecmp(text, name, length) == 0 &&
                strcasecmp(text + length, endings[i]) == 0)
                found = k;
        }
    if (matches <= 1 && found >= 0)
        return found;
    const char *close = names_closest(list, context, text);
    const char *shown = names_shown(text);
    if (matches > 1)
        snprintf(message, NAMES_MESSAGE, "'%s' is ambiguous: %s", shown, all);
    else if (close)
        snprintf(message, NAMES_MESSAGE, "unknown %s '%s'; did you mean '%s'?", what, shown, close);
    else
        snprintf(message, NAMES_MESSAGE, "unknown %s '%s'", what, shown);
    return matches > 1 ? NAMES_SEVERAL : close ? NAMES_CLOSE : NAMES_UNKNOWN;
}
