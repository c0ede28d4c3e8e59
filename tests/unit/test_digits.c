/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Compares the digits that the shell writes with those of printf and strtod, character by character. */
#include "support.h"

#include "answer/cell.h"
#include "language/quad.h"
#undef fabs
#undef pow

static uint64_t random_bits(void)
{
    static uint64_t state = 88172645463325252u; /* xorshift */
    state ^= state << 13;
    state ^= state >> 7;
    return state ^= state << 17;
}

/* Returns a number between 1e-13 and 1e17 that has all bits or few bits, or is a decimal with few digits. */
static double random_double(int k)
{
    double fraction = (double)(random_bits() >> 11) * 0x1p-53, size = (double)(random_bits() % 30) - 13;
    if (k % 4 == 0)
        return ldexp((double)(random_bits() % 64), (int)(random_bits() % 90) - 45);
    if (k % 4 == 1)
        return (double)(random_bits() % 1000000) / quad(pow)(10, (double)(random_bits() % 12));
    return (k % 8 < 4 ? 1 : -1) * fraction * quad(pow)(10, size);
}

static void one_text(double value)
{
    char text[WIDE_TEXT], printed[64];
    for (int digits = 1; digits <= 17; digits++) {
        snprintf(printed, sizeof printed, "%.*g", digits, value);
        assert_string_equal(quad_write((dom_real)value, digits, text), printed);
    }
}

static const struct answer_style in_double = {.precision = IN_DOUBLE, .all_digits = 17},
                                 in_float = {.precision = IN_FLOAT, .all_digits = 9};

/* Checks that csv and json write the fewest digits that round-trip: 15, 16 or 17, or for floats 7, 8 or 9. */
static void one_shortest(double value)
{
    char text[CELL_TEXT], printed[64];
    int digits = 14;
    do
        snprintf(printed, sizeof printed, "%.*g", ++digits, value);
    while (digits < 17 && strtod(printed, NULL) != value);
    assert_string_equal(cell_plain(&in_double, cell_real((dom_real)value), text), printed);
    float single = (float)value;
    digits = 6;
    do
        snprintf(printed, sizeof printed, "%.*g", ++digits, (double)single);
    while (digits < 9 && strtof(printed, NULL) != single);
    if (isfinite(single))
        assert_string_equal(cell_plain(&in_float, cell_real((dom_real)single), text), printed);
}

TEST(random_numbers)
{
    for (int k = 0; k < 25000; k++) {
        double value = random_double(k);
        one_text(value);
        one_shortest(value);
    }
}

/* Checks ties, the ends of the range, powers of two and ten with their neighbours, and numbers that consist
 * of nines. */
TEST(hard_numbers)
{
    static const double hard[] = {0,        -0.0,   0.5,        1.5,     2.5,      0.125,     0.375,
                                  1e-5,     1e-4,   9.5,        99.5,    1e15,     1e14,      1.5e-11,
                                  1.49e-11, 0.1,    0.3,        1.0 / 3, 123456.5, 1234565.0, 1e300,
                                  1e-300,   5e-324, 0.00012345, 999999.5};
    for (size_t i = 0; i < sizeof hard / sizeof *hard; i++) {
        one_text(hard[i]);
        one_shortest(hard[i]);
        one_text(-hard[i]);
    }
    for (int e = -40; e <= 52; e++) {
        double power = ldexp(1, e), ten = quad(pow)(10, e / 3.0);
        double near[] = {power, nextafter(power, 0), nextafter(power, HUGE_VAL), quad(round)(ten),
                         nextafter(quad(round)(ten), 0)};
        for (size_t i = 0; i < sizeof near / sizeof *near; i++) {
            one_text(near[i]);
            one_shortest(near[i]);
        }
        /* Checks floats in the same way. */
        one_shortest((double)nextafterf((float)power, 0));
        one_shortest((double)nextafterf((float)power, HUGE_VALF));
    }
}

#if defined DOMQ_REAL_FLOAT128
extern int strfromf128(char *restrict text, size_t size, const char *restrict format, domq_real value);

static void print_quad(char *text, size_t size, int digits, domq_real value)
{
    char format[16];
    snprintf(format, sizeof format, "%%.%dg", digits);
    strfromf128(text, size, format, value);
}
#else
static void print_quad(char *text, size_t size, int digits, domq_real value)
{
    snprintf(text, size, "%.*Lg", digits, value);
}
#endif

/* Checks wider numbers with few digits, including those that a double would round to a tie. */
TEST(quad_numbers)
{
    char text[WIDE_TEXT], printed[64];
    for (int k = 0; k < 25000; k++) {
        domq_real value = (domq_real)random_double(k);
        if (k % 3 == 0)
            value += value * (domq_real)random_double(k + 1) * (domq_real)1e-17;
        else if (k % 3 == 1)
            value /= 3;
        else
            value = (domq_real)(double)((float)(k % 1000) + 0.5F) + (k % 2 ? 1 : -1) * (domq_real)1e-25;
        for (int digits = 1; digits <= 20; digits++) {
            print_quad(printed, sizeof printed, digits, value);
            assert_string_equal(quad_write(value, digits, text), printed);
        }
    }
}

TEST(counts)
{
    char text[CELL_TEXT];
    assert_string_equal(cell_plain(&in_double, cell_count(112), text), "112");
    assert_string_equal(cell_plain(&in_double, cell_count((dom_real)1e15), text), "1000000000000000");
}
