/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/api_pages.h"

#include "mpm_file.h"
#include "verification/common/folders.h"
#include "verification/common/input.h"
#include "verification/common/names.h"
#include "verification/common/result_path.h"

#include <errno.h>
#include <string.h>

static const char folder_name[] = "api", first_page[] = "index.html";

/* The first line of each copied page. A browser obeys it for all that follows it. */
static const char guard[] =
    "<!DOCTYPE html><meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
    "base-uri 'none'; form-action 'none'; img-src 'self' file:; "
    "style-src 'self' file: 'unsafe-inline'\">\n";

/* ----------------------------------------------------------------------- names */

static bool is_page(const char *name)
{
    return g_str_has_suffix(name, ".html");
}

/* A plain name with the ending of a page, a style sheet or a picture. */
static bool is_copied(const char *name)
{
    static const char *const endings[] = {".html", ".css", ".png"};
    for (size_t i = 0; i < G_N_ELEMENTS(endings); i++)
        if (g_str_has_suffix(name, endings[i])) {
            char *const stem = g_strndup(name, strlen(name) - strlen(endings[i]));
            const bool plain = name_is_plain(stem);
            g_free(stem);
            return plain;
        }
    return false;
}

/* The same, or one that was being written when its process was killed. */
static bool is_ours(const char *name)
{
    char *const whole = g_str_has_suffix(name, MPM_PARTIAL_SUFFIX)
                            ? g_strndup(name, strlen(name) - strlen(MPM_PARTIAL_SUFFIX))
                            : g_strdup(name);
    const bool ours = is_copied(whole);
    g_free(whole);
    return ours;
}

/* The files of `source` that are copied, the first page last; none of them is a link. */
static enum mpm_status source_names(const char *source, GPtrArray **names, struct mpm_error *error)
{
    GPtrArray *all;
    TRY(input_names(source, &all, error));
    enum mpm_status status = MPM_OK;
    *names = g_ptr_array_new_with_free_func(g_free);
    for (unsigned i = 0; status == MPM_OK && i < all->len; i++) {
        if (!is_copied(all->pdata[i]))
            continue;
        char *const path = g_build_filename(source, all->pdata[i], NULL);
        status = result_file_check(path, error);
        g_free(path);
        if (strcmp(all->pdata[i], first_page) != 0)
            g_ptr_array_add(*names, g_strdup(all->pdata[i]));
    }
    g_ptr_array_add(*names, g_strdup(first_page));
    g_ptr_array_unref(all);
    if (status != MPM_OK)
        g_ptr_array_unref(*names);
    return status;
}

/* ----------------------------------------------------------------------- source */

enum mpm_status api_pages_check(const char *source, struct mpm_error *error)
{
    static const char allowed[] = "the html folder of Doxygen, with index.html (make docs)";
    GPtrArray *names;
    char *const path = g_build_filename(source, first_page, NULL);
    char *text = NULL;
    enum mpm_status status = input_text(path, allowed, &text, NULL, error);
    if (status == MPM_OK && strstr(text, "<meta name=\"generator\" content=\"Doxygen") == NULL)
        status = failure_set(error, MPM_BAD_INPUT, "%s: was not written by Doxygen: allowed is %s",
                             path, allowed);
    g_free(text);
    g_free(path);
    if (status == MPM_OK)
        status = source_names(source, &names, error);
    if (status == MPM_OK)
        g_ptr_array_unref(names);
    return status;
}

/* ------------------------------------------------------------------------- copy */

static enum mpm_status copy_file(const char *source, const char *home, const char *name,
                                 struct mpm_error *error)
{
    char *const from = g_build_filename(source, name, NULL);
    char *const to = g_build_filename(home, name, NULL);
    char *text = NULL;
    size_t length = 0;
    enum mpm_status status = input_text(from, NULL, &text, &length, error);
    if (status == MPM_OK) {
        GString *const whole = g_string_new_len(text, (gssize)length);
        if (is_page(name) && !g_str_has_prefix(text, guard))
            g_string_prepend(whole, guard);
        if (mpm_file_save(to, whole->str, whole->len) != 0)
            status = mpm_file_failed(to, errno, error);
        g_string_free(whole, TRUE);
    }
    g_free(text);
    g_free(to);
    g_free(from);
    return status;
}

static enum mpm_status remove_others(const char *home, const GPtrArray *kept,
                                     struct mpm_error *error)
{
    GPtrArray *names;
    TRY(folder_names(home, &names, error));
    enum mpm_status status = MPM_OK;
    for (unsigned i = 0; status == MPM_OK && i < names->len; i++) {
        const char *const name = names->pdata[i];
        if (!is_ours(name) ||
            g_ptr_array_find_with_equal_func((GPtrArray *)kept, name, g_str_equal, NULL))
            continue;
        char *const path = g_build_filename(home, name, NULL);
        status = folder_remove(path, error);
        g_free(path);
    }
    g_ptr_array_unref(names);
    return status;
}

enum mpm_status api_pages_copy(const char *source, const char *folder, struct mpm_error *error)
{
    GPtrArray *names;
    TRY(source_names(source, &names, error));
    char *const home = g_build_filename(folder, folder_name, NULL);
    enum mpm_status status = folder_make(home, error);
    for (unsigned i = 0; status == MPM_OK && i < names->len; i++)
        status = copy_file(source, home, names->pdata[i], error);
    if (status == MPM_OK)
        status = remove_others(home, names, error);
    g_free(home);
    g_ptr_array_unref(names);
    return status;
}

/* ------------------------------------------------------------------------- find */

static enum mpm_status check_copy(const char *home, const char *name, bool replaced,
                                  struct mpm_error *error)
{
    char *const path = g_build_filename(home, name, NULL);
    char *text = NULL;
    enum mpm_status status = MPM_OK;
    if (!is_ours(name))
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: allowed are pages (.html), style sheets (.css) and pictures "
                             "(.png) with plain names: remove it, or the folder",
                             path);
    if (status == MPM_OK)
        status = result_file_check(path, error);
    if (status == MPM_OK && !replaced && is_page(name))
        status = input_text(path, NULL, &text, NULL, error);
    if (text != NULL && !g_str_has_prefix(text, guard))
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: is no copy by mpm-verify: its first line does not forbid "
                             "scripts; give --api, or remove the folder",
                             path);
    g_free(text);
    g_free(path);
    return status;
}

enum mpm_status api_pages_find(const char *folder, bool replaced, bool *there,
                               struct mpm_error *error)
{
    char *const home = g_build_filename(folder, folder_name, NULL);
    GPtrArray *names = NULL;
    enum mpm_status status = result_folder_check(home, error);
    *there = false;
    if (status == MPM_OK)
        status = folder_names(home, &names, error);
    for (unsigned i = 0; status == MPM_OK && i < names->len; i++) {
        status = check_copy(home, names->pdata[i], replaced, error);
        *there = *there || strcmp(names->pdata[i], first_page) == 0;
    }
    if (names != NULL)
        g_ptr_array_unref(names);
    g_free(home);
    return status;
}
