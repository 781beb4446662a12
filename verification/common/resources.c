/* Where the suite's own files are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/resources.h"

#include "mpm_file.h"

#include <glib.h>
#include <stdbool.h>

/* The running program's own path: what it was called by may have been found in PATH. */
static char *home_of(const char *executable)
{
    char *path = g_file_read_link("/proc/self/exe", NULL);
    if (path == NULL)
        path = g_find_program_in_path(executable);
    char *home = g_path_get_dirname(path == NULL ? executable : path);
    g_free(path);
    return home;
}

/* The first place that holds `probe`, or else the first of which the system does not say: using it
 * gives the reason. */
static char *find(const char *executable, const char *in_repository, const char *installed,
                  const char *probe)
{
    char *home = home_of(executable), *found = NULL, *unknown = NULL;
    char *places[] = {g_strdup(in_repository),
                      g_build_filename(home, "..", "..", "..", in_repository, NULL),
                      g_build_filename(home, "..", "share", "touchstone", installed, NULL)};
    for (size_t i = 0; i < G_N_ELEMENTS(places); i++) {
        char *wanted = g_build_filename(places[i], probe, NULL);
        const enum mpm_path kind = found == NULL ? mpm_path_kind(wanted) : MPM_PATH_NONE;
        char **const place = kind == MPM_PATH_UNKNOWN ? &unknown : &found;
        if (kind != MPM_PATH_NONE && *place == NULL)
            *place = g_canonicalize_filename(places[i], NULL);
        g_free(wanted);
        g_free(places[i]);
    }
    g_free(home);
    if (found == NULL)
        return unknown;
    g_free(unknown);
    return found;
}

char *resources_catalogue(const char *executable)
{
    return find(executable, "verification/catalogue", "catalogue", ".");
}

/* `reports` is a common name for a folder: ours holds the style. */
char *resources_reports(const char *executable)
{
    return find(executable, "reports", "reports", "style.gp");
}

char *resources_benchmarks(const char *executable)
{
    return find(executable, "benchmarks", "benchmarks", "scenes");
}

char *resources_reference_data(const char *executable)
{
    return find(executable, "reference_data", "reference_data", "MANIFEST.sha256");
}

char *resources_program(const char *executable, const char *name)
{
    char *home = home_of(executable);
    char *path = g_build_filename(home, name, NULL);
    g_free(home);
    return path;
}

static bool in_repository(void)
{
    return mpm_path_is_file("Makefile") && mpm_path_is_folder("verification/catalogue");
}

char *resources_output(void)
{
    return g_strdup(in_repository() ? "build/reports/verify" : "verify-report");
}

char *resources_score_output(void)
{
    return g_strdup(in_repository() ? "build/reports/score" : "score-report");
}
