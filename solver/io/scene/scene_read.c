/* Reads a scene file: bytes, tree, settings, checks, structs, scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"
#include "io/scene/scene_check.h"
#include "io/scene/scene_load.h"
#include "io/scene/scene_settings.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { FILE_SIZE_MAX = 16 * 1024 * 1024, PATH_SHOWN_MAX = 400 };

/* ---------------------------------------------------------------- messages */

enum mpm_status mpm_scene_error(struct mpm_error *error, const struct mpm_scene *scene, int line,
                                const char *key, const char *format, ...)
{
    char message[MPM_MESSAGE_SIZE], place[24] = "";
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    /* The end of a long path tells more than its start, and the message must fit. */
    const size_t length = strlen(scene->path);
    const bool cut = length > PATH_SHOWN_MAX;
    if (line > 0)
        (void)snprintf(place, sizeof place, ":%d", line);
    return mpm_error_set(error, MPM_BAD_INPUT, "%s%s%s: %s%s%s", cut ? "..." : "",
                         scene->path + (cut ? length - PATH_SHOWN_MAX : 0), place, key,
                         *key != '\0' ? ": " : "", message);
}

/* -------------------------------------------------------------------- file */

struct bytes {
    char *data;
    size_t length;
};

static enum mpm_status refuse_file(const struct mpm_scene *scene, const char *what,
                                   struct mpm_error *error)
{
    return mpm_scene_error(error, scene, 0, "",
                           "%s; allowed: a readable scene file of up to 16 MiB", what);
}

static enum mpm_status check_kind(const struct mpm_scene *scene, int file, size_t *size,
                                  struct mpm_error *error)
{
    struct stat facts;
    if (fstat(file, &facts) != 0)
        return refuse_file(scene, g_strerror(errno), error);
    if (S_ISDIR(facts.st_mode))
        return refuse_file(scene, "is a folder", error);
    if (!S_ISREG(facts.st_mode))
        return refuse_file(scene, "is not a regular file", error);
    if (facts.st_size > FILE_SIZE_MAX)
        return refuse_file(scene, "the file is too big", error);
    *size = (size_t)facts.st_size;
    return MPM_OK;
}

/* Reads up to one byte past the size, so that a file that grows is noticed. */
static enum mpm_status read_bytes(const struct mpm_scene *scene, int file, struct bytes *bytes,
                                  struct mpm_error *error)
{
    size_t size = 0;
    MPM_TRY(check_kind(scene, file, &size, error));
    const size_t capacity = size + 1;
    bytes->data = malloc(capacity);
    if (bytes->data == NULL)
        return mpm_error_memory(error, capacity, "a scene file");
    for (;;) {
        const ssize_t got = read(file, bytes->data + bytes->length, capacity - bytes->length);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return refuse_file(scene, g_strerror(errno), error);
        bytes->length += (size_t)got;
        if (bytes->length > size)
            return refuse_file(scene, "the file grows while it is read", error);
        if (got == 0)
            return MPM_OK;
    }
}

static enum mpm_status read_file(const struct mpm_scene *scene, struct bytes *bytes,
                                 struct mpm_error *error)
{
    /* A named pipe must not make the program wait. */
    const int file = open(scene->path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0)
        return refuse_file(scene, g_strerror(errno), error);
    const enum mpm_status status = read_bytes(scene, file, bytes, error);
    (void)close(file);
    return status;
}

static void hash_bytes(const struct bytes *bytes, struct mpm_scene *scene)
{
    gsize length = sizeof scene->sha256;
    GChecksum *checksum = g_checksum_new(G_CHECKSUM_SHA256);
    g_checksum_update(checksum, (const guchar *)bytes->data, (gssize)bytes->length);
    g_checksum_get_digest(checksum, scene->sha256, &length);
    g_checksum_free(checksum);
}

/* ----------------------------------------------------------------- reading */

static enum mpm_status build(const struct mpm_reading *reading)
{
    MPM_TRY(mpm_build_general(reading));
    MPM_TRY(mpm_build_materials(reading));
    MPM_TRY(mpm_build_bodies(reading));
    MPM_TRY(mpm_build_boundaries(reading));
    MPM_TRY(mpm_build_loads(reading));
    MPM_TRY(mpm_build_cracks(reading));
    MPM_TRY(mpm_build_j_integrals(reading));
    return mpm_build_damping(reading);
}

