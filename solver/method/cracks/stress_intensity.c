/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/stress_intensity.h"

#include "method/cracks/crack_fields.h"

#include <math.h>

/* The part of the way from the tip to a side of the rectangle on which q is 1. */
static const double PLATEAU = 0.25;
/* Of a particle's size: one closer to the crack's line lies on it. */
static const double ON_CRACK = 1e-9;
/* Of a cell: pieces of the faces of a bent crack, and how far beside it they are looked at. */
static const double FACE_PIECE = 0.25, BESIDE = 1e-6;
static const double PI = 3.14159265358979323846;

/* ------------------------------------------------------------- fields of a tip */

/* The auxiliary field of one mode, A = 1, in the axes 1 and 2. */
struct auxiliary {
    double stress[3]; /* t: 11 22 12 */
    double strain[3]; /* a_11, a_22, (a_12 + a_21)/2 */
    double slope[2];  /* a_i,1 */
};

/* Cosine and sine of half the angle from axis 1, -pi to pi. */
struct half_angle {
    double cosine, sine;
};

static void add_mode(const struct mpm_tip_frame *frame, const double stress[3], double rotation,
                     double weight, struct auxiliary *field)
{
    const double compliance = 0.5 * weight / frame->shear;
    const double sum = 0.25 * (3.0 - frame->kappa) * (stress[0] + stress[1]);
    const double strain[3] = {compliance * (stress[0] - sum), compliance * (stress[1] - sum),
                              compliance * stress[2]};
    for (int k = 0; k < 3; k++) {
        field->stress[k] += weight * stress[k];
        field->strain[k] += strain[k];
    }
    field->slope[0] += strain[0];
    field->slope[1] += strain[2] + weight * rotation;
}

/* Adds the fields of both modes, times `weight`, at the distance r from the tip. */
static void add_auxiliary(const struct mpm_tip_frame *frame, double r, struct half_angle half,
                          double weight, struct auxiliary field[MPM_MODES])
{
    const double c = half.cosine, s = half.sine, size = weight / sqrt(2.0 * PI * r);
    const double c3 = c * (4.0 * c * c - 3.0), s3 = s * (3.0 - 4.0 * s * s);
    const double spin = -0.25 * (frame->kappa + 1.0) / frame->shear;
    const double one[3] = {c * (1.0 - s * s3), c * (1.0 + s * s3), c * s * c3};
    const double two[3] = {-s * (2.0 + c * c3), s * c * c3, c * (1.0 - s * s3)};
    add_mode(frame, one, spin * s, size, &field[0]);
    add_mode(frame, two, spin * c, size, &field[1]);
}

/* On which side of the bent crack is a place that is not ahead of the tip? A line to a place just
 * ahead of it crosses the crack where that is not the side of the tip's last segment. */
static bool is_beyond_crack(const struct mpm_tip_frame *frame, const double place[2])
{
    const double ahead = 1e-3 * frame->contour->state->grid.cell[0];
    const double to[2] = {frame->place[0] + ahead * frame->turned[0][0],
                          frame->place[1] + ahead * frame->turned[0][1]};
    return mpm_j_side(frame->contour, place, to, NULL) != MPM_CRACK_SAME_SIDE;
}

static bool is_on_crack(double size, const double x[2])
{
    return x[0] < 0.0 && fabs(x[1]) <= ON_CRACK * size;
}

/* The fields at a place, x along the axes from the tip; `size` of a particle. */
static void auxiliary_at(const struct mpm_tip_frame *frame, double size, const double place[2],
                         const double x[2], struct auxiliary field[MPM_MODES])
{
    const double r = sqrt(x[0] * x[0] + x[1] * x[1]);
    const double far = fmax(r, 0.5 * size);
    const double cosine = r > 0.0 ? x[0] / r : 1.0;
    struct half_angle half = {sqrt(0.5 * fmax(1.0 + cosine, 0.0)),
                              sqrt(0.5 * fmax(1.0 - cosine, 0.0))};
    if (is_on_crack(size, x)) {
        add_auxiliary(frame, far, (struct half_angle){0.0, 1.0}, 0.5, field);
        add_auxiliary(frame, far, (struct half_angle){0.0, -1.0}, 0.5, field);
        return;
    }
    if (x[1] < 0.0)
        half.sine = -half.sine;
    if (x[0] < 0.0 && is_beyond_crack(frame, place)) {
        half.cosine = -half.cosine; /* a turn of 2 pi back */
        half.sine = -half.sine;
    }
    add_auxiliary(frame, far, half, 1.0, field);
}

