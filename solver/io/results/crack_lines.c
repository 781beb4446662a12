/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/crack_lines.h"

#include "io/results/series.h"
#include "mpm_file.h"

#include <errno.h>
#include <glib.h>
#include <string.h>

char *mpm_crack_lines_name(size_t number)
{
    return g_strdup_printf(MPM_CRACKS_PREFIX "%0*zu" MPM_CRACKS_SUFFIX, MPM_SERIES_DIGITS, number);
}

static void append_number(GString *text, double value)
{
    char digits[G_ASCII_DTOSTR_BUF_SIZE];
    g_string_append(text, g_ascii_formatd(digits, sizeof digits, "%.17g", value));
}

static void begin_array(GString *text, const char *type, const char *name, int components)
{
    g_string_append_printf(text,
                           "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" "
                           "format=\"ascii\">\n",
                           type, name, components);
}

static void append_points(GString *text, const struct mpm_simulation *simulation, size_t count)
{
    g_string_append(text, "<Points>\n");
    begin_array(text, "Float64", "Points", 3);
    for (size_t k = 0; k < count; k++) {
        const struct mpm_crack_point point = mpm_simulation_crack_point(simulation, k);
        append_number(text, point.position[0]);
        g_string_append_c(text, ' ');
        append_number(text, point.position[1]);
        g_string_append(text, " 0\n");
    }
    g_string_append(text, "</DataArray>\n</Points>\n");
}

/* Points follow each other crack by crack: a line ends where the next one's begin. */
static void append_lines(GString *text, const struct mpm_simulation *simulation, size_t count)
{
    GString *const ends = g_string_new(NULL), *const cracks = g_string_new(NULL);
    begin_array(text, "Int64", "connectivity", 1);
    for (size_t k = 0; k < count; k++) {
        const size_t crack = mpm_simulation_crack_point(simulation, k).crack;
        g_string_append_printf(text, "%zu\n", k);
        if (k + 1 == count || mpm_simulation_crack_point(simulation, k + 1).crack != crack) {
            g_string_append_printf(ends, "%zu\n", k + 1);
            g_string_append_printf(cracks, "%zu\n", crack);
        }
    }
    g_string_append(text, "</DataArray>\n");
    begin_array(text, "Int64", "offsets", 1);
    g_string_append_printf(text, "%s</DataArray>\n</Lines>\n<CellData>\n", ends->str);
    begin_array(text, "Int64", "crack", 1);
    g_string_append_printf(text, "%s</DataArray>\n</CellData>\n", cracks->str);
    g_string_free(ends, TRUE);
    g_string_free(cracks, TRUE);
}

static GString *text_of(const struct mpm_scene *scene, const struct mpm_simulation *simulation)
{
    const size_t count = mpm_simulation_crack_point_count(simulation);
    GString *const text = g_string_new("<?xml version=\"1.0\"?>\n"
                                       "<VTKFile type=\"PolyData\" version=\"0.1\">\n"
                                       "<PolyData>\n<FieldData>\n"
                                       "<DataArray type=\"Float64\" Name=\"TimeValue\" "
                                       "NumberOfTuples=\"1\" format=\"ascii\">\n");
    append_number(text, mpm_simulation_time(simulation));
    g_string_append_printf(text,
                           "\n</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"%zu\" "
                           "NumberOfVerts=\"0\" NumberOfLines=\"%zu\" NumberOfStrips=\"0\" "
                           "NumberOfPolys=\"0\">\n",
                           count, scene->crack_count);
    append_points(text, simulation, count);
    g_string_append(text, "<Lines>\n");
    append_lines(text, simulation, count);
    g_string_append(text, "</Piece>\n</PolyData>\n</VTKFile>\n");
    return text;
}

enum mpm_status mpm_crack_lines_write(const char *folder, size_t number,
                                      const struct mpm_scene *scene,
                                      const struct mpm_simulation *simulation,
                                      struct mpm_error *error)
{
    if (scene->crack_count == 0)
        return MPM_OK;
    char *const name = mpm_crack_lines_name(number);
    char *const path = g_build_filename(folder, name, NULL);
    GString *const text = text_of(scene, simulation);
    const enum mpm_status status = mpm_file_save(path, text->str, text->len) == 0
                                       ? MPM_OK
                                       : mpm_file_failed(path, errno, error);
    g_string_free(text, TRUE);
    g_free(path);
    g_free(name);
    return status;
}
