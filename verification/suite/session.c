/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/session.h"

#include "verification/report/api_pages.h"
#include "verification/suite/schedule.h"
#include "verification/suite/task_key.h"

/* Said before anything runs: the run is to be compared with another one's results. */
static enum mpm_status check_baseline(const struct run_options *options, struct mpm_error *error)
{
    struct records baseline;
    if (options->texts.baseline == NULL)
        return MPM_OK;
    char *output = g_canonicalize_filename(options->output, NULL);
    const bool same = g_strcmp0(options->texts.baseline, output) == 0;
    g_free(output);
    if (same)
        return failure_set(error, MPM_BAD_INPUT,
                           "--baseline %s: is the output folder, whose results this run replaces",
                           options->texts.baseline);
    TRY(records_read(options->texts.baseline, &baseline, error));
    records_clear(&baseline);
    return MPM_OK;
}

static enum mpm_status make_plan(struct session *session, struct mpm_error *error)
{
    const struct run_options *options = session->options;
    TRY(plan_make(session->catalogue, &options->selection, &session->plan, error));
    enum mpm_status status = plan_check_methods(&session->plan, error);
    if (status == MPM_OK)
        status =
            task_keys(session->catalogue, &session->plan, options->kernels, &session->keys, error);
    if (status != MPM_OK)
        plan_clear(&session->plan);
    return status;
}

enum mpm_status session_open(const struct run_options *options, struct program_table programs,
                             struct console *console, struct session *session,
                             struct mpm_error *error)
{
    *session =
        (struct session){.options = options, .console = console, .start = g_get_monotonic_time()};
    TRY(check_baseline(options, error));
    if (options->texts.api != NULL)
        TRY(api_pages_check(options->texts.api, error));
    TRY(catalogue_read(options->texts.catalogue, programs, &session->catalogue, error));
    const enum mpm_status status = make_plan(session, error);
    if (status != MPM_OK) {
        catalogue_free(session->catalogue);
        return status;
    }
    session->results = g_new0(struct job_result, session->plan.job_count);
    session->output = output_names(options->output);
    session->place = (struct kept_place){session->output.results, session->output.stage};
    for (size_t i = 0; i < session->plan.job_count; i++)
        session->plan.jobs[i].unfinished =
            g_build_filename(session->output.state, "unfinished", session->keys[i], NULL);
    return MPM_OK;
}

void session_close(struct session *session)
{
    schedule_clear(session->results, session->plan.job_count);
    g_free(session->results);
    g_strfreev(session->keys);
    output_close(&session->output);
    plan_clear(&session->plan);
    catalogue_free(session->catalogue);
}

enum mpm_status session_take_folder(struct session *session, struct mpm_error *error)
{
    const struct run_options *options = session->options;
    output_close(&session->output);
    TRY(output_open(options->output, &session->output, error));
    session->place = (struct kept_place){session->output.results, session->output.stage};
    if (options->resumed == NULL)
        return run_state_begin(&session->output, &options->texts, options->command, error);
    return MPM_OK;
}

bool session_has(const struct session *session, size_t job)
{
    const struct kept_place nowhere = {session->output.results, NULL};
    struct job_result result = {.rows = NULL};
    enum kept_state state;
    const enum mpm_status status =
        kept_read(&nowhere, session->keys[job], &session->plan.jobs[job], &result, &state, NULL);
    g_free(result.rows);
    return status == MPM_OK && state == KEPT_SOUND;
}

void session_expect_costs(const struct session *session)
{
    struct records records;
    struct mpm_error none;
    if (records_read(session->options->output, &records, &none) != MPM_OK)
        return;
    if (records.measurements != NULL)
        console_expect(session->console, records.measurements);
    records_clear(&records);
}

enum mpm_status session_take_kept(const struct session *session, struct mpm_error *error)
{
    const struct plan *plan = &session->plan;
    for (size_t i = 0; i < plan->job_count; i++) {
        enum kept_state state;
        TRY(kept_read(&session->place, session->keys[i], &plan->jobs[i], &session->results[i],
                      &state, error));
        if (state == KEPT_SOUND)
            console_finished(session->console, i, &session->results[i]);
        else if (state == KEPT_DAMAGED)
            console_say(session->console, "%s/%s.json is damaged: its program runs again",
                        session->place.results, session->keys[i]);
    }
    return MPM_OK;
}
