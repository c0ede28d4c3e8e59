/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: whole */
/* Completion offers only words that the parser accepts. This is checked at every argument of every
 * command. */
#include "support.h"

#include "interpreter/question.h"
#include "prompt/input.h"
#include "session/session.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 200, OFFERS = 200, DEPTH = 5 };

struct offers {
    int count;
    char word[OFFERS][LINE];
};

static struct session session;
static int checked;

static void keep(const char *word, void *context)
{
    struct offers *o = context;
    assert_true(o->count < OFFERS);
    snprintf(o->word[o->count++], LINE, "%s", word);
}

/* Returns true if the parser accepts the line as it is: before a comment, a command must be whole. */
static bool parses(const char *line)
{
    return line_preview(&session, line, strlen(line), " #", NULL);
}

/* Returns true if the parser accepts the line as the beginning of a longer one. */
static bool may_go_on(const char *line)
{
    /* endings that make some command whole, separated by '|' */
    static const char more[] =
        "| 0.3| 2| 0.3 2| 0.1 0.9 9| 1 2 3| : rmax| 0.1 0.9 9 : rmax| 1 2 2 : rmax|, 2 : rmax|"
        " x = 2| s 0.1 0.9: rmax| s 0.3| friction 0.2| barrier| friction a.csv| a| a b|"
        " 5 : rmax = 1| mass| row.csv| 2 0.3| 2 gap 1 mm| gap 1 mm| 0.3 0.4 2 : rmax|"
        " s 0.1 0.9 9 : rmax| d : rmax = 1| 1 mm| 9 : rmax| 1 : rmax|: rmax| : rmax = 1|"
        " : verdict| = 1| name| 2 s|0)|1)|0.1)|5)|1,0.1)|1,2)|1,2,3)| 4 m| friction|"
        " 0.01 0.1 2 : rmax|0.5) 9|2) 9|0.1,0.1) 9| rmax| growth| log| 1 2|"
        " examples/measured/friction.csv";
    char whole[2 * LINE];
    for (const char *ending = more; ending; ending = strchr(ending, '|') ? strchr(ending, '|') + 1 : NULL) {
        snprintf(whole, sizeof whole, "%s%.*s", line, (int)strcspn(ending, "|"), ending);
        if (parses(whole))
            return true;
    }
    /* Words that are values of parameters, alone and in a list. */
    for (const struct parameter *p = session_parameters; p->name; p++)
        for (int k = 0; parameter_offered(p, k); k++) {
            static const char *const forms[] = {"%s %s", "%s, %s : rmax", "%s %s, %s : rmax"};
            const char *word = parameter_offered(p, k);
            for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
                snprintf(whole, sizeof whole, forms[i], line, word, word);
                if (parses(whole))
                    return true;
            }
        }
    return false;
}

/* Checks all words that are offered after a line, and recursively the words after each of them. */
static void explore(const char *line, int depth)
{
    struct offers *o = calloc(1, sizeof *o);
    char longer[2 * LINE];
    assert_non_null(o);
    complete_line(&session, line, false, keep, o);
    size_t word = strlen(line);
    while (word > 0 && line[word - 1] != ' ')
        word--;
    for (int i = 0; i < o->count; i++) {
        snprintf(longer, sizeof longer, "%.*s%s", (int)word, line, o->word[i]);
        if (!may_go_on(longer))
            fail_msg("'%s' offers '%s', which is refused", line, o->word[i]);
        checked++;
        strcat(longer, " ");
        if (depth > 1 && !strchr(o->word[i], '(') && strcmp(line, "print ") != 0)
            explore(longer, depth - (strlen(line) > 0));
    }
    if (depth > 1 && word > 0) {
        snprintf(longer, sizeof longer, "%s0.3 ", line);
        if (may_go_on(longer))
            explore(longer, depth - 1);
    }
    free(o);
}

/* Begins a session in which every answer has a value, including 'ans'. */
static void begin(void)
{
    features_register(every_feature);
    session_init(&session, fopen("/dev/null", "w"));
    assert_non_null(session.output->out);
    command_run_text(&session, "effect row 4; effect push 6; effect placement 1 mm; rmax");
    assert_int_equal(session.errors, 0);
}

TEST(offers_are_taken)
{
    begin();
    explore("", 2);
    assert_in_range(checked, 500, 100000);
}

TEST(begun_words_are_taken)
{
    static const char *const lines[] = {"curve 0.1 0.9 ",
                                        "effect placement 1 mm ",
                                        "sweep s 0.1 0.9 9 ",
                                        "place 2 3 ",
                                        "count r",
                                        "count 112 r",
                                        "count 48m",
                                        "set h 48m",
                                        "set r r",
                                        "theta1 t",
                                        "curve 0.1 s",
                                        "set d s",
                                        "set s b",
                                        "effect slope 2d"};
    checked = 0;
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        explore(lines[i], 1);
    assert_in_range(checked, 15, 100);
}
