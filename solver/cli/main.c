/* mpm: the solver's command.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

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
         "bodies.0.velocity.1; VALUE is YAML.",
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
               "environment failed (disk, memory, file).");
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
        return cli_fail(MPM_BAD_INPUT, "a command is missing: run, check, info or schema; "
                                       "see 'mpm --help'");
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
        return print_help();
    if (strcmp(argv[1], "--version") == 0)
        return print_version();
    for (size_t i = 0; i < G_N_ELEMENTS(commands); i++)
        if (strcmp(argv[1], commands[i].name) == 0)
            return cli_command_run(&commands[i], argc - 1, argv + 1);
    return cli_fail(MPM_BAD_INPUT,
                    "unknown command '%s': allowed are run, check, info, schema; "
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

int main(int argc, char **argv)
{
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
