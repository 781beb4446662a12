/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/boundary.h"

#include "model/region.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* A node lies on a region within this distance, in cells. */
static const double NODE_SLACK = 1e-6;

typedef double (*value_function)(const void *context, int32_t boundary, int32_t component,
                                 const double position[2], double time);

struct list {
    const struct mpm_scene *scene;
    const struct mpm_grid *grid;
    value_function value;
    const void *context;
    struct mpm_condition *conditions;
    size_t count, capacity;
    struct mpm_error *error;
};

static enum mpm_status append(struct list *list, struct mpm_condition condition)
{
    if (list->count == list->capacity) {
        const size_t capacity = list->capacity == 0 ? 256 : 2 * list->capacity;
        void *const grown = realloc(list->conditions, capacity * sizeof *list->conditions);
        if (grown == NULL)
            return mpm_error_memory(list->error, capacity * sizeof *list->conditions,
                                    "the boundary conditions");
        list->conditions = grown;
        list->capacity = capacity;
    }
    list->conditions[list->count++] = condition;
    return MPM_OK;
}

/* From a node to the last ghost row beyond it, if it is on the grid's edge. */
static void ghost_range(int64_t index, int64_t last, int64_t range[2])
{
    range[0] = index == 0 ? -MPM_GHOST_ROWS : index;
    range[1] = index == last ? last + MPM_GHOST_ROWS : index;
}

/* Nodes beyond a plane of symmetry have no condition: what reaches them is reflected. */
static bool ends_at_plane(const struct list *list, int32_t boundary, int axis)
{
    const struct mpm_boundary_spec *const boundaries = list->scene->boundaries;
    return boundary != MPM_AXIS_CONDITION && boundaries[boundary].symmetry &&
           boundaries[boundary].normal == axis;
}

/* v_r at r < 0 is what axis_nodes says, whatever stands on r = 0. */
static bool is_axis_nodes_matter(const struct list *list, int64_t column, int32_t component)
{
    const double r = list->grid->origin[0] + list->grid->cell[0] * (double)column;
    return list->scene->axis_nodes != MPM_AXIS_NODES_ZERO && component == 0 &&
           r < -NODE_SLACK * list->grid->cell[0];
}

static enum mpm_status append_node(struct list *list, int64_t column, int64_t row,
                                   int32_t component, int32_t boundary)
{
    int64_t columns[2] = {column, column}, rows[2] = {row, row};
    if (!ends_at_plane(list, boundary, 0))
        ghost_range(column, list->grid->cells[0], columns);
    if (!ends_at_plane(list, boundary, 1))
        ghost_range(row, list->grid->cells[1], rows);
    for (int64_t r = rows[0]; r <= rows[1]; r++)
        for (int64_t c = columns[0]; c <= columns[1]; c++)
            if (!is_axis_nodes_matter(list, c, component))
                MPM_TRY(append(list, (struct mpm_condition){mpm_grid_index(list->grid, c, r),
                                                            component, boundary}));
    return MPM_OK;
}

/* Range of node columns or rows that can touch [low, high]. */
static void node_range(const struct mpm_grid *grid, int axis, double low, double high,
                       int64_t range[2])
{
    const double last = (double)grid->cells[axis];
    const double from = floor((low - grid->origin[axis]) * grid->inverse_cell[axis]) - 1.0;
    const double to = ceil((high - grid->origin[axis]) * grid->inverse_cell[axis]) + 1.0;
    range[0] = (int64_t)fmin(fmax(from, 0.0), last);
    range[1] = (int64_t)fmin(fmax(to, 0.0), last);
}

enum mpm_status mpm_boundary_box(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                 const struct mpm_region *region, int line, const char *key,
                                 int64_t low[2], int64_t high[2], struct mpm_error *error)
{
    const double slack[2] = {NODE_SLACK * grid->cell[0], NODE_SLACK * grid->cell[1]};
    double from[2], to[2];
    int64_t range[2][2];
    mpm_region_bounds(region, from, to);
    for (int axis = 0; axis < 2; axis++) {
        node_range(grid, axis, from[axis], to[axis], range[axis]);
        low[axis] = INT64_MAX;
        high[axis] = INT64_MIN;
    }
    for (int64_t row = range[1][0]; row <= range[1][1]; row++)
        for (int64_t column = range[0][0]; column <= range[0][1]; column++) {
            const int64_t place[2] = {column, row};
            double position[2];
            mpm_grid_position(grid, mpm_grid_index(grid, column, row), position);
            for (int axis = 0; axis < 2 && mpm_region_touches(region, position, slack); axis++) {
                low[axis] = place[axis] < low[axis] ? place[axis] : low[axis];
                high[axis] = place[axis] > high[axis] ? place[axis] : high[axis];
            }
        }
    if (low[0] <= high[0])
        return MPM_OK;
    return mpm_scene_error(error, scene, line, key,
                           "selects no node of the grid (spacing %g by %g from (%g, %g)); allowed: "
                           "a line or rectangle with nodes on it to 1e-6 of a cell",
                           grid->cell[0], grid->cell[1], grid->origin[0], grid->origin[1]);
}

