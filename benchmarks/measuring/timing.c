/* Timing: rounds over a list of points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/measuring/timing.h"

#include "benchmarks/common/findings.h"
#include "benchmarks/measuring/side_by_side.h"
#include "verification/common/failure.h"

#include <math.h>
#include <string.h>
#include <time.h>

/* A timing is at least this long: a thousand times what a clock or an interrupt costs. */
static const double SHORTEST = 0.1;
/* Steps are rehearsed for this long before their number is chosen. */
static const double REHEARSAL = 0.03;

/* A simulation sorts once in so many steps (mpm_simulation_advance): timings of whole
 * intervals hold each its share of sorts. */
enum { SORT_INTERVAL = 32, WARM_UP = 2 };

static double seconds_of(clockid_t clock)
{
    struct timespec time;
    (void)clock_gettime(clock, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

double bench_clock_wall(void)
{
    return seconds_of(CLOCK_MONOTONIC);
}

double bench_clock_cpu(void)
{
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

double bench_clock_thread(void)
{
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

/* ------------------------------------------------------------- one simulation */

/* What is known of a point while its list is measured. */
struct course {
    struct bench_point *point;
    struct mpm_scene *scene; /* NULL for a probe */
    unsigned steps;
    double step_seconds, other_seconds; /* of the clock: a step; creation and warm-up, or a probe */
    size_t particles;                   /* deformable ones: what makes a particle-step */
    size_t bytes;
    struct bench_sample *samples; /* by round */
    struct mpm_phases *phases;    /* by round: of the timed steps */
};

enum mpm_status bench_advance(struct mpm_simulation *simulation, unsigned steps,
                              struct mpm_error *error)
{
    for (unsigned i = 0; i < steps; i++)
        TRY(mpm_simulation_advance(simulation, HUGE_VAL, error));
    return MPM_OK;
}

static unsigned warm_up(const struct bench_point *point)
{
    return point->warm_up > 0 ? point->warm_up : WARM_UP;
}

static enum mpm_status time_steps(struct course *course, struct mpm_simulation *simulation,
                                  size_t round, struct mpm_error *error)
{
    struct mpm_phases before;
    TRY(bench_advance(simulation, warm_up(course->point), error));
    mpm_simulation_phases(simulation, &before);
    const double cpu = bench_clock_cpu(), wall = bench_clock_wall();
    TRY(bench_advance(simulation, course->steps, error));
    course->samples[round] = (struct bench_sample){
        .work = (double)course->particles * course->steps,
        .cpu = bench_clock_cpu() - cpu,
        .wall = bench_clock_wall() - wall,
    };
    mpm_simulation_phases(simulation, &course->phases[round]);
    for (size_t k = 0; k < before.count; k++)
        course->phases[round].seconds[k] -= before.seconds[k];
    return MPM_OK;
}

static enum mpm_status visit_runs(const struct course *course, struct bench_sample *sample,
                                  struct mpm_error *error)
{
    const struct bench_point *point = course->point;
    const struct bench_runs runs = {course->scene, &point->simulation, point->runs, warm_up(point),
                                    course->steps};
    TRY(bench_side_by_side(&runs, sample, error));
    sample->work *= (double)course->particles;
    return MPM_OK;
}

static enum mpm_status visit(struct course *course, size_t round, struct mpm_error *error)
{
    const struct bench_point *point = course->point;
    struct mpm_simulation *simulation = NULL;
    if (point->probe != NULL)
        return point->probe(point->probe_context, &course->samples[round], error);
    if (point->runs > 1)
        return visit_runs(course, &course->samples[round], error);
    TRY(mpm_simulation_create(course->scene, &point->simulation, &simulation, error));
    const enum mpm_status status = time_steps(course, simulation, round, error);
    mpm_simulation_free(simulation);
    return status;
}

/* ------------------------------------------------------------------ rehearsal */

/* Rigid particles have no mass. */
static size_t deformable(const struct mpm_simulation *simulation)
{
    const size_t all = mpm_simulation_particle_count(simulation);
    double *mass = g_new(double, all);
    size_t count = 0;
    mpm_simulation_field(simulation, MPM_FIELD_MASS, mass);
    for (size_t i = 0; i < all; i++)
        count += mass[i] > 0;
    g_free(mass);
    return count;
}

static void note_facts(struct course *course, const struct mpm_simulation *simulation)
{
    struct bench_point *point = course->point;
    course->particles = deformable(simulation);
    bench_point_number(point, "particles", (double)course->particles);
    bench_point_number(point, "threads", point->simulation.threads);
    bench_point_number(point, "threads_used", mpm_simulation_threads(simulation));
    bench_point_text(point, "kernels", mpm_simulation_kernels(simulation));
    bench_point_text(point, "simd", mpm_simulation_simd(simulation));
    course->bytes = mpm_simulation_bytes(simulation);
}

/* How long a step takes. */
static enum mpm_status rehearse_steps(struct course *course, struct mpm_simulation *simulation,
                                      struct mpm_error *error)
{
    TRY(bench_advance(simulation, warm_up(course->point), error));
    const double start = bench_clock_wall();
    unsigned steps = 0;
    for (; steps == 0 || bench_clock_wall() - start < REHEARSAL; steps++)
        TRY(bench_advance(simulation, 1, error));
    course->step_seconds = (bench_clock_wall() - start) / steps;
    const double least = ceil(SHORTEST / course->step_seconds);
    course->steps = course->point->steps > 0 ? course->point->steps : (unsigned)least;
    return MPM_OK;
}

static enum mpm_status rehearse(struct course *course, struct mpm_error *error)
{
    struct bench_point *point = course->point;
    struct mpm_simulation *simulation = NULL;
    const double start = bench_clock_wall();
    if (point->probe != NULL) {
        TRY(point->probe(point->probe_context, &course->samples[0], error));
        course->other_seconds = bench_clock_wall() - start;
        return MPM_OK;
    }
    TRY(mpm_scene_read(point->scene, (const char *const *)point->set->pdata, point->set->len,
                       &course->scene, error));
    TRY(mpm_simulation_create(course->scene, &point->simulation, &simulation, error));
    course->other_seconds = bench_clock_wall() - start;
    note_facts(course, simulation);
    const enum mpm_status status = rehearse_steps(course, simulation, error);
    mpm_simulation_free(simulation);
    course->other_seconds *= MAX(point->runs, 1); /* created one after the other */
    course->other_seconds += warm_up(point) * course->step_seconds;
    return status;
}

/* ----------------------------------------------------------------------- plan */

static double cost(const struct course *course)
{
    return course->other_seconds + course->steps * course->step_seconds;
}

static double round_cost(const struct course *courses, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += cost(&courses[i]);
    return sum;
}

/* Whole sort intervals where there is time for them, the cheapest first. */
static void lengthen(struct course *courses, size_t count, double seconds)
{
    double rest = seconds / BENCH_ROUNDS_MIN - round_cost(courses, count);
    bool *done = g_new0(bool, count);
    for (size_t pass = 0; pass < count; pass++) {
        size_t cheapest = count;
        for (size_t i = 0; i < count; i++)
            if (!done[i] &&
                (cheapest == count || courses[i].step_seconds < courses[cheapest].step_seconds))
                cheapest = i;
        struct course *course = &courses[cheapest];
        const unsigned whole = (course->steps + SORT_INTERVAL - 1) / SORT_INTERVAL * SORT_INTERVAL;
        const double more = (whole - course->steps) * course->step_seconds;
        done[cheapest] = true;
        if (course->point->steps == 0 && more <= rest) {
            course->steps = whole;
            rest -= more;
        }
    }
    g_free(done);
}

static size_t choose_rounds(const struct course *courses, size_t count, double seconds)
{
    const double fit = seconds / round_cost(courses, count);
    if (fit >= BENCH_ROUNDS_MAX)
        return BENCH_ROUNDS_MAX;
    return fit > BENCH_ROUNDS_MIN ? (size_t)fit : (size_t)BENCH_ROUNDS_MIN;
}

/* --------------------------------------------------------------------- lines */

static bool uses_wall(const struct bench_point *point)
{
    return point->clock == BENCH_CLOCK_WALL ||
           (point->clock == BENCH_CLOCK_AUTO && point->simulation.threads > 1);
}

static double rate(const struct bench_sample *sample, bool wall)
{
    return sample->work / (wall ? sample->wall : sample->cpu);
}

static void write_rates(struct bench_context *context, const struct bench_subject *subject,
                        const struct course *course, const double *rates, size_t rounds)
{
    const struct bench_point *point = course->point;
    const bool probe = point->probe != NULL, wall = uses_wall(point);
    const char *quantity = probe ? point->quantity : "particle_steps_per_second";
    const char *unit = probe ? point->unit : "1/s";
    char *beside = g_strdup_printf("%s_%s", quantity, wall ? "cpu" : "wall");
    double *other = g_new(double, rounds);
    for (size_t r = 0; r < rounds; r++)
        other[r] = rate(&course->samples[r], !wall);
    bench_result(context, subject, quantity, unit, rates, rounds);
    bench_detail(context, subject, beside, unit, other, rounds);
    g_free(other);
    g_free(beside);
}

static void write_bytes(struct bench_context *context, const struct bench_subject *subject,
                        const struct course *course)
{
    (void)bench_records_value(context->records, subject, "bytes_per_particle", "B",
                              (double)course->bytes / (double)course->particles);
}

/* Nanoseconds of the clock for a particle-step; "rest" is what no phase counts. */
static void write_phases(struct bench_context *context, const struct bench_subject *subject,
                         const struct course *course, size_t rounds)
{
    double *values = g_new(double, rounds), *rest = g_new(double, rounds);
    for (size_t r = 0; r < rounds; r++)
        rest[r] = 1e9 * course->samples[r].wall / course->samples[r].work;
    for (size_t k = 0; k < course->phases[0].count; k++) {
        char *quantity = g_strdup_printf("phase_%s", course->phases[0].name[k]);
        for (size_t r = 0; r < rounds; r++) {
            values[r] = 1e9 * course->phases[r].seconds[k] / course->samples[r].work;
            rest[r] -= values[r];
        }
        bench_detail(context, subject, quantity, "ns", values, rounds);
        g_free(quantity);
    }
    bench_detail(context, subject, "phase_rest", "ns", rest, rounds);
    g_free(rest);
    g_free(values);
}

static size_t find(const struct course *courses, size_t count, const char *name)
{
    size_t i = 0;
    while (i < count && strcmp(courses[i].point->name, name) != 0)
        i++;
    return i;
}

static void write_lines(struct bench_context *context, const char *group,
                        const struct course *courses, const struct bench_rates *rates)
{
    for (size_t i = 0; i < rates->points; i++) {
        const struct bench_point *point = courses[i].point;
        const struct bench_subject subject = {group, point->name, point->settings};
        bench_point_text(courses[i].point, "clock", uses_wall(point) ? "wall" : "cpu");
        if (point->probe == NULL)
            bench_point_number(courses[i].point, "steps", courses[i].steps);
        write_rates(context, &subject, &courses[i], bench_rates_of(rates, i), rates->rounds);
        if (point->phases) {
            write_bytes(context, &subject, &courses[i]);
            write_phases(context, &subject, &courses[i], rates->rounds);
        }
    }
    for (size_t i = 0; i < rates->points; i++) {
        const struct bench_point *point = courses[i].point;
        const struct bench_subject subject = {group, point->name, point->settings};
        const size_t other =
            point->against == NULL ? rates->points : find(courses, rates->points, point->against);
        if (other < rates->points)
            bench_comparison(context, &subject, point->against,
                             point->probe == NULL ? "particle_steps_per_second" : point->quantity,
                             BENCH_RATE, bench_rates_of(rates, i), bench_rates_of(rates, other),
                             rates->rounds);
    }
}

/* --------------------------------------------------------------------- rounds */

void bench_rates_clear(struct bench_rates *rates)
{
    g_free(rates->values);
    *rates = (struct bench_rates){0, 0, NULL};
}

const double *bench_rates_of(const struct bench_rates *rates, size_t point)
{
    return &rates->values[point * rates->rounds];
}

static enum mpm_status named(const struct course *course, enum mpm_status status,
                             struct mpm_error *error)
{
    const struct mpm_error cause = *error;
    return status == MPM_OK
               ? MPM_OK
               : failure_set(error, status, "%s: %s", course->point->name, cause.message);
}

static enum mpm_status run_rounds(struct bench_context *context, struct course *courses,
                                  size_t count, size_t rounds, struct mpm_error *error)
{
    for (size_t r = 0; r < rounds; r++)
        for (size_t i = 0; i < count; i++) {
            struct course *course = &courses[r % 2 == 0 ? i : count - 1 - i];
            bench_console_progress(context->console, r * count + i + 1, rounds * count,
                                   course->point->name);
            TRY(named(course, visit(course, r, error), error));
        }
    return MPM_OK;
}

static enum mpm_status measure(struct bench_context *context, struct course *courses, size_t count,
                               double seconds, struct bench_rates *rates, struct mpm_error *error)
{
    const double start = bench_clock_wall();
    for (size_t i = 0; i < count; i++) {
        bench_console_progress(context->console, i + 1, count, "rehearsal");
        TRY(named(&courses[i], rehearse(&courses[i], error), error));
    }
    seconds -= bench_clock_wall() - start;
    lengthen(courses, count, seconds);
    const size_t rounds = choose_rounds(courses, count, seconds);
    TRY(run_rounds(context, courses, count, rounds, error));
    *rates = (struct bench_rates){count, rounds, g_new(double, count *rounds)};
    for (size_t i = 0; i < count; i++)
        for (size_t r = 0; r < rounds; r++)
            rates->values[i * rounds + r] =
                rate(&courses[i].samples[r], uses_wall(courses[i].point));
    return MPM_OK;
}

enum mpm_status bench_measure(struct bench_context *context, const char *group, GArray *points,
                              double seconds, struct bench_rates *rates, struct mpm_error *error)
{
    const size_t count = points->len;
    struct bench_rates found = {0, 0, NULL};
    struct course *courses = g_new0(struct course, count);
    for (size_t i = 0; i < count; i++) {
        courses[i].point = &g_array_index(points, struct bench_point, i);
        courses[i].samples = g_new0(struct bench_sample, BENCH_ROUNDS_MAX);
        courses[i].phases = g_new0(struct mpm_phases, BENCH_ROUNDS_MAX);
    }
    const enum mpm_status status = measure(context, courses, count, seconds, &found, error);
    if (status == MPM_OK)
        write_lines(context, group, courses, &found);
    for (size_t i = 0; i < count; i++) {
        mpm_scene_free(courses[i].scene);
        g_free(courses[i].samples);
        g_free(courses[i].phases);
    }
    g_free(courses);
    if (rates != NULL && status == MPM_OK)
        *rates = found;
    else
        bench_rates_clear(&found);
    return status;
}

enum mpm_status bench_measure_lists(struct bench_context *context, const char *group,
                                    const struct bench_list *lists, size_t count,
                                    struct mpm_error *error)
{
    const double part = context->tier == BENCH_STANDARD ? 1 : 0.1;
    enum mpm_status status = MPM_OK;
    for (size_t i = 0; i < count && status == MPM_OK; i++) {
        GArray *points = bench_points_new();
        lists[i].add(context, points);
        status = bench_measure(context, group, points, part * lists[i].seconds, NULL, error);
        g_array_unref(points);
    }
    return status;
}
