/* Reads a scene file: bytes, tree, settings, checks, structs, scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"
#include "io/scene/scene_settings.h"

#include <glib.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---------------------------------------------------------------- messages */

enum mpm_status mpm_scene_error(struct mpm_error *error, const struct mpm_scene *scene, int line,
                                const char *key, const char *format, ...)
{
    char message[MPM_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    const struct mpm_source source = mpm_scene_source(scene);
    return mpm_tree_fault(error, &source, (struct mpm_origin){.line = line}, key, "%s", message);
}

/* ----------------------------------------------------------------- reading */

static void hash_bytes(struct mpm_bytes bytes, struct mpm_scene *scene)
{
    gsize length = sizeof scene->sha256;
    GChecksum *checksum = g_checksum_new(G_CHECKSUM_SHA256);
    g_checksum_update(checksum, (const guchar *)bytes.data, (gssize)bytes.length);
    g_checksum_get_digest(checksum, scene->sha256, &length);
    g_checksum_free(checksum);
}

/* What reading a scene takes until it is done. */
struct work {
    struct mpm_bytes bytes;
    struct mpm_tree_node *root;
    struct mpm_raw_scene *raw;
};

static enum mpm_status build(const struct mpm_reading *reading)
{
    static const struct {
        enum mpm_status (*build)(const struct mpm_reading *reading);
        bool goes_on; /* the next one needs nothing of it but names */
    } stages[] = {
        {mpm_build_general, false},    {mpm_build_materials, true},    {mpm_build_bodies, true},
        {mpm_build_boundaries, false}, {mpm_build_loads, false},       {mpm_build_cracks, false},
        {mpm_build_contact, false},    {mpm_build_j_integrals, false}, {mpm_build_damping, false},
        {mpm_build_transport, false},
    };
    for (size_t i = 0; i < sizeof stages / sizeof stages[0]; i++) {
        MPM_TRY(mpm_reading_note(reading, stages[i].build(reading)));
        if (!stages[i].goes_on && reading->faults->count > 0)
            return MPM_BAD_INPUT;
    }
    return MPM_OK;
}

static enum mpm_status copy_arguments(struct mpm_scene *scene, const char *path,
                                      const char *const *settings, size_t setting_count,
                                      struct mpm_error *error)
{
    const struct mpm_reading reading = {.scene = scene, .error = error};
    MPM_TRY(mpm_reading_copy(&reading, path, &scene->path));
    MPM_TRY(mpm_reading_allocate(&reading, setting_count, sizeof *scene->settings, "settings",
                                 &scene->settings));
    for (size_t i = 0; i < setting_count; i++) {
        MPM_TRY(mpm_reading_copy(&reading, settings[i], &scene->settings[i]));
        scene->setting_count++;
    }
    return MPM_OK;
}

/* Of the file, or of a text in memory. */
static enum mpm_status take_bytes(const struct mpm_source *source, const struct mpm_bytes *text,
                                  struct mpm_bytes *bytes, struct mpm_error *error)
{
    if (text == NULL)
        return mpm_source_read(source, bytes, error);
    if (text->length > MPM_SOURCE_SIZE_MAX)
        return mpm_tree_fault(error, source, (struct mpm_origin){.line = 0}, "",
                              "a text of %zu bytes is too big; allowed: up to 16 MiB",
                              text->length);
    *bytes = (struct mpm_bytes){.data = malloc(text->length + 1), .length = text->length};
    if (bytes->data == NULL)
        return mpm_error_memory(error, text->length, "a scene's text");
    memcpy(bytes->data, text->data, text->length);
    return MPM_OK;
}

/* The tree of the scene's file with its settings and the defaults of what is missing. */
static enum mpm_status read_tree(const struct mpm_scene *scene, const struct mpm_bytes *text,
                                 struct work *work, struct mpm_faults *faults,
                                 struct mpm_error *error)
{
    const struct mpm_source source = mpm_scene_source(scene);
    const struct mpm_origin origin = {.setting = MPM_FROM_FILE};
    struct mpm_bytes *const bytes = &work->bytes;
    MPM_TRY(take_bytes(&source, text, bytes, error));
    /* the caller frees the bytes: NOLINTNEXTLINE(clang-analyzer-unix.Malloc) */
    MPM_TRY(mpm_tree_parse(&source, origin, bytes->data, bytes->length, &work->root, error));
    MPM_TRY(mpm_tree_apply_settings(&source, scene->setting_count, work->root, faults, error));
    return mpm_tree_check(&source, &mpm_scene_root, work->root, faults, error);
}

static enum mpm_status read_scene(struct mpm_scene *scene, const struct mpm_bytes *text,
                                  struct work *work, struct mpm_faults *faults,
                                  struct mpm_error *error)
{
    MPM_TRY(read_tree(scene, text, work, faults, error));
    hash_bytes(work->bytes, scene);
    work->raw = mpm_keys_fill(&mpm_scene_root, work->root);
    if (work->raw == NULL)
        return mpm_error_memory(error, sizeof *work->raw, "a scene's values");
    return build(&(struct mpm_reading){
        .scene = scene, .root = work->root, .raw = work->raw, .faults = faults, .error = error});
}

enum mpm_status mpm_scene_tree(const struct mpm_scene *scene, struct mpm_tree_node **root,
                               struct mpm_error *error)
{
    struct work work = {.root = NULL};
    struct mpm_faults faults = {.count = 0};
    struct mpm_error own = {.status = MPM_OK}; /* `error` may be NULL, mistakes are kept */
    const enum mpm_status status = read_tree(scene, NULL, &work, &faults, &own);
    free(work.bytes.data);
    *root = status == MPM_OK ? work.root : NULL;
    if (status == MPM_OK)
        return MPM_OK;
    mpm_tree_free(work.root);
    if (error != NULL)
        *error = own;
    return status;
}

static enum mpm_status make_scene(const char *path, const struct mpm_bytes *text,
                                  const char *const *settings, size_t setting_count,
                                  struct mpm_scene **scene, struct mpm_faults *faults,
                                  struct mpm_error *error)
{
    struct mpm_scene *made = calloc(1, sizeof *made);
    if (made == NULL)
        return mpm_error_memory(error, sizeof *made, "a scene");
    struct work work = {.root = NULL};
    enum mpm_status status = copy_arguments(made, path, settings, setting_count, error);
    if (status == MPM_OK)
        status = read_scene(made, text, &work, faults, error);
    mpm_keys_free(&mpm_scene_root, work.raw);
    mpm_tree_free(work.root);
    free(work.bytes.data);
    if (status != MPM_OK) {
        mpm_scene_free(made);
        return status;
    }
    *scene = made;
    return MPM_OK;
}

/* All mistakes of the file, or of a text in memory. */
static enum mpm_status read_all(const char *path, const struct mpm_bytes *text,
                                const char *const *settings, size_t setting_count,
                                struct mpm_scene **scene, struct mpm_faults *faults)
{
    struct mpm_error error = {.status = MPM_OK};
    *scene = NULL;
    faults->count = 0;
    const enum mpm_status status =
        make_scene(path, text, settings, setting_count, scene, faults, &error);
    /* what ends the reading at once is no list of mistakes */
    if (status != MPM_OK && (status != MPM_BAD_INPUT || faults->count == 0)) {
        faults->list[0] = error;
        faults->count = 1;
    }
    return status;
}

/* The first mistake. */
static enum mpm_status read_first(const char *path, const struct mpm_bytes *text,
                                  const char *const *settings, size_t setting_count,
                                  struct mpm_scene **scene, struct mpm_error *error)
{
    struct mpm_faults faults;
    const enum mpm_status status = read_all(path, text, settings, setting_count, scene, &faults);
    if (status != MPM_OK && error != NULL)
        *error = faults.list[0];
    return status;
}

enum mpm_status mpm_scene_read_all(const char *path, const char *const *settings,
                                   size_t setting_count, struct mpm_scene **scene,
                                   struct mpm_faults *faults)
{
    return read_all(path, NULL, settings, setting_count, scene, faults);
}

enum mpm_status mpm_scene_read(const char *path, const char *const *settings, size_t setting_count,
                               struct mpm_scene **scene, struct mpm_error *error)
{
    return read_first(path, NULL, settings, setting_count, scene, error);
}

enum mpm_status mpm_scene_parse(const char *name, const char *text, size_t length,
                                const char *const *settings, size_t setting_count,
                                struct mpm_scene **scene, struct mpm_error *error)
{
    const struct mpm_bytes bytes = {.data = (char *)(uintptr_t)text, .length = length};
    return read_first(name, &bytes, settings, setting_count, scene, error);
}

/* ------------------------------------------------------------------- scene */

static void free_vector(struct mpm_vector_expression *vector)
{
    free(vector->text[0]);
    free(vector->text[1]);
}

static void free_scalar(struct mpm_scalar_spec *scalar)
{
    for (size_t i = 0; i < scalar->condition_count; i++)
        free(scalar->conditions[i].value);
    free(scalar->conditions);
    free(scalar->start);
    free(scalar->source);
}

static void free_table(const struct mpm_property *table)
{
    free(table->points);
    free(table->integral);
}

static void free_properties(const struct mpm_material_spec *material)
{
    free_table(&material->hardening);
    for (int which = 0; which < MPM_SCALAR_COUNT; which++) {
        for (int k = 0; k < MPM_TABLE_COUNT; k++)
            free_table(&material->conduction[which].tables[k]);
    }
}

void mpm_scene_free(struct mpm_scene *scene)
{
    if (scene == NULL)
        return;
    for (size_t i = 0; i < scene->body_count; i++) {
        free(scene->bodies[i].region.points);
        free_vector(&scene->bodies[i].velocity);
        for (int k = 0; k < MPM_SCALAR_COUNT; k++)
            free(scene->bodies[i].start[k]);
    }
    for (size_t i = 0; i < scene->boundary_count; i++)
        free_vector(&scene->boundaries[i].velocity);
    for (size_t i = 0; i < scene->edge_load_count; i++)
        free_vector(&scene->edge_loads[i].value);
    for (size_t i = 0; i < scene->crack_count; i++)
        free(scene->cracks[i].points);
    for (size_t i = 0; i < scene->setting_count; i++)
        free(scene->settings[i]);
    for (size_t i = 0; i < scene->material_count; i++)
        free_properties(&scene->materials[i]);
    free_vector(&scene->body_force);
    for (int k = 0; k < MPM_SCALAR_COUNT; k++)
        free_scalar(&scene->scalars[k]);
    free(scene->damping.grid);
    free(scene->damping.particle);
    free(scene->damping.pic);
    free(scene->bodies);
    free(scene->boundaries);
    free(scene->edge_loads);
    free(scene->cracks);
    free(scene->contact.groups);
    free(scene->contact.group_of);
    free(scene->contact.field_of);
    free(scene->contact.pairs);
    free(scene->j_integrals);
    free(scene->probes);
    free(scene->materials);
    free(scene->settings);
    free(scene->title);
    free(scene->path);
    free(scene);
}

const char *const *mpm_scene_coordinates(const struct mpm_scene *scene)
{
    static const char *const planar[2] = {"x", "y"}, *const radial[2] = {"r", "z"};
    return scene->geometry == MPM_AXISYMMETRIC ? radial : planar;
}

size_t mpm_scene_body_count(const struct mpm_scene *scene)
{
    return scene->body_count;
}

const char *mpm_scene_body_name(const struct mpm_scene *scene, size_t body)
{
    return scene->bodies[body].name;
}

double mpm_scene_end_time(const struct mpm_scene *scene)
{
    return scene->end;
}

size_t mpm_scene_j_integral_count(const struct mpm_scene *scene)
{
    return scene->j_integral_count;
}

bool mpm_scene_is_damped(const struct mpm_scene *scene)
{
    const struct mpm_damping_spec *const damping = &scene->damping;
    return damping->grid != NULL || damping->particle != NULL || damping->pic != NULL ||
           damping->thermostat;
}

bool mpm_scene_is_cohesive(const struct mpm_scene *scene)
{
    for (size_t k = 0; k < scene->crack_count; k++)
        if (scene->cracks[k].cohesive.law != NULL)
            return true;
    return false;
}

bool mpm_scene_has_contact(const struct mpm_scene *scene)
{
    return scene->contact.field_count > 0;
}

bool mpm_scene_has_energy_balance(const struct mpm_scene *scene)
{
    return scene->energy_balance;
}

bool mpm_scene_has_contact_loss(const struct mpm_scene *scene)
{
    for (size_t k = 0; k < scene->crack_count; k++)
        if (scene->crack_method == MPM_CRACKS_FIELDS &&
            scene->cracks[k].contact != MPM_CONTACT_NONE)
            return scene->energy_balance;
    return false;
}
