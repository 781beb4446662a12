/* One snapshot: all particles at one instant in one HDF5 file.
 *
 * Every HDF5 call goes through checked(): the first failure is kept as text, the
 * calls after it fail without harm, and the file is thrown away at the end.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/snapshot.h"

#include "io/file_write.h"
#include "io/hdf5_sink.h"
#include "io/provenance.h"
#include "io/units.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <hdf5.h>
#include <stdio.h>
#include <unistd.h>

enum {
    SNAPSHOT_FORMAT = 1,
    CHUNK_ROWS = 16384, /* 0.6 MiB of the widest field: within HDF5's chunk cache */
    POINT_COMPONENTS = 3,
};

enum compression { STORED, DEFLATED };

struct snapshot {
    const struct mpm_scene *scene;
    const struct mpm_simulation *simulation;
    double *work;
    hsize_t count; /* particles */
    char *failure; /* first failure of HDF5, or NULL */
    hid_t file, scalar, text;
};

size_t mpm_snapshot_work_size(size_t particle_count)
{
    size_t components = POINT_COMPONENTS;
    for (int field = 0; field < MPM_FIELD_COUNT; field++)
        components = MAX(components, mpm_field_describe((enum mpm_field)field)->components);
    return MIN(particle_count + 1, CHUNK_ROWS) * components; /* one row more: Offsets */
}

/* ---------------------------------------------------------- HDF5, checked */

static herr_t keep_innermost(unsigned depth, const H5E_error2_t *entry, void *failure)
{
    char **text = failure;
    if (depth == 0)
        *text = g_strdup_printf("%s: %s", entry->func_name, entry->desc);
    return 0;
}

static hid_t checked(struct snapshot *snapshot, hid_t result)
{
    if (result < 0 && snapshot->failure == NULL) {
        (void)H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &snapshot->failure);
        if (snapshot->failure == NULL)
            snapshot->failure = g_strdup("HDF5 failed without a reason");
    }
    return result;
}

static hid_t group_create(struct snapshot *snapshot, hid_t parent, const char *name)
{
    const hid_t list = checked(snapshot, H5Pcreate(H5P_GROUP_CREATE));
    checked(snapshot, H5Pset_obj_track_times(list, false));
    const hid_t group = checked(snapshot, H5Gcreate2(parent, name, H5P_DEFAULT, list, H5P_DEFAULT));
    checked(snapshot, H5Pclose(list));
    return group;
}

/* `rank` dimensions of `size`; rank 0 is a scalar. */
static void attribute_write(struct snapshot *snapshot, hid_t object, const char *name,
                            hid_t file_type, hid_t memory_type, hsize_t size, int rank,
                            const void *data)
{
    const hid_t space =
        rank == 0 ? snapshot->scalar : checked(snapshot, H5Screate_simple(rank, &size, NULL));
    const hid_t attribute =
        checked(snapshot, H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT));
    checked(snapshot, H5Awrite(attribute, memory_type, data));
    checked(snapshot, H5Aclose(attribute));
    if (rank != 0)
        checked(snapshot, H5Sclose(space));
}

static void attribute_text(struct snapshot *snapshot, hid_t object, const char *name,
                           const char *text)
{
    attribute_write(snapshot, object, name, snapshot->text, snapshot->text, 1, 0, &text);
}

static void attribute_texts(struct snapshot *snapshot, hid_t object, const char *name,
                            const char *const *texts, size_t count)
{
    if (count > 0)
        attribute_write(snapshot, object, name, snapshot->text, snapshot->text, count, 1, texts);
}

static hid_t creation_list(struct snapshot *snapshot, int rank, const hsize_t *size,
                           enum compression compression)
{
    /* one chunk is also one block of writing */
    const hsize_t chunk[2] = {MIN(size[0], CHUNK_ROWS), size[1]};
    const hid_t list = checked(snapshot, H5Pcreate(H5P_DATASET_CREATE));
    checked(snapshot, H5Pset_obj_track_times(list, false));
    checked(snapshot, H5Pset_chunk(list, rank, chunk));
    checked(snapshot, H5Pset_shuffle(list));
    if (compression == DEFLATED)
        checked(snapshot, H5Pset_deflate(list, 1));
    checked(snapshot, H5Pset_fletcher32(list));
    return list;
}

/* What the rows of a dataset come from: puts rows first .. first + count - 1 into `work`. */
struct source {
    void (*fill)(const struct snapshot *snapshot, const struct source *source, size_t first,
                 size_t count);
    enum mpm_field field;
    double value;
};

