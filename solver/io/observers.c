/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/observers.h"

#include "base/status.h"
#include "io/run_state.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

struct mpm_observation {
    const struct mpm_scene *scene;
    const struct mpm_simulation *simulation;
    double *values[MPM_FIELD_COUNT]; /* taken when first asked for, kept for further ones */
    bool filled[MPM_FIELD_COUNT];    /* in this observation */
};

/* What was due last. */
struct entry {
    const struct mpm_observer *observer;
    double instant; /* number of the last one passed */
    size_t reached; /* how many of `times` have been */
    bool due;
};

struct mpm_observers {
    struct entry *entries;
    size_t count;
    struct mpm_observation observation;
};

/* ------------------------------------------------------------------- observations */

const struct mpm_simulation *mpm_observation_simulation(const struct mpm_observation *observation)
{
    return observation->simulation;
}

enum mpm_status mpm_observation_field(struct mpm_observation *observation, enum mpm_field field,
                                      struct mpm_field_view *view, struct mpm_error *error)
{
    *view = (struct mpm_field_view){.values = NULL};
    if ((int)field < 0 || field >= MPM_FIELD_COUNT)
        return mpm_error_set(error, MPM_BAD_INPUT, "there is no field %d; allowed: from 0 to %d",
                             (int)field, MPM_FIELD_COUNT - 1);
    const struct mpm_field_info *const info = mpm_field_describe(field);
    if (!mpm_scene_has_field(observation->scene, field))
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "the scene has no field %s; allowed: fields of its snapshots",
                             info->name);
    const size_t count = mpm_simulation_particle_count(observation->simulation);
    const size_t size = count * info->components;
    if (observation->values[field] == NULL)
        observation->values[field] = calloc(size + 1, sizeof *observation->values[field]);
    if (observation->values[field] == NULL)
        return mpm_error_memory(error, size * sizeof(double), info->name);
    if (!observation->filled[field])
        mpm_simulation_field(observation->simulation, field, observation->values[field]);
    observation->filled[field] = true;
    *view = (struct mpm_field_view){.values = observation->values[field],
                                    .count = count,
                                    .components = info->components,
                                    .stride = info->components};
    return MPM_OK;
}

/* ----------------------------------------------------------------- instants */

/* A time this close to the one at hand has come: a last sliver of a step would serve nobody. */
static const double time_tolerance = 1e-12;

static size_t times_reached(const struct mpm_observer *observer, double time)
{
    const double until = time + time_tolerance * fabs(time);
    size_t reached = 0;
    while (reached < observer->time_count && observer->times[reached] <= until)
        reached++;
    return reached;
}

static void note(struct entry *entry, double time)
{
    entry->instant = mpm_run_instant(time, entry->observer->interval);
    entry->reached = times_reached(entry->observer, time);
}

double mpm_observers_limit(const struct mpm_observers *observers, double end)
{
    double limit = end;
    for (size_t k = 0; observers != NULL && k < observers->count; k++) {
        const struct entry *const entry = &observers->entries[k];
        const struct mpm_observer *const observer = entry->observer;
        if (observer->interval > 0.0)
            limit = fmin(limit, (entry->instant + 1.0) * observer->interval);
        if (entry->reached < observer->time_count)
            limit = fmin(limit, observer->times[entry->reached]);
    }
    return limit < end - time_tolerance * fabs(end) ? limit : end;
}

bool mpm_observers_due(struct mpm_observers *observers, bool end)
{
    bool any = false;
    for (size_t k = 0; observers != NULL && k < observers->count; k++) {
        struct entry *const entry = &observers->entries[k];
        const struct entry before = *entry;
        const uint64_t steps = entry->observer->steps;
        note(entry, mpm_simulation_time(observers->observation.simulation));
        entry->due =
            end || entry->instant > before.instant || entry->reached > before.reached ||
            (steps > 0 && mpm_simulation_step(observers->observation.simulation) % steps == 0);
        any = any || entry->due;
    }
    return any;
}

/* -------------------------------------------------------------------- calls */

static enum mpm_status check(const struct mpm_observer *observer, size_t index,
                             struct mpm_error *error)
{
    if (observer->observe == NULL)
        return mpm_error_set(error, MPM_BAD_INPUT, "observer %zu: it has no function", index);
    if (!isfinite(observer->interval) || observer->interval < 0.0)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "observer %zu: interval %g; allowed: 0 or above, finite", index,
                             observer->interval);
    for (size_t k = 0; k < observer->time_count; k++) {
        const double before = k > 0 ? observer->times[k - 1] : -HUGE_VAL;
        if (!isfinite(observer->times[k]) || observer->times[k] <= before)
            return mpm_error_set(error, MPM_BAD_INPUT,
                                 "observer %zu: time %zu is %g; allowed: finite times that ascend",
                                 index, k, observer->times[k]);
    }
    return MPM_OK;
}

enum mpm_status mpm_observers_create(const struct mpm_observer *list, size_t count,
                                     const struct mpm_scene *scene,
                                     const struct mpm_simulation *simulation,
                                     struct mpm_observers **observers, struct mpm_error *error)
{
    *observers = NULL;
    for (size_t k = 0; k < count; k++)
        MPM_TRY(check(&list[k], k, error));
    struct mpm_observers *const made = g_new0(struct mpm_observers, 1);
    made->entries = g_new0(struct entry, count + 1);
    made->count = count;
    made->observation = (struct mpm_observation){.scene = scene, .simulation = simulation};
    for (size_t k = 0; k < count; k++) {
        made->entries[k].observer = &list[k];
        note(&made->entries[k], mpm_simulation_time(simulation));
    }
    *observers = made;
    return MPM_OK;
}

void mpm_observers_free(struct mpm_observers *observers)
{
    if (observers == NULL)
        return;
    for (int field = 0; field < MPM_FIELD_COUNT; field++)
        free(observers->observation.values[field]);
    g_free(observers->entries);
    g_free(observers);
}

enum mpm_status mpm_observers_call(struct mpm_observers *observers, bool all,
                                   struct mpm_error *error)
{
    for (int field = 0; observers != NULL && field < MPM_FIELD_COUNT; field++)
        observers->observation.filled[field] = false;
    for (size_t k = 0; observers != NULL && k < observers->count; k++) {
        const struct mpm_observer *const observer = observers->entries[k].observer;
        struct mpm_error own = {.status = MPM_OK};
        if (!all && !observers->entries[k].due)
            continue;
        const enum mpm_status status =
            observer->observe(observer->context, &observers->observation, &own);
        if (status != MPM_OK)
            return mpm_error_set(error, status, "observer %zu: %s", k,
                                 own.message[0] != '\0' ? own.message : "ended the run");
    }
    return MPM_OK;
}
