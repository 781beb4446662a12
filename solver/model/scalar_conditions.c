/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/scalar_conditions.h"

#include "model/boundary.h"

#include <stdio.h>
#include <stdlib.h>

struct list {
    const struct mpm_scene *scene;
    const struct mpm_grid *grid;
    enum mpm_scalar which;
    double (*value)(const void *context, int32_t condition, const double position[2], double time);
    const void *context;
    struct mpm_scalar_hold *holds;
    size_t count;
    struct mpm_error *error;
};

/* A box of nodes, ghosts included. */
struct node_range {
    int64_t low[2], high[2];
};

static size_t nodes_in(const struct node_range *range)
{
    return (size_t)(range->high[0] - range->low[0] + 1) *
           (size_t)(range->high[1] - range->low[1] + 1);
}

static enum mpm_status find_range(const struct list *list, size_t condition,
                                  struct node_range *range)
{
    const struct mpm_scalar_condition_spec *const spec =
        &list->scene->scalars[list->which].conditions[condition];
    char key[96];
    (void)snprintf(key, sizeof key, "transport.%s.conditions.%zu.region",
                   mpm_scalar_rows[list->which].name, condition);
    MPM_TRY(mpm_boundary_box(list->scene, list->grid, &spec->region, spec->line, key, range->low,
                             range->high, list->error));
    for (int axis = 0; axis < 2; axis++) {
        range->low[axis] -= range->low[axis] == 0 ? MPM_GHOST_ROWS : 0;
        range->high[axis] += range->high[axis] == list->grid->cells[axis] ? MPM_GHOST_ROWS : 0;
    }
    return MPM_OK;
}

static void append(struct list *list, const struct node_range *range, size_t condition)
{
    for (int64_t row = range->low[1]; row <= range->high[1]; row++)
        for (int64_t column = range->low[0]; column <= range->high[0]; column++)
            list->holds[list->count++] = (struct mpm_scalar_hold){
                mpm_grid_index(list->grid, column, row), (int32_t)condition};
}

static int compare(const void *left, const void *right)
{
    const struct mpm_scalar_hold *const a = left, *const b = right;
    if (a->node != b->node)
        return a->node < b->node ? -1 : 1;
    return (a->condition > b->condition) - (a->condition < b->condition);
}

/* Two conditions on one node: fine if they say the same. On a ghost node, where conditions only
 * continue those of the edge, the first one stands. */
static enum mpm_status check_pair(const struct list *list, const struct mpm_scalar_hold *first,
                                  const struct mpm_scalar_hold *second)
{
    enum { TIMES = 33 };
    const char *const name = mpm_scalar_rows[list->which].name;
    double position[2];
    if (mpm_grid_is_ghost(list->grid, second->node))
        return MPM_OK;
    mpm_grid_position(list->grid, second->node, position);
    for (int k = 0; k < TIMES; k++) {
        const double time = list->scene->end * k / (TIMES - 1);
        const double a = list->value(list->context, first->condition, position, time);
        const double b = list->value(list->context, second->condition, position, time);
        char key[96];
        if (a == b)
            continue;
        (void)snprintf(key, sizeof key, "transport.%s.conditions.%d.value", name,
                       (int)second->condition);
        return mpm_scene_error(
            list->error, list->scene,
            list->scene->scalars[list->which].conditions[second->condition].line, key,
            "prescribes %g at the node (%g, %g) at time %g where conditions.%d prescribes %g; "
            "allowed: one value for a node",
            b, position[0], position[1], time, (int)first->condition, a);
    }
    return MPM_OK;
}

static enum mpm_status merge(struct list *list)
{
    size_t kept = list->count > 0 ? 1 : 0;
    qsort(list->holds, list->count, sizeof *list->holds, compare);
    for (size_t k = 1; k < list->count; k++) {
        if (list->holds[k].node != list->holds[kept - 1].node)
            list->holds[kept++] = list->holds[k];
        else
            MPM_TRY(check_pair(list, &list->holds[kept - 1], &list->holds[k]));
    }
    list->count = kept;
    return MPM_OK;
}

static enum mpm_status fill(struct list *list)
{
    const size_t conditions = list->scene->scalars[list->which].condition_count;
    struct node_range range;
    size_t capacity = 0;
    for (size_t k = 0; k < conditions; k++) {
        MPM_TRY(find_range(list, k, &range));
        capacity += nodes_in(&range);
    }
    list->holds = calloc(capacity + 1, sizeof *list->holds);
    if (list->holds == NULL)
        return mpm_error_memory(list->error, capacity * sizeof *list->holds, "the conditions");
    for (size_t k = 0; k < conditions; k++) {
        MPM_TRY(find_range(list, k, &range));
        append(list, &range, k);
    }
    return merge(list);
}

enum mpm_status mpm_scalar_holds_list(
    const struct mpm_scene *scene, const struct mpm_grid *grid, enum mpm_scalar which,
    double (*value)(const void *context, int32_t condition, const double position[2], double time),
    const void *context, struct mpm_scalar_hold **holds, size_t *count, struct mpm_error *error)
{
    struct list list = {.scene = scene,
                        .grid = grid,
                        .which = which,
                        .value = value,
                        .context = context,
                        .error = error};
    const enum mpm_status status = fill(&list);
    if (status != MPM_OK) {
        free(list.holds);
        list = (struct list){0};
    }
    *holds = list.holds;
    *count = list.count;
    return status;
}
