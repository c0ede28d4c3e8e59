/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/measure.h"
#include "language/quad.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The units for display, such as mm, so that 0.005 m is shown as 5 mm. A number in the unit `base` is shown
 * in the first unit of the list that has this base and a limit `below` larger than the number. For example,
 * 0.5 m is shown as 50 cm, because 0.5 is below 1 but not below 1/100. If the list has no such unit, the
 * number is shown in `base`. */
static const struct {
    const char *base;
    domq_real below;
    struct measure measure;
} measures[] = {{"m", (domq_real)1 / 100, {"mm", 3}},
                {"m", 1, {"cm", 2}},
                {"kg", 1, {"g", 3}},
                {"kg", 10000, {"kg", 0}},
                {"kg", (domq_real)1e30, {"t", -3}}, /* otherwise, as for unknown numbers: kg */
                {"share", (domq_real)HUGE_VAL, {"%", 2}}};

struct measure measure_of(const char *unit, domq_real largest)
{
    /* With this factor, 10 mm is shown as 1 cm in spite of rounding errors. */
    const domq_real almost = 1 + (domq_real)1e-12;
    for (size_t i = 0; *unit && i < sizeof measures / sizeof *measures; i++)
        if (strcmp(unit, measures[i].base) == 0 && quad(fabs)(largest) * almost < measures[i].below)
            return measures[i].measure;
    return (struct measure){unit, 0};
}

domq_real measure_number(struct measure measure, domq_real value)
{
    char text[2 * WIDE_TEXT];
    if (measure.power == 0 || !isfinite(value))
        return value;
    quad_exact(value, WIDE_DIGITS, text);
    char *exponent = strchr(text, 'e');
    int power = measure.power + (exponent ? atoi(exponent + 1) : 0);
    char *end = exponent ? exponent : text + strlen(text);
    snprintf(end, sizeof text - (size_t)(end - text), "e%d", power);
    return quad_read(text, NULL);
}

struct measured measured(domq_real value, const char *unit, int digits)
{
    struct measured result;
    struct measure measure = measure_of(unit, value);
    domq_real shown = measure_number(measure, value), limit = 1;
    for (int n = 0; n < digits; n++)
        limit *= 10;
    /* With only two digits, for example, printf would write 100 as 1e+02. */
    for (; digits < 15 && quad(fabs)(shown) >= limit - (domq_real)0.5; limit *= 10)
        digits++;
    snprintf(result.text, sizeof result.text, "%s%s%s", quad_text(shown, digits), *measure.unit ? " " : "",
             measure.unit);
    return result;
}

struct measured measured_share(domq_real value, int digits)
{
    struct measured result = measured(value, "share", digits);
    while (value != 1 && strcmp(result.text, "100 %") == 0 && digits < 15)
        result = measured(value, "share", ++digits);
    return result;
}

struct axis_unit measure_axis(double longest)
{
    return longest >= 2     ? (struct axis_unit){"m", 1}
           : longest >= 0.2 ? (struct axis_unit){"cm", 0.01}
                            : (struct axis_unit){"mm", 0.001};
}
