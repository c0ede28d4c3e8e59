/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Compares our front speed of equal dominoes with the method of a published program: "dominoes" by J. Luebke
 * (github.com/jerluebke/dominoes, 2018), after J. M. J. van Leeuwen, "The domino effect" (2004). The method
 * is implemented again here. That program sums the inertia of the last ten dominoes, whose tilts follow from
 * the tilt of the head, and integrates the time of a cycle with GSL's qags to 1.49e-8.
 *
 * Its equation for the angular velocity between two hits is not the energy balance, so its front has a
 * different speed. The table shows both speeds. The unit of time is sqrt(height / g).
 */
#include "bench.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

enum { FEW = 10, MANY = 100, INTERVALS = 100, REPEATS = 7 };

#define TOLERANCE     1.49e-8 /* the absolute and relative tolerance of the published program */
#define LEAST_SECONDS 2e-3    /* the shortest time of a batch */

struct front {
    double s, d;
    int dominoes;       /* the number of dominoes in the sums */
    double spin, start; /* squares of the eigenfrequency, and of the angular velocity after a hit */
    double diagonal;    /* angle of the diagonal; a domino that tilts less falls back */
    gsl_integration_workspace *space;
};

/* Returns the inertia of the train when its head has this tilt, divided by the inertia of one domino. */
static double inertia(const struct front *f, double tilt)
{
    double sum = 1;
    for (int last = 1; last <= f->dominoes; last++) {
        double at = tilt, slope = 1;
        for (int i = 0; i < last; i++) {
            double turn = asin((f->s + f->d) * cos(at) - f->d);
            slope *= 1 - (f->s + f->d) * sin(at) / cos(turn);
            at += turn;
        }
        sum += slope * slope;
    }
    return sum;
}

/* Returns the energy that one domino has released at this tilt, as the square of an angular velocity. */
static double set_free(const struct front *f, double tilt)
{
    return 2 * f->spin * (cos(f->diagonal) - cos(tilt - f->diagonal));
}

static double slowness(double tilt, void *context)
{
    const struct front *f = context;
    double k = inertia(f, tilt);
    return 1 / sqrt((k * f->start + set_free(f, tilt)) / (k - 1));
}

/* Returns the front speed in units of sqrt(g height). */
static double front_speed(struct front *f)
{
    double time, error;
    f->diagonal = atan(f->d);
    f->spin = 1.5 * cos(f->diagonal);
    double k = inertia(f, 0);
    f->start = (k - 1) / k * set_free(f, acos(f->d / (f->s + f->d)));
    gsl_function of = {slowness, f};
    int failed =
        gsl_integration_qags(&of, 0, asin(f->s), TOLERANCE, TOLERANCE, INTERVALS, f->space, &time, &error);
    return failed ? NONE : (f->s + f->d) / time;
}

static double our_speed(const struct front *f)
{
    struct setup train = setup_default();
    domq_real duration;
    train.s = f->s;
    train.d = f->d;
    train.r = 1;
    train.tol = TOLERANCE;
    if (ask_cycle_duration(&train, &duration) != DOM_OK)
        return NONE;
    return (f->s + f->d) / ((double)duration * sqrt((1 + f->d * f->d) / 3));
}

static double speed_of(struct front *f, bool ours)
{
    return ours ? our_speed(f) : front_speed(f);
}

/* Returns the front speed. *seconds receives the shortest of several times. */
static double measure(struct front *f, bool ours, double *seconds)
{
    double begun = seconds_now(), speed = speed_of(f, ours);
    int batch = (int)(LEAST_SECONDS / (seconds_now() - begun)) + 1;
    *seconds = INFINITY;
    for (int k = 0; k < REPEATS; k++) {
        begun = seconds_now();
        for (int i = 0; i < batch; i++)
            speed = speed_of(f, ours);
        *seconds = fmin(*seconds, (seconds_now() - begun) / batch);
    }
    return speed;
}

void front_print(void)
{
    static const double separations[] = {0.1, 0.2, 0.4, 0.6, 0.8};
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    struct front f = {.d = (double)setup_default().d, .space = gsl_integration_workspace_alloc(INTERVALS)};
    puts("\nThe front speed of equal dominoes to 1.49e-8, in sqrt(g h), beside the recipe of a published "
         "program\n"
         "(J. Luebke, 2018: ten dominoes in the sum; another law between two hits, so another speed)");
    printf("  %-6s %10s %10s %10s %10s %9s %22s\n", "s", "ours", "us", "recipe", "us", "ratio",
           "its speed for 100, 10");
    for (size_t i = 0; f.space && i < sizeof separations / sizeof *separations; i++) {
        double ours, theirs;
        f.s = separations[i];
        f.dominoes = MANY;
        double whole = front_speed(&f);
        f.dominoes = FEW;
        double speed = measure(&f, true, &ours), recipe = measure(&f, false, &theirs);
        printf("  %-6.2g %10.6f %10.2f %10.6f %10.2f %9.3g", f.s, speed, 1e6 * ours, recipe, 1e6 * theirs,
               theirs / ours);
        printf("  differs by %.1e\n", fabs(recipe / whole - 1));
    }
    if (f.space)
        gsl_integration_workspace_free(f.space);
    gsl_set_error_handler(handler);
    fflush(stdout);
}
