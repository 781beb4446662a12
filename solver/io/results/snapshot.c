/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/snapshot.h"

#include "io/results/provenance.h"
#include "io/results/snapshot_data.h"
#include "io/units.h"
#include "mpm_file.h"
#include "mpm_hdf5.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <hdf5.h>
#include <string.h>

enum { SNAPSHOT_FORMAT = 1, POINT_COMPONENTS = 3 };

size_t mpm_snapshot_work_size(const struct mpm_scene *scene, size_t particle_count)
{
    size_t components = POINT_COMPONENTS;
    for (int field = 0; field < MPM_FIELD_COUNT; field++)
        components = MAX(components, mpm_field_describe((enum mpm_field)field)->components);
    if (scene->crack_count > 0) /* any number of points */
        return MPM_SNAPSHOT_BLOCK * components;
    return MIN(particle_count + 1, MPM_SNAPSHOT_BLOCK) * components; /* one row more: Offsets */
}

/* -------------------------------------------------------------------- /mpm */

static const char *const geometry_names[] = {
    [MPM_PLANE_STRAIN] = "plane_strain",
    [MPM_PLANE_STRESS] = "plane_stress",
    [MPM_AXISYMMETRIC] = "axisymmetric",
};

/* Every scheme is a leapfrog of velocity against what moves with it; which one is
 * ahead follows from which is updated first in a step. */
static const char *const velocity_against_stress[] = {
    [MPM_USL] = "velocity is half a time step behind deformation_gradient and stress",
    [MPM_MUSL] = "velocity is half a time step behind deformation_gradient and stress",
    [MPM_USF] = "velocity is half a time step ahead of deformation_gradient and stress",
    [MPM_USAVG] = "velocity, deformation_gradient and stress are at one instant",
    [MPM_USAVG_ONCE] = "velocity, deformation_gradient and stress are at one instant",
};
static const char *const position_against_velocity[] = {
    [MPM_GRID_VELOCITY] = "position is half a time step ahead of velocity",
    [MPM_MIDPOINT] = "position and velocity are at one instant",
};

