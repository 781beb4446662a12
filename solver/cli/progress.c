/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/progress.h"

#include "mpm_words.h"

#include <inttypes.h>
#include <stdio.h>
#include <unistd.h>

enum {
    REDRAW_MICROSECONDS = 100000, /* ten times a second */
    CLOCK_TEXT_SIZE = 32,
};

void cli_progress_start(struct cli_progress *progress, bool quiet)
{
    const gint64 now = g_get_monotonic_time();
    *progress = (struct cli_progress){
        .quiet = quiet,
        .terminal = isatty(STDERR_FILENO) == 1,
        .start = now,
        .next_draw = now,
    };
}

/* "0:07", "12:30", "3:05:00" to go, if the rest goes as the run went so far. */
static const char *time_to_go(const struct cli_progress *progress, double fraction, gint64 now,
                              char text[CLOCK_TEXT_SIZE])
{
    const double elapsed = 1e-6 * (double)(now - progress->start);
    const double done = fraction - progress->first; /* since the start, or since it was resumed */
    const double left = done > 0.0 ? elapsed * (1.0 - fraction) / done : 0.0;
    const long seconds = left < 1e8 ? (long)(left + 0.5) : 100000000L;
    if (seconds >= 3600)
        g_snprintf(text, CLOCK_TEXT_SIZE, "%ld:%02ld:%02ld", seconds / 3600, seconds / 60 % 60,
                   seconds % 60);
    else
        g_snprintf(text, CLOCK_TEXT_SIZE, "%ld:%02ld", seconds / 60, seconds % 60);
    return text;
}

enum { NOTES_TEXT_SIZE = 128 };

/* "  residual 2.1e-03  kinetic energy 4.0e-05" where the scene has `time.rest`, "  energy x 1.62"
 * once it has grown; else "". */
static const char *notes_text(const struct mpm_simulation *simulation, char text[NOTES_TEXT_SIZE])
{
    struct mpm_rest rest;
    struct mpm_energy_growth growth;
    size_t length = 0;
    text[0] = '\0';
    (void)mpm_simulation_at_rest(simulation, &rest);
    if (rest.asked)
        length = (size_t)g_snprintf(text, NOTES_TEXT_SIZE, "  residual %.1e  kinetic energy %.1e",
                                    rest.residual, rest.kinetic_energy);
    if (mpm_simulation_energy_growth(simulation, &growth))
        g_snprintf(text + length, NOTES_TEXT_SIZE - length, "  energy x %.3g", growth.factor);
    return text;
}

static void draw_bar(struct cli_progress *progress, double fraction,
                     const struct mpm_simulation *simulation, gint64 now)
{
    char clock[CLOCK_TEXT_SIZE], notes[NOTES_TEXT_SIZE];
    char *const text =
        g_strdup_printf("%3.0f %%  t %.4g  step %" PRIu64 "%s  %s to go", 100.0 * fraction,
                        mpm_simulation_time(simulation), progress->step,
                        notes_text(simulation, notes), time_to_go(progress, fraction, now, clock));
    mpm_progress_draw(stderr, fraction, text);
    g_free(text);
    progress->line_open = true;
    progress->next_draw = now + REDRAW_MICROSECONDS;
}

static void print_tenth(struct cli_progress *progress, double fraction,
                        const struct mpm_simulation *simulation, gint64 now)
{
    char clock[CLOCK_TEXT_SIZE], notes[NOTES_TEXT_SIZE];
    progress->tenths = (int)(fraction * 10.0);
    (void)fprintf(stderr, "%3d %%  t %.4g  step %" PRIu64 "%s  %s to go\n", 10 * progress->tenths,
                  mpm_simulation_time(simulation), progress->step, notes_text(simulation, notes),
                  time_to_go(progress, fraction, now, clock));
}

static double seconds_stepping(const struct mpm_simulation *simulation)
{
    struct mpm_phases phases;
    mpm_simulation_phases(simulation, &phases);
    double seconds = 0.0;
    for (size_t i = 0; i < phases.count; i++)
        seconds += phases.seconds[i];
    return seconds;
}

void cli_progress_step(void *context, double fraction, const struct mpm_simulation *simulation)
{
    struct cli_progress *progress = context;
    if (progress->quiet)
        return;
    if (progress->step == 0)
        progress->first = mpm_simulation_step(simulation) > 1 ? fraction : 0.0;
    progress->step = mpm_simulation_step(simulation);
    progress->particles = mpm_simulation_particle_count(simulation);
    progress->seconds = seconds_stepping(simulation);
    const gint64 now = g_get_monotonic_time();
    if (progress->terminal && (now >= progress->next_draw || fraction >= 1.0))
        draw_bar(progress, fraction, simulation, now);
    else if (!progress->terminal && (int)(fraction * 10.0) > progress->tenths)
        print_tenth(progress, fraction, simulation, now);
}

void cli_progress_warn(void *context, const char *warning)
{
    struct cli_progress *progress = context;
    if (progress->quiet)
        return;
    cli_progress_end(progress);
    (void)fprintf(stderr, "mpm: warning: %s\n", warning);
}

void cli_progress_end(struct cli_progress *progress)
{
    if (progress->line_open)
        (void)fputc('\n', stderr);
    progress->line_open = false;
}
