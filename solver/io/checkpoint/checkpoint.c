/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/checkpoint/checkpoint.h"

#include "mpm_file.h"

#include <errno.h>
#include <glib.h>
#include <stdio.h>
#include <string.h>

enum { SUM_SIZE = 32, KERNELS_SIZE = 32, BUILD_SIZE = 1024 };

/* What the state belongs to. */
struct identity {
    uint8_t scene[SUM_SIZE];    /* SHA-256 of the scene's file */
    uint8_t settings[SUM_SIZE]; /* and of its --set texts, each with its final zero */
    char kernels[KERNELS_SIZE];
    char build[BUILD_SIZE]; /* bits may depend on it */
};

static void identify(const struct mpm_scene *scene, const char *kernels, struct identity *identity)
{
    const struct mpm_build_info *const build = mpm_build_info();
    GChecksum *const checksum = g_checksum_new(G_CHECKSUM_SHA256);
    gsize size = sizeof identity->settings;
    *identity = (struct identity){.kernels = ""};
    memcpy(identity->scene, scene->sha256, sizeof identity->scene);
    for (size_t k = 0; k < scene->setting_count; k++)
        g_checksum_update(checksum, (const guchar *)scene->settings[k],
                          (gssize)strlen(scene->settings[k]) + 1);
    g_checksum_get_digest(checksum, identity->settings, &size);
    g_checksum_free(checksum);
    (void)g_strlcpy(identity->kernels, kernels, sizeof identity->kernels);
    (void)g_snprintf(identity->build, sizeof identity->build, "%s (%s), %s %s, %s", build->version,
                     build->revision, build->compiler, build->flags, build->libraries);
}

static void visit_identity(struct identity *identity, struct mpm_piece_visitor *visitor)
{
    mpm_piece_visit(visitor, MPM_PIECE_UINT8, identity->scene, SUM_SIZE, "scene", -1);
    mpm_piece_visit(visitor, MPM_PIECE_UINT8, identity->settings, SUM_SIZE, "settings", -1);
    mpm_piece_visit(visitor, MPM_PIECE_UINT8, identity->kernels, KERNELS_SIZE, "kernels", -1);
    mpm_piece_visit(visitor, MPM_PIECE_UINT8, identity->build, BUILD_SIZE, "build", -1);
    identity->kernels[KERNELS_SIZE - 1] = '\0';
    identity->build[BUILD_SIZE - 1] = '\0';
}

/* ------------------------------------------------------------------ writing */

struct contents {
    struct identity identity;
    void (*visit)(void *context, struct mpm_piece_visitor *visitor);
    void *context;
};

static void visit_contents(void *context, struct mpm_piece_visitor *visitor)
{
    struct contents *const contents = context;
    visit_identity(&contents->identity, visitor);
    contents->visit(contents->context, visitor);
}

static enum mpm_status rename_file(const char *from, const char *to, bool may_be_absent,
                                   struct mpm_error *error)
{
    if (mpm_path_rename(from, to) == 0 || (may_be_absent && errno == ENOENT))
        return MPM_OK;
    return mpm_file_failed(to, errno, error);
}

/* The new one is whole and on the disk before the old one loses its name. */
static enum mpm_status put_in_place(const char *folder, const char *partial, const char *path,
                                    struct mpm_error *error)
{
    char *const previous = g_build_filename(folder, MPM_CHECKPOINT_PREVIOUS, NULL);
    enum mpm_status status = rename_file(path, previous, true, error);
    g_free(previous);
    MPM_TRY(status);
    MPM_TRY(rename_file(partial, path, false, error));
    return mpm_folder_sync(folder) == 0 ? MPM_OK : mpm_file_failed(folder, errno, error);
}

enum mpm_status
mpm_checkpoint_write(const char *folder, const struct mpm_scene *scene, const char *kernels,
                     void (*visit)(void *context, struct mpm_piece_visitor *visitor), void *context,
                     struct mpm_error *error)
{
    struct contents contents = {.visit = visit, .context = context};
    char *const path = g_build_filename(folder, MPM_CHECKPOINT_NAME, NULL);
    char *const partial = g_strconcat(path, MPM_PARTIAL_SUFFIX, NULL);
    identify(scene, kernels, &contents.identity);
    enum mpm_status status = mpm_checkpoint_file_write(partial, visit_contents, &contents, error);
    if (status == MPM_OK)
        status = put_in_place(folder, partial, path, error);
    if (status != MPM_OK)
        (void)mpm_file_remove(partial);
    g_free(partial);
    g_free(path);
    return status;
}

