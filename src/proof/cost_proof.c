/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows that proofs add to the table of 'cost'. */
#include "domino_proof.h"
#include "io/terminal.h"
#include "proof/proof.h"
#include "train/cost.h"

void cost_proved(const struct query *query, struct answer *a, void *context)
{
    static const double proved[] = {1e-3, 1e-6, 1e-9, 1e-12, 1e-14};
    struct cost_more *more = context;
    struct dom_train train = train_in_double(&query->scene->train);
    struct dom_compute compute = {.interrupt = query->scene->compute.interrupt};
    more->method = "proved";
    for (size_t k = 0; (more->is_rmax || more->is_pair) && k < sizeof proved / sizeof *proved; k++) {
        struct dom_proof proof = {.low = DOM_NAN};
        compute.tol = proved[k];
        double begun = terminal_clock();
        enum dom_status status = (more->is_rmax ? dom_prove_rmax : dom_prove_pair)(&train, &compute, &proof);
        if (status != DOM_OK || (proof.ends != DOM_PROVED_BARRIER && proof.ends != DOM_PROVED_REACH))
            break;
        double seconds = terminal_clock() - begun, error = (proof.high - proof.low) / (2 * proof.low);
        answer_cells(a, cell_word("proved"), cell_word("double"), cell_brief(proved[k]), cell_brief(error),
                     cell_real(DOMQ_NAN), cell_count((domq_real)proof.work.chains), cell_brief(1e6 * seconds),
                     cell_brief(seconds / more->cheapest));
        more->twelve = proved[k] == 1e-12 ? seconds : more->twelve;
    }
}