static void block_write(struct snapshot *snapshot, hid_t dataset, hid_t space, int rank,
                        const hsize_t first[2], const hsize_t size[2])
{
    const hid_t block = checked(snapshot, H5Screate_simple(rank, size, NULL));
    checked(snapshot, H5Sselect_hyperslab(space, H5S_SELECT_SET, first, NULL, size, NULL));
    checked(snapshot,
            H5Dwrite(dataset, H5T_NATIVE_DOUBLE, block, space, H5P_DEFAULT, snapshot->work));
    checked(snapshot, H5Sclose(block));
}

/* Writes a new dataset of `type`, a chunk at a time; returns it open. */
static hid_t dataset_write(struct snapshot *snapshot, hid_t parent, const char *name, hid_t type,
                           hsize_t rows, hsize_t columns, enum compression compression,
                           const struct source *source)
{
    const hsize_t size[2] = {rows, columns};
    const int rank = columns == 1 ? 1 : 2;
    const hid_t space = checked(snapshot, H5Screate_simple(rank, size, NULL));
    const hid_t list = creation_list(snapshot, rank, size, compression);
    const hid_t dataset =
        checked(snapshot, H5Dcreate2(parent, name, type, space, H5P_DEFAULT, list, H5P_DEFAULT));
    for (hsize_t row = 0; row < rows && snapshot->failure == NULL; row += CHUNK_ROWS) {
        const hsize_t first[2] = {row, 0}, block[2] = {MIN(rows - row, CHUNK_ROWS), columns};
        source->fill(snapshot, source, (size_t)row, (size_t)block[0]);
        block_write(snapshot, dataset, space, rank, first, block);
    }
    checked(snapshot, H5Pclose(list));
    checked(snapshot, H5Sclose(space));
    return dataset;
}

static void fill_value(const struct snapshot *snapshot, const struct source *source, size_t first,
                       size_t count)
{
    (void)first;
    for (size_t i = 0; i < count; i++)
        snapshot->work[i] = source->value;
}

