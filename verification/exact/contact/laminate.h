/* Two layers joined by an imperfect interface, under one traction t: exact solution of case C6.
 *
 * Each layer has a length L_k along the normal and a modulus E_k of the component at hand (for
 * tension or compression that of the state of strain across it, for shear G). The interface bears t
 * at a jump of displacement t/D. Since t is the same everywhere, displacements add up:
 *
 *     (L1 + L2)/E = L1/E1 + L2/E2 + 1/D,   stored in the interface: area t^2/(2 D).
 *
 * Own derivation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_LAMINATE_H
#define VERIFICATION_EXACT_LAMINATE_H

struct laminate {
    double length[2], modulus[2]; /* > 0 */
    double interface;             /* D > 0, stress over length; infinite: bonded */
};

/* E: t times the whole length over the displacement of one end against the other. */
double laminate_modulus(const struct laminate *laminate);

/* At a place from 0 to L1 + L2, 0 being held, under the traction t; the interface itself belongs
 * to the first layer. */
double laminate_displacement(const struct laminate *laminate, double traction, double place);

/* Energy in the interface over its area. */
double laminate_stored(const struct laminate *laminate, double traction);

#endif
