/* The state of a simulation as pieces: what a checkpoint has.
 *
 * A checkpoint has the state after the last sort, which the last good state keeps anyway, and the
 * lengths of the steps since, 32 at most. They are taken again when it is read: a step gives the
 * same bits each time, and whatever steps leave to one another between sorts is there again without
 * being listed here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_SIMULATION_CHECKPOINT_H
#define MPM_SIMULATION_CHECKPOINT_H

#include "base/piece.h"
#include "simulation/simulation.h"

/* Lists the pieces of a simulation between two steps, of which none has failed. */
void mpm_checkpoint_visit(struct mpm_simulation *simulation, struct mpm_piece_visitor *visitor);

/* Takes the pieces of a simulation of the same scene and kernels into one that was created and has
 * taken no step; it goes on to the same bits from there. MPM_BAD_INPUT: a piece has a value that no
 * run leaves there; the simulation is of no use then. Cost: up to 32 steps. */
enum mpm_status mpm_checkpoint_load(struct mpm_simulation *simulation,
                                    struct mpm_piece_visitor *visitor);

/* Bytes of all pieces. */
size_t mpm_checkpoint_bytes(struct mpm_simulation *simulation);

#endif
