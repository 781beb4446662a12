/* mpm: the solver's command.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const struct cli_command commands[] = {
    {.name = "run",
     .operands = "SCENE",
     .options = (const char *const[]){"output", "overwrite", "resume", "set", "quiet", "kernels",
                                      "simd", "threads", NULL},
     .summary = "Run a scene and write its results.",
     .description =
         "The results go to the folder DIR, or to NAME-results in the current folder for\n"
         "a scene NAME.yaml: run.json, history.csv, particles-NNNNNN.hdf and\n"
         "particles.hdf.series, which ParaView opens. A folder that holds results is\n"
         "refused unless --overwrite is given, which removes them first.\n"
         "Results are the same for any number of threads, and for any LEVEL of SIMD. 'mpm\n"
         "check' states which kernels and how many threads a scene gets, and why. PATH is a\n"
         "place in the scene, such as grid.refine, materials.polymer.bulk or\n"
         "bodies.0.velocity.1; VALUE is YAML.\n\n"
         "With output.checkpoint (an interval of the scene's time) or\n"
         "output.checkpoint_seconds (of the clock) a run leaves checkpoint.h5 and the one\n"
         "before it, checkpoint-previous.h5. SIGINT, SIGTERM and SIGXCPU end a run after the\n"
         "step at hand, with a checkpoint and exit status 128 plus the signal's number; a\n"
         "second SIGINT or SIGTERM ends it at once. --resume goes on from the last sound\n"
         "checkpoint, to the same bytes as a run without interruption; the scene, its\n"
         "settings and the kernels must be the same, threads and LEVEL need not.",
     .run = cli_run},
    {.name = "check",
     .operands = "SCENE",
     .options = (const char *const[]){"set", "kernels", "simd", "threads", NULL},
     .summary = "Validate a scene and print what running it costs.",
     .run = cli_check},
    {.name = "info",
     .operands = "",
     .options = (const char *const[]){NULL},
     .summary = "Print version, git revision, compiler, flags, libraries, SIMD in use.",
     .run = cli_info},
    {.name = "schema",
     .operands = "",
     .options = (const char *const[]){"json", NULL},
     .summary = "Print every scene key: type, unit, default, range, one line of help.",
     .run = cli_schema},
    {.name = "new",
     .operands = "[KIND]",
     .options = (const char *const[]){"list", "output", "quiet", NULL},
     .summary = "Write a commented scene to begin with, which runs at once.",
     .description = "The scene goes to the file KIND.yaml in the current folder, or to that of\n"
                    "--output. A file that is there is never overwritten. 'mpm new --list' lists\n"
                    "the kinds.",
     .run = cli_new},
    {.name = "plot",
     .operands = "[DIR]",
     .options =
         (const char *const[]){"field", "snapshot", "format", "output", "list", "quiet", NULL},
     .summary = "Draw a field of the particles, and the history, with gnuplot.",
     .description =
         "DIR is a folder that 'mpm run' has written. The pictures go there too, or to the\n"
         "folder of --output: plot-FIELD-NNNNNN.svg has the particles with their\n"
         "domains, plot-history.svg the energies and the range of det F over time.\n"
         "'mpm plot --list' lists fields. gnuplot runs without a shell, with scripts of\n"
         "this program alone: a folder of results is only data.",
     .run = cli_plot},
};

static int print_help(void)
{
    (void)puts("Usage: mpm COMMAND [OPTION...] [SCENE]\n\n"
               "The reference solver of Touchstone for the Material Point Method.\n\n"
               "Commands:");
    for (size_t i = 0; i < G_N_ELEMENTS(commands); i++)
        (void)printf("  %-8s %-6s %s\n", commands[i].name, commands[i].operands,
                     commands[i].summary);
    (void)puts("\n'mpm COMMAND --help' lists the options of a command, 'mpm --version' the "
               "version.\n\n"
               "Exit status: 0 done; 2 bad usage or bad input; 3 the run failed; 4 the\n"
               "environment failed (disk, memory, file); 128 + n ended by signal n.");
    return MPM_OK;
}

static int print_version(void)
{
    const struct mpm_build_info *build = mpm_build_info();
    (void)printf("mpm %s (%s)\n", build->version, build->revision);
    return MPM_OK;
}

static int dispatch(int argc, char **argv)
{
    if (argc < 2)
        return cli_fail(MPM_BAD_INPUT,
                        "a command is missing: run, check, info, schema, new or plot; "
                        "see 'mpm --help'");
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
        return print_help();
    if (strcmp(argv[1], "--version") == 0)
        return print_version();
    for (size_t i = 0; i < G_N_ELEMENTS(commands); i++)
        if (strcmp(argv[1], commands[i].name) == 0)
            return cli_command_run(&commands[i], argc - 1, argv + 1);
    return cli_fail(MPM_BAD_INPUT,
                    "unknown command '%s': allowed are run, check, info, schema, new, plot; "
                    "see 'mpm --help'",
                    argv[1]);
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
    const int status = dispatch(argc, argv);
    const bool written = fflush(stdout) == 0 && ferror(stdout) == 0;
    if (!written && errno != EPIPE && status == MPM_OK)
        return cli_fail(MPM_ENVIRONMENT_FAILED, "standard output cannot be written: %s",
                        g_strerror(errno));
    return status;
}
