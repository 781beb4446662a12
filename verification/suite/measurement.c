/* One run of a measuring program: what it may read and report.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/measurement.h"

#include "mpm_file.h"
#include "verification/common/names.h"
#include "verification/common/output.h"
#include "verification/common/rows.h"
#include "verification/suite/picture_take.h"

#include <errno.h>
#include <glib.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

struct measurement {
    struct measurement_setup setup;
    uint64_t particle_steps;
    bool skipped;
    int write_error; /* errno of the first row that could not be written */
};

/* ----------------------------------------------------------------- reading */

const char *measurement_case(const struct measurement *measurement)
{
    return measurement->setup.entry->file->name;
}

const char *measurement_variant(const struct measurement *measurement)
{
    return measurement->setup.variant->name;
}

const struct mpm_simulation_options *measurement_options(const struct measurement *measurement)
{
    return &measurement->setup.simulation;
}

const char *measurement_unfinished(const struct measurement *measurement)
{
    return measurement->setup.unfinished;
}

static const char *find(const struct case_parameter *parameters, unsigned count, const char *name)
{
    for (unsigned i = 0; i < count; i++)
        if (strcmp(parameters[i].name, name) == 0)
            return parameters[i].value;
    return NULL;
}

static const char *parameter(const struct measurement *measurement, const char *name)
{
    const struct case_variant *variant = measurement->setup.variant;
    const struct case_file *file = measurement->setup.entry->file;
    const char *own = find(variant->parameters, variant->parameters_count, name);
    return own != NULL ? own : find(file->parameters, file->parameters_count, name);
}

bool measurement_has(const struct measurement *measurement, const char *name)
{
    return parameter(measurement, name) != NULL;
}

enum mpm_status measurement_text(const struct measurement *measurement, const char *name,
                                 const char **value, struct mpm_error *error)
{
    *value = parameter(measurement, name);
    if (*value != NULL)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "case %s, variant %s: parameter \"%s\" is missing",
                       measurement_case(measurement), measurement_variant(measurement), name);
}

enum mpm_status measurement_number(const struct measurement *measurement, const char *name,
                                   double *value, struct mpm_error *error)
{
    const char *text;
    TRY(measurement_text(measurement, name, &text, error));
    if (row_number(text, value) && isfinite(*value))
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT,
                       "case %s, variant %s: parameter \"%s\": \"%s\" is not a finite number",
                       measurement_case(measurement), measurement_variant(measurement), name, text);
}

enum mpm_status measurement_numbers(const struct measurement *measurement,
                                    const struct measurement_parameter *table, size_t count,
                                    struct mpm_error *error)
{
    for (size_t k = 0; k < count; k++)
        TRY(measurement_number(measurement, table[k].name, table[k].value, error));
    return MPM_OK;
}

enum mpm_status measurement_count(const struct measurement *measurement, const char *name,
                                  unsigned low, unsigned high, unsigned *value,
                                  struct mpm_error *error)
{
    double number;
    TRY(measurement_number(measurement, name, &number, error));
    if (number >= low && number <= high && number <= floor(number)) {
        *value = (unsigned)number;
        return MPM_OK;
    }
    return failure_set(error, MPM_BAD_INPUT,
                       "case %s, variant %s: parameter \"%s\" is %g; allowed: whole numbers from "
                       "%u to %u",
                       measurement_case(measurement), measurement_variant(measurement), name,
                       number, low, high);
}

enum mpm_status measurement_list(const struct measurement *measurement, const char *name,
                                 size_t most, double *values, size_t *count,
                                 struct mpm_error *error)
{
    const char *text;
    TRY(measurement_text(measurement, name, &text, error));
    char **const words = g_strsplit(text, " ", -1);
    bool good = true;
    *count = 0;
    for (char **word = words; good && *word != NULL; word++)
        if (**word != '\0') {
            good = *count < most && row_number(*word, &values[*count]) && isfinite(values[*count]);
            *count += good;
        }
    g_strfreev(words);
    if (good && *count > 0)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT,
                       "case %s, variant %s: parameter \"%s\": \"%s\"; allowed: 1 to %zu numbers",
                       measurement_case(measurement), measurement_variant(measurement), name, text,
                       most);
}

