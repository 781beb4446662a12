/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/scalar_exchange.h"

#include <math.h>
#include <string.h>

enum { SIDES = MPM_CONTACT_SIDES };

/* ----------------------------------------------------------------- who hangs together */

/* Gives those that a link joins the number of the first of them. */
static void unite(int label[SIDES], int count, int one, int other)
{
    const int low = label[one] < label[other] ? label[one] : label[other];
    const int high = label[one] < label[other] ? label[other] : label[one];
    for (int k = 0; k < count; k++)
        if (label[k] == high)
            label[k] = low;
}

static void find_groups(struct mpm_scalar_meeting *meeting)
{
    for (int k = 0; k < meeting->side_count; k++)
        meeting->group[k] = k;
    for (int k = 0; k < meeting->link_count; k++)
        if (meeting->links[k].perfect)
            unite(meeting->group, meeting->side_count, meeting->links[k].of[0],
                  meeting->links[k].of[1]);
}

void mpm_scalar_meeting_join(struct mpm_scalar_meeting *meeting)
{
    find_groups(meeting);
    for (int g = 0; g < meeting->side_count; g++) {
        double capacity = 0.0, content = 0.0;
        for (int k = g; k < meeting->side_count; k++) {
            capacity += meeting->group[k] == g ? meeting->sides[k].capacity : 0.0;
            content += meeting->group[k] == g ? meeting->sides[k].content : 0.0;
        }
        for (int k = g; k < meeting->side_count; k++)
            if (meeting->group[k] == g)
                meeting->sides[k].value = content / capacity;
    }
}

/* -------------------------------------------------------------------------- modes */

/* Groups that conductances link: n of them, with what they gain. */
struct modes {
    int n;
    double capacity[SIDES], value[SIDES], rate[SIDES]; /* M, v, I / M, both less the mean */
    double matrix[SIDES][SIDES];                       /* dt M^(-1/2) L M^(-1/2), then z */
    double vectors[SIDES][SIDES];                      /* Q, by columns */
    double gained[SIDES];
};

/* One rotation of Jacobi's method: matrix[p][q] becomes 0. */
static void rotate(struct modes *modes, int p, int q)
{
    double(*const a)[SIDES] = modes->matrix;
    const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
    const double t = copysign(1.0, theta) / (fabs(theta) + hypot(theta, 1.0));
    const double c = 1.0 / sqrt(t * t + 1.0), s = t * c;
    for (int k = 0; k < modes->n; k++) {
        const double kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq;
        a[k][q] = s * kp + c * kq;
    }
    for (int k = 0; k < modes->n; k++) {
        const double pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk;
        a[q][k] = s * pk + c * qk;
    }
    for (int k = 0; k < modes->n; k++) {
        const double kp = modes->vectors[k][p], kq = modes->vectors[k][q];
        modes->vectors[k][p] = c * kp - s * kq;
        modes->vectors[k][q] = s * kp + c * kq;
    }
}

/* Jacobi's method converges quadratically: a few sweeps for matrices of this size. */
static void diagonalise(struct modes *modes)
{
    enum { SWEEPS = 30 };
    double size = 0.0;
    for (int p = 0; p < modes->n; p++)
        for (int q = 0; q < modes->n; q++) {
            modes->vectors[p][q] = p == q ? 1.0 : 0.0;
            size = fmax(size, fabs(modes->matrix[p][q]));
        }
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        bool done = true;
        for (int p = 0; p < modes->n; p++)
            for (int q = p + 1; q < modes->n; q++)
                if (fabs(modes->matrix[p][q]) > 1e-17 * size) {
                    rotate(modes, p, q);
                    done = false;
                }
        if (done)
            return;
    }
}

/* 1 - (1 - exp(-z))/z */
static double lag(double z)
{
    return z < 1e-3 ? z * (0.5 - z * (1.0 / 6.0 - z * (1.0 / 24.0 - z / 120.0)))
                    : 1.0 + expm1(-z) / z;
}

