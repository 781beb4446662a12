/* D2: a double cantilever beam at rest against a finite-element solution of it (CRAMP Fig. 2).
 *
 * The reference is a table of stresses at points of the upper arm, the particles of a grid of 1 mm.
 * A point represents the square of a quarter of such a cell around it: on finer grids, the mean of
 * the particles that began in it. On the mid-plane both are seen as nodes of the 1 mm grid see
 * them, by means over points with linear weights; the table of the finite elements has that curve
 * for each of their meshes. Differences are in percent of the beam's stress at the tip. What
 * four-node elements on the same grid get is reported beside: their own error, and, with particles
 * for integration points, the limit of the material point method with hat functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/follow.h"
#include "verification/programs/table_file.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, STRESS = 4, POINT_COLUMNS = 7, CURVE_COLUMNS = 6 };

static const double CELL = 1.0; /* of the grid of the reference, mm */

struct point {
    double x, y;
    double reference, stress;    /* sigma_xx; that of the run is NAN where it has no particle */
    double elements, integrated; /* of four-node elements by Gauss points, and by these points */
    double small;                /* reference at small strains */
};

/* The mid-plane at one node. */
struct node {
    double x, stress, reference;
    double elements;     /* of four-node elements at the points */
    double coarse, fine; /* of four-node elements smoothed to their nodes, and of the finest mesh */
};

struct study {
    struct table_file table, elements, curve;
    double factor; /* of the load, and of the reference's stresses */
    double scale, tip_x, tip_y, rise;
    struct point *points;
    struct node *nodes;
    size_t point_count, node_count;
    double opening;
};

/* ----------------------------------------------------------------- reference */

static enum mpm_status read_points(struct study *study, const char *column, struct mpm_error *error)
{
    size_t x, y, stress, small, gauss, particles;
    const struct table_file *const table = &study->table, *const elements = &study->elements;
    TRY(table_file_column(table, "x", &x, error));
    TRY(table_file_column(table, "y", &y, error));
    TRY(table_file_column(table, column, &stress, error));
    TRY(table_file_column(table, "xx", &small, error));
    TRY(table_file_column(elements, "gauss", &gauss, error));
    TRY(table_file_column(elements, "particles", &particles, error));
    if (elements->rows != table->rows)
        return failure_set(error, MPM_BAD_INPUT, "%s: %zu rows; allowed: %zu, as many as in %s",
                           elements->path, elements->rows, table->rows, table->path);
    study->point_count = table->rows;
    study->points = g_new0(struct point, table->rows);
    for (size_t k = 0; k < table->rows; k++) {
        const double *const row = &table->values[k * table->columns];
        const double *const beside = &elements->values[k * elements->columns];
        study->points[k] = (struct point){
            .x = row[x],
            .y = row[y],
            .reference = study->factor * row[stress],
            .stress = (double)NAN,
            .elements = study->factor * beside[gauss],
            .integrated = study->factor * beside[particles],
            .small = study->factor * row[small],
        };
    }
    return MPM_OK;
}

static enum mpm_status read_nodes(struct study *study, struct mpm_error *error)
{
    size_t x, coarse, fine;
    const struct table_file *const table = &study->curve;
    TRY(table_file_column(table, "x", &x, error));
    TRY(table_file_column(table, "q4_1.00mm", &coarse, error));
    TRY(table_file_column(table, "q8_0.25mm", &fine, error));
    study->node_count = table->rows;
    study->nodes = g_new0(struct node, table->rows);
    for (size_t k = 0; k < table->rows; k++) {
        const double *const row = &table->values[k * table->columns];
        study->nodes[k] = (struct node){
            .x = row[x], .coarse = study->factor * row[coarse], .fine = study->factor * row[fine]};
    }
    return MPM_OK;
}

static enum mpm_status read_reference(struct measurement *m, struct study *study,
                                      struct mpm_error *error)
{
    const struct measurement_parameter numbers[] = {
        {"factor", &study->factor}, {"scale", &study->scale}, {"tip_x", &study->tip_x},
        {"tip_y", &study->tip_y},   {"rise", &study->rise},
    };
    const char *points, *elements, *curve, *column;
    TRY(measurement_numbers(m, numbers, sizeof numbers / sizeof *numbers, error));
    TRY(measurement_text(m, "points", &points, error));
    TRY(measurement_text(m, "column", &column, error));
    TRY(measurement_text(m, "elements", &elements, error));
    TRY(measurement_text(m, "curve", &curve, error));
    TRY(table_file_read(points, &study->table, error));
    TRY(table_file_read(elements, &study->elements, error));
    TRY(table_file_read(curve, &study->curve, error));
    TRY(read_points(study, column, error));
    return read_nodes(study, error);
}

