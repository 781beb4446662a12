/* C10: how far from the surface's are the normals that contact between two bodies finds at nodes?
 *
 * Bodies are placed by the program, in the scene's grid, about its point (20, 20) moved by parts of
 * a cell, turned by each of a list of angles; one step is taken, and the normals of all nodes in
 * contact are compared with that of the surface. Shapes:
 *     plane   two blocks of 16 x 6 cells, nodes up to 4 cells from the middle
 *     corner  a block of 8 x 5 cells on one of 20 x 6, nodes up to 2 cells from the block's edge
 *     plate   a plate, 16 cells long and a cell thick, on a block, nodes up to 4 from the
 * middle circle  a disk of radius 6 cells in a ring that it fills sphere  the same in axisymmetry,
 * with its centre on the axis Reports of each the root of the mean squared angle, weighted with the
 * areas of contact of the nodes, and the largest angle of nodes that have at least a tenth of a
 * cell of it: <shape>_rms and <shape>_worst, degrees; and nodes per variant in a note.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/programs.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { AXES = 2, ANGLES_MAX = 16, SHIFTS = 3, SETTINGS = 4 };

static const double DEGREE = 57.29577951308232087680; /* of a radian */
static const double MIDDLE = 20.0;
static const double RADIUS = 6.0;

/* Parts of a cell by which bodies are moved: none, and two that no lattice shares. */
static const double shifts[SHIFTS][AXES] = {{0.0, 0.0}, {0.37, 0.21}, {0.71, 0.83}};

/* A box along the surface, which is y = 0 there; the second body is below it. */
struct box {
    double from[AXES], to[AXES];
};

static const struct shape {
    const char *name;
    struct box upper, lower;
    double from, to; /* nodes that count, along the surface; 0, 0: all */
    bool round, axisymmetric;
} shapes[] = {
    {.name = "plane", .upper = {{-8, 0}, {8, 6}}, .lower = {{-8, -6}, {8, 0}}, .from = -4, .to = 4},
    {.name = "corner",
     .upper = {{-4, 0}, {4, 5}},
     .lower = {{-10, -6}, {10, 0}},
     .from = 2,
     .to = 6},
    {.name = "plate", .upper = {{-8, 0}, {8, 1}}, .lower = {{-8, -6}, {8, 0}}, .from = -4, .to = 4},
    {.name = "circle", .round = true},
    {.name = "sphere", .round = true, .axisymmetric = true},
};
enum { SHAPES = sizeof shapes / sizeof *shapes };

/* Where a shape is. */
struct place {
    double middle[AXES], along[AXES]; /* along: unit vector */
};

/* Over all nodes of a shape. */
struct angles {
    double squares, area, worst;
    size_t nodes;
};

/* ---------------------------------------------------------------- the scene */

static char *write_box(const char *body, const struct place *place, const struct box *box)
{
    GString *const text = g_string_new(NULL);
    g_string_printf(text, "bodies.%s.region={polygon: {points: [", body);
    for (int corner = 0; corner < 4; corner++) {
        const double x = corner == 0 || corner == 3 ? box->from[0] : box->to[0];
        const double y = corner < 2 ? box->from[1] : box->to[1];
        g_string_append_printf(text, "%s[%.17g, %.17g]", corner == 0 ? "" : ", ",
                               place->middle[0] + place->along[0] * x - place->along[1] * y,
                               place->middle[1] + place->along[1] * x + place->along[0] * y);
    }
    g_string_append(text, "]}}");
    return g_string_free(text, FALSE);
}

static void write_settings(const struct shape *shape, const struct place *place,
                           char *settings[SETTINGS])
{
    settings[0] = g_strdup(shape->axisymmetric ? "geometry=axisymmetric" : "geometry=plane_strain");
    if (!shape->round) {
        settings[1] = write_box("0", place, &shape->upper);
        settings[2] = write_box("1", place, &shape->lower);
        return;
    }
    settings[1] = g_strdup_printf("bodies.0.region={disk: {center: [%.17g, %.17g], radius: %g}}",
                                  place->middle[0], place->middle[1], RADIUS);
    settings[2] =
        g_strdup_printf("bodies.1.region={annulus: {center: [%.17g, %.17g], inner: %g, outer: %g}}",
                        place->middle[0], place->middle[1], RADIUS, RADIUS + 4.0);
}

/* ------------------------------------------------------------------ normals */

/* The surface's normal nearest to the node, from the upper or inner body to the other one; does the
 * node count? */
static bool find_exact(const struct shape *shape, const struct place *place,
                       const double node[AXES], double normal[AXES])
{
    const double from[AXES] = {node[0] - place->middle[0], node[1] - place->middle[1]};
    const double distance = hypot(from[0], from[1]);
    if (shape->round) {
        for (int axis = 0; axis < AXES; axis++)
            normal[axis] = from[axis] / distance;
        return distance > 0.0;
    }
    const double along = place->along[0] * from[0] + place->along[1] * from[1];
    normal[0] = place->along[1];
    normal[1] = -place->along[0];
    return along >= shape->from && along <= shape->to;
}

