/* The state behind a checkpoint: its pieces, some of which have other numbers, are loaded, and the
 * simulation takes steps from there. Inputs do not depend on the checkpoint's format.
 *
 * An input is a byte for the run, then edits of SIZE bytes, as `enum part` has them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"
#include "fuzz/fuzz_runs.h"

#include "simulation/checkpoint.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { STEPS_AFTER = 3 };
enum part { PIECE, PLACE, PLACE_HIGH, KIND, NUMBER, SIZE = NUMBER + 8 };

/* The pieces of a run, in their order. */
static GArray *pieces[FUZZ_RUNS]; /* of struct mpm_piece, each with data of its own */

static enum mpm_status keep(void *context, const struct mpm_piece *piece, struct mpm_error *error)
{
    struct mpm_piece own = *piece;
    (void)error;
    own.data = g_memdup2(piece->data, mpm_piece_bytes(piece));
    g_array_append_val((GArray *)context, own);
    return MPM_OK;
}

static void clear_piece(void *element)
{
    g_free(((struct mpm_piece *)element)->data);
}

static void leave_pieces(size_t run)
{
    struct mpm_error error = {.status = MPM_OK};
    struct mpm_simulation *simulation = NULL;
    enum mpm_status status =
        mpm_simulation_create(fuzz_run_scene(run), &fuzz_run_options, &simulation, &error);
    for (int k = 0; k < FUZZ_STEPS && status == MPM_OK; k++)
        status = mpm_simulation_advance(simulation, HUGE_VAL, &error);
    if (!fuzz_judge(status, &error))
        g_error("fuzz: %s", error.message);
    pieces[run] = g_array_new(FALSE, FALSE, sizeof(struct mpm_piece));
    g_array_set_clear_func(pieces[run], clear_piece);
    struct mpm_piece_visitor visitor = {.take = keep, .context = pieces[run], .error = &error};
    mpm_checkpoint_visit(simulation, &visitor);
    mpm_simulation_free(simulation);
}

static void free_pieces(void)
{
    for (size_t k = 0; k < FUZZ_RUNS; k++)
        g_array_unref(pieces[k]);
}

/* ------------------------------------------------------------------- edits */

struct edits {
    const uint8_t *data;
    size_t size; /* of the edits */
    size_t run, next;
};

/* A number at that place: one that is odd, or any bytes. */
static void edit(const struct mpm_piece *piece, const uint8_t *part)
{
    static const double odd[] = {0.0,      -1.0, 1e300,        -1e300, 1e-300, (double)NAN,
                                 HUGE_VAL, 0.5,  4294967295.0, 33.0,   1e6,    -0.0};
    const size_t width = mpm_piece_bytes(piece) / piece->count;
    const size_t place = (part[PLACE] + ((size_t)part[PLACE_HIGH] << 8)) % piece->count;
    unsigned char *const at = (unsigned char *)piece->data + place * width;
    double value = odd[part[KIND] % G_N_ELEMENTS(odd)];
    if (part[KIND] & 0x80) {
        memcpy(at, part + NUMBER, width);
    } else if (piece->type == MPM_PIECE_DOUBLE) {
        double old;
        memcpy(&old, at, sizeof old);
        if (part[KIND] & 0x40)
            value = old * (1.0 + (part[NUMBER] - 128.0) / 64.0);
        memcpy(at, &value, sizeof value);
    } else {
        memset(at, part[KIND] & 1 ? 0xff : part[NUMBER], width);
    }
    if (piece->type == MPM_PIECE_BOOL) /* a file's reader lets no others through */
        *at &= 1;
}

static enum mpm_status give(void *context, const struct mpm_piece *piece, struct mpm_error *error)
{
    struct edits *const edits = context;
    const GArray *const all = pieces[edits->run];
    const size_t index = edits->next++;
    (void)error;
    if (index >= all->len)
        g_error("fuzz: more pieces are read than written");
    const struct mpm_piece *const own = &g_array_index(all, struct mpm_piece, index);
    if (strcmp(own->name, piece->name) != 0 || own->count != piece->count)
        g_error("fuzz: '%s' is read where '%s' was written", piece->name, own->name);
    memcpy(piece->data, own->data, mpm_piece_bytes(own));
    for (size_t at = 0; at + SIZE <= edits->size; at += SIZE)
        if (edits->data[at + PIECE] % all->len == index)
            edit(piece, edits->data + at);
    return MPM_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct mpm_error error = {.status = MPM_OK};
    struct mpm_simulation *simulation = NULL;
    if (size == 0)
        return 0;
    const size_t run = data[0] % FUZZ_RUNS;
    struct edits edits = {data + 1, size - 1, run, 0};
    struct mpm_piece_visitor visitor = {.take = give, .context = &edits, .error = &error};
    if (!fuzz_judge(
            mpm_simulation_create(fuzz_run_scene(run), &fuzz_run_options, &simulation, &error),
            &error))
        g_error("fuzz: %s", error.message);
    enum mpm_status status = mpm_checkpoint_load(simulation, &visitor);
    for (int k = 0; k < STEPS_AFTER && status == MPM_OK; k++)
        status = mpm_simulation_advance(simulation, HUGE_VAL, &error);
    if (status == MPM_OK)
        status = mpm_simulation_judge(simulation, &error);
    (void)fuzz_judge(status, &error);
    mpm_simulation_free(simulation);
    return 0;
}

int LLVMFuzzerInitialize(int *argument_count, char ***arguments)
{
    (void)argument_count;
    (void)arguments;
    for (size_t k = 0; k < FUZZ_RUNS; k++)
        leave_pieces(k);
    return atexit(free_pieces);
}
