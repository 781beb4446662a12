/* Reading YAML files.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "io/yaml/keys.h"
#include "mpm_file.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static enum mpm_status refuse_file(const struct mpm_source *source, const char *fault,
                                   struct mpm_error *error)
{
    return mpm_tree_fault(error, source, (struct mpm_origin){.line = 0}, "",
                          "%s; allowed: a readable %s of up to 16 MiB", fault, source->what);
}

/* A name without a file and a file that is not ours to read are bad input, a disk is not. */
static enum mpm_status refuse_read(const struct mpm_source *source, struct mpm_error *error)
{
    const int reason = errno;
    struct mpm_error own = {.status = MPM_OK};
    if (mpm_file_unread(source->path, reason, NULL, &own) == MPM_ENVIRONMENT_FAILED)
        return mpm_error_set(error, own.status, "%s", own.message);
    return refuse_file(source, g_strerror(reason), error);
}

static enum mpm_status check_kind(const struct mpm_source *source, int file, size_t *size,
                                  struct mpm_error *error)
{
    struct stat facts;
    if (mpm_file_facts(file, &facts) != 0)
        return refuse_read(source, error);
    if (S_ISDIR(facts.st_mode))
        return refuse_file(source, "is a folder", error);
    if (!S_ISREG(facts.st_mode))
        return refuse_file(source, "is not a regular file", error);
    if (facts.st_size > MPM_SOURCE_SIZE_MAX)
        return refuse_file(source, "the file is too big", error);
    *size = (size_t)facts.st_size;
    return MPM_OK;
}

/* Reads up to one byte past the size, so that a file that grows is noticed. */
static enum mpm_status read_bytes(const struct mpm_source *source, int file,
                                  struct mpm_bytes *bytes, struct mpm_error *error)
{
    size_t size = 0;
    MPM_TRY(check_kind(source, file, &size, error));
    const size_t capacity = size + 1;
    bytes->data = malloc(capacity);
    if (bytes->data == NULL)
        return mpm_error_memory(error, capacity, "a file");
    const ssize_t got = mpm_file_read(file, bytes->data, capacity);
    if (got < 0)
        return refuse_read(source, error);
    bytes->length = (size_t)got;
    return bytes->length <= size ? MPM_OK
                                 : refuse_file(source, "the file grows while it is read", error);
}

/* What a pipe will bring is not known before its end. */
static enum mpm_status read_stream(const struct mpm_source *source, struct mpm_bytes *bytes,
                                   struct mpm_error *error)
{
    const size_t capacity = (size_t)MPM_SOURCE_SIZE_MAX + 1;
    bytes->data = malloc(capacity);
    if (bytes->data == NULL)
        return mpm_error_memory(error, capacity, "standard input");
    const ssize_t got = mpm_file_read(STDIN_FILENO, bytes->data, capacity);
    if (got < 0)
        return refuse_read(source, error);
    bytes->length = (size_t)got;
    return bytes->length < capacity ? MPM_OK : refuse_file(source, "the file is too big", error);
}

enum mpm_status mpm_source_read(const struct mpm_source *source, struct mpm_bytes *bytes,
                                struct mpm_error *error)
{
    *bytes = (struct mpm_bytes){.data = NULL};
    if (strcmp(source->path, "-") == 0)
        return read_stream(source, bytes, error);
    /* A named pipe must not make the program wait. */
    const int file = mpm_file_open(source->path, O_RDONLY | O_NONBLOCK);
    if (file < 0)
        return refuse_read(source, error);
    const enum mpm_status status = read_bytes(source, file, bytes, error);
    (void)mpm_file_close(file);
    return status;
}

enum mpm_status mpm_tree_read(const char *path, struct mpm_tree_node **root,
                              struct mpm_error *error)
{
    const struct mpm_source source = {.path = path, .what = "file"};
    const struct mpm_origin origin = {.setting = MPM_FROM_FILE};
    struct mpm_bytes bytes;
    *root = NULL;
    enum mpm_status status = mpm_source_read(&source, &bytes, error);
    if (status == MPM_OK)
        status = mpm_tree_parse(&source, origin, bytes.data, bytes.length, root, error);
    free(bytes.data);
    return status;
}

enum mpm_status mpm_keys_read(const char *path, const struct mpm_key *root, void **data,
                              struct mpm_error *error)
{
    const struct mpm_source source = {.path = path, .what = "file"};
    struct mpm_tree_node *tree = NULL;
    *data = NULL;
    MPM_TRY(mpm_tree_read(path, &tree, error));
    struct mpm_faults faults = {.count = 0};
    enum mpm_status status = mpm_tree_check(&source, root, tree, &faults, error);
    if (status == MPM_OK && (*data = mpm_keys_fill(root, tree)) == NULL)
        status = mpm_error_memory(error, root->size, "what a file says");
    mpm_tree_free(tree);
    return status;
}
