/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest growth at a separation. To build it where domino is installed:
 *   cc rmax.c -o rmax $(pkg-config --cflags --libs domino)
 */
#include <domino.h>
#include <stdio.h>

int main(int argc, char **argv)
{
    struct dom_train train = dom_train_default();
    struct dom_limit limit;
    char rest;
    if (argc != 2 || sscanf(argv[1], "%lf%c", &train.s, &rest) != 1) {
        fprintf(stderr, "usage: rmax SEPARATION\n");
        return 2;
    }
    enum dom_status status = dom_limit_rmax(&train, NULL, &limit);
    if (status == DOM_OK)
        status = limit.why; /* no growth may be possible at this separation */
    if (status != DOM_OK) {
        fprintf(stderr, "rmax: s = %g: %s\n", train.s, dom_status_text(status));
        return 1;
    }
    printf("%.12g, ends by %s\n", limit.r_max, dom_end_text(limit.ends));
    return 0;
}
