/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/case_pictures.h"

#include "mpm_file.h"
#include "verification/common/names.h"
#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/common/text.h"
#include "verification/report/picture_file.h"
#include "verification/report/picture_svg.h"
#include "verification/report/sketch_svg.h"

#include <errno.h>
#include <string.h>

static const char sketch_name[] = "picture-sketch.svg", still_name[] = "picture-state.svg",
                  motion_name[] = "picture-motion.svg", small_name[] = "picture-small.svg";

static enum mpm_status write_owned(const char *home, const char *name, char *text,
                                   struct mpm_error *error)
{
    const enum mpm_status status = output_write(home, name, text, error);
    g_free(text);
    return status;
}

/* Width and height that the picture states, so that a page does not move as it loads. */
static void add_image(GString *html, const char *name, const char *svg, const char *alt)
{
    const char *const width = strstr(svg, " width=\""), *const height = strstr(svg, " height=\"");
    if (width == NULL || height == NULL)
        return;
    text_markup(html, "<img src=\"%s\"", name);
    g_string_append_printf(html, " width=\"%.*s\" height=\"%.*s\"",
                           (int)strspn(width + 8, "0123456789"), width + 8,
                           (int)strspn(height + 9, "0123456789"), height + 9);
    text_markup(html, " alt=\"%s\" />\n", alt);
}

/* What the state shows, for readers who see it and those who do not. */
static char *state_text(const struct picture_file *file)
{
    GString *text = g_string_new(NULL);
    const size_t drawn = file->still.count, stride = file->still.stride;
    g_string_append_printf(text,
                           "The particles of variant %s, each as the domain that its "
                           "deformation gradient makes of its first rectangle.",
                           file->variant);
    if (stride > 1)
        g_string_append_printf(text,
                               " Of %zu particles %zu are drawn, one of %zu by %zu neighbours, as "
                               "large as they all.",
                               file->particles, drawn, stride, stride);
    if (file->magnify > 1)
        g_string_append_printf(text, " Displacements are drawn %.6g times as large.",
                               file->magnify);
    return g_string_free(text, FALSE);
}

static enum mpm_status add_state(const char *home, const json_t *entry,
                                 const struct picture_file *file, GString *html,
                                 struct mpm_error *error)
{
    const char *const caption = record_text(json_object_get(entry, "picture"), "caption");
    char *title = g_strdup_printf("%s: %s", record_text(entry, "case"), file->title);
    char *text = state_text(file);
    char *svg = picture_still_svg(file, title, text);
    char *alt = g_strdup_printf("%s of the deformed bodies. %s", title, caption);
    g_string_append(html, "<figure>\n");
    add_image(html, still_name, svg, alt);
    char *name = g_strdup(file->title);
    *name = g_ascii_toupper(*name);
    text_markup(html, "<figcaption><strong>%s%s.</strong> ", name,
                file->motion.frame_count > 0 ? " at the end" : "");
    g_free(name);
    text_markup(html, "%s<span class=\"about\">%s%s</span></figcaption>\n</figure>\n", caption,
                text,
                strstr(svg, "class=\"before\"") != NULL ? " Dashed: the bodies at the start." : "");
    enum mpm_status status = write_owned(home, still_name, svg, error);
    if (status == MPM_OK)
        status = write_owned(home, small_name, picture_small_svg(file, title), error);
    g_free(alt);
    g_free(text);
    g_free(title);
    return status;
}

/* In an element that a reader can close: what moves for long must be possible to stop. */
static enum mpm_status add_motion(const char *home, const json_t *entry,
                                  const struct picture_file *file, GString *html,
                                  struct mpm_error *error)
{
    if (file->motion.frame_count == 0)
        return MPM_OK;
    char *title = g_strdup_printf("%s: %s in motion", record_text(entry, "case"), file->title);
    char *text = g_strdup_printf("%zu states from the start to the end; of %zu particles %zu are "
                                 "drawn.",
                                 file->motion.frame_count, file->particles, file->motion.count);
    char *svg = picture_motion_svg(file, title, text);
    g_string_append(html, "<details class=\"motion\" open=\"open\"><summary>Motion (closing this "
                          "stops it)</summary>\n<figure>\n");
    add_image(html, motion_name, svg, title);
    text_markup(html,
                "<figcaption><span class=\"about\">%s</span></figcaption>\n</figure>"
                "</details>\n",
                text);
    const enum mpm_status status = write_owned(home, motion_name, svg, error);
    g_free(text);
    g_free(title);
    return status;
}

