/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest growth at a separation.  To build it where domino is installed:
 *   cc rmax.c -o rmax $(pkg-config --cflags --libs domino)
 */
#include <domino.h>
#include <stdio.h>

int main(int argc, char **argv)
{
    struct dom_train train = dom_train_default();
    struct dom_limit limit;
    double s;
    char rest;
    if (argc != 2 || sscanf(argv[1], "%lf%c", &s, &rest) != 1) {
        fprintf(stderr, "usage: rmax SEPARATION\n");
        return 2;
    }
    train.s = s;
    enum dom_status why = DOM_OK; /* set where there is no limit */
    enum dom_status status = dom_limit_rmax(&train, &limit, NULL, &why);
    status = status == DOM_OK ? why : status;
    if (status != DOM_OK) {
        fprintf(stderr, "rmax: s = %g: %s\n", s, dom_status_text(status));
        return 1;
    }
    double r = (double)limit.r_max;
    printf("%.12g, ends by %s\n", r, dom_end_text(limit.ends));
    return 0;
}
