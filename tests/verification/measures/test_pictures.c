/* What pictures of particles and the faces of cracks are made of: pixels and distances against what
 * is known beforehand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/measures/crack_faces.h"
#include "verification/measures/shapes/raster.h"

#include <math.h>
#include <stddef.h>

enum { AXES = 2, GRADIENT = 5 };

static const double ROUND_OFF = 1e-14;

/* ------------------------------------------------------------------- raster */

/* A parallelogram of domain vectors (1, 0) and (1, 1): area 4, that is 100 of 0.2 by 0.2, those on
 * its slanted edges in or out. */
START_TEST(a_raster_has_a_particle_where_its_deformed_domain_is)
{
    static const double edges[] = {1.0, 1.0, 0.0, 1.0}, centre[] = {0.1, -0.2};
    struct raster raster;
    ck_assert(raster_create((const double[]){-3, -2}, (const double[]){3, 2.1}, 0.2, &raster));
    ck_assert_uint_eq(raster.columns, 30);
    ck_assert_uint_eq(raster.rows, 21);
    raster_add(&raster, centre, edges, 7.0);
    size_t inside = 0;
    for (size_t row = 0; row < raster.rows; row++)
        for (size_t column = 0; column < raster.columns; column++) {
            const double x = -3.0 + 0.2 * ((double)column + 0.5) - centre[0];
            const double y = -2.0 + 0.2 * ((double)row + 0.5) - centre[1];
            const double slack = fmin(1.0 - fabs(y), 1.0 - fabs(x - y));
            const double value = raster.values[row * raster.columns + column];
            ck_assert(value == 7.0 || value == RASTER_EMPTY);
            ck_assert(fabs(slack) < 1e-9 || (value == 7.0) == (slack > 0.0));
            inside += value == 7.0;
        }
    ck_assert(inside >= 90 && inside <= 120);
    raster_free(&raster);
}
END_TEST

START_TEST(a_raster_leaves_out_what_lies_beyond_it)
{
    struct raster raster;
    ck_assert(raster_create((const double[]){0, 0}, (const double[]){1, 1}, 0.25, &raster));
    raster_add(&raster, (const double[]){-1, 0.5}, (const double[]){0.4, 0, 0, 0.4}, 1.0);
    raster_add(&raster, (const double[]){1.0, 1.0}, (const double[]){0.3, 0, 0, 0.3}, 2.0);
    for (size_t i = 0; i < 16; i++)
        ck_assert(raster.values[i] == (i == 15 ? 2.0 : RASTER_EMPTY));
    raster_free(&raster);
    ck_assert(!raster_create((const double[]){0, 0}, (const double[]){0, 1}, 0.25, &raster));
}
END_TEST

/* -------------------------------------------------------------------- faces */

/* A lattice of 1, its sites at halves, about a crack on y = 0 from x = 1 to 5 in three segments. */
enum { SIDE = 6, PARTICLES = SIDE * SIDE, POINTS = 4 };
static const double CRACK[POINTS][AXES] = {{1, 0}, {2, 0}, {3.5, 0}, {5, 0}};

struct lattice {
    double start[AXES * PARTICLES], position[AXES * PARTICLES], gradient[GRADIENT * PARTICLES];
    double points[POINTS][AXES];
    struct crack_faces faces;
};

static void lattice_open(struct lattice *lattice)
{
    for (size_t p = 0; p < PARTICLES; p++) {
        const size_t column = p % SIDE, row = p / SIDE;
        lattice->start[AXES * p] = (double)column + 0.5;
        lattice->start[AXES * p + 1] = (double)row + 0.5 - 0.5 * SIDE;
    }
    ck_assert(
        crack_faces_create(lattice->start, PARTICLES, CRACK, POINTS, 1.6, 1.0, &lattice->faces));
}

/* Both parts stretched by `stretch` along y, that above moved by `apart` and all turned by an angle
 * about the origin. */
