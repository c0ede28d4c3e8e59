/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/landmarks.h"
#include "language/text.h"
#include "language/units.h"
#include <ctype.h>
#include <stddef.h>

const struct landmark landmarks[LANDMARKS + 1] = {
    {"domtoren", "dom_tower", "112", "Utrecht, 1382; the tower of the paper", "Dutch Science Quiz 2012"},
    {"eiffel", "eiffel_tower", "330", "Paris, with the antenna of 2022", "toureiffel.paris"},
    {"big_ben", "elizabeth_tower", "96", "London, 1859", "parliament.uk"},
    {"ulm", "ulm_minster", "161.53", "the steeple of the minster, 1890", "ulmer-muenster.de"},
    {"cologne", "cologne_cathedral", "157.22", "the south tower of the cathedral, 1880",
     "archive of the cathedral, 2010"},
    {"giza", "great_pyramid", "146.6", "as built, about 2560 BC", "280 royal cubits of 52.36 cm"},
    {"liberty", "statue_of_liberty", "92.99", "New York, 1886, ground to torch", "nps.gov: 305 ft 1 in"},
    {"empire_state", "empire_state_building", "381", "New York, 1931, without the antenna",
     "esbnyc.com: 1250 ft"},
    {"one_world_trade", "one_world_trade_center", "541.3", "New York, 2014, with the spire",
     "CTBUH: 1776 ft"},
    {"washington_monument", NULL, "169.29", "Washington, 1884", "nps.gov: 555 ft 5 1/8 in"},
    {"gateway_arch", NULL, "192", "St. Louis, 1965", "nps.gov: 630 ft"},
    {"space_needle", NULL, "184.4", "Seattle, 1962", "spaceneedle.com: 605 ft"},
    {"cn_tower", NULL, "553.33", "Toronto, 1976", "cntower.ca"},
    {"tokyo_tower", NULL, "333", "Tokyo, 1958", "tokyotower.co.jp"},
    {"skytree", "tokyo_skytree", "634", "Tokyo, 2012", "tokyo-skytree.jp"},
    {"taipei_101", NULL, "508", "Taipei, 2004, with the spire", "CTBUH"},
    {"petronas", "petronas_towers", "451.9", "Kuala Lumpur, 1998, with the spires", "CTBUH"},
    {"shanghai_tower", NULL, "632", "Shanghai, 2015", "CTBUH"},
    {"burj_khalifa", NULL, "828", "Dubai, 2010, with the spire", "CTBUH"},
    {"everest", "mount_everest", "8848.86", "above sea level, surveyed in 2020", "China and Nepal"},
    {NULL, NULL, NULL, NULL, NULL},
};

/* Returns the end of the name at the beginning of the text, or NULL if the text begins otherwise. */
static const char *name_end(const char *name, const char *text)
{
    for (; *name; name++) {
        const char *blanks = skip_blanks(text);
        if (*name == '_' && blanks > text)
            text = blanks;
        else if (tolower((unsigned char)*text++) != *name)
            return NULL;
    }
    return name_length(text) == 0 ? text : NULL;
}

const struct landmark *landmark_scan(const char *text, const char **end)
{
    const struct landmark *longest = NULL;
    const char first = (char)tolower((unsigned char)*text); /* most names are none of these */
    *end = text;
    for (const struct landmark *l = landmarks; l->name; l++)
        for (int i = 0; i < 2; i++) {
            const char *name = i ? l->also : l->name;
            const char *stop = name && *name == first ? name_end(name, text) : NULL;
            if (stop && stop > *end) {
                longest = l;
                *end = stop;
            }
        }
    return longest;
}

const struct landmark *landmark_find(const char *name)
{
    const char *end;
    const struct landmark *l = landmark_scan(name, &end);
    return l && *end == '\0' ? l : NULL;
}

const char *landmark_names(const void *context, int k)
{
    (void)context;
    return landmarks[k].name;
}