/* ------------------------------------------------------------------- weights */

/* f of the header and its slope. */
static double falling(double s, double *slope)
{
    const double w = (s - PLATEAU) / (1.0 - PLATEAU);
    *slope = 0.0;
    if (w <= 0.0)
        return 1.0;
    if (w >= 1.0)
        return 0.0;
    *slope = -30.0 * w * w * (1.0 - w) * (1.0 - w) / (1.0 - PLATEAU);
    return 1.0 - w * w * w * (10.0 - w * (15.0 - 6.0 * w));
}

/* q and its gradient along x and y. */
static double weight_at(const struct mpm_tip_frame *frame, const double from_tip[2],
                        double gradient[2])
{
    double f[2], slope[2];
    for (int axis = 0; axis < 2; axis++) {
        const double width = frame->width[axis];
        f[axis] = falling(fabs(from_tip[axis]) / width, &slope[axis]);
        slope[axis] *= (from_tip[axis] > 0.0 ? 1.0 : -1.0) / width;
    }
    gradient[0] = slope[0] * f[1];
    gradient[1] = f[0] * slope[1];
    return f[0] * f[1];
}

/* ----------------------------------------------------------------- integrands */

/* The field of the body at a particle, in the axes 1 and 2. */
struct measured {
    double stress[3];        /* s: 11 22 12 */
    double gradient[4];      /* u_i,k: 11 12 21 22 */
    double force[2];         /* rho (v' - b) */
    double weight, slope[2]; /* q and q,k */
};

static double along(const double axis[2], const double vector[2])
{
    return axis[0] * vector[0] + axis[1] * vector[1];
}

static struct measured measured_at(const struct mpm_tip_frame *frame,
                                   const struct mpm_j_particle *own, const double force[2],
                                   double weight, const double gradient[2])
{
    const double tau[4] = {own->tau[MPM_SYM_XX], own->tau[MPM_SYM_XY], own->tau[MPM_SYM_XY],
                           own->tau[MPM_SYM_YY]};
    struct measured made = {.weight = weight};
    double stress[4];
    for (int i = 0; i < 2; i++) {
        const double *const e = frame->turned[i];
        const double row[2] = {e[0] * tau[0] + e[1] * tau[2], e[0] * tau[1] + e[1] * tau[3]};
        const double carried[2] = {e[0] * own->f[MPM_XX] + e[1] * own->f[MPM_YX],
                                   e[0] * own->f[MPM_XY] + e[1] * own->f[MPM_YY]};
        for (int k = 0; k < 2; k++) {
            stress[2 * i + k] = along(frame->turned[k], row);
            made.gradient[2 * i + k] = along(frame->axes[k], carried) - (i == k ? 1.0 : 0.0);
        }
        made.force[i] = own->density * along(e, force);
        made.slope[i] = along(e, gradient);
    }
    made.stress[0] = stress[0];
    made.stress[1] = stress[3];
    made.stress[2] = stress[1];
    return made;
}

/* s_ik n_k of a stress 11 22 12, times a vector. */
static double product(const double stress[3], const double n[2], const double vector[2])
{
    return (stress[0] * n[0] + stress[2] * n[1]) * vector[0] +
           (stress[2] * n[0] + stress[1] * n[1]) * vector[1];
}

/* s_lm a_l,m */
static double mixed_energy(const struct measured *own, const struct auxiliary *field)
{
    return own->stress[0] * field->strain[0] + own->stress[1] * field->strain[1] +
           2.0 * own->stress[2] * field->strain[2];
}

/* t_33: 0 in plane stress */
static double across_plane(const struct mpm_tip_frame *frame, const struct auxiliary *field)
{
    const bool strained = frame->contour->state->scene->geometry != MPM_PLANE_STRESS;
    return strained ? 0.25 * (3.0 - frame->kappa) * (field->stress[0] + field->stress[1]) : 0.0;
}

static double trace_of(const struct mpm_tip_frame *frame, const struct auxiliary *field)
{
    return field->stress[0] + field->stress[1] + across_plane(frame, field);
}

/* [...] q,k + rho (v' - b)_i a_i,1 q */
static double planar_part(const struct measured *own, const struct auxiliary *field)
{
    const double slope[2] = {own->gradient[0], own->gradient[2]}; /* u_i,1 */
    return product(own->stress, own->slope, field->slope) +
           product(field->stress, own->slope, slope) - mixed_energy(own, field) * own->slope[0] +
           own->weight * along(own->force, field->slope);
}

