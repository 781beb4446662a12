/* What a checkpoint is refused for, and that nothing has changed then.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/checkpoint/checkpoint.h"
#include "io/results/results_folder.h"
#include "simulation/checkpoint.h"
#include "suites.h"
#include "support/blocks.h"
#include "support/folder.h"
#include "support/results.h"
#include "support/scene_files.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <math.h>
#include <signal.h>
#include <string.h>

/* --------------------------------------------------------- files of a run */

static int calls;

static int after_forty(void)
{
    return calls++ >= 40 ? SIGTERM : 0;
}

/* One line for each. */
static void keep_warning(void *context, const char *warning)
{
    char *const kept = context;
    if (kept[0] != '\0')
        (void)g_strlcat(kept, "\n", MPM_MESSAGE_SIZE);
    (void)g_strlcat(kept, warning, MPM_MESSAGE_SIZE);
}

static enum mpm_status run_with(bool resume, enum mpm_kernels kernels, int (*interrupted)(void),
                                char *warning, struct mpm_error *error)
{
    const struct mpm_run_options options = {
        .output = test_results.output,
        .simulation = {.threads = 1, .kernels = kernels},
        .resume = resume,
        .warn = warning != NULL ? keep_warning : NULL,
        .progress_context = warning,
        .interrupted = interrupted,
    };
    calls = 0;
    return mpm_scene_run(test_results.scene, &options, error);
}

/* A run of 40 steps with checkpoints after some 22 and after 40. */
static void leave_checkpoints(void)
{
    struct mpm_error error = {.status = MPM_OK};
    test_results_scene(TEST_BLOCKS_WITH("{end: 1, courant: 0.4}",
                                        "{history: 0.1, snapshots: 0.3, checkpoint: 0.45}"));
    ck_assert_int_eq(run_with(false, MPM_KERNELS_AUTO, after_forty, NULL, &error), MPM_INTERRUPTED);
}

static char *path_of(const char *name)
{
    return test_folder_path(test_results.output, name);
}

static void set_bytes(const char *name, const char *bytes, gsize size)
{
    char *const path = path_of(name);
    ck_assert(g_file_set_contents(path, bytes, (gssize)size, NULL));
    g_free(path);
}

static char *get_bytes(const char *name, gsize *size)
{
    char *const path = path_of(name), *bytes = NULL;
    ck_assert(g_file_get_contents(path, &bytes, size, NULL));
    g_free(path);
    return bytes;
}

/* The history is as it was: nothing was cut off or written. */
static void check_refused(enum mpm_kernels kernels, const char *said)
{
    struct mpm_error error = {.status = MPM_OK};
    char *const lock = path_of(MPM_FOLDER_LOCK_NAME);
    gsize size[2];
    char *const before = get_bytes("history.csv", &size[0]);
    ck_assert_int_eq(run_with(true, kernels, NULL, NULL, &error), MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, said) != NULL, "%s, not: %s", error.message, said);
    char *const after = get_bytes("history.csv", &size[1]);
    ck_assert(size[0] == size[1] && memcmp(before, after, size[0]) == 0);
    ck_assert(!test_file_exists(lock));
    g_free(before);
    g_free(after);
    g_free(lock);
}

/* ---------------------------------------------------------------- damage */

static const struct damage {
    const char *name;
    double at;   /* part of the file where a bit is turned; below 0: none is */
    double kept; /* part of the file that is left */
    const char *said;
} damages[] = {
    {"a bit of the head", 0.0, 1.0, "is no checkpoint"},
    {"a bit of its length or its sum", 60.0, 1.0, "is damaged"},
    {"a bit after the head's text", 400.0, 1.0, "is damaged"},
    {"a bit of HDF5's own", 520.0, 1.0, "is damaged"},
    {"a bit in the middle", 0.5, 1.0, "is damaged"},
    {"the last bit", 0.999999, 1.0, "is damaged"},
    {"a file that ends early", -1.0, 0.7, "is damaged"},
    {"a head alone", -1.0, 0.01, "is "},
    {"an empty file", -1.0, 0.0, "is no checkpoint"},
};