static enum mpm_status append_boundary(struct list *list, int32_t boundary)
{
    const struct mpm_boundary_spec *const spec = &list->scene->boundaries[boundary];
    char key[64];
    int64_t low[2], high[2];
    (void)snprintf(key, sizeof key, "boundary.%d.region", (int)boundary);
    MPM_TRY(mpm_boundary_box(list->scene, list->grid, &spec->region, spec->line, key, low, high,
                             list->error));
    for (int64_t row = low[1]; row <= high[1]; row++)
        for (int64_t column = low[0]; column <= high[0]; column++)
            for (int32_t component = 0; component < 2; component++)
                if (spec->velocity.text[component] != NULL)
                    MPM_TRY(append_node(list, column, row, component, boundary));
    return MPM_OK;
}

static enum mpm_status append_axis(struct list *list)
{
    const struct mpm_grid *const grid = list->grid;
    for (int64_t column = 0; column <= grid->cells[0]; column++) {
        const double r = grid->origin[0] + grid->cell[0] * (double)column;
        if (r > NODE_SLACK * grid->cell[0])
            break;
        for (int64_t row = 0; row <= grid->cells[1]; row++)
            MPM_TRY(append_node(list, column, row, 0, MPM_AXIS_CONDITION));
    }
    return MPM_OK;
}

static int compare(const void *left, const void *right)
{
    const struct mpm_condition *const a = left, *const b = right;
    if (a->node != b->node)
        return a->node < b->node ? -1 : 1;
    if (a->component != b->component)
        return a->component < b->component ? -1 : 1;
    return (a->boundary > b->boundary) - (a->boundary < b->boundary);
}

static double prescribed(const struct list *list, const struct mpm_condition *condition,
                         const double position[2], double time)
{
    if (condition->boundary == MPM_AXIS_CONDITION)
        return 0.0;
    return list->value(list->context, condition->boundary, condition->component, position, time);
}

/* Two conditions on one component of one node: fine if they say the same. On a ghost node,
 * where conditions only continue those of the edge, the first one stands. */
static enum mpm_status check_pair(const struct list *list, const struct mpm_condition *first,
                                  const struct mpm_condition *second)
{
    const double end = list->scene->end;
    enum { TIMES = 33 };
    double position[2];
    if (mpm_grid_is_ghost(list->grid, second->node))
        return MPM_OK;
    mpm_grid_position(list->grid, second->node, position);
    for (int k = 0; k < TIMES; k++) {
        const double time = end * k / (TIMES - 1);
        const double a = prescribed(list, first, position, time);
        const double b = prescribed(list, second, position, time);
        if (a == b)
            continue;
        char key[64], other[64] = "the axis r = 0";
        if (list->scene->boundaries[second->boundary].symmetry)
            (void)snprintf(key, sizeof key, "boundary.%d.symmetry", (int)second->boundary);
        else
            (void)snprintf(key, sizeof key, "boundary.%d.velocity.%d", (int)second->boundary,
                           (int)second->component);
        if (first->boundary != MPM_AXIS_CONDITION)
            (void)snprintf(other, sizeof other, "boundary.%d", (int)first->boundary);
        return mpm_scene_error(list->error, list->scene,
                               list->scene->boundaries[second->boundary].line, key,
                               "prescribes %g at the node (%g, %g) at time %g where %s prescribes "
                               "%g; allowed: one value for each component of a node",
                               b, position[0], position[1], time, other, a);
    }
    return MPM_OK;
}

static enum mpm_status merge(struct list *list)
{
    if (list->count == 0)
        return MPM_OK;
    qsort(list->conditions, list->count, sizeof *list->conditions, compare);
    size_t kept = 1;
    for (size_t k = 1; k < list->count; k++) {
        const struct mpm_condition *const last = &list->conditions[kept - 1];
        const struct mpm_condition *const next = &list->conditions[k];
        if (next->node != last->node || next->component != last->component)
            list->conditions[kept++] = *next;
        else
            MPM_TRY(check_pair(list, last, next));
    }
    list->count = kept;
    return MPM_OK;
}

static enum mpm_status fill(struct list *list)
{
    if (list->scene->geometry == MPM_AXISYMMETRIC)
        MPM_TRY(append_axis(list));
    for (size_t boundary = 0; boundary < list->scene->boundary_count; boundary++)
        MPM_TRY(append_boundary(list, (int32_t)boundary));
    return merge(list);
}

enum mpm_status mpm_conditions_list(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                    value_function value, const void *context,
                                    struct mpm_condition **conditions, size_t *count,
                                    struct mpm_error *error)
{
    struct list list = {
        .scene = scene, .grid = grid, .value = value, .context = context, .error = error};
    const enum mpm_status status = fill(&list);
    if (status != MPM_OK) {
        free(list.conditions);
        list = (struct list){0};
    }
    *conditions = list.conditions;
    *count = list.count;
    return status;
}