static void free_study(struct study *study)
{
    table_file_free(&study->table);
    table_file_free(&study->elements);
    table_file_free(&study->curve);
    g_free(study->points);
    g_free(study->nodes);
}

/* ----------------------------------------------------------------- measuring */

static void see_points(struct study *study, const struct particle_set *set)
{
    const double reach = 0.25 * CELL;
    for (size_t k = 0; k < study->point_count; k++) {
        struct point *const point = &study->points[k];
        double sum = 0.0;
        size_t count = 0;
        for (size_t p = 0; p < set->count; p++)
            if (fabs(set->start[AXES * p] - point->x) < reach &&
                fabs(set->start[AXES * p + 1] - point->y) < reach) {
                sum += set->stress[STRESS * p];
                count++;
            }
        point->stress = sum / (double)count; /* not a number where the run has none */
    }
}

static double hat(double distance)
{
    return fmax(0.0, 1.0 - fabs(distance) / CELL);
}

static void see_nodes(struct study *study)
{
    for (size_t i = 0; i < study->node_count; i++) {
        struct node *const node = &study->nodes[i];
        double weight = 0.0;
        for (size_t k = 0; k < study->point_count; k++) {
            const struct point *const point = &study->points[k];
            const double s = hat(point->x - node->x) * hat(point->y - study->tip_y);
            if (s == 0.0)
                continue;
            weight += s;
            node->stress += s * point->stress;
            node->reference += s * point->reference;
            node->elements += s * (point->elements - point->small);
        }
        node->stress /= weight;
        node->reference /= weight;
        node->elements = node->fine + node->elements / weight;
    }
}

/* Mean displacement along y of the particles that began at `x`. */
static double column_rise(const struct particle_set *set, double x)
{
    double sum = 0.0;
    size_t count = 0;
    for (size_t p = 0; p < set->count; p++)
        if (set->start[AXES * p] == x) {
            sum += set->position[AXES * p + 1] - set->start[AXES * p + 1];
            count++;
        }
    return sum / (double)count;
}

/* That of the loaded face x = 0, along the line through the first two columns. */
static double face_rise(const struct particle_set *set)
{
    double first = HUGE_VAL, second = HUGE_VAL;
    for (size_t p = 0; p < set->count; p++)
        first = fmin(first, set->start[AXES * p]);
    for (size_t p = 0; p < set->count; p++)
        if (set->start[AXES * p] > first)
            second = fmin(second, set->start[AXES * p]);
    const double near = column_rise(set, first), far = column_rise(set, second);
    return near - first * (far - near) / (second - first);
}

static void see(struct study *study, const struct mpm_simulation *simulation,
                struct particle_set *set)
{
    particle_set_read(set, simulation);
    see_points(study, set);
    see_nodes(study);
    study->opening = face_rise(set);
}

/* ----------------------------------------------------------------- reporting */

struct norm {
    double squares, largest, at;
    size_t count;
};

static void norm_add(struct norm *norm, double difference, double at)
{
    if (fabs(difference) > norm->largest)
        norm->at = at;
    norm->largest = field_larger(norm->largest, fabs(difference));
    norm->squares += difference * difference;
    norm->count++;
}

static double norm_l2(const struct norm *norm)
{
    return sqrt(norm->squares / (double)norm->count);
}

/* What is compared beyond some distance from the tip. */
struct beyond {
    struct norm points, elements, integrated;          /* at particles */
    struct norm curve, curve_elements, curve_smoothed; /* on the mid-plane */
};

static void add_points(struct beyond *beyond, const struct study *study, double distance)
{
    const double percent = 100.0 / (study->factor * study->scale);
    for (size_t k = 0; k < study->point_count; k++) {
        const struct point *const at = &study->points[k];
        if (hypot(at->x - study->tip_x, at->y - study->tip_y) <= distance)
            continue;
        norm_add(&beyond->points, percent * (at->stress - at->reference), at->x);
        norm_add(&beyond->elements, percent * (at->elements - at->small), at->x);
        norm_add(&beyond->integrated, percent * (at->stress - at->integrated), at->x);
    }
}