static void damage(const char *name, const struct damage *damage)
{
    gsize size;
    char *const bytes = get_bytes(name, &size);
    const gsize at = damage->at < 1.0 ? (gsize)(damage->at * (double)size) : (gsize)damage->at;
    if (damage->at >= 0.0)
        bytes[MIN(at, size - 1)] ^= 1;
    set_bytes(name, bytes, (gsize)(damage->kept * (double)size));
    g_free(bytes);
}

START_TEST(a_damaged_checkpoint_is_named_and_the_one_before_it_is_taken)
{
    struct mpm_error error = {.status = MPM_OK};
    char warning[MPM_MESSAGE_SIZE] = "";
    leave_checkpoints();
    damage(MPM_CHECKPOINT_NAME, &damages[_i]);
    ck_assert_msg(run_with(true, MPM_KERNELS_AUTO, NULL, warning, &error) == MPM_OK, "%s: %s",
                  damages[_i].name, error.message);
    ck_assert_msg(strstr(warning, damages[_i].said) != NULL, "%s: %s", damages[_i].name, warning);
    ck_assert(strstr(warning, "goes on from checkpoint-previous.h5") != NULL);
    json_t *const record = test_results_json("run.json");
    ck_assert_str_eq(json_string_value(json_array_get(json_object_get(record, "warnings"), 0)),
                     warning);
    json_decref(record);
}
END_TEST

START_TEST(two_damaged_checkpoints_are_refused)
{
    leave_checkpoints();
    damage(MPM_CHECKPOINT_NAME, &damages[_i]);
    damage(MPM_CHECKPOINT_PREVIOUS, &damages[_i]);
    check_refused(MPM_KERNELS_AUTO, damages[_i].said);
}
END_TEST

START_TEST(a_checkpoint_of_another_format_is_refused)
{
    static const char known[] = "touchstone checkpoint\nformat 1";
    const gsize at = strlen(known) - 1;
    gsize size;
    leave_checkpoints();
    char *const bytes = get_bytes(MPM_CHECKPOINT_NAME, &size);
    char *const previous = path_of(MPM_CHECKPOINT_PREVIOUS);
    ck_assert(memcmp(bytes, known, at + 1) == 0 && g_unlink(previous) == 0);
    bytes[at] = '2';
    set_bytes(MPM_CHECKPOINT_NAME, bytes, size);
    check_refused(MPM_KERNELS_AUTO, "has format 2; allowed: 1");
    g_free(bytes);
    g_free(previous);
}
END_TEST

/* ------------------------------------------------------- of something else */

START_TEST(another_scene_other_settings_and_other_kernels_are_refused)
{
    static const char *const settings[] = {"time.courant=0.3"};
    struct mpm_error error = {.status = MPM_OK};
    leave_checkpoints();
    check_refused(MPM_KERNELS_REFERENCE, "of a run with --kernels fast, got reference");
    mpm_scene_free(test_results.scene);
    ck_assert_int_eq(
        mpm_scene_read(test_results.scene_path, settings, 1, &test_results.scene, &error), MPM_OK);
    check_refused(MPM_KERNELS_AUTO, "other --set texts");
    test_results_scene(TEST_BLOCKS);
    check_refused(MPM_KERNELS_AUTO, "of another scene");
}
END_TEST

static char *find(char *bytes, gsize size, const char *text)
{
    const gsize length = strlen(text);
    for (gsize k = 0; k + length <= size; k++)
        if (memcmp(bytes + k, text, length) == 0)
            return bytes + k;
    return NULL;
}

/* The text without its end. */
static void overwrite(char *place, const char *text)
{
    while (*text != '\0')
        *place++ = *text++;
}

