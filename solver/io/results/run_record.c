/* run.json: how a run ended, what it cost and where it comes from.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/run_record.h"

#include "io/results/provenance.h"

#include <glib.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>

/* Text that is not UTF-8 (a file name may be anything) is written with the wrong
 * bytes replaced: JSON has no other way. */
static json_t *text(const char *bytes)
{
    char *valid = g_utf8_make_valid(bytes, -1);
    json_t *string = json_string(valid);
    g_free(valid);
    return string;
}

/* "model name" of Linux, the machine's kind elsewhere. */
static char *processor_name(void)
{
    char *name = NULL;
    char *cpus = NULL;
    if (g_file_get_contents("/proc/cpuinfo", &cpus, NULL, NULL)) {
        const char *line = strstr(cpus, "model name");
        const char *colon = line != NULL ? strchr(line, ':') : NULL;
        if (colon != NULL)
            name = g_strstrip(g_strndup(colon + 1, strcspn(colon + 1, "\n")));
    }
    g_free(cpus);
    struct utsname machine;
    if (name == NULL)
        name = g_strdup(uname(&machine) == 0 ? machine.machine : "unknown");
    return name;
}

static json_t *provenance_object(const struct mpm_scene *scene, const struct mpm_run_record *record)
{
    struct mpm_provenance provenance;
    mpm_provenance_fill(scene, &provenance);
    json_t *object = json_object();
    const char *path = record->scene_path != NULL ? record->scene_path : scene->path;
    json_object_set_new(object, "scene", text(path != NULL ? path : ""));
    json_t *settings = json_array();
    for (size_t i = 0; i < scene->setting_count; i++)
        json_array_append_new(settings, text(scene->settings[i]));
    json_object_set_new(object, "settings", settings);
    for (size_t i = 0; i < MPM_FACT_COUNT; i++)
        json_object_set_new(object, provenance.facts[i].name, text(provenance.facts[i].text));
    char *processor = processor_name();
    json_object_set_new(object, "processor", text(processor));
    g_free(processor);
    json_object_set_new(object, "threads", json_integer(record->threads));
    return object;
}

static json_t *seconds_object(const struct mpm_run_record *record)
{
    json_t *object = json_pack("{s:f, s:f, s:f}", "setup", record->seconds_setup, "step",
                               record->seconds_step, "output", record->seconds_output);
    for (size_t i = 0; i < record->phases.count; i++)
        json_object_set_new(object, record->phases.name[i], json_real(record->phases.seconds[i]));
    return object;
}

static json_t *counters_object(const struct mpm_run_record *record)
{
    const json_int_t steps = (json_int_t)record->steps;
    const json_int_t particles = (json_int_t)record->particles;
    const double per_particle =
        record->particles > 0 ? (double)record->bytes / (double)record->particles : 0.0;
    return json_pack("{s:I, s:I, s:I, s:o, s:{s:I, s:f}}", "steps", steps, "particles", particles,
                     "particle_steps", steps * particles, "seconds", seconds_object(record),
                     "bytes", "total", (json_int_t)record->bytes, "per_particle", per_particle);
}

static json_t *cause_text(enum mpm_cause cause)
{
    return cause == MPM_CAUSE_NONE ? json_null() : json_string(mpm_cause_describe(cause)->name);
}

static json_t *warnings_array(const struct mpm_run_record *record)
{
    json_t *array = json_array();
    for (size_t i = 0; i < G_N_ELEMENTS(record->warnings); i++)
        if (record->warnings[i] != NULL)
            json_array_append_new(array, text(record->warnings[i]));
    return array;
}

static json_t *growth_object(const struct mpm_energy_growth *growth)
{
    if (!growth->seen)
        return json_null();
    return json_pack("{s:I, s:f, s:f, s:f}", "step", (json_int_t)growth->step, "time", growth->time,
                     "largest_factor", growth->largest, "last_factor", growth->factor);
}

enum mpm_status mpm_run_record_write(const char *folder, const struct mpm_scene *scene,
                                     const struct mpm_run_record *record, struct mpm_error *error)
{
    json_t *root =
        json_pack("{s:s, s:o, s:o, s:i, s:o, s:o, s:o, s:o, s:o, s:o}", "outcome",
                  record->status == MPM_OK ? "done" : "failed", "cause", cause_text(record->cause),
                  "reason", text(record->reason), "exit_status", (int)record->status, "warnings",
                  warnings_array(record), "energy_growth", growth_object(&record->growth),
                  "counters", counters_object(record), "kernels", text(record->kernels), "simd",
                  text(record->simd), "provenance", provenance_object(scene, record));
    char *written = root != NULL ? json_dumps(root, JSON_INDENT(2)) : NULL;
    json_decref(root);
    if (written == NULL)
        return mpm_error_memory(error, 0, MPM_RUN_RECORD_NAME);
    char *path = g_build_filename(folder, MPM_RUN_RECORD_NAME, NULL);
    GError *failure = NULL;
    enum mpm_status status = MPM_OK;
    if (!g_file_set_contents(path, written, -1, &failure))
        status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s", failure->message);
    g_clear_error(&failure);
    g_free(path);
    free(written);
    return status;
}
