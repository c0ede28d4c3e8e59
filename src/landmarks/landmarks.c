/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heights that people want to topple. Their names have values in expressions: 'count big_ben', or 'eiffel/h'.
 */
#include "interpreter/command.h"
#include "language/text.h"
#include <ctype.h>

static const struct landmark {
    const char *name;   /* in lower case, with '_' between words */
    const char *also;   /* another name, or NULL */
    const char *height; /* a decimal number, in metres */
    const char *what;   /* what the landmark is, and for which year or state the height holds */
    const char *source;
} landmarks[] = {
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

static const char *landmark_names(const void *context, int k)
{
    (void)context;
    return landmarks[k].name;
}

/* Returns the end of the name at the beginning of the text, or NULL if the text begins otherwise. Case does
 * not matter, and blanks may stand for '_', as in "Big Ben". */
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

/* The longest name counts. */
static const char *landmark_value(const char *text, const char **end, struct quantity *value)
{
    const char *longest = NULL;
    const char first = (char)tolower((unsigned char)*text); /* most names are none of these */
    *end = text;
    for (const struct landmark *l = landmarks; l->name; l++)
        for (int i = 0; i < 2; i++) {
            const char *name = i ? l->also : l->name;
            const char *stop = name && *name == first ? name_end(name, text) : NULL;
            if (stop && stop > *end) {
                *value = (struct quantity){.value = quad_read(l->height, NULL), .length = 1};
                *end = stop;
                longest = l->name;
            }
        }
    return longest;
}

static const struct column landmarks_columns[] = {
    {"name", "", "the name, for expressions and for 'count'", 20},
    {"height", "m", "the height", 0},
    {"what", "", "where the landmark is, and for which year or state the height holds", 42},
    {"source", "", "who publishes the height", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_landmarks(const struct query *query, struct answer *a, struct problem *problem)
{
    (void)query;
    (void)problem;
    for (const struct landmark *l = landmarks; l->name; l++)
        answer_cells(a, cell_word(l->name), cell_without_error(quad_read(l->height, NULL)),
                     cell_word(l->what), cell_word(l->source));
    return true;
}

static const struct command landmarks_commands[] = {
    {.name = "landmarks",
     .synonyms = "buildings monuments monument building landmark",
     .summary = "list the towers and other landmarks whose heights have names",
     .help =
         "A name in this list stands for the height, in 'count big_ben' and in every expression: "
         "'eiffel/h'. Blanks may stand for '_', so 'count big ben' works, too. A height "
         "holds for the year or the state in the list. If 'let' defines the same name, that value counts.",
     .example = "count big ben; print domtoren / 5 cm; landmarks details",
     .see = "count print let",
     .rows = true,
     .brief = "name height what",
     ANSWER(landmarks)},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"Heights with names", "settings", landmarks_commands},
    {NULL, NULL, NULL},
};

const struct feature landmarks_feature = {
    .name = "landmarks", .groups = groups, .names = landmark_names, .value = landmark_value};
