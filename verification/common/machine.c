/* Facts of the machine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/machine.h"

#include "mpm.h"
#include "mpm_file.h"

#include <cmark-gfm.h>
#include <glib.h>
#include <gsl/gsl_version.h>
#include <string.h>
#include <sys/utsname.h>

static char *value_after(const char *text, const char *key)
{
    const char *found = strstr(text, key);
    const char *colon = found == NULL ? NULL : strchr(found, ':');
    if (colon == NULL)
        return NULL;
    char *value = g_strndup(colon + 1, strcspn(colon, "\n") - 1);
    return g_strstrip(value);
}

char *machine_processor(void)
{
    char *text = mpm_file_load("/proc/cpuinfo", NULL), *name = NULL;
    if (text != NULL)
        name = value_after(text, "model name");
    g_free(text);
    struct utsname system;
    if (name == NULL)
        name = g_strdup(uname(&system) == 0 ? system.machine : "unknown");
    return name;
}

unsigned machine_processor_count(void)
{
    return MAX(1, g_get_num_processors());
}

char *machine_gnuplot(void)
{
    char *command[] = {"gnuplot", "--version", NULL};
    char *said = NULL;
    const gboolean ran =
        g_spawn_sync(NULL, command, NULL, G_SPAWN_SEARCH_PATH | G_SPAWN_STDERR_TO_DEV_NULL, NULL,
                     NULL, &said, NULL, NULL, NULL);
    if (ran && said != NULL && *said != '\0') {
        said[strcspn(said, "\n")] = '\0';
        return said;
    }
    g_free(said);
    return g_strdup("not found");
}

char *machine_libraries(void)
{
    return g_strdup_printf("%s, GSL %s, cmark-gfm %s", mpm_build_info()->libraries, gsl_version,
                           cmark_version_string());
}
