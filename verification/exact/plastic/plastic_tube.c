/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/plastic_tube.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { RR, TT, ZZ, AXES, ROUNDS = 50 };
static const double CLOSE = 1e-9; /* residual over the load */

struct element {
    double plastic[AXES];
    double start[AXES]; /* plastic strain at the start of the step */
    double stress[AXES];
    double tangent[2][2]; /* of rr and tt with their strains */
    bool yielded;
};

struct plastic_tube_run {
    struct plastic_tube tube;
    double width, pressure;
    struct element *element;
    double *u;                              /* at the nodes */
    double *lower, *middle, *upper, *force; /* of Newton's step */
};

struct plastic_tube_run *plastic_tube_create(const struct plastic_tube *tube)
{
    struct plastic_tube_run *const run = g_new0(struct plastic_tube_run, 1);
    const size_t nodes = tube->elements + 1;
    run->tube = *tube;
    run->width = (tube->outer - tube->inner) / (double)tube->elements;
    run->element = g_new0(struct element, tube->elements);
    run->u = g_new0(double, nodes);
    run->lower = g_new(double, nodes);
    run->middle = g_new(double, nodes);
    run->upper = g_new(double, nodes);
    run->force = g_new(double, nodes);
    return run;
}

void plastic_tube_free(struct plastic_tube_run *run)
{
    if (run == NULL)
        return;
    g_free(run->element);
    g_free(run->u);
    g_free(run->lower);
    g_free(run->middle);
    g_free(run->upper);
    g_free(run->force);
    g_free(run);
}

static double middle_of(const struct plastic_tube_run *run, size_t k)
{
    return run->tube.inner + run->width * ((double)k + 0.5);
}

/* Stress, plastic strain and tangent of an element of the strains e_rr, e_tt. */
static void stretch(const struct plastic_tube *tube, struct element *element,
                    const double strain[2])
{
    const double g = tube->young / (2.0 * (1.0 + tube->poisson));
    const double k = tube->young / (3.0 * (1.0 - 2.0 * tube->poisson));
    const double radius = sqrt(2.0 / 3.0) * tube->yield;
    const double trace = strain[0] + strain[1], total[AXES] = {strain[0], strain[1], 0.0};
    double s[AXES], norm = 0.0;
    for (int i = 0; i < AXES; i++) {
        s[i] = 2.0 * g * (total[i] - trace / 3.0 - element->start[i]);
        norm += s[i] * s[i];
    }
    norm = sqrt(norm);
    const bool flows = norm > radius;
    const double back = flows ? radius / norm : 1.0;
    for (int i = 0; i < AXES; i++) {
        element->plastic[i] = element->start[i] + (1.0 - back) * s[i] / (2.0 * g);
        element->stress[i] = k * trace + back * s[i];
    }
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            const double deviator = (i == j ? 1.0 : 0.0) - 1.0 / 3.0;
            const double along = flows ? s[i] * s[j] / (norm * norm) : 0.0;
            element->tangent[i][j] = k + 2.0 * g * back * (deviator - along);
        }
    element->yielded = element->yielded || flows;
}

/* Forces at nodes and their derivatives; returns the largest force over the load's scale. */
static double assemble(struct plastic_tube_run *run, double pressure)
{
    const struct plastic_tube *const tube = &run->tube;
    const size_t n = tube->elements + 1;
    const double h = run->width;
    for (size_t i = 0; i < n; i++)
        run->lower[i] = run->middle[i] = run->upper[i] = run->force[i] = 0.0;
    run->force[0] = pressure * tube->inner;
    for (size_t k = 0; k < tube->elements; k++) {
        struct element *const element = &run->element[k];
        const double r = middle_of(run, k);
        const double b[2][2] = {{-1.0 / h, 0.5 / r}, {1.0 / h, 0.5 / r}}; /* node; rr, tt */
        const double strain[2] = {(run->u[k + 1] - run->u[k]) / h,
                                  0.5 * (run->u[k + 1] + run->u[k]) / r};
        double stiffness[2][2] = {{0.0}};
        stretch(tube, element, strain);
        for (int i = 0; i < 2; i++) {
            run->force[k + (size_t)i] -=
                h * r * (b[i][0] * element->stress[RR] + b[i][1] * element->stress[TT]);
            for (int j = 0; j < 2; j++)
                for (int p = 0; p < 2; p++)
                    for (int q = 0; q < 2; q++)
                        stiffness[i][j] += h * r * b[i][p] * element->tangent[p][q] * b[j][q];
        }
        run->middle[k] += stiffness[0][0];
        run->upper[k] += stiffness[0][1];
        run->lower[k + 1] += stiffness[1][0];
        run->middle[k + 1] += stiffness[1][1];
    }
    double largest = 0.0;
    for (size_t i = 0; i < n; i++)
        if (!(fabs(run->force[i]) <= largest)) /* NaN stays */
            largest = fabs(run->force[i]);
    return largest / (tube->yield * tube->inner);
}

/* Adds the solution of the three-diagonal system to u. */
static void improve(struct plastic_tube_run *run)
{
    const size_t n = run->tube.elements + 1;
    for (size_t i = 1; i < n; i++) {
        const double part = run->lower[i] / run->middle[i - 1];
        run->middle[i] -= part * run->upper[i - 1];
        run->force[i] -= part * run->force[i - 1];
    }
    double next = 0.0;
    for (size_t i = n; i-- > 0;) {
        next = (run->force[i] - run->upper[i] * next) / run->middle[i];
        run->u[i] += next;
    }
}

bool plastic_tube_load(struct plastic_tube_run *run, double pressure)
{
    const double from = run->pressure;
    for (size_t step = 1; step <= run->tube.steps; step++) {
        run->pressure = from + (pressure - from) * (double)step / (double)run->tube.steps;
        for (size_t k = 0; k < run->tube.elements; k++)
            memcpy(run->element[k].start, run->element[k].plastic, sizeof run->element[k].start);
        int round = 0;
        while (!(assemble(run, run->pressure) < CLOSE)) {
            if (++round > ROUNDS)
                return false;
            improve(run);
        }
    }
    return true;
}

double plastic_tube_front(const struct plastic_tube_run *run)
{
    double front = run->tube.inner;
    for (size_t k = 0; k < run->tube.elements; k++)
        if (run->element[k].yielded)
            front = middle_of(run, k) + 0.5 * run->width;
    return front;
}

struct plastic_tube_state plastic_tube_at(const struct plastic_tube_run *run, double r)
{
    const double last = (double)(run->tube.elements - 1);
    const double place = (r - run->tube.inner) / run->width;
    const double low = fmin(fmax(floor(place - 0.5), 0.0), last - 1.0), part = place - 0.5 - low;
    const double node = fmin(fmax(floor(place), 0.0), last);
    const struct element *const element = &run->element[(size_t)low];
    const double *const u = &run->u[(size_t)node];
    double s[AXES];
    for (int i = 0; i < AXES; i++)
        s[i] = (1.0 - part) * element[0].stress[i] + part * element[1].stress[i];
    return (struct plastic_tube_state){s[RR], s[TT], s[ZZ], u[0] + (place - node) * (u[1] - u[0])};
}
