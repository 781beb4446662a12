/* A bar in uniaxial strain (a plate, struck evenly) hits a wall faster than it can stop
 * elastically: two fronts, at small strain. Derived here; von Mises with linear isotropic hardening
 * H.
 *
 * With compression counted positive, strain e and q = |sigma_xx - sigma_yy|:
 *
 *     sigma = K e + (2/3) q,
 *     below yield    q = 2 G e,                        d sigma/de = K + 4 G/3 = M,
 *     beyond         dq = H dp = 3 G ((2/3) de - dp),  dp = 2 G de/(3 G + H),
 *                    d sigma/de = K + (4 G/3) H/(3 G + H) = M_p, and K without hardening.
 *
 * Yield begins at e_Y = Y/(2 G), under sigma_Y = M e_Y = Y (K/(2 G) + 2/3), the Hugoniot elastic
 * limit. As M_p < M the step splits: an elastic precursor at c_L = sqrt(M/rho), which stops
 * v_e = sigma_Y/(rho c_L) of the speed V, and behind it, at c_p = sqrt(M_p/rho), a plastic front,
 * which stops the rest:
 *
 *     sigma = sigma_Y + rho c_p (V - v_e),   e = e_Y + (V - v_e)/c_p,   p = 2 G (e - e_Y)/(3 G +
 * H).
 *
 * Balance of momentum at each front; the state behind is on the curve of monotone loading. Speeds
 * are those in the undeformed bar.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_PLASTIC_WAVE_H
#define VERIFICATION_EXACT_PLASTIC_WAVE_H

struct plastic_wave {
    double bulk, shear, density; /* K, G, rho */
    double yield, hardening;     /* Y > 0, H >= 0 */
    double speed;                /* V > v_e */
};

/* Behind a front, compression positive. */
struct plastic_wave_state {
    double celerity;  /* of the front before this state */
    double pressure;  /* sigma, along the bar */
    double lateral;   /* sigma - q */
    double strain;    /* e */
    double plastic;   /* p */
    double remaining; /* speed towards the wall */
};

struct plastic_wave_fronts {
    struct plastic_wave_state precursor, plastic;
};

struct plastic_wave_fronts plastic_wave_fronts(const struct plastic_wave *wave);

#endif