static void number_write(struct snapshot *snapshot, hid_t parent, const char *name, hid_t type,
                         double value)
{
    const struct source source = {.fill = fill_value, .value = value};
    checked(snapshot, H5Dclose(dataset_write(snapshot, parent, name, type, 1, 1, STORED, &source)));
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

static const char *components_text(enum mpm_geometry geometry, size_t components)
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

static void write_units(struct snapshot *snapshot, hid_t object)
{
    const struct mpm_scene *scene = snapshot->scene;
    const struct {
        const char *name;
        int length, mass, time;
    } units[] = {{"units_length", 1, 0, 0}, {"units_mass", 0, 1, 0}, {"units_time", 0, 0, 1}};
    for (size_t i = 0; i < G_N_ELEMENTS(units); i++) {
        char unit[MPM_UNIT_SIZE];
        mpm_unit_text(scene, units[i].length, units[i].mass, units[i].time, unit);
        attribute_text(snapshot, object, units[i].name, unit);
    }
    attribute_text(snapshot, object, "units_temperature",
                   scene->units_temperature[0] != '\0' ? scene->units_temperature : "temperature");
}

static void write_texts(struct snapshot *snapshot, hid_t object)
{
    const struct mpm_scene *scene = snapshot->scene;
    char *staggered = g_strdup_printf("state at the end of the step; %s; %s",
                                      velocity_against_stress[scene->stress_update],
                                      position_against_velocity[scene->position_update]);
    attribute_text(snapshot, object, "title", scene->title != NULL ? scene->title : "");
    attribute_text(snapshot, object, "geometry", geometry_names[scene->geometry]);
    attribute_text(snapshot, object, "staggered", staggered);
    g_free(staggered);

    const char **names = g_new(const char *, scene->body_count + 1);
    for (size_t i = 0; i < scene->body_count; i++)
        names[i] = scene->bodies[i].name;
    attribute_texts(snapshot, object, "body_names", names, scene->body_count);
    g_free(names);

    attribute_texts(snapshot, object, "settings", (const char *const *)scene->settings,
                    scene->setting_count);
    struct mpm_provenance provenance;
    mpm_provenance_fill(scene, &provenance);
    for (size_t i = 0; i < MPM_FACT_COUNT; i++)
        attribute_text(snapshot, object, provenance.facts[i].name, provenance.facts[i].text);
}

static void write_description(struct snapshot *snapshot, hid_t object)
{
    const int format = SNAPSHOT_FORMAT;
    const double time = mpm_simulation_time(snapshot->simulation);
    const uint64_t step = mpm_simulation_step(snapshot->simulation);
    attribute_write(snapshot, object, "format", H5T_STD_I32LE, H5T_NATIVE_INT, 1, 0, &format);
    attribute_write(snapshot, object, "time", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 1, 0, &time);
    attribute_write(snapshot, object, "step", H5T_STD_I64LE, H5T_NATIVE_UINT64, 1, 0, &step);
    attribute_write(snapshot, object, "thickness", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 1, 0,
                    &snapshot->scene->thickness);
    write_units(snapshot, object);
    write_texts(snapshot, object);
}

static void fill_field(const struct snapshot *snapshot, const struct source *source, size_t first,
                       size_t count)
{
    mpm_simulation_field_range(snapshot->simulation, source->field, first, count, snapshot->work);
}

static void write_field(struct snapshot *snapshot, hid_t particles, hid_t point_data,
                        enum mpm_field field)
{
    const struct mpm_field_info *info = mpm_field_describe(field);
    char unit[MPM_UNIT_SIZE];
    mpm_unit_text(snapshot->scene, info->length, info->mass, info->time, unit);
    const struct source source = {.fill = fill_field, .field = field};
    const hid_t dataset = dataset_write(snapshot, particles, info->name,
                                        info->integer ? H5T_STD_I64LE : H5T_IEEE_F64LE,
                                        snapshot->count, info->components, STORED, &source);
    attribute_text(snapshot, dataset, "unit", unit);
    attribute_text(snapshot, dataset, "description", info->description);
    attribute_text(snapshot, dataset, "components",
                   components_text(snapshot->scene->geometry, info->components));
    checked(snapshot, H5Dclose(dataset));
    checked(snapshot, H5Lcreate_hard(particles, info->name, point_data, info->name, H5P_DEFAULT,
                                     H5P_DEFAULT));
}

/* ----------------------------------------------------------------- /VTKHDF */

static void write_vtk_attributes(struct snapshot *snapshot, hid_t vtk)
{
    const int version[] = {1, 0};
    attribute_write(snapshot, vtk, "Version", H5T_STD_I32LE, H5T_NATIVE_INT, 2, 1, version);
    const char type[] = "UnstructuredGrid";
    const hid_t text = checked(snapshot, H5Tcopy(H5T_C_S1)); /* ASCII, fixed length */
    checked(snapshot, H5Tset_size(text, sizeof type - 1));
    checked(snapshot, H5Tset_strpad(text, H5T_STR_NULLPAD));
    attribute_write(snapshot, vtk, "Type", text, text, 1, 0, type);
    checked(snapshot, H5Tclose(text));
}

/* Positions get a third component; in place, from the last particle to the first. */
static void fill_points(const struct snapshot *snapshot, const struct source *source, size_t first,
                        size_t count)
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

static void fill_numbers(const struct snapshot *snapshot, const struct source *source, size_t first,
                         size_t count)
{
    (void)source;
    for (size_t i = 0; i < count; i++)
        snapshot->work[i] = (double)(first + i);
}

/* Each particle is a cell of its own: one vertex. */
static void write_grid(struct snapshot *snapshot, hid_t vtk)
{
    enum { VTK_VERTEX = 1 };
    const hsize_t count = snapshot->count;
    const struct {
        const char *name;
        hid_t type;
        hsize_t rows, columns;
        enum compression compression;
        struct source source;
    } datasets[] = {
        {"Points",
         H5T_IEEE_F64LE,
         count,
         POINT_COMPONENTS,
         STORED,
         {.fill = fill_points, .field = MPM_FIELD_POSITION}},
        {"Connectivity", H5T_STD_I64LE, count, 1, DEFLATED, {.fill = fill_numbers}},
        {"Offsets", H5T_STD_I64LE, count + 1, 1, DEFLATED, {.fill = fill_numbers}},
        {"Types", H5T_STD_U8LE, count, 1, DEFLATED, {.fill = fill_value, .value = VTK_VERTEX}},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(datasets); i++)
        checked(snapshot, H5Dclose(dataset_write(snapshot, vtk, datasets[i].name, datasets[i].type,
                                                 datasets[i].rows, datasets[i].columns,
                                                 datasets[i].compression, &datasets[i].source)));
}

static void write_vtk(struct snapshot *snapshot, hid_t vtk)
{
    static const char *const counts[] = {"NumberOfPoints", "NumberOfCells",
                                         "NumberOfConnectivityIds"};
    write_vtk_attributes(snapshot, vtk);
    for (size_t i = 0; i < G_N_ELEMENTS(counts); i++)
        number_write(snapshot, vtk, counts[i], H5T_STD_I64LE, (double)snapshot->count);
    write_grid(snapshot, vtk);
    const hid_t data = group_create(snapshot, vtk, "FieldData");
    number_write(snapshot, data, "TimeValue", H5T_IEEE_F64LE,
                 mpm_simulation_time(snapshot->simulation));
    number_write(snapshot, data, "step", H5T_STD_I64LE,
                 (double)mpm_simulation_step(snapshot->simulation));
    checked(snapshot, H5Gclose(data));
}

/* -------------------------------------------------------------------- file */

static void write_groups(struct snapshot *snapshot)
{
    const hid_t mpm = group_create(snapshot, snapshot->file, "mpm");
    const hid_t particles = group_create(snapshot, mpm, "particles");
    const hid_t vtk = group_create(snapshot, snapshot->file, "VTKHDF");
    const hid_t point_data = group_create(snapshot, vtk, "PointData");
    write_description(snapshot, mpm);
    for (int field = 0; field < MPM_FIELD_COUNT; field++)
        write_field(snapshot, particles, point_data, (enum mpm_field)field);
    write_vtk(snapshot, vtk);
    checked(snapshot, H5Gclose(point_data));
    checked(snapshot, H5Gclose(vtk));
    checked(snapshot, H5Gclose(particles));
    checked(snapshot, H5Gclose(mpm));
}

/* Files of HDF5 1.10 and later: compact for few particles, attributes of any size. */
static void write_hdf5(struct snapshot *snapshot, struct mpm_hdf5_sink *sink)
{
    const hid_t access = checked(snapshot, mpm_hdf5_sink_access(sink));
    checked(snapshot, H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110));
    const hid_t creation = checked(snapshot, H5Pcreate(H5P_FILE_CREATE));
    checked(snapshot, H5Pset_obj_track_times(creation, false));
    snapshot->scalar = checked(snapshot, H5Screate(H5S_SCALAR));
    snapshot->text = checked(snapshot, H5Tcopy(H5T_C_S1));
    checked(snapshot, H5Tset_size(snapshot->text, H5T_VARIABLE));
    checked(snapshot, H5Tset_cset(snapshot->text, H5T_CSET_UTF8));
    snapshot->file = checked(snapshot, H5Fcreate("snapshot", H5F_ACC_TRUNC, creation, access));
    if (snapshot->failure == NULL)
        write_groups(snapshot);
    checked(snapshot, H5Tclose(snapshot->text));
    checked(snapshot, H5Sclose(snapshot->scalar));
    checked(snapshot, H5Pclose(creation));
    checked(snapshot, H5Fclose(snapshot->file));
    checked(snapshot, H5Pclose(access));
}