/* As another compiler's build would have written it, with a right sum. */
static void make_of_another_build(const char *name)
{
    enum { HEAD = 512 };
    static const char key[] = "\nmd5 ";
    const char *const compiler = mpm_build_info()->compiler;
    gsize size;
    char *const bytes = get_bytes(name, &size);
    char *const place = find(bytes + HEAD, size - HEAD, compiler);
    char *const sum = find(bytes, HEAD, key);
    ck_assert(place != NULL && sum != NULL);
    overwrite(place, "tcc");
    char *const right =
        g_compute_checksum_for_data(G_CHECKSUM_MD5, (const guchar *)bytes + HEAD, size - HEAD);
    overwrite(sum + strlen(key), right);
    set_bytes(name, bytes, size);
    g_free(right);
    g_free(bytes);
}

START_TEST(an_older_checkpoint_of_another_build_has_two_warnings)
{
    struct mpm_error error = {.status = MPM_OK};
    char warning[MPM_MESSAGE_SIZE] = "";
    leave_checkpoints();
    make_of_another_build(MPM_CHECKPOINT_PREVIOUS);
    damage(MPM_CHECKPOINT_NAME, &damages[4]);
    ck_assert_msg(run_with(true, MPM_KERNELS_AUTO, NULL, warning, &error) == MPM_OK, "%s",
                  error.message);
    json_t *const record = test_results_json("run.json");
    const json_t *const list = json_object_get(record, "warnings");
    ck_assert_uint_eq(json_array_size(list), 2);
    const char *const older = json_string_value(json_array_get(list, 0));
    const char *const build = json_string_value(json_array_get(list, 1));
    ck_assert_msg(strstr(older, "goes on from checkpoint-previous.h5") != NULL, "%s", older);
    ck_assert_msg(g_str_has_prefix(build, "checkpoint-previous.h5 is of another build"), "%s",
                  build);
    char *const both = g_strdup_printf("%s\n%s", older, build);
    ck_assert_str_eq(warning, both);
    g_free(both);
    json_decref(record);
}
END_TEST

START_TEST(kernels_that_nobody_names_are_those_of_the_checkpoint)
{
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(run_with(false, MPM_KERNELS_REFERENCE, after_forty, NULL, &error),
                     MPM_INTERRUPTED);
    ck_assert_int_eq(run_with(true, MPM_KERNELS_AUTO, NULL, NULL, &error), MPM_OK);
    json_t *const record = test_results_json("run.json");
    ck_assert_str_eq(json_string_value(json_object_get(record, "kernels")), "reference");
    json_decref(record);
}
END_TEST

START_TEST(without_a_checkpoint_nothing_goes_on)
{
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(run_with(true, MPM_KERNELS_AUTO, NULL, NULL, &error), MPM_BAD_INPUT);
    ck_assert(strstr(error.message, "there is no such folder") != NULL);
    ck_assert(!test_file_exists(test_results.output));
    test_results_run_well();
    check_refused(MPM_KERNELS_AUTO, "there is no checkpoint in");
}
END_TEST

START_TEST(a_history_that_is_shorter_is_refused)
{
    leave_checkpoints();
    set_bytes("history.csv", "time\n", 5);
    check_refused(MPM_KERNELS_AUTO, "fewer than when the checkpoint was written");
}
END_TEST

/* ------------------------------------------------- values that cannot be */

struct store {
    GHashTable *pieces; /* copies of data, by their names */
    const char *changed;
    void (*change)(const struct mpm_piece *piece);
};

static enum mpm_status put(void *context, const struct mpm_piece *piece, struct mpm_error *error)
{
    struct store *const store = context;
    (void)error;
    ck_assert_msg(g_hash_table_insert(store->pieces, g_strdup(piece->name),
                                      g_memdup2(piece->data, mpm_piece_bytes(piece))),
                  "%s comes twice", piece->name);
    return MPM_OK;
}

static enum mpm_status get(void *context, const struct mpm_piece *piece, struct mpm_error *error)
{
    const struct store *const store = context;
    const void *const data = g_hash_table_lookup(store->pieces, piece->name);
    (void)error;
    ck_assert_msg(data != NULL, "no %s", piece->name);
    memcpy(piece->data, data, mpm_piece_bytes(piece));
    if (strcmp(piece->name, store->changed) == 0)
        store->change(piece);
    return MPM_OK;
}

static void to_nan(const struct mpm_piece *piece)
{
    ((double *)piece->data)[piece->count - 1] = (double)NAN;
}

