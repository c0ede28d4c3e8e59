/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A test program. It runs the tests that a file defines with TEST, in the order of the file. */
#ifndef TEST_SUITE_H
#define TEST_SUITE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

/* Defines a test. The body of the test follows, as for a function. */
#define TEST(name)                                                                                           \
    static void name(void **state);                                                                          \
    static __attribute__((constructor)) void add_##name(void)                                                \
    {                                                                                                        \
        suite_add(#name, name, __LINE__);                                                                    \
    }                                                                                                        \
    static void name(__attribute__((unused)) void **state)

void suite_add(const char *name, CMUnitTestFunction test, int line);

#endif