const char *mpm_snapshot_components(enum mpm_geometry geometry, size_t components)
{
    static const struct {
        size_t components;
        const char *planar, *axisymmetric;
    } orders[] = {
        {1, "scalar", "scalar"},
        {2, "x, y", "r, z"},
        {4, "xx, yy, zz, xy", "rr, zz, θθ, rz"},
        {5, "xx, xy, yx, yy, zz", "rr, rz, zr, zz, θθ"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(orders); i++)
        if (orders[i].components == components)
            return geometry == MPM_AXISYMMETRIC ? orders[i].axisymmetric : orders[i].planar;
    return "not named";
}

static void write_units(struct mpm_snapshot *snapshot, hid_t object)
{
    const struct mpm_scene *scene = snapshot->scene;
    const struct {
        const char *name;
        struct mpm_dimension dimension;
    } units[] = {
        {"units_length", MPM_DIMENSION_LENGTH},
        {"units_mass", MPM_DIMENSION_MASS},
        {"units_time", MPM_DIMENSION_TIME},
        {"units_temperature", MPM_DIMENSION_TEMPERATURE},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(units); i++) {
        char unit[MPM_UNIT_SIZE];
        mpm_unit_text(scene, units[i].dimension, unit);
        mpm_snapshot_text(snapshot, object, units[i].name, unit);
    }
}

static void write_texts(struct mpm_snapshot *snapshot, hid_t object)
{
    const struct mpm_scene *scene = snapshot->scene;
    char *staggered = g_strdup_printf("state at the end of the step; %s; %s",
                                      velocity_against_stress[scene->stress_update],
                                      position_against_velocity[scene->position_update]);
    mpm_snapshot_text(snapshot, object, "title", scene->title != NULL ? scene->title : "");
    mpm_snapshot_text(snapshot, object, "geometry", geometry_names[scene->geometry]);
    mpm_snapshot_text(snapshot, object, "staggered", staggered);
    g_free(staggered);

    const char **names = g_new(const char *, scene->body_count + 1);
    for (size_t i = 0; i < scene->body_count; i++)
        names[i] = scene->bodies[i].name;
    mpm_snapshot_texts(snapshot, object, "body_names", names, scene->body_count);
    g_free(names);

    mpm_snapshot_texts(snapshot, object, "settings", (const char *const *)scene->settings,
                       scene->setting_count);
    struct mpm_provenance provenance;
    mpm_provenance_fill(scene, &provenance);
    for (size_t i = 0; i < MPM_FACT_COUNT; i++)
        mpm_snapshot_text(snapshot, object, provenance.facts[i].name, provenance.facts[i].text);
}

/* Of the bodies' particles before they deform: lengths along the axes, two of each body. */
static void write_domains(struct mpm_snapshot *snapshot, hid_t object)
{
    const struct mpm_scene *const scene = snapshot->scene;
    double *const sizes = g_new(double, 2 * scene->body_count);
    for (size_t body = 0; body < scene->body_count; body++)
        for (size_t axis = 0; axis < 2; axis++)
            sizes[2 * body + axis] =
                scene->cell[axis] / scene->bodies[body].particles_per_cell[axis];
    mpm_snapshot_attribute(snapshot, object, "body_domains", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE,
                           2 * scene->body_count, 1, sizes);
    g_free(sizes);
}

static void write_description(struct mpm_snapshot *snapshot, hid_t object)
{
    const int format = SNAPSHOT_FORMAT;
    const double time = mpm_simulation_time(snapshot->simulation);
    const uint64_t step = mpm_simulation_step(snapshot->simulation);
    mpm_snapshot_attribute(snapshot, object, "format", H5T_STD_I32LE, H5T_NATIVE_INT, 1, 0,
                           &format);
    mpm_snapshot_attribute(snapshot, object, "time", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 1, 0,
                           &time);
    mpm_snapshot_attribute(snapshot, object, "step", H5T_STD_I64LE, H5T_NATIVE_UINT64, 1, 0, &step);
    mpm_snapshot_attribute(snapshot, object, "thickness", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 1, 0,
                           &snapshot->scene->thickness);
    write_domains(snapshot, object);
    write_units(snapshot, object);
    write_texts(snapshot, object);
}

static void fill_field(const struct mpm_snapshot *snapshot,
                       const struct mpm_snapshot_source *source, size_t first, size_t count)
{
    mpm_simulation_field_range(snapshot->simulation, source->field, first, count, snapshot->work);
}

/* A dataset with its attributes. */
static void write_described(struct mpm_snapshot *snapshot, hid_t parent,
                            const struct mpm_field_info *info, hsize_t rows,
                            const struct mpm_snapshot_source *source)
{
    const hid_t dataset = mpm_snapshot_dataset(snapshot, parent, info->name,
                                               info->integer ? H5T_STD_I64LE : H5T_IEEE_F64LE, rows,
                                               info->components, MPM_STORED, source);
    char unit[MPM_UNIT_SIZE];
    mpm_unit_text(snapshot->scene, info->dimension, unit);
    mpm_snapshot_text(snapshot, dataset, "unit", unit);
    mpm_snapshot_text(snapshot, dataset, "description", info->description);
    mpm_snapshot_text(snapshot, dataset, "components",
                      mpm_snapshot_components(snapshot->scene->geometry, info->components));
    mpm_snapshot_checked(snapshot, H5Dclose(dataset));
}

/* One component of a field, in place from the first particle on. */
static void fill_component(const struct mpm_snapshot *snapshot,
                           const struct mpm_snapshot_source *source, size_t first, size_t count)
{
    const size_t components = mpm_field_describe(source->field)->components;
    fill_field(snapshot, source, first, count);
    for (size_t i = 0; i < count; i++)
        snapshot->work[i] = snapshot->work[components * i + source->component];
}

/* "stress_xx" and so on, datasets of their own: ParaView numbers components. */
static void write_components(struct mpm_snapshot *snapshot, hid_t particles, hid_t point_data,
                             enum mpm_field field)
{
    const struct mpm_field_info *const whole = mpm_field_describe(field);
    char **const names =
        g_strsplit(mpm_snapshot_components(snapshot->scene->geometry, whole->components), ", ", -1);
    for (size_t k = 0; k < whole->components; k++) {
        const char *const last = strcmp(names[k], "θθ") == 0 ? "tt" : names[k];
        char *const name = g_strdup_printf("%s_%s", whole->name, last);
        struct mpm_field_info info = *whole;
        info.name = name;
        info.components = 1;
        const struct mpm_snapshot_source source = {
            .fill = fill_component, .field = field, .component = k};
        write_described(snapshot, particles, &info, snapshot->count, &source);
        mpm_snapshot_checked(
            snapshot, H5Lcreate_hard(particles, name, point_data, name, H5P_DEFAULT, H5P_DEFAULT));
        g_free(name);
    }
    g_strfreev(names);
}

static void write_field(struct mpm_snapshot *snapshot, hid_t particles, hid_t point_data,
                        enum mpm_field field)
{
    const struct mpm_field_info *info = mpm_field_describe(field);
    const struct mpm_snapshot_source source = {.fill = fill_field, .field = field};
    write_described(snapshot, particles, info, snapshot->count, &source);
    mpm_snapshot_checked(snapshot, H5Lcreate_hard(particles, info->name, point_data, info->name,
                                                  H5P_DEFAULT, H5P_DEFAULT));
}

static void fill_crack_positions(const struct mpm_snapshot *snapshot,
                                 const struct mpm_snapshot_source *source, size_t first,
                                 size_t count)
{
    (void)source;
    for (size_t i = 0; i < count; i++)
        memcpy(&snapshot->work[2 * i],
               mpm_simulation_crack_point(snapshot->simulation, first + i).position,
               2 * sizeof *snapshot->work);
}

static void fill_crack_numbers(const struct mpm_snapshot *snapshot,
                               const struct mpm_snapshot_source *source, size_t first, size_t count)
{
    (void)source;
    for (size_t i = 0; i < count; i++)
        snapshot->work[i] =
            (double)mpm_simulation_crack_point(snapshot->simulation, first + i).crack;
}

static void write_cracks(struct mpm_snapshot *snapshot, hid_t mpm)
{
    static const struct mpm_field_info
        position = {"position", 2, false, MPM_DIMENSION_LENGTH,
                    "points of the cracks, crack by crack, each from its first to its last"},
        crack = {"crack", 1, true, MPM_DIMENSION_NONE, "index of the point's crack in the scene"};
    const struct mpm_snapshot_source positions = {.fill = fill_crack_positions},
                                     numbers = {.fill = fill_crack_numbers};
    const hsize_t points = mpm_simulation_crack_point_count(snapshot->simulation);
    if (points == 0)
        return;
    const hid_t cracks = mpm_snapshot_group(snapshot, mpm, "cracks");
    write_described(snapshot, cracks, &position, points, &positions);
    write_described(snapshot, cracks, &crack, points, &numbers);
    mpm_snapshot_checked(snapshot, H5Gclose(cracks));
}

/* ----------------------------------------------------------------- /VTKHDF */

static void write_vtk_attributes(struct mpm_snapshot *snapshot, hid_t vtk)
{
    const int version[] = {1, 0};
    mpm_snapshot_attribute(snapshot, vtk, "Version", H5T_STD_I32LE, H5T_NATIVE_INT, 2, 1, version);
    const char type[] = "UnstructuredGrid";
    const hid_t text = mpm_snapshot_checked(snapshot, H5Tcopy(H5T_C_S1)); /* ASCII, fixed length */
    mpm_snapshot_checked(snapshot, H5Tset_size(text, sizeof type - 1));
    mpm_snapshot_checked(snapshot, H5Tset_strpad(text, H5T_STR_NULLPAD));
    mpm_snapshot_attribute(snapshot, vtk, "Type", text, text, 1, 0, type);
    mpm_snapshot_checked(snapshot, H5Tclose(text));
}

/* Positions get a third component; in place, from the last particle to the first. */
static void fill_points(const struct mpm_snapshot *snapshot,
                        const struct mpm_snapshot_source *source, size_t first, size_t count)
{
    double *work = snapshot->work;
    fill_field(snapshot, source, first, count);
    for (size_t i = count; i-- > 0;) {
        const double position[2] = {work[2 * i], work[2 * i + 1]};
        work[3 * i] = position[0];
        work[3 * i + 1] = position[1];
        work[3 * i + 2] = 0.0;
    }
}

static void fill_numbers(const struct mpm_snapshot *snapshot,
                         const struct mpm_snapshot_source *source, size_t first, size_t count)
{
    (void)source;
    for (size_t i = 0; i < count; i++)
        snapshot->work[i] = (double)(first + i);
}

static void write_grid_data(struct mpm_snapshot *snapshot, hid_t vtk, const char *name, hid_t type,
                            hsize_t rows, const struct mpm_snapshot_source *source)
{
    mpm_snapshot_checked(snapshot, H5Dclose(mpm_snapshot_dataset(snapshot, vtk, name, type, rows, 1,
                                                                 MPM_DEFLATED, source)));
}

/* Each particle is a cell of its own: one vertex. */
static void write_grid(struct mpm_snapshot *snapshot, hid_t vtk)
{
    enum { VTK_VERTEX = 1 };
    const hsize_t count = snapshot->count;
    const struct mpm_snapshot_source points = {.fill = fill_points, .field = MPM_FIELD_POSITION},
                                     numbers = {.fill = fill_numbers},
                                     types = {.fill = mpm_snapshot_fill_value, .value = VTK_VERTEX};
    mpm_snapshot_checked(
        snapshot, H5Dclose(mpm_snapshot_dataset(snapshot, vtk, "Points", H5T_IEEE_F64LE, count,
                                                POINT_COMPONENTS, MPM_STORED, &points)));
    write_grid_data(snapshot, vtk, "Connectivity", H5T_STD_I64LE, count, &numbers);
    write_grid_data(snapshot, vtk, "Offsets", H5T_STD_I64LE, count + 1, &numbers);
    write_grid_data(snapshot, vtk, "Types", H5T_STD_U8LE, count, &types);
}

static void write_vtk(struct mpm_snapshot *snapshot, hid_t vtk)
{
    static const char *const counts[] = {"NumberOfPoints", "NumberOfCells",
                                         "NumberOfConnectivityIds"};
    write_vtk_attributes(snapshot, vtk);
    for (size_t i = 0; i < G_N_ELEMENTS(counts); i++)
        mpm_snapshot_number(snapshot, vtk, counts[i], H5T_STD_I64LE, (double)snapshot->count);
    write_grid(snapshot, vtk);
    const hid_t data = mpm_snapshot_group(snapshot, vtk, "FieldData");
    mpm_snapshot_number(snapshot, data, "TimeValue", H5T_IEEE_F64LE,
                        mpm_simulation_time(snapshot->simulation));
    mpm_snapshot_number(snapshot, data, "step", H5T_STD_I64LE,
                        (double)mpm_simulation_step(snapshot->simulation));
    mpm_snapshot_checked(snapshot, H5Gclose(data));
}

/* -------------------------------------------------------------------- file */

static void write_groups(struct mpm_snapshot *snapshot)
{
    const hid_t mpm = mpm_snapshot_group(snapshot, snapshot->file, "mpm");
    const hid_t particles = mpm_snapshot_group(snapshot, mpm, "particles");
    const hid_t vtk = mpm_snapshot_group(snapshot, snapshot->file, "VTKHDF");
    const hid_t point_data = mpm_snapshot_group(snapshot, vtk, "PointData");
    write_description(snapshot, mpm);
    for (int field = 0; field < MPM_FIELD_COUNT; field++)
        if (mpm_scene_has_field(snapshot->scene, (enum mpm_field)field))
            write_field(snapshot, particles, point_data, (enum mpm_field)field);
    static const enum mpm_field tensors[] = {MPM_FIELD_STRESS, MPM_FIELD_DEFORMATION_GRADIENT};
    for (size_t k = 0; k < G_N_ELEMENTS(tensors) && snapshot->scene->derived; k++)
        write_components(snapshot, particles, point_data, tensors[k]);
    write_cracks(snapshot, mpm);
    write_vtk(snapshot, vtk);
    mpm_snapshot_checked(snapshot, H5Gclose(point_data));
    mpm_snapshot_checked(snapshot, H5Gclose(vtk));
    mpm_snapshot_checked(snapshot, H5Gclose(particles));
    mpm_snapshot_checked(snapshot, H5Gclose(mpm));
}

/* Files of HDF5 1.10 and later: compact for few particles, attributes of any size. */
static void write_hdf5(struct mpm_snapshot *snapshot, struct mpm_hdf5_sink *sink)
{
    const hid_t access = mpm_snapshot_checked(snapshot, mpm_hdf5_sink_access(sink));
    mpm_snapshot_checked(snapshot, H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110));
    const hid_t creation = mpm_snapshot_checked(snapshot, H5Pcreate(H5P_FILE_CREATE));
    mpm_snapshot_checked(snapshot, H5Pset_obj_track_times(creation, false));
    snapshot->scalar = mpm_snapshot_checked(snapshot, H5Screate(H5S_SCALAR));
    snapshot->text = mpm_snapshot_checked(snapshot, H5Tcopy(H5T_C_S1));
    mpm_snapshot_checked(snapshot, H5Tset_size(snapshot->text, H5T_VARIABLE));
    mpm_snapshot_checked(snapshot, H5Tset_cset(snapshot->text, H5T_CSET_UTF8));
    snapshot->file =
        mpm_snapshot_checked(snapshot, H5Fcreate("snapshot", H5F_ACC_TRUNC, creation, access));
    if (snapshot->failure == NULL)
        write_groups(snapshot);
    mpm_snapshot_checked(snapshot, H5Tclose(snapshot->text));
    mpm_snapshot_checked(snapshot, H5Sclose(snapshot->scalar));
    mpm_snapshot_checked(snapshot, H5Pclose(creation));
    mpm_snapshot_checked(snapshot, H5Fclose(snapshot->file));
    mpm_snapshot_checked(snapshot, H5Pclose(access));
}