static void add_nodes(struct beyond *beyond, const struct study *study, double distance)
{
    const double percent = 100.0 / (study->factor * study->scale);
    for (size_t k = 0; k < study->node_count; k++) {
        const struct node *const node = &study->nodes[k];
        if (fabs(node->x - study->tip_x) <= distance)
            continue;
        norm_add(&beyond->curve, percent * (node->stress - node->reference), node->x);
        norm_add(&beyond->curve_elements, percent * (node->elements - node->fine), node->x);
        norm_add(&beyond->curve_smoothed, percent * (node->coarse - node->fine), node->x);
    }
}

static void report_value(struct measurement *m, const char *what, double distance, double value)
{
    char *const name = g_strdup_printf("%s_%g", what, distance);
    measurement_report(m, name, value);
    g_free(name);
}

/* What does not depend on the run: the finite elements that its errors are held against. */
static void note_elements(struct measurement *m, double distance, const struct beyond *beyond)
{
    const struct {
        const char *what;
        const struct norm *norm;
    } table[] = {{"four-node elements at particles", &beyond->elements},
                 {"the same on the mid-plane", &beyond->curve_elements},
                 {"the same, smoothed at nodes", &beyond->curve_smoothed}};
    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        measurement_note(m, "beyond %g mm, %s: %.2f %%, at most %.2f %% at x = %g", distance,
                         table[k].what, norm_l2(table[k].norm), table[k].norm->largest,
                         table[k].norm->at);
}

static void report_beyond(struct measurement *m, const struct study *study, double distance)
{
    struct beyond beyond = {0};
    add_points(&beyond, study, distance);
    add_nodes(&beyond, study, distance);
    report_value(m, "points_l2", distance, norm_l2(&beyond.points));
    report_value(m, "points_worst", distance, beyond.points.largest);
    report_value(m, "integrated_l2", distance, norm_l2(&beyond.integrated));
    report_value(m, "curve_l2", distance, norm_l2(&beyond.curve));
    report_value(m, "curve_worst", distance, beyond.curve.largest);
    measurement_note(m,
                     "beyond %g mm, the largest differences are at x = %g and, on the mid-plane, "
                     "at x = %g",
                     distance, beyond.points.at, beyond.curve.at);
    note_elements(m, distance, &beyond);
}

/* Largest stress on the mid-plane, for the whole load. */
static void report_peaks(struct measurement *m, const struct study *study)
{
    double stress = 0.0, reference = 0.0;
    for (size_t k = 0; k < study->node_count; k++) {
        stress = field_larger(stress, study->nodes[k].stress);
        reference = field_larger(reference, study->nodes[k].reference);
    }
    measurement_report(m, "peak", stress / study->factor);
    measurement_note(m, "peak of the reference: %.5g", reference / study->factor);
}

static void report(struct measurement *m, const struct study *study)
{
    report_beyond(m, study, 2.0);
    report_beyond(m, study, 5.0);
    report_peaks(m, study);
    measurement_note(m, "the face has risen by %.6g", study->opening);
    measurement_report(m, "opening_difference",
                       100.0 * (study->opening / (study->factor * study->rise) - 1.0));
}

static enum mpm_status write_series(struct measurement *m, const struct study *study,
                                    struct mpm_error *error)
{
    TRY(measurement_series(m, "points", "x y reference stress elements integrated small",
                           POINT_COLUMNS, study->point_count, &study->points[0].x, error));
    return measurement_series(m, "curve", "x stress reference elements smoothed finest",
                              CURVE_COLUMNS, study->node_count, &study->nodes[0].x, error);
}

/* ------------------------------------------------------------------- running */

static enum mpm_status run_opened(struct measurement *m, struct study *study,
                                  struct mpm_simulation *simulation, double end,
                                  struct mpm_error *error)
{
    struct particle_set set = {0};
    bool finished = false;
    enum mpm_status status = particle_set_create(simulation, 0, &set, error);
    if (status == MPM_OK)
        status = follow_to_rest(m, simulation, end, &finished, error);
    if (status == MPM_OK)
        see(study, simulation, &set);
    particle_set_free(&set);
    TRY(status);
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    measurement_report(m, "reached", mpm_simulation_time(simulation));
    report(m, study);
    return write_series(m, study, error);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {0};
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    enum mpm_status status = read_reference(m, &study, error);
    if (status == MPM_OK)
        status = measurement_scene(m, NULL, 0, &scene, error);
    if (status == MPM_OK)
        status = mpm_simulation_create(scene, measurement_options(m), &simulation, error);
    if (status == MPM_OK)
        status = run_opened(m, &study, simulation, mpm_scene_end_time(scene), error);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    free_study(&study);
    return status;
}

const struct measure_program program_cantilever = {
    .name = "cantilever",
    .summary = "a cracked beam at rest against stresses by finite elements",
    .run = run,
};
