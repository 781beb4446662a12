/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/plane_stress.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { EXPANSIONS = 60, ITERATIONS = 100 };
static const double ROUND_OFF = 32.0 * DBL_EPSILON; /* of strains */
static const double MARGIN = 1.01;                  /* of the bracket */

/* The law at one x, from the same start of the step. */
struct trial {
    const struct mpm_material *material;
    struct mpm_law_step step;
    double *f;
    const double *old_state;
    double *state, *stress, *wave;
    double least, largest; /* slope of tau_zz in x */
    bool updated;          /* by the last call */
};

/* tau_zz over rho_0 at x; NaN without an end of the step. */
static double across(struct trial *trial, double x)
{
    const struct mpm_material_law *const law = trial->material->law;
    memcpy(trial->state, trial->old_state, law->variable_count * sizeof *trial->state);
    trial->f[MPM_ZZ] = exp(x);
    trial->updated =
        law->update(trial->material, &trial->step, trial->state, trial->stress, trial->wave);
    return trial->updated ? trial->stress[MPM_SYM_ZZ] : (double)NAN;
}

static bool is_zero(const struct trial *trial, double stress)
{
    return fabs(stress) <= ROUND_OFF * trial->largest;
}

/* Regula falsi (Illinois) between x[0] and x[1], where tau_zz has two signs. */
static bool close_bracket(struct trial *trial, double x[2], double stress[2])
{
    for (int k = 0; k < ITERATIONS; k++) {
        const double middle = x[1] - stress[1] * (x[1] - x[0]) / (stress[1] - stress[0]);
        const double now = across(trial, middle);
        if (isnan(now))
            return false;
        if (is_zero(trial, now) || fabs(x[1] - x[0]) <= ROUND_OFF * fmax(1.0, fabs(middle)))
            return true;
        if ((now > 0.0) == (stress[1] > 0.0)) {
            stress[0] *= 0.5;
        } else {
            x[0] = x[1];
            stress[0] = stress[1];
        }
        x[1] = middle;
        stress[1] = now;
    }
    trial->f[MPM_ZZ] = (double)NAN;
    return false;
}

/* From x and its tau_zz on: away by what the least slope leads to, and further where it does not
 * reach. */
static bool search(struct trial *trial, double x, double stress)
{
    double ends[2] = {x, x}, values[2] = {stress, stress};
    double way = -MARGIN * stress / trial->least;
    for (int k = 0; k < EXPANSIONS; k++) {
        ends[1] = ends[0] + way;
        values[1] = across(trial, ends[1]);
        if (isnan(values[1]))
            return false;
        if (is_zero(trial, values[1]))
            return true;
        if ((values[1] > 0.0) != (stress > 0.0))
            return close_bracket(trial, ends, values);
        ends[0] = ends[1];
        values[0] = values[1];
        way *= 2.0;
    }
    trial->f[MPM_ZZ] = (double)NAN;
    return false;
}

bool mpm_plane_stress_update(const struct mpm_material *m, const struct mpm_law_step *step,
                             double f[MPM_GRADIENT_SIZE], const double *old_state, double *state,
                             double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    struct trial trial = {.material = m,
                          .step = *step,
                          .f = f,
                          .old_state = old_state,
                          .state = state,
                          .stress = stress,
                          .wave = wave_speed_squared,
                          .least = m->bulk,
                          .largest = m->bulk + 4.0 / 3.0 * m->shear};
    trial.step.f = f;
    double x = log(f[MPM_ZZ]), now = across(&trial, x);
    if (!isnan(now) && !is_zero(&trial, now)) {
        x -= now / trial.largest;
        now = across(&trial, x);
    }
    if (isnan(now))
        return false;
    return is_zero(&trial, now) || search(&trial, x, now);
}