/* The caller's way of reporting HDF5's errors is put aside for the while. */
static char *write_hdf5_silently(struct mpm_snapshot *snapshot, struct mpm_hdf5_sink *sink)
{
    const struct mpm_hdf5_messages messages = mpm_hdf5_silence();
    write_hdf5(snapshot, sink);
    mpm_hdf5_restore(&messages);
    return snapshot->failure;
}

/* Writes, syncs and closes `path`; returns NULL or why it failed (g_free). */
static char *write_file(struct mpm_snapshot *snapshot, const char *path)
{
    struct mpm_hdf5_sink sink = {.file = mpm_file_open(path, O_RDWR | O_CREAT | O_TRUNC)};
    if (sink.file < 0)
        return g_strdup(g_strerror(errno));
    char *failure = write_hdf5_silently(snapshot, &sink);
    if (sink.error_number == 0 && mpm_file_sync(sink.file) != 0)
        sink.error_number = errno;
    if (mpm_file_close(sink.file) != 0 && sink.error_number == 0)
        sink.error_number = errno;
    if (sink.error_number != 0) { /* the cause of whatever HDF5 may say */
        g_free(failure);
        failure = g_strdup(g_strerror(sink.error_number));
    }
    return failure;
}

enum mpm_status mpm_snapshot_write(const char *path, const struct mpm_scene *scene,
                                   const struct mpm_simulation *simulation, double *work,
                                   struct mpm_error *error)
{
    struct mpm_snapshot snapshot = {
        .scene = scene,
        .simulation = simulation,
        .work = work,
        .count = mpm_simulation_particle_count(simulation),
    };
    char *partial = g_strconcat(path, MPM_PARTIAL_SUFFIX, NULL);
    char *failure = write_file(&snapshot, partial);
    if (failure == NULL && mpm_path_rename(partial, path) != 0)
        failure = g_strdup(g_strerror(errno));
    enum mpm_status status = MPM_OK;
    if (failure != NULL) {
        (void)mpm_file_remove(partial);
        status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be written: %s", path,
                               failure);
    }
    g_free(failure);
    g_free(partial);
    return status;
}
