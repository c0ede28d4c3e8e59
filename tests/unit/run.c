/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run.h"
#include "support.h"

static bool fall_seen(const struct dom_fall *fall, void *context)
{
    struct run *run = context;
    assert_true(run->falls < ROW_MOST && fall->domino == run->falls + 1);
    run->fall[run->falls++] = *fall;
    return true;
}

enum dom_status run_row(struct run *run)
{
    run->row.domino = run->domino;
    run->falls = 0;
    return dom_row_run(&run->row, true, fall_seen, run, &run->verdict);
}

enum dom_row_end row_end(struct run *run)
{
    run->row.domino = run->domino;
    assert_status(dom_row_run(&run->row, false, NULL, NULL, &run->verdict), DOM_OK);
    return run->verdict.end;
}

double push_over(const struct dom_domino *domino)
{
    double h = domino->height, d = domino->thickness;
    return sqrt(3 * 9.81 * (hypot(h, d) - h) / (h * h + d * d));
}

void make_row(struct run *run, size_t count, double s, double r, double mu)
{
    struct dom_train train = dom_train_default();
    struct dom_scale scale = dom_scale_default();
    train.s = s;
    train.r = r;
    dom_row_of_train(&train, &scale, 0.01, run->domino, count);
    run->row = (struct dom_row){.domino = run->domino,
                                .count = count,
                                .g = 9.81,
                                .push = 3 * push_over(run->domino),
                                .mu = mu,
                                .tol = 1e-12,
                                .precision = DOM_DOUBLE};
}

void newton_run(const struct run *run, struct newton *n)
{
    for (size_t k = 0; k < run->row.count; k++) {
        n->height[k] = run->domino[k].height;
        n->thickness[k] = run->domino[k].thickness;
        n->gap[k] = run->domino[k].gap;
        n->mass[k] = run->domino[k].mass;
    }
    struct direct_row row = {run->row.count, n->height,   n->thickness, n->gap,       n->mass,
                             run->row.mu,    run->row.g,  run->row.push, 0};
    n->wrong = direct_run(&row, n->hit, &n->result);
}
