/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command version: which version of the program this is, and what it was built with. */
#include "commands/tables.h"
#include <gsl/gsl_version.h>
#include <readline/readline.h>
#include <sys/utsname.h>

#if defined __clang__
#define COMPILER "clang " __clang_version__
#elif defined __GNUC__
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER ""
#endif

const struct column version_columns[] = {
    {"version", "", "the version of this program and of its library", 0},
    {"system", "", "the operating system and the machine", 0},
    {"compiler", "", "the compiler of this program", 0},
    {"quad", "", "the C type that quad precision uses", 0},
    {"quad_bits", "", "the bits of its significand; 0 if there is no quad precision", 0},
    {"gsl", "", "the version of the GNU Scientific Library", 0},
    {"readline", "", "the version of GNU Readline", 0},
    {NULL, NULL, NULL, 0},
};

bool run_version(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct domq_arithmetic *quad = domq_arithmetic(DOM_QUAD);
    struct utsname name = {.sysname = ""};
    char system[sizeof name.sysname + sizeof name.machine];
    (void)query;
    (void)problem;
    (void)uname(&name);
    snprintf(system, sizeof system, "%s %s", name.sysname, name.machine);
    answer_say(a, "domino %s\n", dom_version());
    return answer_cells(a, cell_word(dom_version()), cell_word(system), cell_word(COMPILER),
                        cell_word(quad->type), cell_count(quad->bits), cell_word(gsl_version),
                        cell_word(rl_library_version));
}
