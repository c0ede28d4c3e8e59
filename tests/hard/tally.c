/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sweep.h"

#include <stdio.h>
#include <string.h>

static double wanted(const struct comparison *c)
{
    return c->ref ? ref_double(c->ref, c->quantity) : c->want;
}

static double scale_of(const struct comparison *c, double enough)
{
    return c->ref ? ref_scale_up_to(c->ref, c->quantity, enough) : c->scale;
}

static struct sample sample_of(const struct comparison *c, double excess)
{
    return (struct sample){.input = *c->input,
                           .link = c->ref ? c->ref->link : 0,
                           .tol = c->tol,
                           .got = (double)c->got,
                           .want = wanted(c),
                           .excess = excess};
}

static void keep_worst(struct sample *worst, const struct comparison *c, double excess)
{
    if (excess > worst->excess)
        *worst = sample_of(c, excess);
}

void tally_mistake(struct tally *tally, const struct comparison *c, const char *what)
{
    if (tally->wrong++)
        return;
    tally->mistake = sample_of(c, (double)INFINITY);
    snprintf(tally->what, sizeof tally->what, "%s", what);
}

/* Compares an error in units with the largest one so far. The full scale is computed only if the error may be
 * larger. */
static void compare_units(struct sample *worst, const struct comparison *c, double error, double allowed,
                          double least)
{
    const double enough = error / (fmax(worst->excess, least) * allowed);
    const double scale = fabs(wanted(c)) < enough ? scale_of(c, enough) : enough;
    if (scale < enough)
        keep_worst(worst, c, error / (allowed * scale));
}

void tally_compare(struct tally *tally, const struct comparison *c)
{
    const bool got = !isnan((double)c->got), exists = !isnan(wanted(c));
    if (!got && !exists)
        return;
    if (!got || !exists) {
        tally_mistake(tally, c, got ? "a value, but none exists" : "no value");
        return;
    }
    const double error = c->ref ? ref_error(c->ref, c->quantity, c->got) : fabs(c->error);
    if (isnan(error)) {
        tally_mistake(tally, c, "the error is NaN");
        return;
    }
    tally->checked++;
    if (error == 0)
        return;
    if (c->sharp)
        compare_units(&tally->units, c, error, c->unit, TALLY_UNITS);
    else
        compare_units(&tally->tol, c, error, c->tol + 16 * c->unit, 0.1);
}

void tally_merge(struct tally *into, const struct tally *from)
{
    into->units = from->units.excess > into->units.excess ? from->units : into->units;
    into->tol = from->tol.excess > into->tol.excess ? from->tol : into->tol;
    if (!into->wrong && from->wrong) {
        into->mistake = from->mistake;
        memcpy(into->what, from->what, sizeof into->what);
    }
    into->wrong += from->wrong;
    into->checked += from->checked;
}

/* Prints a number as a hexadecimal C constant, or as a sum of such constants. */
static void print_real(const char *name, domq_real x)
{
    double part = (double)x;
    if ((domq_real)part == x) {
        fprintf(stderr, " %s=%.17g", name, part);
        return;
    }
    fprintf(stderr, " %s=%a", name, part);
    while ((x -= (domq_real)part) != 0)
        fprintf(stderr, "%+a", part = (double)x);
}

void tally_print(const char *label, enum ref_quantity quantity, const struct sample *sample)
{
    const struct ref_input *in = &sample->input;
    fprintf(stderr, "# %s %s:", label, ref_name(quantity));
    print_real("s", in->s);
    print_real("r", in->r);
    print_real("d", in->d);
    print_real("q", in->q);
    print_real("tilt", in->tilt);
    fprintf(stderr, " fuel=%s link=%zu tol=%.3g: got %.17g, wanted %.17g: %.3g\n",
            in->paper ? "paper" : "exact", sample->link, sample->tol, sample->got, sample->want,
            sample->excess);
}
