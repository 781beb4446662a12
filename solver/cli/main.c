/* mpm: the solver's command.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <unistd.h>

/* Which options a command takes; bits of `takes`. */
enum {
    TAKES_SCENE = 1,
    TAKES_RUN = 2,
    TAKES_SCHEMA = 4,
    TAKES_NEW = 8,
    TAKES_PLOT = 16,
    TAKES_QUIET = 32
};

#define OPTION(who, key, member, form, what, text)                                                 \
    {                                                                                              \
        .takes = (who), .name = (key), .kind = MPM_OPTION_##form,                                  \
        .offset = offsetof(struct cli_arguments, member), .value = (what), .help = (text)          \
    }

#define OUTPUT(who, what, text)                                                                    \
    {                                                                                              \
        .takes = (who), .name = "output", .letter = 'o', .kind = MPM_OPTION_TEXT,                  \
        .offset = offsetof(struct cli_arguments, output), .value = (what), .help = (text)          \
    }

static const struct mpm_option options[] = {
    OUTPUT(TAKES_RUN, "DIR", "folder for the results"),
    OUTPUT(TAKES_NEW, "FILE", "the file to write; KIND.yaml unless given"),
    OUTPUT(TAKES_PLOT, "DIR", "folder for the pictures; that of the results unless given"),
    OPTION(TAKES_RUN, "overwrite", overwrite, FLAG, NULL, "replace the results that DIR holds"),
    OPTION(TAKES_RUN, "resume", resume, FLAG, NULL, "go on from the checkpoint in DIR"),
    OPTION(TAKES_SCENE, "set", settings, LIST, "PATH=VALUE",
           "set a value of the scene, the last one wins; PATH= takes the key out"),
    OPTION(TAKES_SCENE, "threads", threads, TEXT, "N",
           "compute with at most so many threads (OMP_NUM_THREADS, or all processors)"),
    {.takes = TAKES_QUIET,
     .name = "quiet",
     .letter = 'q',
     .kind = MPM_OPTION_FLAG,
     .offset = offsetof(struct cli_arguments, quiet),
     .help = "print nothing but errors"},
    OPTION(TAKES_SCENE, "kernels", kernels, TEXT, "auto|reference|fast",
           "auto, fast wherever the scene allows, unless given"),
    OPTION(TAKES_SCENE, "simd", simd, TEXT, "auto|baseline|x86-64-v3",
           "instructions of the fast kernels: auto, the widest of this machine, unless given"),
    OPTION(TAKES_SCHEMA, "filter", filter, TEXT, "WORD",
           "only keys that have the word in their name, type, range or meaning"),
    OPTION(TAKES_SCHEMA, "json", json, FLAG, NULL,
           "print a JSON Schema (draft 7) of scenes, for editors"),
    OPTION(TAKES_SCHEMA, "list", list, FLAG, NULL, "print the keys and laws as JSON, for programs"),
    OPTION(TAKES_NEW, "list", list, FLAG, NULL, "list the kinds"),
    OPTION(TAKES_NEW, "names", names, FLAG, NULL, "print the names of the kinds alone"),
    OPTION(TAKES_PLOT, "list", list, FLAG, NULL, "list the fields"),
    OPTION(TAKES_PLOT, "names", names, FLAG, NULL,
           "print the names for --field alone: those of the snapshot, or all without DIR"),
    {.takes = TAKES_PLOT,
     .name = "field",
     .kind = MPM_OPTION_TEXT,
     .offset = offsetof(struct cli_arguments, field),
     .value = "FIELD",
     .help = "what to draw: a field, or one component of it, as stress.xx; von_mises unless given",
     .names = "plot --names DIR"},
    OPTION(TAKES_PLOT, "snapshot", snapshot, TEXT, "N",
           "number of the snapshot to draw; the last one unless given"),
    OPTION(TAKES_PLOT, "format", format, TEXT, "svg|png",
           "format of the pictures; svg unless given"),
};

