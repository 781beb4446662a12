/* Conservation over a run: how far energy, momentum and angular momentum move from where they
 * started, over all samples of the ledger. Pure functions; a NaN in a ledger stays in every
 * drift that it touches.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_CONSERVATION_H
#define VERIFICATION_MEASURES_CONSERVATION_H

#include "mpm.h"

struct conservation {
    struct mpm_ledger start, last;
    double energy_low, energy_high; /* extremes of (E - W) / E(0) - 1; W work from outside */
    double momentum;                /* largest |p - p(0)| */
    double angular_momentum;        /* largest |L - L(0)| */
    double smallest_kinetic;        /* smallest kinetic energy over E(0) */
    size_t samples;
};

/* The first ledger; its total energy is what drifts are measured by. */
void conservation_open(struct conservation *conservation, const struct mpm_ledger *ledger);
void conservation_add(struct conservation *conservation, const struct mpm_ledger *ledger);

/* (E - W) / E(0) - 1 of the last sample, and the largest such drift either way; without unit. */
double conservation_energy_now(const struct conservation *conservation);
double conservation_energy_drift(const struct conservation *conservation);

/* Largest change of momentum over sqrt(2 M E(0)), the momentum that the mass M would have with
 * all of the energy in one motion: a scale that is there when momenta cancel. Without unit. */
double conservation_momentum_drift(const struct conservation *conservation);

/* Largest change of angular momentum over sqrt(2 M E(0)) `arm`, arm > 0 a length of the
 * problem. Without unit. */
double conservation_angular_momentum_drift(const struct conservation *conservation, double arm);

#endif