static enum mpm_status refuse_choice(const struct measurement *measurement, const char *name,
                                     const char *text, const char *const *names, size_t count,
                                     struct mpm_error *error)
{
    GString *const allowed = g_string_new(NULL);
    for (size_t k = 0; k < count; k++)
        g_string_append_printf(allowed, "%s%s", k == 0 ? "" : ", ", names[k]);
    const enum mpm_status status = failure_set(
        error, MPM_BAD_INPUT, "case %s, variant %s: parameter \"%s\" is \"%s\"; allowed: %s",
        measurement_case(measurement), measurement_variant(measurement), name, text, allowed->str);
    g_string_free(allowed, TRUE);
    return status;
}

enum mpm_status measurement_choice(const struct measurement *measurement, const char *name,
                                   const char *const *names, size_t count, size_t *place,
                                   struct mpm_error *error)
{
    const char *text;
    TRY(measurement_text(measurement, name, &text, error));
    for (*place = 0; *place < count; (*place)++)
        if (strcmp(names[*place], text) == 0)
            return MPM_OK;
    return refuse_choice(measurement, name, text, names, count, error);
}

enum mpm_status measurement_geometry(const struct measurement *measurement,
                                     enum mpm_geometry *geometry, struct mpm_error *error)
{
    static const char *const names[] = {[MPM_PLANE_STRAIN] = "plane_strain",
                                        [MPM_PLANE_STRESS] = "plane_stress",
                                        [MPM_AXISYMMETRIC] = "axisymmetric"};
    size_t place;
    TRY(measurement_choice(measurement, "geometry", names, G_N_ELEMENTS(names), &place, error));
    *geometry = (enum mpm_geometry)place;
    return MPM_OK;
}

static enum mpm_status read_scene(const struct measurement *measurement, const char *path,
                                  const char *const *settings, size_t setting_count,
                                  struct mpm_scene **scene, struct mpm_error *error)
{
    const struct case_variant *variant = measurement->setup.variant;
    GPtrArray *all = g_ptr_array_new();
    for (unsigned i = 0; i < variant->settings_count; i++)
        g_ptr_array_add(all, variant->settings[i]);
    for (size_t i = 0; i < setting_count; i++)
        g_ptr_array_add(all, (void *)(uintptr_t)settings[i]);
    const enum mpm_status status =
        mpm_scene_read(path, (const char *const *)all->pdata, all->len, scene, error);
    g_ptr_array_unref(all);
    return status;
}

enum mpm_status measurement_scene(const struct measurement *measurement,
                                  const char *const *settings, size_t setting_count,
                                  struct mpm_scene **scene, struct mpm_error *error)
{
    *scene = NULL;
    char *path = catalogue_scene_path(measurement->setup.entry, measurement->setup.variant);
    if (path == NULL)
        return failure_set(error, MPM_BAD_INPUT, "case %s names no scene",
                           measurement_case(measurement));
    const enum mpm_status status =
        read_scene(measurement, path, settings, setting_count, scene, error);
    g_free(path);
    return status;
}

enum mpm_status measurement_scene_file(const struct measurement *measurement, const char *file,
                                       const char *const *settings, size_t setting_count,
                                       struct mpm_scene **scene, struct mpm_error *error)
{
    char *path = g_build_filename(measurement->setup.entry->folder, file, NULL);
    const enum mpm_status status =
        read_scene(measurement, path, settings, setting_count, scene, error);
    g_free(path);
    return status;
}

/* --------------------------------------------------------------- reporting */

static void send_line(struct measurement *measurement, char *line)
{
    const size_t length = strlen(line);
    if (measurement->write_error == 0 && mpm_file_write(measurement->setup.rows, line, length) != 0)
        measurement->write_error = errno;
    g_free(line);
}

static void send_formatted(struct measurement *measurement, enum row_kind kind, const char *name,
                           const char *format, va_list arguments)
    __attribute__((format(printf, 4, 0)));

static void send_formatted(struct measurement *measurement, enum row_kind kind, const char *name,
                           const char *format, va_list arguments)
{
    char *text = g_strdup_vprintf(format, arguments);
    send_line(measurement, row_line(kind, name, text));
    g_free(text);
}

void measurement_report(struct measurement *measurement, const char *quantity, double value)
{
    send_line(measurement, row_line_value(quantity, value));
}

void measurement_inconclusive(struct measurement *measurement, const char *quantity,
                              const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    send_formatted(measurement, ROW_INCONCLUSIVE, quantity, format, arguments);
    va_end(arguments);
}

