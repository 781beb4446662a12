/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/run_record.h"

#include "io/results/file_write.h"
#include "io/results/provenance.h"
#include "mpm_file.h"

#include <glib.h>
#include <jansson.h>
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
    char *const cpus = mpm_file_load("/proc/cpuinfo", NULL);
    if (cpus != NULL) {
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
    json_object_set_new(object, "threads",
                        json_integer(mpm_simulation_threads(record->simulation)));
    return object;
}

static json_t *seconds_object(const struct mpm_run_record *record)
{
    struct mpm_phases phases;
    mpm_simulation_phases(record->simulation, &phases);
    json_t *object = json_pack("{s:f, s:f, s:f, s:f}", "setup", record->seconds_setup, "step",
                               record->seconds_step, "output", record->seconds_output, "checkpoint",
                               record->seconds_checkpoint);
    for (size_t i = 0; i < phases.count; i++)
        json_object_set_new(object, phases.name[i], json_real(phases.seconds[i]));
    return object;
}

static json_t *counters_object(const struct mpm_run_record *record)
{
    const json_int_t steps = (json_int_t)mpm_simulation_step(record->simulation);
    const json_int_t particles = (json_int_t)mpm_simulation_particle_count(record->simulation);
    const size_t bytes = mpm_simulation_bytes(record->simulation) + record->output_bytes;
    const double per_particle = particles > 0 ? (double)bytes / (double)particles : 0.0;
    return json_pack("{s:I, s:I, s:I, s:o, s:{s:I, s:f}, s:{s:I, s:I}}", "steps", steps,
                     "particles", particles, "particle_steps", steps * particles, "seconds",
                     seconds_object(record), "bytes", "total", (json_int_t)bytes, "per_particle",
                     per_particle, "checkpoints", "written", (json_int_t)record->checkpoints,
                     "bytes", (json_int_t)record->checkpoint_bytes);
}

static json_t *cause_text(enum mpm_cause cause)
{
    return cause == MPM_CAUSE_NONE ? json_null() : json_string(mpm_cause_describe(cause)->name);
}

static json_t *warnings_array(const struct mpm_scene *scene, const struct mpm_run_record *record)
{
    const char *const given[] = {mpm_simulation_advice(record->simulation),
                                 record->older_warning,
                                 record->build_warning,
                                 record->growth_warning,
                                 record->parted_warning,
                                 record->melted_warning};
    json_t *array = json_array();
    for (size_t k = 0; k < sizeof given / sizeof given[0]; k++)
        if (given[k][0] != '\0')
            json_array_append_new(array, text(given[k]));
    for (size_t k = 0; k < mpm_scene_j_integral_count(scene); k++) {
        struct mpm_tip_end end;
        char message[MPM_MESSAGE_SIZE];
        if (mpm_simulation_tip_end(record->simulation, k, &end, message))
            json_array_append_new(array, text(message));
    }
    return array;
}

static json_t *tips_array(const struct mpm_scene *scene, const struct mpm_run_record *record)
{
    static const char *const reasons[] = {
        [MPM_TIP_GOES_ON] = "",
        [MPM_TIP_MEETS_CRACK] = "meets_crack",
        [MPM_TIP_CONTOUR_MEETS_CRACK] = "contour_meets_crack",
    };
    json_t *array = json_array();
    for (size_t k = 0; k < mpm_scene_j_integral_count(scene); k++) {
        struct mpm_tip_end end;
        char message[MPM_MESSAGE_SIZE];
        if (mpm_simulation_tip_end(record->simulation, k, &end, message))
            json_array_append_new(array, json_pack("{s:s, s:s, s:I, s:I, s:f, s:[f, f]}",
                                                   "integral", scene->j_integrals[k].key, "reason",
                                                   reasons[end.reason], "met", (json_int_t)end.met,
                                                   "step", (json_int_t)end.step, "time", end.time,
                                                   "place", end.place[0], end.place[1]));
    }
    return array;
}

static json_t *growth_object(const struct mpm_run_record *record)
{
    struct mpm_energy_growth growth;
    if (!mpm_simulation_energy_growth(record->simulation, &growth))
        return json_null();
    return json_pack("{s:I, s:f, s:f, s:f}", "step", (json_int_t)growth.step, "time", growth.time,
                     "largest_factor", growth.largest, "last_factor", growth.factor);
}

/* Null in a run that was never interrupted. */
static json_t *resumed_object(const struct mpm_run_record *record)
{
    if (record->resumes == 0)
        return json_null();
    return json_pack("{s:I, s:I}", "times", (json_int_t)record->resumes, "last_step",
                     (json_int_t)record->resumed_step);
}

static const char *outcome(enum mpm_status status)
{
    return status == MPM_OK ? "done" : status == MPM_INTERRUPTED ? "interrupted" : "failed";
}

enum mpm_status mpm_run_record_write(const char *folder, const struct mpm_scene *scene,
                                     const struct mpm_run_record *record, struct mpm_error *error)
{
    json_t *root = json_pack(
        "{s:s, s:o, s:o, s:i, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "outcome",
        outcome(record->status), "cause", cause_text(record->cause), "reason", text(record->reason),
        "exit_status", (int)record->status + record->signal, "resumed", resumed_object(record),
        "warnings", warnings_array(scene, record), "energy_growth", growth_object(record),
        "ended_tips", tips_array(scene, record), "counters", counters_object(record), "kernels",
        text(mpm_simulation_kernels(record->simulation)), "simd",
        text(mpm_simulation_simd(record->simulation)), "provenance",
        provenance_object(scene, record));
    const enum mpm_status status = mpm_file_write_json(folder, MPM_RUN_RECORD_NAME, root, 2, error);
    json_decref(root);
    return status;
}