static void to_outside(const struct mpm_piece *piece)
{
    ((double *)piece->data)[0] = 1e300;
}

static void to_negative(const struct mpm_piece *piece)
{
    ((double *)piece->data)[0] *= -1.0;
}

static void to_huge_steps(const struct mpm_piece *piece)
{
    for (size_t k = 0; k < piece->count; k++)
        ((double *)piece->data)[k] *= 1e6;
}

static void to_twice(const struct mpm_piece *piece)
{
    ((uint32_t *)piece->data)[0] = ((uint32_t *)piece->data)[1];
}

static void to_none(const struct mpm_piece *piece)
{
    ((uint32_t *)piece->data)[0] = 4000000000u;
}

static void to_large(const struct mpm_piece *piece)
{
    ((uint64_t *)piece->data)[piece->count - 1] = UINT64_MAX;
}

static void to_none_at_all(const struct mpm_piece *piece)
{
    memset(piece->data, 0, mpm_piece_bytes(piece));
}

static void to_nothing(const struct mpm_piece *piece)
{
    (void)piece;
}

static const struct wrong {
    const char *piece;
    void (*change)(const struct mpm_piece *piece);
    const char *said;  /* NULL: it is not wrong */
    const char *scene; /* NULL: that of the other tests */
} wrongs[] = {
    {"step", to_nothing, NULL, NULL},
    {"particles.id", to_twice, "does not have each particle once", NULL},
    {"particles.id", to_none, "does not have each particle once", NULL},
    {"particles.position.1", to_nan, "'particles.position.1' has a value that is not finite", NULL},
    {"particles.position.0", to_outside, "outside of the grid", NULL},
    {"rigid.position.1", to_outside, "outside of the grid", "tests/fuzz/scenes/disk.yaml"},
    {"cracks.y", to_outside, "left the grid from", "tests/fuzz/scenes/crack.yaml"},
    {"cracks.x", to_negative, "left the grid from", "tests/fuzz/scenes/crack.yaml"},
    {"cracks.opening_x", to_outside, "a surface of cracks.0 left", "tests/fuzz/scenes/crack.yaml"},
    {"particles.deformation_gradient.0", to_negative, "a step since 'sorted.step' fails", NULL},
    {"step", to_large, "'sorted.step' has a value", NULL},
    {"step", to_none_at_all, "'sorted.step' has a value", NULL},
    {"sorted.step", to_large, "'sorted.step' has a value", NULL},
    {"sorted.step", to_none_at_all, "'sorted.step' has a value", NULL},
    {"steps.length", to_huge_steps, "a step since 'sorted.step' fails", NULL},
    {"steps.length", to_negative, "time does not go on", NULL},
    {"steps.end", to_none_at_all, "time does not go on", NULL},
    {"wave_speed", to_nan, "'wave_speed' has a value that is not finite", NULL},
};

START_TEST(values_that_no_run_leaves_are_refused)
{
    const struct mpm_simulation_options options = {.threads = 1};
    const struct wrong *const wrong = &wrongs[_i];
    struct mpm_error error = {.status = MPM_OK};
    struct store store = {g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free),
                          wrong->piece, wrong->change};
    struct mpm_piece_visitor writer = {.take = put, .context = &store, .error = &error};
    struct mpm_piece_visitor reader = {.take = get, .context = &store, .error = &error};
    struct mpm_scene *const own = wrong->scene == NULL ? NULL : test_scene_read(wrong->scene, NULL);
    const struct mpm_scene *const scene = own == NULL ? test_results.scene : own;
    struct mpm_simulation *one, *other;
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &one, &error), MPM_OK);
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &other, &error), MPM_OK);
    for (int k = 0; k < 40; k++)
        ck_assert_int_eq(mpm_simulation_advance(one, HUGE_VAL, &error), MPM_OK);
    mpm_checkpoint_visit(one, &writer);
    const enum mpm_status status = mpm_checkpoint_load(other, &reader);
    if (wrong->said == NULL) {
        ck_assert_int_eq(status, MPM_OK);
        ck_assert(mpm_simulation_time(one) == mpm_simulation_time(other));
    } else {
        ck_assert_msg(status == MPM_BAD_INPUT, "%s", wrong->piece);
        ck_assert_msg(strstr(error.message, wrong->said) != NULL, "%s", error.message);
    }
    mpm_simulation_free(one);
    mpm_simulation_free(other);
    mpm_scene_free(own);
    g_hash_table_unref(store.pieces);
}
END_TEST

