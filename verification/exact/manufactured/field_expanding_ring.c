/* M2: a ring with free faces that breathes (Wallstedt and Guilkey 2008, J. Comput. Phys. 227,
 * 9628), in plane strain or stress; in axisymmetry a hollow cylinder, r for the radius:
 *
 *     u_r = A sin(pi c t / (2 r_b)) (c1 + c2 R + c3 R^2) R,
 *
 * with u_r = A sin(...) at r_b and no traction on both faces at small strain,
 *     M u_r' + L u_r / R = 0,   M = lambda + 2 G, L = lambda, in plane stress with 2 G lambda / M
 * for lambda. With the law linear_elastic, whose P is Hooke's wherever nothing turns, that is so at
 * any amplitude; with neo_hookean a traction of second order in A is left, at A = 0.1 a tenth of
 * the largest |P| (manufactured_edges), which a scene would have to apply.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_field.h"

enum { AMPLITUDE, INNER, OUTER, HEIGHT };

static void prepare(struct manufactured_problem *problem)
{
    const double *const p = problem->parameter, stiff = problem->lame + 2.0 * problem->shear;
    const bool sheet = problem->geometry == MPM_PLANE_STRESS;
    const double side = sheet ? 2.0 * problem->shear * problem->lame / stiff : problem->lame;
    const double modulus = side + 2.0 * problem->shear, a = p[INNER], b = p[OUTER];
    /* with c3 = 1: (M + L) c1 + (2 M + L) R c2 = -(3 M + L) R^2 at both radii */
    const double c2 = -(3.0 * modulus + side) / (2.0 * modulus + side) * (a + b);
    const double c1 = (3.0 * modulus + side) / (modulus + side) * (a * b);
    const double scale = p[AMPLITUDE] / (b * (c1 + b * (c2 + b)));
    problem->domain =
        (struct manufactured_domain){MANUFACTURED_ANNULUS, .high = {b, b}, .inner = a, .outer = b};
    problem->edge[MANUFACTURED_INNER] = problem->edge[MANUFACTURED_OUTER] = MANUFACTURED_FREE;
    if (problem->geometry == MPM_AXISYMMETRIC) {
        problem->domain = (struct manufactured_domain){.low = {a, 0.0}, .high = {b, p[HEIGHT]}};
        problem->edge[MANUFACTURED_BOTTOM] = problem->edge[MANUFACTURED_TOP] = MANUFACTURED_SLIDES;
    }
    problem->period = 4.0 * b / manufactured_bar_speed(problem);
    problem->end = 0.2 * problem->period;
    problem->constant[0] = 2.0 * MANUFACTURED_PI / problem->period;
    problem->constant[1] = scale * c1;
    problem->constant[2] = scale * c2;
    problem->constant[3] = scale;
}

static void swing(const struct manufactured_problem *problem, struct jet time,
                  struct jet swings[MANUFACTURED_SWINGS])
{
    swings[0] = jet_sin(jet_scale(problem->constant[0], time));
}

static void displacement(const struct manufactured_problem *problem, const struct jet place[2],
                         const struct jet swings[MANUFACTURED_SWINGS], struct jet u[2])
{
    const double *const c = problem->constant;
    const bool radial = problem->geometry == MPM_AXISYMMETRIC;
    const struct jet square = jet_add(jet_square(place[0]), jet_square(place[1]));
    const struct jet r = radial ? place[0] : jet_root(square);
    const struct jet slope = jet_shift(jet_scale(c[3], r), c[2]);
    const struct jet profile = jet_shift(jet_multiply(slope, r), c[1]);
    const struct jet part = jet_multiply(profile, swings[0]);
    u[0] = jet_multiply(part, place[0]);
    u[1] = radial ? jet_constant(0.0) : jet_multiply(part, place[1]);
}

const struct manufactured_field MANUFACTURED_OF_LEVEL(expanding_ring) = {
    .name = "expanding_ring",
    .parameter = {[AMPLITUDE] = {"amplitude", 0.1, 1e-9, 0.15, "A, length: of the outer face"},
                  [INNER] = {"inner", 0.4, 0.01, 10, "radius of the inner face, length"},
                  [OUTER] = {"outer", 0.6, 0.02, 20, "r_b, length"},
                  [HEIGHT] = {"height", 0.2, 0.001, 20, "of the cylinder in axisymmetry, length"}},
    .prepare = prepare,
    .swing = swing,
    .displacement = displacement,
};
