/* Facts compiled into the binary: what built it and from what.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm.h"

#include "build_facts.h"
#include "method/fast/fast.h"

#include <glib.h>
#include <hdf5.h>
#include <jansson.h>
#include <muParserDLL.h>
#include <string.h>
#include <yaml.h>

#if defined __clang__
#define COMPILER                                                                                   \
    "clang " G_STRINGIFY(__clang_major__) "." G_STRINGIFY(__clang_minor__) "." G_STRINGIFY(        \
        __clang_patchlevel__)
#elif defined __GNUC__
#define COMPILER                                                                                   \
    "gcc " G_STRINGIFY(__GNUC__) "." G_STRINGIFY(__GNUC_MINOR__) "." G_STRINGIFY(                  \
        __GNUC_PATCHLEVEL__)
#else
#define COMPILER "unknown"
#endif

/* "2.3.3" of "2.3.3 (Release)"; the library has it only through a parser. */
static char *muparser_version(void)
{
    const muParserHandle_t parser = mupCreate(muBASETYPE_FLOAT);
    if (parser == NULL)
        return g_strdup("unknown");
    char *version = g_strdup(mupGetVersion(parser));
    mupRelease(parser);
    version[strcspn(version, " ")] = '\0';
    return version;
}

/* Versions of the libraries that the program runs with, not of their headers. */
static char *library_versions(void)
{
    unsigned major = 0, minor = 0, release = 0;
    (void)H5get_libversion(&major, &minor, &release);
    char *muparser = muparser_version();
    char *text = g_strdup_printf("HDF5 %u.%u.%u, libyaml %s, muParser %s, "
                                 "GLib %u.%u.%u, jansson %s",
                                 major, minor, release, yaml_get_version_string(), muparser,
                                 glib_major_version, glib_minor_version, glib_micro_version,
                                 jansson_version_str());
    g_free(muparser);
    return text;
}

const struct mpm_build_info *mpm_build_info(void)
{
    static struct mpm_build_info info = {
        .version = BUILD_VERSION,
        .revision = BUILD_REVISION,
        .compiler = COMPILER,
        .flags = BUILD_FLAGS,
    };
    static gsize ready = 0;
    if (g_once_init_enter(&ready)) {
        info.libraries = library_versions();
        info.simd = mpm_simd_name(mpm_fast_widest());
        g_once_init_leave(&ready, 1);
    }
    return &info;
}