static void count_from_mean(struct modes *modes)
{
    double capacity = 0.0, value = 0.0, rate = 0.0;
    for (int k = 0; k < modes->n; k++) {
        capacity += modes->capacity[k];
        value += modes->capacity[k] * modes->value[k];
        rate += modes->capacity[k] * modes->rate[k];
    }
    for (int k = 0; k < modes->n; k++) {
        modes->value[k] -= value / capacity;
        modes->rate[k] -= rate / capacity;
    }
}

static void find_gains(struct modes *modes, double time_step)
{
    count_from_mean(modes);
    diagonalise(modes);
    memset(modes->gained, 0, sizeof modes->gained);
    for (int mode = 0; mode < modes->n; mode++) {
        const double z = fmax(modes->matrix[mode][mode], 0.0);
        double of_value = 0.0, of_rate = 0.0;
        for (int k = 0; k < modes->n; k++) {
            const double part = sqrt(modes->capacity[k]) * modes->vectors[k][mode];
            of_value += part * modes->value[k];
            of_rate += part * modes->rate[k];
        }
        const double change = expm1(-z) * of_value - time_step * lag(z) * of_rate;
        for (int k = 0; k < modes->n; k++)
            modes->gained[k] += sqrt(modes->capacity[k]) * modes->vectors[k][mode] * change;
    }
}

/* ---------------------------------------------------------------- what links pass */

/* Content that nodes of a net gain, and how well its links conduct. */
struct net {
    int n;
    double gained[SIDES], matrix[SIDES][SIDES];
    double potential[SIDES];
};

static void add_link(struct net *net, int one, int other, double conductance)
{
    net->matrix[one][one] += conductance;
    net->matrix[other][other] += conductance;
    net->matrix[one][other] -= conductance;
    net->matrix[other][one] -= conductance;
}

/* L u = - gained, by elimination; the last of those that hang together has u = 0. */
static void find_potentials(struct net *net)
{
    double pivots[SIDES] = {0.0};
    for (int k = 0; k < net->n; k++) {
        const double whole = net->matrix[k][k];
        pivots[k] = whole;
        net->potential[k] = -net->gained[k];
    }
    for (int k = 0; k < net->n; k++) {
        const double pivot = net->matrix[k][k];
        if (!(pivot > 1e-12 * pivots[k])) {
            pivots[k] = 0.0;
            continue;
        }
        for (int i = k + 1; i < net->n; i++) {
            const double factor = net->matrix[i][k] / pivot;
            for (int j = k; j < net->n; j++)
                net->matrix[i][j] -= factor * net->matrix[k][j];
            net->potential[i] -= factor * net->potential[k];
        }
    }
    for (int k = net->n - 1; k >= 0; k--) {
        for (int j = k + 1; j < net->n; j++)
            net->potential[k] -= net->matrix[k][j] * net->potential[j];
        net->potential[k] = pivots[k] == 0.0 ? 0.0 : net->potential[k] / net->matrix[k][k];
    }
}

/* Between groups. */
static void pass_by_conductance(struct mpm_scalar_meeting *meeting, const double gained[SIDES])
{
    struct net net = {.n = meeting->side_count};
    memcpy(net.gained, gained, sizeof net.gained);
    for (int k = 0; k < meeting->link_count; k++) {
        const struct mpm_scalar_link *const link = &meeting->links[k];
        if (!link->perfect)
            add_link(&net, meeting->group[link->of[0]], meeting->group[link->of[1]],
                     link->conductance);
    }
    find_potentials(&net);
    for (int k = 0; k < meeting->link_count; k++) {
        struct mpm_scalar_link *const link = &meeting->links[k];
        link->passed = link->perfect
                           ? 0.0
                           : link->conductance * (net.potential[meeting->group[link->of[0]]] -
                                                  net.potential[meeting->group[link->of[1]]]);
    }
}