/* The caller's way of reporting HDF5's errors is put aside for the while. */
static char *write_hdf5_silently(struct snapshot *snapshot, struct mpm_hdf5_sink *sink)
{
    H5E_auto2_t report = NULL;
    void *report_context = NULL;
    (void)H5Eget_auto2(H5E_DEFAULT, &report, &report_context);
    (void)H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    write_hdf5(snapshot, sink);
    (void)H5Eset_auto2(H5E_DEFAULT, report, report_context);
    return snapshot->failure;
}

/* Writes, syncs and closes `path`; returns NULL or why it failed (g_free). */
static char *write_file(struct snapshot *snapshot, const char *path)
{
    struct mpm_hdf5_sink sink = {.file = open(path, O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
    if (sink.file < 0)
        return g_strdup(g_strerror(errno));
    char *failure = write_hdf5_silently(snapshot, &sink);
    if (sink.error_number == 0 && fsync(sink.file) != 0)
        sink.error_number = errno;
    if (close(sink.file) != 0 && sink.error_number == 0)
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
    struct snapshot snapshot = {
        .scene = scene,
        .simulation = simulation,
        .work = work,
        .count = mpm_simulation_particle_count(simulation),
    };
    char *partial = g_strconcat(path, MPM_PARTIAL_SUFFIX, NULL);
    char *failure = write_file(&snapshot, partial);
    if (failure == NULL && rename(partial, path) != 0)
        failure = g_strdup(g_strerror(errno));
    enum mpm_status status = MPM_OK;
    if (failure != NULL) {
        (void)unlink(partial);
        status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be written: %s", path,
                               failure);
    }
    g_free(failure);
    g_free(partial);
    return status;
}
