/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shell's own commands, and the command 'version'. */
#include "interpreter/command.h"
#include "language/text.h"
#include <gsl/gsl_version.h>
#include <readline/readline.h>
#include <string.h>

#if defined __clang__
#define COMPILER "clang " __clang_version__
#elif defined __GNUC__
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER ""
#endif

static const struct column version_columns[] = {
    {"version", "", "the version of this program and of its library", 0},
    {"compiler", "", "the compiler that built this program", 0},
    {"quad", "", "the C type that quad precision uses", 0},
    {"gsl", "", "the version of the GNU Scientific Library", 0},
    {"readline", "", "the version of GNU Readline", 0},
    {"features", "", "what this build has besides the calculator of the paper, separated by blanks", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_version(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct domq_arithmetic quad = any_arithmetic(IN_QUAD);
    char names[256] = "";
    const struct feature *f;
    for (int k = 0; (f = feature_at(k)) != NULL; k++)
        if (!strchr(f->name, '_') && !feature_is_always(f))
            text_add(names, sizeof names, "%s%s", *names ? " " : "", f->name);
    (void)query;
    (void)problem;
    answer_say(a, "domino %s\n", dom_version());
    return answer_cells(a, cell_word(dom_version()), cell_word(COMPILER), cell_word(quad.type),
                        cell_word(gsl_version), cell_word(rl_library_version), cell_word(names));
}

static const struct command version_commands[] = {
    {.name = "version",
     .synonyms = "about build release compiler",
     .summary = "the version of this program, and what it was built with",
     ANSWER(version)},
    {.name = NULL},
};

extern const struct command session_commands[], value_commands[], script_commands[], help_commands[];

static const struct command_group groups[] = {
    {"The session", "settings", session_commands}, {"Values and names", "settings", value_commands},
    {"Scripts", "scripts", script_commands},       {"Help", "scripts", help_commands},
    {"This program", "scripts", version_commands}, {NULL, NULL, NULL},
};

static const struct first_line first[] = {
    {3, "set s 0.3", "dominoes closer together: gaps of 0.3 times the height", false},
    {7, "set r 1.2", "each domino is 1.2 times as large as the one before it", false},
    {10, "help rmax", "explains a command; 'apropos tower' finds commands", false},
    {11, "quit", "ends the session; ^C stops a computation", false},
    {0, NULL, NULL, false},
};

const struct feature shell_feature = {.name = "shell", .groups = groups, .first = first};
