/* gnuplot without a shell.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_gnuplot.h"

#include "mpm_file.h"

#include <errno.h>
#include <glib.h>
#include <signal.h>
#include <stdint.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#if defined __linux__ && (defined __x86_64__ || defined __aarch64__)
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <stddef.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#ifdef __x86_64__
#define OWN_ARCHITECTURE AUDIT_ARCH_X86_64
#else
#define OWN_ARCHITECTURE AUDIT_ARCH_AARCH64
#endif
enum { THREAD = 0x00010000 /* CLONE_THREAD, which POSIX names hide */, OTHER_CALLS = 0x40000000 };

#define LOAD(what)     BPF_STMT(BPF_LD | BPF_W | BPF_ABS, (unsigned)offsetof(struct seccomp_data, what))
#define RETURN(what)   BPF_STMT(BPF_RET | BPF_K, (what))
#define REFUSE(number) RETURN(SECCOMP_RET_ERRNO | (number))
/* the next statement, for that system call alone */
#define OF_CALL(call) BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (call), 0, 1)

/* The program itself was started before the filter holds new ones back: it may execute, once its
 * process is there, but make no process. Threads are allowed. */
static bool forbid_processes(void)
{
    static struct sock_filter rules[] = {
        LOAD(arch),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, OWN_ARCHITECTURE, 1, 0),
        REFUSE(EPERM),
        LOAD(nr),
        BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, OTHER_CALLS, 0, 1), /* those of x32 */
        REFUSE(EPERM),
#ifdef __NR_fork
        OF_CALL(__NR_fork),
        REFUSE(EPERM),
        OF_CALL(__NR_vfork),
        REFUSE(EPERM),
#endif
#ifdef __NR_clone3
        OF_CALL(__NR_clone3), /* its flags lie in memory: clone is asked for instead */
        REFUSE(ENOSYS),
#endif
        OF_CALL(__NR_socket),
        REFUSE(EPERM),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_clone, 1, 0),
        RETURN(SECCOMP_RET_ALLOW),
        LOAD(args[0]),
        BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, THREAD, 0, 1),
        RETURN(SECCOMP_RET_ALLOW),
        REFUSE(EPERM),
    };
    const struct sock_fprog program = {G_N_ELEMENTS(rules), rules};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}
#else
static bool forbid_processes(void)
{
    const struct rlimit none = {0, 0};
    return setrlimit(RLIMIT_NPROC, &none) == 0;
}
#endif

/* In the new process, before gnuplot is executed. */
static void confine(void *unused)
{
    static const char refused[] =
        "warning: it is not run, since the system cannot keep it from starting programs\n";
    (void)unused;
    if (forbid_processes())
        return;
    (void)mpm_file_write(STDERR_FILENO, refused, strlen(refused)); /* the signal is enough */
    (void)raise(SIGKILL);
}

/* The scripts are UTF-8, and a picture must not depend on the caller's locale. */
static char **environment_of(const char *home)
{
    char **environment = g_environ_setenv(NULL, "LC_ALL", "C.UTF-8", TRUE);
    environment = g_environ_setenv(environment, "PATH", "/nonexistent", TRUE);
    environment = g_environ_setenv(environment, "HOME", home, TRUE);
    const char *libraries = g_getenv("LD_LIBRARY_PATH"); /* where gnuplot's own may be */
    return libraries == NULL ? environment
                             : g_environ_setenv(environment, "LD_LIBRARY_PATH", libraries, TRUE);
}

bool mpm_gnuplot_run(const char *folder, const char *settings, const char *script, char **said,
                     char **failure)
{
    /* -d: no file of settings is read */
    char *command[] = {
        "gnuplot", "-d", "-e", (char *)(uintptr_t)settings, (char *)(uintptr_t)script, NULL};
    char **environment = environment_of(folder);
    GError *error = NULL;
    int state = 0;
    const bool ran =
        g_spawn_sync(folder, command, environment, G_SPAWN_SEARCH_PATH | G_SPAWN_STDOUT_TO_DEV_NULL,
                     confine, NULL, NULL, said, &state, &error) &&
        g_spawn_check_wait_status(state, &error);
    *failure = error != NULL ? g_strdup(error->message) : NULL;
    g_clear_error(&error);
    g_strfreev(environment);
    return ran;
}