/* Within groups: what each field gains to follow its group, less what came by other links. */
static void pass_within_groups(struct mpm_scalar_meeting *meeting, double time_step, bool values)
{
    struct net net = {.n = meeting->side_count};
    for (int k = 0; k < meeting->side_count; k++) {
        const struct mpm_scalar_side *const side = &meeting->sides[k];
        net.gained[k] = time_step * (side->capacity * side->rate - side->inflow) +
                        (values ? side->capacity * side->value - side->content : 0.0);
    }
    for (int k = 0; k < meeting->link_count; k++) {
        const struct mpm_scalar_link *const link = &meeting->links[k];
        net.gained[link->of[0]] += link->passed;
        net.gained[link->of[1]] -= link->passed;
        if (link->perfect)
            add_link(&net, link->of[0], link->of[1], 1.0);
    }
    find_potentials(&net);
    for (int k = 0; k < meeting->link_count; k++) {
        struct mpm_scalar_link *const link = &meeting->links[k];
        if (link->perfect)
            link->passed = net.potential[link->of[0]] - net.potential[link->of[1]];
    }
}

/* -------------------------------------------------------------------- the exchange */

/* The groups that hang together with group `first`, if it is the first of them. */
static int list_linked(const int label[SIDES], int count, int first, int list[SIDES])
{
    int n = 0;
    for (int k = 0; k < count && label[first] == first; k++)
        if (label[k] == first)
            list[n++] = k;
    return n;
}

static int place_in(const int *list, int n, int group)
{
    for (int k = 0; k < n; k++)
        if (list[k] == group)
            return k;
    return -1;
}

/* Capacities and inflow of groups stand at the first of their fields. */
struct groups {
    int label[SIDES]; /* of the groups that conductances link; -1: no group */
    double capacity[SIDES], inflow[SIDES], gained[SIDES];
};

static void exchange_linked(const struct mpm_scalar_meeting *meeting, double time_step, int first,
                            struct groups *groups)
{
    int list[SIDES] = {0};
    struct modes modes = {.n = list_linked(groups->label, meeting->side_count, first, list)};
    if (modes.n < 2)
        return;
    for (int k = 0; k < modes.n; k++) {
        modes.capacity[k] = groups->capacity[list[k]];
        modes.value[k] = meeting->sides[list[k]].value;
        modes.rate[k] = groups->inflow[list[k]] / groups->capacity[list[k]];
    }
    for (int k = 0; k < meeting->link_count; k++) {
        const struct mpm_scalar_link *const link = &meeting->links[k];
        const int one = place_in(list, modes.n, meeting->group[link->of[0]]);
        const int other = place_in(list, modes.n, meeting->group[link->of[1]]);
        if (link->perfect || one < 0 || one == other)
            continue;
        const double g = time_step * link->conductance;
        const double across = g / sqrt(modes.capacity[one]) / sqrt(modes.capacity[other]);
        modes.matrix[one][one] += g / modes.capacity[one];
        modes.matrix[other][other] += g / modes.capacity[other];
        modes.matrix[one][other] -= across;
        modes.matrix[other][one] -= across;
    }
    find_gains(&modes, time_step);
    for (int k = 0; k < modes.n; k++)
        groups->gained[list[k]] = modes.gained[k];
}

static void collect_groups(const struct mpm_scalar_meeting *meeting, struct groups *groups)
{
    memset(groups, 0, sizeof *groups);
    for (int k = 0; k < meeting->side_count; k++) {
        const int g = meeting->group[k];
        groups->label[k] = g == k ? k : -1;
        groups->capacity[g] += meeting->sides[k].capacity;
        groups->inflow[g] += meeting->sides[k].inflow;
    }
    for (int k = 0; k < meeting->link_count; k++)
        if (!meeting->links[k].perfect)
            unite(groups->label, meeting->side_count, meeting->group[meeting->links[k].of[0]],
                  meeting->group[meeting->links[k].of[1]]);
}

void mpm_scalar_meeting_exchange(struct mpm_scalar_meeting *meeting, double time_step, bool values)
{
    struct groups groups;
    collect_groups(meeting, &groups);
    for (int k = 0; k < meeting->side_count; k++)
        exchange_linked(meeting, time_step, k, &groups);
    for (int k = 0; k < meeting->side_count; k++) {
        const int g = meeting->group[k];
        meeting->sides[k].rate =
            (groups.inflow[g] + groups.gained[g] / time_step) / groups.capacity[g] +
            meeting->sides[k].settling / time_step;
    }
    pass_by_conductance(meeting, groups.gained);
    pass_within_groups(meeting, time_step, values);
}