static const struct mpm_command_entry commands[] = {
    {.name = "run",
     .takes = TAKES_SCENE | TAKES_RUN | TAKES_QUIET,
     .operands = "SCENE",
     .summary = "run a scene and write its results",
     .description =
         "The results go to the folder DIR, or to NAME-results in the current folder for a scene "
         "NAME.yaml: run.json, history.csv, particles-NNNNNN.hdf and particles.hdf.series, which "
         "ParaView opens. A folder that holds results is refused unless --overwrite is given, "
         "which removes them first.\n\n"
         "Results are the same for any number of threads, and for any level of SIMD. 'mpm check' "
         "states which kernels and how many threads a scene gets, and why. PATH is a place in the "
         "scene, such as grid.refine, materials.polymer.bulk or bodies.0.velocity.1; VALUE is "
         "YAML. PATH= without a value takes the key, or the entry of a list, out of the scene. "
         "SCENE - is read from standard input, and requires --output.\n\n"
         "With output.checkpoint (an interval of the scene's time) or output.checkpoint_seconds "
         "(of the clock) a run leaves checkpoint.h5 and the one before it, "
         "checkpoint-previous.h5. SIGINT, SIGTERM and SIGXCPU end a run after the step at hand, "
         "with a checkpoint and exit status 128 plus the signal's number; a second SIGINT or "
         "SIGTERM ends it at once. --resume goes on from the last sound checkpoint, to the same "
         "bytes as a run without interruption; the scene, its settings and the kernels must be "
         "the same, threads and level of SIMD need not.",
     .run = cli_run},
    {.name = "check",
     .takes = TAKES_SCENE,
     .operands = "SCENE",
     .summary = "validate a scene and print what running it costs",
     .description = "All mistakes of a scene are listed, up to ten. SCENE - is read from standard "
                    "input.",
     .run = cli_check},
    {.name = "info",
     .operands = "",
     .summary = "print version, git revision, compiler, flags, libraries, SIMD in use",
     .run = cli_info},
    {.name = "schema",
     .takes = TAKES_SCHEMA,
     .operands = "",
     .summary = "print every scene key: type, unit, default, range, one line of help",
     .description = "An editor that knows YAML completes and checks scenes by 'mpm schema --json > "
                    "scene.schema.json', with a first line '# yaml-language-server: "
                    "$schema=scene.schema.json' in a scene.",
     .run = cli_schema},
    {.name = "new",
     .takes = TAKES_NEW | TAKES_QUIET,
     .operands = "[KIND]",
     .summary = "write a commented scene to begin with, which runs at once",
     .description = "The scene goes to the file KIND.yaml in the current folder, or to that of "
                    "--output. A file that is there is never overwritten. 'mpm new --list' lists "
                    "the kinds.",
     .run = cli_new,
     .names = "new --names"},
    {.name = "plot",
     .takes = TAKES_PLOT | TAKES_QUIET,
     .operands = "[DIR]",
     .summary = "draw a field of the particles, and the history, with gnuplot",
     .description =
         "DIR is a folder that 'mpm run' has written. The pictures go there too, or to the folder "
         "of --output: plot-FIELD-NNNNNN.svg has the particles with their domains, "
         "plot-history.svg the energies and the range of det F over time. 'mpm plot --list' lists "
         "fields. gnuplot runs without a shell, with scripts of this program alone: a folder of "
         "results is only data.",
     .run = cli_plot},
};

static int run(int argc, char **argv)
{
    struct command command = {.signal_number = 0};
    const struct mpm_command_line line = {
        .program = "mpm",
        .about = "The reference solver of Touchstone for the Material Point Method.",
        .notes = "Exit status: 0 done; 2 bad usage or bad input; 3 the run failed; 4 the "
                 "environment failed (disk, memory, file); 128 + n ended by signal n.",
        .commands = commands,
        .command_count = G_N_ELEMENTS(commands),
        .options = options,
        .option_count = G_N_ELEMENTS(options),
        .values = &command.arguments,
        .rest = &command.arguments.operands,
        .out = stdout,
        .err = stderr,
    };
    g_set_prgname(line.program);
    const enum mpm_status status = mpm_command_line_run(&line, argc, argv, &command);
    mpm_command_line_clear(&line);
    return status == MPM_INTERRUPTED ? (int)status + command.signal_number : (int)status;
}

/* A reader that goes away (`mpm schema | head`) and a full disk come back as errors of
 * the call that writes, not as signals. */
static void ignore_write_signals(void)
{
    const struct sigaction ignore = {.sa_handler = SIG_IGN};
    (void)sigaction(SIGPIPE, &ignore, NULL);
    (void)sigaction(SIGXFSZ, &ignore, NULL);
}

/* A result file must not get the number of a standard stream that the caller has closed: what is
 * printed there would go into it. Opened the wrong way round, such a stream still fails. */
static void fill_closed_streams(void)
{
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++)
        if (fcntl(stream, F_GETFD) == -1 && errno == EBADF)
            (void)open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int main(int argc, char **argv)
{
    fill_closed_streams();
    static char everything[1 << 18]; /* printed at the end: one call reports why it failed */
    (void)setvbuf(stdout, everything, _IOFBF, sizeof everything);
    ignore_write_signals();
    const int status = run(argc, argv);
    const bool written = fflush(stdout) == 0 && ferror(stdout) == 0;
    if (written || errno == EPIPE || status != MPM_OK)
        return status;
    (void)fprintf(stderr, "mpm: standard output cannot be written: %s\n", g_strerror(errno));
    return MPM_ENVIRONMENT_FAILED;
}
