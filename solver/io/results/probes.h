/* Fields at places: probes.csv, a row for each place of output.probes and output.lines.
 *
 * At a place x, a field f of the particles is the mean
 *
 *     f(x) = sum_p w_p f_p / sum_p w_p,
 *     w_p = m_p h(dx/cell_x) h(dy/cell_y),
 *     h(s) = max(0, 1 - |s|)
 *
 * over the deformable particles within a cell of x, of all bodies and of both sides of a crack. It
 * is exact for a field that is constant, and for one that is linear where the particles lie
 * symmetrically about x; at a body's edge it is the mean of the particles inside. The column
 * `weight` is the sum of w_p; where no particle is within a cell it is 0, and the fields are nan.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_PROBES_H
#define MPM_IO_PROBES_H

#include "base/piece.h"
#include "model/scene.h"

#define MPM_PROBES_NAME "probes.csv"

struct mpm_probes;

/* NULL in scenes without. `folder` and `scene` must outlive it. */
enum mpm_status mpm_probes_create(const char *folder, const struct mpm_scene *scene,
                                  struct mpm_probes **probes, struct mpm_error *error);
/* That of a run that was interrupted; mpm_probes_cut puts into force what mpm_probes_visit reads,
 * as for the history. */
enum mpm_status mpm_probes_reopen(const char *folder, const struct mpm_scene *scene,
                                  struct mpm_probes **probes, struct mpm_error *error);
void mpm_probes_visit(struct mpm_probes *probes, struct mpm_piece_visitor *visitor);
enum mpm_status mpm_probes_cut(struct mpm_probes *probes, struct mpm_error *error);
void mpm_probes_free(struct mpm_probes *probes);

/* The rows of a state; nothing if those of its step are there. Cost: each place looks at all
 * particles. */
enum mpm_status mpm_probes_write(struct mpm_probes *probes, const struct mpm_simulation *simulation,
                                 struct mpm_error *error);

enum mpm_status mpm_probes_sync(const struct mpm_probes *probes, struct mpm_error *error);

#endif