/* --------------------------------------------------------------- one writer */

START_TEST(a_folder_has_one_writer)
{
    struct mpm_error error = {.status = MPM_OK};
    struct mpm_folder_lock lock;
    leave_checkpoints();
    ck_assert_int_eq(mpm_results_folder_lock(test_results.output, &lock, &error), MPM_OK);
    for (int overwrite = 0; overwrite < 2; overwrite++) {
        ck_assert_int_eq(test_results_run(overwrite == 1, &error), MPM_BAD_INPUT);
        ck_assert(strstr(error.message, overwrite == 1 ? "another run writes to" : "results") !=
                  NULL);
    }
    ck_assert_int_eq(run_with(true, MPM_KERNELS_AUTO, NULL, NULL, &error), MPM_BAD_INPUT);
    ck_assert(strstr(error.message, "another run writes to") != NULL);
    mpm_results_folder_unlock(&lock);
    ck_assert_int_eq(run_with(true, MPM_KERNELS_AUTO, NULL, NULL, &error), MPM_OK);
}
END_TEST

START_TEST(a_lock_that_was_left_behind_locks_nothing)
{
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(g_mkdir(test_results.output, 0777), 0);
    char *const path = test_folder_write(test_results.output, MPM_FOLDER_LOCK_NAME, "");
    ck_assert_msg(test_results_run(false, &error) == MPM_OK, "%s", error.message);
    ck_assert(!test_file_exists(path));
    g_free(path);
}
END_TEST

START_TEST(a_plan_states_the_size_of_a_checkpoint)
{
    const struct mpm_simulation_options options = {.threads = 1};
    struct mpm_error error = {.status = MPM_OK};
    struct mpm_plan plan;
    gsize size;
    leave_checkpoints();
    ck_assert_int_eq(mpm_scene_plan(test_results.scene, &options, &plan, &error), MPM_OK);
    g_free(get_bytes(MPM_CHECKPOINT_NAME, &size));
    ck_assert_uint_ge(size, plan.checkpoint_bytes);
    ck_assert_uint_le(size, plan.checkpoint_bytes + 65536); /* of HDF5, and of the run */
}
END_TEST

Suite *suite_checkpoint_file(void)
{
    Suite *suite = suite_create("checkpoint_file");
    TCase *files = tcase_create("files");
    tcase_add_checked_fixture(files, test_results_set_up, test_results_tear_down);
    tcase_add_loop_test(files, a_damaged_checkpoint_is_named_and_the_one_before_it_is_taken, 0,
                        G_N_ELEMENTS(damages));
    tcase_add_loop_test(files, two_damaged_checkpoints_are_refused, 0, G_N_ELEMENTS(damages));
    tcase_add_test(files, a_checkpoint_of_another_format_is_refused);
    tcase_add_test(files, another_scene_other_settings_and_other_kernels_are_refused);
    tcase_add_test(files, an_older_checkpoint_of_another_build_has_two_warnings);
    tcase_add_test(files, kernels_that_nobody_names_are_those_of_the_checkpoint);
    tcase_add_test(files, without_a_checkpoint_nothing_goes_on);
    tcase_add_test(files, a_history_that_is_shorter_is_refused);
    tcase_add_loop_test(files, values_that_no_run_leaves_are_refused, 0, G_N_ELEMENTS(wrongs));
    tcase_add_test(files, a_folder_has_one_writer);
    tcase_add_test(files, a_lock_that_was_left_behind_locks_nothing);
    tcase_add_test(files, a_plan_states_the_size_of_a_checkpoint);
    suite_add_tcase(suite, files);
    return suite;
}