static void add_points(const struct mpm_simulation *simulation, const struct shape *shape,
                       const struct place *place, struct angles *angles)
{
    static const double SMALL = 0.1; /* of a cell, which is 1 */
    const size_t count = mpm_simulation_contact_point_count(simulation);
    for (size_t k = 0; k < count; k++) {
        const struct mpm_contact_point point = mpm_simulation_contact_point(simulation, k);
        double exact[AXES];
        if (!point.has_normal || !find_exact(shape, place, point.position, exact))
            continue;
        const double *const n = point.normal;
        const double angle = DEGREE * fabs(atan2(n[0] * exact[1] - n[1] * exact[0],
                                                 n[0] * exact[0] + n[1] * exact[1]));
        const double area =
            shape->axisymmetric ? point.area / fmax(point.position[0], 0.25) : point.area;
        angles->squares += area * angle * angle;
        angles->area += area;
        angles->nodes++;
        if (area > SMALL)
            angles->worst = fmax(angles->worst, angle);
    }
}

static enum mpm_status look_at(struct measurement *m, const struct shape *shape,
                               const struct place *place, struct angles *angles,
                               struct mpm_error *error)
{
    char *settings[SETTINGS] = {NULL};
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    write_settings(shape, place, settings);
    enum mpm_status status = measurement_scene(m, (const char *const *)settings, 3, &scene, error);
    if (status == MPM_OK)
        status = mpm_simulation_create(scene, measurement_options(m), &simulation, error);
    if (status == MPM_OK)
        status = mpm_simulation_advance(simulation, mpm_scene_end_time(scene), error);
    if (status == MPM_OK) {
        add_points(simulation, shape, place, angles);
        measurement_work(m, mpm_simulation_particle_count(simulation));
    }
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    for (int k = 0; k < SETTINGS; k++)
        g_free(settings[k]);
    return status;
}

static double root_mean(const struct angles *angles)
{
    return sqrt(angles->squares / angles->area);
}

/* All positions of a shape turned by one angle. */
static enum mpm_status turn(struct measurement *m, const struct shape *shape, double angle,
                            struct angles *angles, struct mpm_error *error)
{
    for (int shift = 0; shift < SHIFTS; shift++) {
        const struct place place = {
            .middle = {shape->axisymmetric ? 0.0 : MIDDLE + shifts[shift][0],
                       MIDDLE + shifts[shift][1]},
            .along = {cos(angle / DEGREE), sin(angle / DEGREE)},
        };
        TRY(look_at(m, shape, &place, angles, error));
    }
    return MPM_OK;
}

/* Rows of the series have the angle and then, shape by shape, the root of the mean square. */
static enum mpm_status measure(struct measurement *m, size_t index, const double *turned,
                               size_t count, double *rows, struct mpm_error *error)
{
    const struct shape *const shape = &shapes[index];
    struct angles all = {0};
    for (size_t k = 0; k < count; k++) {
        struct angles angles = {0};
        if (!shape->round || k == 0)
            TRY(turn(m, shape, turned[k], &angles, error));
        rows[(1 + SHAPES) * k] = turned[k];
        rows[(1 + SHAPES) * k + 1 + index] = shape->round ? 0.0 : root_mean(&angles);
        all.squares += angles.squares;
        all.area += angles.area;
        all.nodes += angles.nodes;
        all.worst = fmax(all.worst, angles.worst);
        if (index == 0 && turned[k] == 0.0) /* 1 where all are the surface's */
            measurement_report(m, "aligned", cos(angles.worst / DEGREE));
    }
    char *const rms = g_strdup_printf("%s_rms", shape->name);
    char *const worst = g_strdup_printf("%s_worst", shape->name);
    measurement_report(m, rms, root_mean(&all));
    measurement_report(m, worst, all.worst);
    measurement_note(m, "%s: %zu nodes", shape->name, all.nodes);
    g_free(rms);
    g_free(worst);
    return MPM_OK;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    double turned[ANGLES_MAX], rows[ANGLES_MAX * (1 + SHAPES)];
    size_t count;
    TRY(measurement_list(measurement, "angles", ANGLES_MAX, turned, &count, error));
    for (size_t k = 0; k < SHAPES; k++)
        TRY(measure(measurement, k, turned, count, rows, error));
    return measurement_series(measurement, "angles", "angle plane corner plate circle sphere",
                              1 + SHAPES, count, rows, error);
}

const struct measure_program program_normals = {
    .name = "normals",
    .summary = "normals of contact between bodies against those of their surfaces",
    .run = run,
};