static enum mpm_status build_from_tree(struct mpm_scene *scene, struct mpm_tree_node *root,
                                       struct mpm_error *error)
{
    struct mpm_raw_scene *raw = NULL;
    MPM_TRY(mpm_tree_apply_settings(scene, root, error));
    MPM_TRY(mpm_tree_check(scene, root, error));
    MPM_TRY(mpm_raw_load(scene, root, &raw, error));
    const struct mpm_reading reading = {.scene = scene, .root = root, .raw = raw, .error = error};
    const enum mpm_status status = build(&reading);
    mpm_raw_free(raw);
    return status;
}

static enum mpm_status build_from_bytes(struct mpm_scene *scene, const struct bytes *bytes,
                                        struct mpm_error *error)
{
    const struct mpm_origin origin = {.setting = MPM_FROM_FILE};
    struct mpm_tree_node *root = NULL;
    hash_bytes(bytes, scene);
    MPM_TRY(mpm_tree_parse(scene, origin, bytes->data, bytes->length, &root, error));
    const enum mpm_status status = build_from_tree(scene, root, error);
    mpm_tree_free(root);
    return status;
}

static enum mpm_status copy_arguments(struct mpm_scene *scene, const char *path,
                                      const char *const *settings, size_t setting_count,
                                      struct mpm_error *error)
{
    const struct mpm_reading reading = {.scene = scene, .error = error};
    MPM_TRY(mpm_reading_copy(&reading, path, &scene->path));
    scene->settings =
        mpm_reading_allocate(&reading, setting_count, sizeof *scene->settings, "settings");
    if (scene->settings == NULL)
        return MPM_ENVIRONMENT_FAILED;
    for (size_t i = 0; i < setting_count; i++) {
        MPM_TRY(mpm_reading_copy(&reading, settings[i], &scene->settings[i]));
        scene->setting_count++;
    }
    return MPM_OK;
}

static enum mpm_status read_scene(struct mpm_scene *scene, const char *path,
                                  const char *const *settings, size_t setting_count,
                                  struct mpm_error *error)
{
    struct bytes bytes = {.data = NULL};
    MPM_TRY(copy_arguments(scene, path, settings, setting_count, error));
    enum mpm_status status = read_file(scene, &bytes, error);
    if (status == MPM_OK)
        status = build_from_bytes(scene, &bytes, error);
    free(bytes.data);
    return status;
}

enum mpm_status mpm_scene_read(const char *path, const char *const *settings, size_t setting_count,
                               struct mpm_scene **scene, struct mpm_error *error)
{
    *scene = NULL;
    struct mpm_scene *made = calloc(1, sizeof *made);
    if (made == NULL)
        return mpm_error_memory(error, sizeof *made, "a scene");
    const enum mpm_status status = read_scene(made, path, settings, setting_count, error);
    if (status != MPM_OK) {
        mpm_scene_free(made);
        return status;
    }
    *scene = made;
    return MPM_OK;
}

/* ------------------------------------------------------------------- scene */

static void free_vector(struct mpm_vector_expression *vector)
{
    free(vector->text[0]);
    free(vector->text[1]);
}

void mpm_scene_free(struct mpm_scene *scene)
{
    if (scene == NULL)
        return;
    for (size_t i = 0; i < scene->body_count; i++) {
        free(scene->bodies[i].region.points);
        free_vector(&scene->bodies[i].velocity);
    }
    for (size_t i = 0; i < scene->boundary_count; i++)
        free_vector(&scene->boundaries[i].velocity);
    for (size_t i = 0; i < scene->edge_load_count; i++)
        free_vector(&scene->edge_loads[i].value);
    for (size_t i = 0; i < scene->crack_count; i++)
        free(scene->cracks[i].points);
    for (size_t i = 0; i < scene->setting_count; i++)
        free(scene->settings[i]);
    free_vector(&scene->body_force);
    free(scene->damping.grid);
    free(scene->damping.particle);
    free(scene->damping.pic);
    free(scene->bodies);
    free(scene->boundaries);
    free(scene->edge_loads);
    free(scene->cracks);
    free(scene->j_integrals);
    free(scene->materials);
    free(scene->settings);
    free(scene->title);
    free(scene->path);
    free(scene);
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

bool mpm_scene_wants_checkpoints(const struct mpm_scene *scene)
{
    return scene->checkpoint_interval > 0.0;
}