static struct crack_gap gap_of(struct lattice *lattice, double stretch, double apart, double angle)
{
    const double c = cos(angle), s = sin(angle);
    for (size_t p = 0; p < PARTICLES; p++) {
        const double x = lattice->start[AXES * p], y = lattice->start[AXES * p + 1];
        const double moved = stretch * y + (y > 0.0 ? apart : 0.0);
        const double f[GRADIENT] = {c, -s * stretch, s, c * stretch, 1.0};
        lattice->position[AXES * p] = c * x - s * moved;
        lattice->position[AXES * p + 1] = s * x + c * moved;
        for (size_t k = 0; k < GRADIENT; k++)
            lattice->gradient[GRADIENT * p + k] = f[k];
    }
    for (size_t k = 0; k < POINTS; k++) {
        const double y = 0.5 * apart;
        lattice->points[k][0] = c * CRACK[k][0] - s * y;
        lattice->points[k][1] = s * CRACK[k][0] + c * y;
    }
    return crack_faces_gap(&lattice->faces, lattice->position, lattice->gradient,
                           (const double(*)[AXES])lattice->points, POINTS);
}

START_TEST(faces_are_the_particles_beside_the_crack_and_not_past_its_ends)
{
    struct lattice lattice;
    lattice_open(&lattice);
    ck_assert_uint_eq(lattice.faces.count, 4 * 4); /* columns 1.5 to 4.5, two rows on each side */
    ck_assert_uint_eq(lattice.faces.station_count, 4);
    for (size_t k = 0; k < lattice.faces.count; k++) {
        const struct crack_face_particle *const particle = &lattice.faces.particles[k];
        const double y = lattice.start[AXES * particle->index + 1];
        ck_assert(particle->side == (y > 0.0 ? 1.0 : -1.0));
        ck_assert_near(particle->way[0], 0.0, ROUND_OFF);
        ck_assert_near(particle->way[1], -y, ROUND_OFF);
    }
    crack_faces_free(&lattice.faces);
}
END_TEST

/* An even strain and any turn are told from an opening, and an overlap is a negative one. */
START_TEST(the_gap_is_the_distance_of_the_faces_along_the_normal)
{
    static const double turns[] = {0.0, 0.7, 3.0}, apart[] = {0.0, 0.3, -0.2};
    struct lattice lattice;
    lattice_open(&lattice);
    for (size_t k = 0; k < 3; k++)
        for (size_t i = 0; i < 3; i++) {
            const struct crack_gap gap = gap_of(&lattice, 1.25, apart[i], turns[k]);
            ck_assert_near(gap.widest, apart[i], 10.0 * ROUND_OFF);
            ck_assert_near(gap.narrowest, apart[i], 10.0 * ROUND_OFF);
            ck_assert_near(gap.mean, apart[i], 10.0 * ROUND_OFF);
            ck_assert_uint_eq(gap.crossed, 0);
        }
    crack_faces_free(&lattice.faces);
}
END_TEST

/* Moved through each other by 1.4, the nearest row of each side, at 0.5, is 0.2 past the middle. */
START_TEST(particles_on_the_other_side_have_crossed)
{
    struct lattice lattice;
    lattice_open(&lattice);
    const struct crack_gap gap = gap_of(&lattice, 1.0, -1.4, 0.4);
    ck_assert_uint_eq(gap.crossed, 8);
    ck_assert_near(gap.depth, 0.2, 10.0 * ROUND_OFF);
    ck_assert_near(gap.narrowest, -1.4, 10.0 * ROUND_OFF);
    crack_faces_free(&lattice.faces);
}
END_TEST

Suite *suite_pictures(void)
{
    Suite *suite = suite_create("pictures");
    TCase *rasters = tcase_create("rasters");
    tcase_add_test(rasters, a_raster_has_a_particle_where_its_deformed_domain_is);
    tcase_add_test(rasters, a_raster_leaves_out_what_lies_beyond_it);
    suite_add_tcase(suite, rasters);
    TCase *faces = tcase_create("faces");
    tcase_add_test(faces, faces_are_the_particles_beside_the_crack_and_not_past_its_ends);
    tcase_add_test(faces, the_gap_is_the_distance_of_the_faces_along_the_normal);
    tcase_add_test(faces, particles_on_the_other_side_have_crossed);
    suite_add_tcase(suite, faces);
    return suite;
}