/* ------------------------------------------------------------------ reading */

/* Is it of this scene, and of kernels that are allowed? */
static enum mpm_status check_identity(const struct mpm_scene *scene, enum mpm_kernels asked,
                                      struct mpm_checkpoint *checkpoint, struct mpm_error *error)
{
    struct identity found = {.kernels = ""}, own;
    struct mpm_piece_visitor visitor = {
        .take = mpm_checkpoint_file_read, .context = checkpoint->file, .error = error};
    visit_identity(&found, &visitor);
    MPM_TRY(visitor.status);
    identify(scene, found.kernels, &own);
    if (memcmp(found.scene, own.scene, sizeof own.scene) != 0)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "--resume: %s is of another scene, or the scene has been changed",
                             checkpoint->name);
    if (memcmp(found.settings, own.settings, sizeof own.settings) != 0)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "--resume: %s is of a run with other --set texts; allowed: the same, "
                             "in the same order",
                             checkpoint->name);
    MPM_TRY(mpm_kernels_find(found.kernels, &checkpoint->kernels, error));
    if (asked != MPM_KERNELS_AUTO && asked != checkpoint->kernels)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "--resume: %s is of a run with --kernels %s, got %s; bits depend on "
                             "it; allowed: the same",
                             checkpoint->name, found.kernels, mpm_kernels_name(asked));
    if (strcmp(found.build, own.build) != 0)
        (void)snprintf(checkpoint->build_warning, sizeof checkpoint->build_warning,
                       "%s is of another build, mpm %.600s: results need not be the same bits",
                       checkpoint->name, found.build);
    return MPM_OK;
}

static enum mpm_status open_one(const char *folder, const char *name,
                                struct mpm_checkpoint *checkpoint, struct mpm_error *error)
{
    char *const path = g_build_filename(folder, name, NULL);
    const enum mpm_status status = mpm_checkpoint_file_open(path, &checkpoint->file, error);
    checkpoint->name = name;
    g_free(path);
    return status;
}

/* One of which the system does not say whether it is there, is: opening it gives the reason. */
static bool has(const char *folder, const char *name)
{
    char *const path = g_build_filename(folder, name, NULL);
    const bool found = mpm_path_kind(path) != MPM_PATH_NONE;
    g_free(path);
    return found;
}

enum mpm_status mpm_checkpoint_open(const char *folder, const struct mpm_scene *scene,
                                    enum mpm_kernels asked, struct mpm_checkpoint *checkpoint,
                                    struct mpm_error *error)
{
    struct mpm_error first = {.status = MPM_OK}, second = {.status = MPM_OK};
    *checkpoint = (struct mpm_checkpoint){.file = NULL};
    const bool newest = has(folder, MPM_CHECKPOINT_NAME),
               older = has(folder, MPM_CHECKPOINT_PREVIOUS);
    if (!newest && !older)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "--resume: there is no checkpoint in '%s'; run the scene from its "
                             "start",
                             folder);
    enum mpm_status status = MPM_BAD_INPUT;
    if (newest)
        status = open_one(folder, MPM_CHECKPOINT_NAME, checkpoint, &first);
    if (status != MPM_OK && older)
        status = open_one(folder, MPM_CHECKPOINT_PREVIOUS, checkpoint, &second);
    if (status != MPM_OK)
        return mpm_error_set(error, status, "--resume: %s%s%s", first.message,
                             newest && older ? "; " : "", second.message);
    status = check_identity(scene, asked, checkpoint, error);
    if (status == MPM_OK && newest && first.status != MPM_OK)
        (void)snprintf(checkpoint->older_warning, sizeof checkpoint->older_warning,
                       "%.700s; the run goes on from %s", first.message, checkpoint->name);
    if (status != MPM_OK)
        mpm_checkpoint_close(checkpoint);
    return status;
}

void mpm_checkpoint_close(struct mpm_checkpoint *checkpoint)
{
    mpm_checkpoint_file_close(checkpoint->file);
    checkpoint->file = NULL;
}
