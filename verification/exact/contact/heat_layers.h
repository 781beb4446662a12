/* Two bodies brought together at t = 0, each of one temperature before: a slab on a slab, or a
 * cylinder in a tube, insulated outside, with the heat flux H (T_1 - T_2) between them (H. S.
 * Carslaw, J. C. Jaeger, Conduction of Heat in Solids, composite slabs and contact resistance).
 *
 *     c v_t = (k v_x)_x, or (1/r)(k r v_r)_r;    k_1 v_1' = k_2 v_2' = H (v_2 - v_1) between them
 *
 * With z = sqrt(l c/k) in each of them, the modes decay by exp(-l t) and are multiples of
 *
 *     slabs      p_1 = cos(z_1 x),     p_2 = cos(z_2 (b - x))
 *     cylinder   p_1 = J0(z_1 r),      p_2 = J0(z_2 r) Y1(z_2 b) - Y0(z_2 r) J1(z_2 b)
 *
 * where k_1 k_2 p_1' p_2'/H + k_2 p_1 p_2' - k_1 p_1' p_2 = 0 at the contact. What flows there adds
 * one square to the energy, so that there is one l between each two neighbours of those of both
 * bodies alone: none is missed. A mode has the amplitude (v_1 - v_2) I_1/N of t = 0, with its
 * content I_1 of the first body and its norm N.
 *
 * Two half-spaces have, for perfect contact, the temperature (e_1 v_1 + e_2 v_2)/(e_1 + e_2)
 * between them, e = sqrt(k c), from t = 0 on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_HEAT_LAYERS_H
#define VERIFICATION_EXACT_HEAT_LAYERS_H

#include <stdbool.h>
#include <stddef.h>

struct heat_layers {
    bool cylinder;
    double width[2]; /* of the first, and of the second behind it, which ends at their sum b */
    double conductivity[2], capacity[2]; /* k; c per volume */
    double start[2];                     /* v at t = 0 */
    double conductance;                  /* H > 0; HUGE_VAL: perfect contact */
};

enum { HEAT_LAYERS_MODES = 400 };

struct heat_layers_mode {
    double rate;                          /* l */
    double root[2], amplitude[2], factor; /* z of each; of p, of the mode */
    double content;                       /* of the first body, with the factor */
};

struct heat_layers_series {
    struct heat_layers layers;
    double end; /* v for t -> infinity */
    size_t count;
    struct heat_layers_mode modes[HEAT_LAYERS_MODES];
};

/* The modes that matter from time `from` > 0 on. False: more than there is room for, or a root was
 * not found. */
bool heat_layers_solve(const struct heat_layers *layers, double from,
                       struct heat_layers_series *series);

/* v at x or r, in the first or the second body (0, 1); t >= `from`. */
double heat_layers_value(const struct heat_layers_series *series, int body, double place,
                         double time);

/* What the first has given to the second since t = 0, per area; per radian and height. */
double heat_layers_passed(const struct heat_layers_series *series, double time);

/* Between two half-spaces; see above. */
double heat_layers_between(const struct heat_layers *layers);

#endif
