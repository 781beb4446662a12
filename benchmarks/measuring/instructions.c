/* Instructions of a scene's steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/measuring/instructions.h"

#include "mpm_file.h"
#include "verification/common/failure.h"
#include "verification/common/input.h"

#include <errno.h>
#include <glib.h>
#include <jansson.h>
#include <stdarg.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* Names in the scratch folder. */
#define PROGRAM "mpm"
#define SCENE   "scene.yaml"
#define RESULTS "results"
#define COUNTS  "callgrind.out"

double instructions_rate(const struct instructions *counted)
{
    return (double)counted->counts.instructions / (double)counted->particle_steps;
}

double instructions_branch_rate(const struct instructions *counted)
{
    return (double)counted->counts.branches / (double)counted->particle_steps;
}

static char *find_valgrind(struct mpm_error *error)
{
    char *path = g_find_program_in_path("valgrind");
    if (path == NULL)
        (void)failure_set(error, MPM_ENVIRONMENT_FAILED,
                          "instructions cannot be counted: valgrind is not found in PATH "
                          "(`make deps` installs it)");
    return path;
}

enum mpm_status instructions_available(struct mpm_error *error)
{
    char *path = find_valgrind(error);
    const enum mpm_status status = path != NULL ? MPM_OK : MPM_ENVIRONMENT_FAILED;
    g_free(path);
    return status;
}

/* ------------------------------------------------------ reading the run record */

static enum mpm_status read_record(const char *folder, struct instructions *counted,
                                   struct mpm_error *error)
{
    char *path = g_build_filename(folder, RESULTS, "run.json", NULL);
    json_error_t failure = {.text = ""};
    json_int_t steps = 0, particles = 0, particle_steps = 0, bytes = 0;
    const char *kernels = "", *simd = "";
    json_t *root;
    const enum mpm_status loaded = input_json(path, 0, &root, error);
    const bool read =
        root != NULL &&
        json_unpack_ex(root, &failure, 0, "{s:{s:I, s:I, s:I, s:{s:I, s:F}}, s:s, s:s}", "counters",
                       "steps", &steps, "particles", &particles, "particle_steps", &particle_steps,
                       "bytes", "total", &bytes, "per_particle", &counted->bytes_per_particle,
                       "kernels", &kernels, "simd", &simd) == 0;
    counted->steps = (uint64_t)steps;
    counted->particles = (uint64_t)particles;
    counted->particle_steps = (uint64_t)particle_steps;
    counted->bytes = (uint64_t)bytes;
    g_strlcpy(counted->kernels, kernels, sizeof counted->kernels);
    g_strlcpy(counted->simd, simd, sizeof counted->simd);
    json_decref(root);
    g_free(path);
    if (loaded != MPM_OK)
        return MPM_ENVIRONMENT_FAILED;
    if (!read)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "run.json of the counted run: %s",
                           failure.text);
    return particle_steps > 0
               ? MPM_OK
               : failure_set(error, MPM_ENVIRONMENT_FAILED, "the counted run took no step");
}

static enum mpm_status read_counts(const char *folder, struct instructions *counted,
                                   struct mpm_error *error)
{
    char *path = g_build_filename(folder, COUNTS, NULL), *text = NULL;
    enum mpm_status status = input_text(path, NULL, &text, NULL, error);
    if (status == MPM_OK)
        status = callgrind_file_parse(text, &counted->counts, error);
    else
        status = MPM_ENVIRONMENT_FAILED; /* this program's own file */
    g_free(text);
    g_free(path);
    return status == MPM_OK ? read_record(folder, counted, error) : status;
}

/* -------------------------------------------------------------------- running */

static enum mpm_status link_into(const char *folder, const char *name, const char *file,
                                 struct mpm_error *error)
{
    char *target = g_canonicalize_filename(file, NULL);
    char *link = g_build_filename(folder, name, NULL);
    enum mpm_status status = MPM_OK;
    if (mpm_path_access(target, R_OK) != 0)
        status = failure_set(error, MPM_BAD_INPUT, "%s: %s", file, g_strerror(errno));
    else if (mpm_path_link(target, link) != 0)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: %s", link, g_strerror(errno));
    g_free(link);
    g_free(target);
    return status;
}

/* Adds copies of the texts that follow, up to NULL. */
static void __attribute__((sentinel)) add(GPtrArray *words, ...)
{
    va_list list;
    va_start(list, words);
    for (const char *word = va_arg(list, const char *); word != NULL;
         word = va_arg(list, const char *))
        g_ptr_array_add(words, g_strdup(word));
    va_end(list);
}