/* What axisymmetry adds to R times that. */
static double curved_part(const struct mpm_tip_frame *frame, const struct mpm_j_particle *particle,
                          const struct measured *own, const struct auxiliary *field)
{
    const double radial[2] = {frame->axes[0][0], frame->axes[1][0]}; /* e_R */
    const double slope[2] = {own->gradient[0], own->gradient[2]};
    const double hoop = across_plane(frame, field);
    const double stretch = particle->f[MPM_ZZ] - 1.0;
    return own->weight * (particle->tau[MPM_SYM_ZZ] * along(radial, field->slope) +
                          product(field->stress, radial, slope) -
                          hoop * (along(radial, slope) - radial[0] * stretch) -
                          radial[0] * mixed_energy(own, field));
}

/* What u_1,1 = 1 gives with t. */
static double constant_part(const struct mpm_tip_frame *frame, double radius,
                            const struct measured *own, const struct auxiliary *field)
{
    const double along_crack[2] = {1.0, 0.0};
    const double radial[2] = {frame->axes[0][0], frame->axes[1][0]};
    const double curved = own->weight * product(field->stress, radial, along_crack);
    return radius * product(field->stress, own->slope, along_crack) +
           (frame->curved ? curved : 0.0);
}

/* Weights fall to 0 at the distance of a cell, so that none depends on round-off; one on the crack
 * counts for both faces. */
static void add_to_faces(const struct mpm_tip_frame *frame, const struct mpm_j_particle *particle,
                         const double x[2], const struct measured *own,
                         struct mpm_intensity_sums *sums)
{
    const double share = 1.0 - fabs(x[1]) / frame->near;
    if (x[0] >= 0.0 || share <= 0.0)
        return;
    const double weight = share * fabs(own->slope[0]) / sqrt(-x[0]);
    const bool on_crack = is_on_crack(sqrt(particle->area), x);
    for (int face = 0; face < 2; face++) {
        if (!on_crack && (face == 1) != (x[1] > 0.0))
            continue;
        sums->weight[face] += weight;
        sums->strain[face] += weight * own->gradient[0];
    }
}

/* The part of a particle's domain that is beyond the crack. */
static double share_beyond(const struct mpm_tip_frame *frame, const struct mpm_j_particle *particle,
                           const double x[2])
{
    const struct mpm_state *const state = frame->contour->state;
    const double *const half = state->bodies[state->particles.body[particle->p]].half_size;
    const double *const across = frame->axes[1];
    const double reach = fabs(across[0]) * half[0] + fabs(across[1]) * half[1];
    const double image[2] = {particle->place[0] - 2.0 * x[1] * frame->turned[1][0],
                             particle->place[1] - 2.0 * x[1] * frame->turned[1][1]};
    if (x[0] >= 0.0 || fabs(x[1]) >= reach ||
        mpm_j_side(frame->contour, particle->place, image, NULL) == MPM_CRACK_SAME_SIDE)
        return 0.0;
    return 0.5 * (1.0 - fabs(x[1]) / reach);
}

void mpm_stress_intensity_add(const struct mpm_tip_frame *frame,
                              const struct mpm_j_particle *particle, const double force[2],
                              const double expansion[2], struct mpm_intensity_sums *sums)
{
    const double from[2] = {particle->place[0] - frame->place[0],
                            particle->place[1] - frame->place[1]};
    double gradient[2];
    const double weight = weight_at(frame, from, gradient);
    if (!(weight > 0.0))
        return;
    const double x[2] = {along(frame->turned[0], from), along(frame->turned[1], from)};
    const struct measured own = measured_at(frame, particle, force, weight, gradient);
    struct auxiliary field[MPM_MODES] = {{.slope = {0.0, 0.0}}, {.slope = {0.0, 0.0}}};
    auxiliary_at(frame, sqrt(particle->area), particle->place, x, field);
    add_to_faces(frame, particle, x, &own, sums);
    const double radius = frame->curved ? particle->place[0] / particle->f[MPM_ZZ] : 1.0;
    const double slope = along(frame->axes[0], expansion); /* e,1 */
    const double beyond = slope == 0.0 ? 0.0 : share_beyond(frame, particle, x);
    for (int mode = 0; mode < MPM_MODES; mode++) {
        const double kept = mode == 0 ? 1.0 : 1.0 - 2.0 * beyond;
        const double free_strain = weight * kept * trace_of(frame, &field[mode]) * slope;
        double sum = radius * (planar_part(&own, &field[mode]) + free_strain);
        if (frame->curved)
            sum += curved_part(frame, particle, &own, &field[mode]);
        sums->body[mode] += particle->area * sum;
        sums->constant[mode] += particle->area * constant_part(frame, radius, &own, &field[mode]);
    }
}

