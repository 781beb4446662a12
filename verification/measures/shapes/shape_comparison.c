/* The solver's shape functions against quadrature; see shape_comparison.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/shapes/shape_comparison.h"
#include "verification/measures/fields.h"

#include <math.h>

/* Rounding of a position at node 1000 is 1e-13 of a cell; ten times that and some. */
static const double REACH_TOLERANCE = 1e-11;

struct stencil {
    struct mpm_stencil_entry entries[MPM_STENCIL_MAX];
    bool used[MPM_STENCIL_MAX];
    size_t count;
};

/* The first unused entry of a node, or NULL. */
static const struct mpm_stencil_entry *stencil_take(struct stencil *stencil, int64_t column,
                                                    int64_t row)
{
    for (size_t i = 0; i < stencil->count; i++) {
        const struct mpm_stencil_entry *entry = &stencil->entries[i];
        if (!stencil->used[i] && entry->column == column && entry->row == row) {
            stencil->used[i] = true;
            return entry;
        }
    }
    return NULL;
}

static bool entry_is_zero(const struct mpm_stencil_entry *entry)
{
    return fpclassify(entry->s) == FP_ZERO && fpclassify(entry->g[0]) == FP_ZERO &&
           fpclassify(entry->g[1]) == FP_ZERO && fpclassify(entry->t) == FP_ZERO;
}

static void compare_values(struct shape_comparison *comparison,
                           const struct mpm_stencil_entry *entry,
                           const struct mpm_shape_query *query, const struct shape_domain *domain,
                           const struct shape_reference *reference)
{
    /* In planar geometry T is zero by convention; any unit will do. */
    const double radius =
        query->geometry == MPM_AXISYMMETRIC ? domain->mean_radius : query->cell[0];
    double value[SHAPE_VALUES] = {0};
    if (entry != NULL) {
        value[SHAPE_S] = entry->s;
        value[SHAPE_GX] = entry->g[0] * query->cell[0];
        value[SHAPE_GY] = entry->g[1] * query->cell[1];
        value[SHAPE_T] = entry->t * radius;
    }
    for (size_t i = 0; i < SHAPE_VALUES; i++) {
        const double scale = fmax(domain->magnification, fabs(reference->value[i]));
        comparison->error[i] =
            field_larger(comparison->error[i], fabs(value[i] - reference->value[i]) / scale);
        comparison->estimate[i] =
            field_larger(comparison->estimate[i], reference->estimate[i] / scale);
    }
}

bool shape_comparison_add(struct shape_comparison *comparison, struct shape_quadrature *quadrature,
                          const struct mpm_shape_query *query)
{
    struct shape_domain domain;
    if (!shape_quadrature_prepare(quadrature, query, &domain)) {
        return false;
    }
    struct stencil stencil = {.count = 0};
    stencil.count = mpm_shape_evaluate(query, stencil.entries);
    for (int64_t row = domain.first[1]; row <= domain.last[1]; row++) {
        for (int64_t column = domain.first[0]; column <= domain.last[0]; column++) {
            struct shape_reference reference;
            if (!shape_quadrature_node(quadrature, column, row, &reference)) {
                return false;
            }
            const bool outside = reference.depth < -REACH_TOLERANCE;
            comparison->nodes_outside += outside;
            comparison->nodes_reached += !outside;
            if (!outside) {
                const struct mpm_stencil_entry *entry = stencil_take(&stencil, column, row);
                comparison->strays += entry != NULL && entry_is_zero(entry);
                compare_values(comparison, entry, query, &domain, &reference);
            }
        }
    }
    for (size_t i = 0; i < stencil.count; i++) {
        comparison->strays += !stencil.used[i];
    }
    comparison->samples++;
    return true;
}

static double largest(const double values[SHAPE_VALUES])
{
    return field_maximum(values, 1, SHAPE_VALUES);
}

double shape_comparison_error(const struct shape_comparison *comparison)
{
    return largest(comparison->error);
}

double shape_comparison_least(const struct shape_comparison *comparison, bool has_t)
{
    double least = comparison->error[SHAPE_S];
    for (size_t i = 0; i < SHAPE_VALUES; i++)
        if (i != SHAPE_T || has_t)
            least = -field_larger(-least, -comparison->error[i]);
    return least;
}

double shape_comparison_estimate(const struct shape_comparison *comparison)
{
    return largest(comparison->estimate);
}