static GPtrArray *command_line(const char *valgrind, const struct instructions_request *request)
{
    static const char *const steps[] = {"mpm_simulation_advance", NULL};
    const char *const *functions = request->functions != NULL ? request->functions : steps;
    GPtrArray *words = g_ptr_array_new_with_free_func(g_free);
    add(words, valgrind, "--quiet", "--tool=callgrind", "--branch-sim=yes", "--compress-strings=no",
        "--compress-pos=no", "--callgrind-out-file=" COUNTS, NULL);
    for (size_t i = 0; functions[i] != NULL; i++)
        g_ptr_array_add(words, g_strconcat("--toggle-collect=", functions[i], NULL));
    add(words, "./" PROGRAM, "run", SCENE, "--quiet", "--output", RESULTS, "--threads", "1", NULL);
    if (request->simulation.kernels != MPM_KERNELS_AUTO)
        add(words, "--kernels", mpm_kernels_name(request->simulation.kernels), NULL);
    if (request->simulation.simd != MPM_SIMD_AUTO)
        add(words, "--simd", mpm_simd_name(request->simulation.simd), NULL);
    for (size_t i = 0; request->settings != NULL && request->settings[i] != NULL; i++)
        add(words, "--set", request->settings[i], NULL);
    add(words, "--set", NULL);
    g_ptr_array_add(words, g_strdup_printf("time.steps=%u", request->steps));
    g_ptr_array_add(words, NULL);
    return words;
}

/* The program's exit status is valgrind's; its last message is the reason. */
static enum mpm_status judge_end(int state, char *said, const char *scene, struct mpm_error *error)
{
    if (WIFEXITED(state) && WEXITSTATUS(state) == 0)
        return MPM_OK;
    const int code = WIFEXITED(state) ? WEXITSTATUS(state) : 0;
    const enum mpm_status status = code == MPM_BAD_INPUT || code == MPM_RUN_FAILED
                                       ? (enum mpm_status)code
                                       : MPM_ENVIRONMENT_FAILED;
    g_strchomp(said);
    const char *last = strrchr(said, '\n');
    last = last != NULL ? last + 1 : said;
    if (WIFSIGNALED(state))
        return failure_set(error, status, "%s under callgrind: ended by signal %d: %s", scene,
                           WTERMSIG(state), last);
    return failure_set(error, status, "%s under callgrind: exit status %d: %s", scene, code, last);
}

static enum mpm_status run_in(const char *folder, const char *valgrind,
                              const struct instructions_request *request, struct mpm_error *error)
{
    /* A library that is not in the usual places is still found; nothing else of the
     * environment reaches the stack that the program starts on. */
    char *libraries = g_strconcat("LD_LIBRARY_PATH=", g_getenv("LD_LIBRARY_PATH"), NULL);
    char *environment[] = {g_getenv("LD_LIBRARY_PATH") != NULL ? libraries : NULL, NULL};
    GPtrArray *words = command_line(valgrind, request);
    GError *failure = NULL;
    char *said = NULL;
    int state = 0;
    enum mpm_status status = MPM_OK;
    if (g_spawn_sync(folder, (char **)words->pdata, environment, G_SPAWN_STDOUT_TO_DEV_NULL, NULL,
                     NULL, NULL, &said, &state, &failure))
        status = judge_end(state, said, request->scene, error);
    else
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s", failure->message);
    g_clear_error(&failure);
    g_free(said);
    g_ptr_array_free(words, TRUE);
    g_free(libraries);
    return status;
}

enum mpm_status instructions_count(const struct instructions_request *request,
                                   struct instructions *counted, struct mpm_error *error)
{
    *counted = (struct instructions){0};
    char *folder = NULL, *valgrind = find_valgrind(error);
    enum mpm_status status = valgrind != NULL ? MPM_OK : MPM_ENVIRONMENT_FAILED;
    if (status == MPM_OK)
        status = mpm_folder_make_temporary(&folder, error);
    if (status == MPM_OK)
        status = link_into(folder, PROGRAM, request->program, error);
    if (status == MPM_OK)
        status = link_into(folder, SCENE, request->scene, error);
    if (status == MPM_OK)
        status = run_in(folder, valgrind, request, error);
    if (status == MPM_OK)
        status = read_counts(folder, counted, error);
    if (folder != NULL)
        (void)mpm_folder_remove_all(folder, NULL);
    g_free(folder);
    g_free(valgrind);
    return status;
}
