/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "suite.h"

enum { TESTS_MOST = 32 };

static struct CMUnitTest tests[TESTS_MOST];
static int lines[TESTS_MOST];
static size_t count;

/* The constructors of a file may be called in any order, so the tests are sorted by line. */
void suite_add(const char *name, CMUnitTestFunction test, int line)
{
    if (count == TESTS_MOST)
        abort();
    size_t k = count++;
    for (; k > 0 && lines[k - 1] > line; k--) {
        tests[k] = tests[k - 1];
        lines[k] = lines[k - 1];
    }
    tests[k] = (struct CMUnitTest){.name = name, .test_func = test};
    lines[k] = line;
}

int main(void)
{
    return _cmocka_run_group_tests("tests", tests, count, NULL, NULL);
}