/* ------------------------------------------------------------------ bent cracks */

/* Mean stress and gradient of the body at a place that is no particle's: of the nodes of its cell,
 * by the fields that a particle there would have. `form` has F; its other members are not used.
 * False: no particles are near. */
static bool face_at(const struct mpm_tip_frame *frame, const double place[2],
                    struct mpm_j_particle *form)
{
    const struct mpm_j_contour *const contour = frame->contour;
    const struct mpm_grid *const grid = &contour->state->grid;
    double sum = 0.0, part[2];
    int64_t first[2];
    *form = (struct mpm_j_particle){.place = {place[0], place[1]}, .density = 0.0};
    for (int axis = 0; axis < 2; axis++) {
        const double from = (place[axis] - grid->origin[axis]) * grid->inverse_cell[axis];
        first[axis] = mpm_floor(from);
        part[axis] = from - (double)first[axis];
        first[axis] += MPM_GHOST_ROWS;
    }
    for (int corner = 0; corner < 4; corner++) {
        const int64_t at[2] = {first[0] + corner % 2, first[1] + corner / 2};
        double node[2];
        mpm_j_place(contour, at, node);
        const struct mpm_j_sums *const sums =
            &mpm_j_node_at(contour, at)->side[mpm_j_side(contour, place, node, NULL)];
        const double weight = (corner % 2 == 0 ? 1.0 - part[0] : part[0]) *
                              (corner / 2 == 0 ? 1.0 - part[1] : part[1]);
        if (!(sums->area > 0.0))
            continue;
        sum += weight;
        for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
            form->f[k] += weight * sums->gradient[k] / sums->area;
        form->tau[MPM_SYM_XX] += weight * sums->stress[0] / sums->area;
        form->tau[MPM_SYM_YY] += weight * sums->stress[1] / sums->area;
        form->tau[MPM_SYM_XY] += weight * sums->stress[2] / sums->area;
    }
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        form->f[k] =
            (sum > 0.0 ? form->f[k] / sum : 0.0) + (k == MPM_XY || k == MPM_YX ? 0.0 : 1.0);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        form->tau[k] = sum > 0.0 ? form->tau[k] / sum : 0.0;
    return sum > 0.0;
}

/* A piece of a face: s_lm a_l,m n_1 - t_ik n_k u_i,1, `out` being n times its length. */
static void add_face(const struct mpm_tip_frame *frame, const double place[2], const double out[2],
                     struct mpm_intensity_sums *sums)
{
    const double still[2] = {0.0, 0.0};
    const double from[2] = {place[0] - frame->place[0], place[1] - frame->place[1]};
    const double x[2] = {along(frame->turned[0], from), along(frame->turned[1], from)};
    struct auxiliary field[MPM_MODES] = {{.slope = {0.0, 0.0}}, {.slope = {0.0, 0.0}}};
    struct mpm_j_particle form;
    double gradient[2];
    const double weight = weight_at(frame, from, gradient);
    if (!(weight > 0.0) || !face_at(frame, place, &form))
        return;
    const struct measured own = measured_at(frame, &form, still, weight, gradient);
    const double n[2] = {along(frame->turned[0], out), along(frame->turned[1], out)};
    const double slope[2] = {own.gradient[0], own.gradient[2]}, along_crack[2] = {1.0, 0.0};
    const double radius = frame->curved ? place[0] / form.f[MPM_ZZ] : 1.0;
    auxiliary_at(frame, 0.0, place, x, field);
    for (int mode = 0; mode < MPM_MODES; mode++) {
        const double *const t = field[mode].stress;
        sums->body[mode] +=
            weight * radius * (mixed_energy(&own, &field[mode]) * n[0] - product(t, n, slope));
        sums->constant[mode] -= weight * radius * product(t, n, along_crack);
    }
}

