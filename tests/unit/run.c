/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run.h"
#include "support.h"

static bool fall_seen(const struct domq_fall *fall, void *context)
{
    struct run *run = context;
    assert_true(run->falls < ROW_MOST && fall->domino == run->falls + 1);
    run->fall[run->falls++] = *fall;
    return true;
}

enum dom_status run_whole(struct run *run)
{
    run->row.domino = run->domino;
    run->falls = 0;
    return ask_row_run(&run->row, true, fall_seen, run, &run->verdict);
}

enum dom_row_end row_end(struct run *run)
{
    run->row.domino = run->domino;
    assert_status(ask_row_run(&run->row, false, NULL, NULL, &run->verdict), DOM_OK);
    return run->verdict.end;
}

double push_over(const struct domq_domino *domino)
{
    double h = domino->height, d = domino->thickness;
    return sqrt(3 * 9.81 * (hypot(h, d) - h) / (h * h + d * d));
}

void make_row(struct run *run, size_t count, double s, double r, double mu)
{
    struct asked train = asked_default();
    struct domq_scale scale = domq_scale_default();
    train.s = s;
    train.r = r;
    ask_row_of_train(&train, &scale, 0.01, run->domino, count);
    run->row = (struct asked_row){.domino = run->domino,
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
        n->lean[k] = run->domino[k].lean;
    }
    struct direct_row row = {run->row.count, n->height,  n->thickness,  n->gap, n->mass,
                             run->row.mu,    run->row.g, run->row.push, 0,      0,
                             n->lean};
    n->wrong = direct_run(&row, n->hit, &n->result);
}