static enum mpm_status add_sketch(const char *home, const json_t *entry,
                                  const struct picture_file *file, GString *html,
                                  struct mpm_error *error)
{
    GString *legend = g_string_new(NULL);
    char *title = g_strdup_printf("%s: sketch of the scene", record_text(entry, "case"));
    char *svg = sketch_svg(file->scene, title, legend);
    g_string_append(html, "<figure>\n");
    add_image(html, sketch_name, svg, "Sketch of the scene; the list below has its parts");
    g_string_append_printf(
        html, "<figcaption><strong>The scene.</strong>%s</figcaption>\n</figure>\n", legend->str);
    const enum mpm_status status = write_owned(home, sketch_name, svg, error);
    g_string_free(legend, TRUE);
    g_free(title);
    return status;
}

static void add_notice(GString *html, const char *reason)
{
    text_markup(html,
                "<p class=\"notice quiet\"><strong>No picture of the scene:</strong> %s</p>\n",
                reason);
}

/* Pictures of another run must not stand for those of this one. */
static enum mpm_status remove_old(const char *home, struct mpm_error *error)
{
    const char *const names[] = {sketch_name, still_name, motion_name, small_name};
    enum mpm_status status = MPM_OK;
    for (size_t i = 0; i < G_N_ELEMENTS(names) && status == MPM_OK; i++) {
        char *path = g_build_filename(home, names[i], NULL);
        if (mpm_file_remove(path) != 0 && errno != ENOENT)
            status = mpm_file_failed(path, errno, error);
        g_free(path);
    }
    return status;
}

static enum mpm_status add_pictures(const char *home, const json_t *entry,
                                    const struct picture_file *file, GString *html,
                                    struct mpm_error *error)
{
    g_string_append(html, "<div class=\"scene\">\n");
    TRY(add_sketch(home, entry, file, html, error));
    TRY(add_state(home, entry, file, html, error));
    TRY(add_motion(home, entry, file, html, error));
    g_string_append(html, "</div>\n");
    return MPM_OK;
}

enum mpm_status case_pictures(const char *home, const json_t *entry, GString *html,
                              struct mpm_error *error)
{
    const char *const variant = record_text(json_object_get(entry, "picture"), "variant");
    const char *const reason = record_text(entry, "no_picture");
    struct picture_file file;
    struct mpm_error own = {.status = MPM_OK};
    enum mpm_status status = MPM_OK;
    TRY(remove_old(home, error));
    if (*variant == '\0') {
        if (*reason != '\0')
            add_notice(html, reason);
        return MPM_OK;
    }
    char *name = g_strdup_printf("picture-%s.json", variant);
    char *path = g_build_filename(home, name, NULL);
    if (mpm_path_kind(path) == MPM_PATH_NONE)
        own.status = failure_set(&own, MPM_BAD_INPUT,
                                 "variant %s, whose run it shows, has left none here", variant);
    if (own.status == MPM_OK)
        own.status = picture_file_read(path, &file, &own);
    if (own.status == MPM_OK) {
        status = add_pictures(home, entry, &file, html, error);
        picture_file_clear(&file);
    } else if (own.status == MPM_ENVIRONMENT_FAILED) {
        status = failure_set(error, own.status, "%s", own.message);
    } else {
        add_notice(html, own.message);
    }
    g_free(path);
    g_free(name);
    return status;
}

/* ------------------------------------------------------------------------ strip */

static void add_small(GString *html, const json_t *entry)
{
    const char *const name = record_text(entry, "case");
    text_markup(html,
                "<li><a href=\"cases/%s/index.html\"><img src=\"cases/%s/%s\" width=\"240\" "
                "height=\"150\" alt=\"Its deformed bodies\" /><span>",
                name, name, small_name);
    text_markup(html, "<b>%s</b> %s</span></a></li>\n", name, record_text(entry, "title"));
}

void case_pictures_strip(GString *html, const struct records *records, const char *folder)
{
    const json_t *const cases = json_object_get(records->run, "cases");
    GString *list = g_string_new(NULL);
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *const entry = json_array_get(cases, i);
        const json_t *const picture = json_object_get(entry, "picture");
        char *file = g_strdup_printf("picture-%s.json", record_text(picture, "variant"));
        char *path = g_build_filename(folder, "cases", record_text(entry, "case"), file, NULL);
        if (json_is_true(json_object_get(picture, "strip")) && mpm_path_kind(path) != MPM_PATH_NONE)
            add_small(list, entry);
        g_free(path);
        g_free(file);
    }
    if (list->len > 0)
        g_string_append_printf(
            html, "<ul class=\"strip\" aria-label=\"Pictures of cases\">\n%s</ul>\n", list->str);
    g_string_free(list, TRUE);
}