void measurement_skip(struct measurement *measurement, const char *format, ...)
{
    va_list arguments;
    measurement->skipped = true;
    va_start(arguments, format);
    send_formatted(measurement, ROW_SKIP, "", format, arguments);
    va_end(arguments);
}

void measurement_note(struct measurement *measurement, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    send_formatted(measurement, ROW_NOTE, "", format, arguments);
    va_end(arguments);
}

void measurement_work(struct measurement *measurement, uint64_t particle_steps)
{
    measurement->particle_steps += particle_steps;
}

double measurement_processor_seconds(void)
{
    struct timespec now = {0, 0};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static char *table_text(const char *columns, size_t column_count, size_t rows, const double *values)
{
    GString *text = g_string_new(NULL);
    g_string_append_printf(text, "# %s\n", columns);
    for (size_t i = 0; i < rows * column_count; i++) {
        char number[G_ASCII_DTOSTR_BUF_SIZE];
        g_string_append(text, g_ascii_formatd(number, sizeof number, "%.17g", values[i]));
        g_string_append_c(text, (i + 1) % column_count == 0 ? '\n' : ' ');
    }
    return g_string_free(text, FALSE);
}

enum mpm_status measurement_series(struct measurement *measurement, const char *name,
                                   const char *columns, size_t column_count, size_t rows,
                                   const double *values, struct mpm_error *error)
{
    if (!name_is_plain(name) || column_count == 0)
        return failure_set(error, MPM_BAD_INPUT,
                           "series \"%s\": allowed are letters, digits, '_' and '-', and at least "
                           "one column",
                           name);
    char *file_name = g_strdup_printf("data-%s-%s.dat", measurement_variant(measurement), name);
    char *text = table_text(columns, column_count, rows, values);
    const enum mpm_status status =
        output_write(measurement->setup.data_folder, file_name, text, error);
    if (status == MPM_OK)
        send_line(measurement, row_line(ROW_SERIES, file_name, ""));
    g_free(text);
    g_free(file_name);
    return status;
}

/* ----------------------------------------------------------------- running */

/* The most memory that this process has had, in bytes (getrusage has units of 1024 on Linux). */
static double most_memory(void)
{
    struct rusage usage;
#ifdef __APPLE__
    const double unit = 1;
#else
    const double unit = 1024;
#endif
    return getrusage(RUSAGE_SELF, &usage) == 0 ? unit * (double)usage.ru_maxrss : 0;
}

static void send_number(struct measurement *measurement, enum row_kind kind, const char *format,
                        double number)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(text, sizeof text, format, number);
    send_line(measurement, row_line(kind, "", text));
}

/* Runs the program, and writes what the taker, if there is one, has seen of it. */
static enum mpm_status run_program(struct measurement *measurement, struct picture_taker *taker,
                                   struct mpm_error *error)
{
    TRY(measurement->setup.entry->program->run(measurement, error));
    if (taker == NULL || measurement->skipped)
        return MPM_OK;
    TRY(picture_taker_write(taker, measurement->setup.data_folder, error));
    char *name = picture_file_name(measurement_variant(measurement));
    send_line(measurement, row_line(ROW_SERIES, name, ""));
    g_free(name);
    return MPM_OK;
}

enum mpm_status measurement_run(const struct measurement_setup *setup, struct mpm_error *error)
{
    struct measurement measurement = {.setup = *setup};
    struct picture_taker *taker = picture_taker_new(setup->entry, setup->variant);
    measurement.setup.simulation.monitor = picture_taker_monitor(taker);
    enum mpm_status status = run_program(&measurement, taker, error);
    picture_taker_free(taker);
    if (status != MPM_OK)
        send_line(&measurement, row_line(ROW_FAILURE, "", error->message));
    char *work = g_strdup_printf("%" G_GUINT64_FORMAT, (guint64)measurement.particle_steps);
    send_line(&measurement, row_line(ROW_WORK, "", work));
    g_free(work);
    send_number(&measurement, ROW_PROCESSOR, "%.3f", measurement_processor_seconds());
    send_number(&measurement, ROW_MEMORY, "%.0f", most_memory());
    send_line(&measurement, row_line(ROW_END, "", ""));
    if (status == MPM_OK && measurement.write_error != 0)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED,
                             "%s/rows-%s.jsonl: cannot be written: %s", setup->data_folder,
                             setup->variant->name, g_strerror(measurement.write_error));
    return status;
}