void mpm_stress_intensity_add_faces(const struct mpm_tip_frame *frame,
                                    struct mpm_intensity_sums *sums)
{
    const struct mpm_j_contour *const contour = frame->contour;
    const struct mpm_state *const state = contour->state;
    const struct mpm_crack_chain *const chain = &state->cracks.chains[contour->spec->crack];
    const struct mpm_crack_part *const part = &contour->parts[contour->spec->crack];
    const size_t last = contour->spec->at_start ? 0 : chain->count - 2;
    const double cell = fmin(state->grid.cell[0], state->grid.cell[1]);
    for (size_t k = part->first; k < part->end; k++) {
        const double way[2] = {chain->x[k + 1] - chain->x[k], chain->y[k + 1] - chain->y[k]};
        const double length = sqrt(way[0] * way[0] + way[1] * way[1]);
        const double pieces = ceil(length / (FACE_PIECE * cell));
        for (double i = 0.0; i < pieces && k != last; i += 1.0) {
            const double at = (i + 0.5) / pieces;
            for (int side = -1; side <= 1; side += 2) { /* right and left of the way */
                const double shift = side * BESIDE * cell / length;
                const double place[2] = {chain->x[k] + at * way[0] - shift * way[1],
                                         chain->y[k] + at * way[1] + shift * way[0]};
                const double out[2] = {side * way[1] / pieces, -side * way[0] / pieces};
                add_face(frame, place, out, sums);
            }
        }
    }
}

void mpm_stress_intensity_find(const struct mpm_tip_frame *frame,
                               const struct mpm_intensity_sums *sums, double intensity[MPM_MODES])
{
    double strain = 0.0;
    if (sums->weight[0] > 0.0 && sums->weight[1] > 0.0)
        strain = 0.5 * (sums->strain[0] / sums->weight[0] + sums->strain[1] / sums->weight[1]);
    for (int mode = 0; mode < MPM_MODES; mode++)
        intensity[mode] = frame->factor * (sums->body[mode] - strain * sums->constant[mode]);
}

/* --------------------------------------------------------------------- frame */

/* Cosine and sine, times a length, of the rotation of the mean of F, with the weights q. */
static void mean_rotation(const struct mpm_tip_frame *frame, double rotation[2])
{
    const struct mpm_particles *const particles = &frame->contour->state->particles;
    rotation[0] = rotation[1] = 0.0;
    for (size_t p = 0; p < particles->count; p++) {
        const double from[2] = {particles->position[0][p] - frame->place[0],
                                particles->position[1][p] - frame->place[1]};
        double f[MPM_GRADIENT_SIZE], gradient[2];
        if (fabs(from[0]) >= frame->width[0] || fabs(from[1]) >= frame->width[1] ||
            !mpm_cracks_cut(frame->contour->state, p))
            continue;
        const double weight = weight_at(frame, from, gradient);
        mpm_particle_deformation(particles, p, f);
        rotation[0] += weight * (f[MPM_XX] + f[MPM_YY]);
        rotation[1] += weight * (f[MPM_YX] - f[MPM_XY]);
    }
}

static void turn_axes(struct mpm_tip_frame *frame)
{
    double rotation[2] = {1.0, 0.0};
    if (!frame->curved)
        mean_rotation(frame, rotation);
    const double length = sqrt(rotation[0] * rotation[0] + rotation[1] * rotation[1]);
    for (int k = 0; k < 2; k++) {
        const double *const axis = frame->axes[k];
        frame->turned[k][0] = (rotation[0] * axis[0] - rotation[1] * axis[1]) / length;
        frame->turned[k][1] = (rotation[1] * axis[0] + rotation[0] * axis[1]) / length;
    }
}

struct mpm_tip_frame mpm_tip_frame_of(const struct mpm_j_contour *contour, double bulk,
                                      double shear)
{
    const struct mpm_state *const state = contour->state;
    const double poisson = (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear));
    const double *const d = contour->tip->direction;
    const enum mpm_geometry geometry = state->scene->geometry;
    struct mpm_tip_frame made = {
        .contour = contour,
        .axes = {{d[0], d[1]}, {-d[1], d[0]}},
        .near = fmax(state->grid.cell[0], state->grid.cell[1]),
        .shear = shear,
        .kappa =
            geometry == MPM_PLANE_STRESS ? (3.0 - poisson) / (1.0 + poisson) : 3.0 - 4.0 * poisson,
        .curved = geometry == MPM_AXISYMMETRIC,
    };
    double low[2], high[2];
    made.factor = 4.0 * shear / (made.kappa + 1.0) / (made.curved ? contour->tip->place[0] : 1.0);
    mpm_j_tip_place(state, contour->spec, made.place);
    mpm_j_place(contour, contour->low, low);
    mpm_j_place(contour, contour->high, high);
    for (int axis = 0; axis < 2; axis++)
        made.width[axis] = fmin(made.place[axis] - low[axis], high[axis] - made.place[axis]);
    turn_axes(&made);
    return made;
}
