/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/lateness.h"

double lateness_agreement(const struct lateness *lateness, const enum score_column *columns,
                          size_t count, enum agreement_norm norm)
{
    const struct lattice *lattice = lateness->lattice;
    const struct reference_problem *problem = lateness->problem;
    struct agreement agreement = {.error = 0.0};
    for (size_t k = 1; k <= lateness->instants; k++) {
        const double time = lateness->end * (double)k / (double)lateness->instants;
        for (size_t p = 0; p < lattice->count[0] * lattice->count[1]; p++) {
            double place[2], now[SCORE_COLUMNS], later[SCORE_COLUMNS];
            double multiple[SCORE_COLUMNS], computed[SCORE_COLUMNS], exact[SCORE_COLUMNS];
            lattice_point(lattice, p, place);
            problem->reference->evaluate(problem, place, time, now);
            problem->reference->evaluate(problem, place, time + lateness->late, later);
            for (size_t c = 0; c < count; c++) {
                multiple[c] = columns[c] == SCORE_STRESS_XY ? 2.0 : 1.0;
                computed[c] = later[columns[c]];
                exact[c] = now[columns[c]];
            }
            agreement_add(&agreement, count, multiple, computed, exact);
        }
    }
    return agreement_percent(&agreement, norm);
}
