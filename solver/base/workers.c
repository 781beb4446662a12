/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/workers.h"

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <strings.h>
#include <time.h>

enum { CACHE_LINE = 64, WORKERS_MAX = 4096 };

/* A step has some twenty jobs with little between them. Waking a thread takes about as long. */
static const int64_t PATIENCE = 50000; /* nanoseconds */

/* What is written by all keeps clear of what all read. The items left are in the low bits of
 * `ticket`, above them the number of workers that may take one. Whoever takes an item by counting
 * the ticket down knows that the job is not over until the item is done: only then it reads what
 * the job is. */
struct team {
    _Alignas(CACHE_LINE) _Atomic uint64_t ticket;
    _Atomic int64_t pending; /* items that are not done */
    _Alignas(CACHE_LINE) int64_t count;
    void (*work)(void *context, int64_t item, int worker);
    void *context;
    int helpers;
    _Atomic int sleeping; /* of the helpers */
    _Atomic int members;  /* the last one to leave frees the team */
    _Atomic bool owner_sleeps, ended;
    pthread_mutex_t mutex;
    pthread_cond_t wake_helpers, wake_owner;
};

enum { TICKET_BITS = 48 };
static const uint64_t TICKET_ITEMS = ((uint64_t)1 << TICKET_BITS) - 1;

/* ------------------------------------------------------------------ waiting */

static int64_t patience; /* nanoseconds; set once */

static void choose_patience(void)
{
    const char *const policy = getenv("OMP_WAIT_POLICY");
    patience = PATIENCE;
    if (policy != NULL && strcasecmp(policy, "passive") == 0)
        patience = 0;
    if (policy != NULL && strcasecmp(policy, "active") == 0)
        patience = INT64_MAX;
}

static int64_t nanoseconds_now(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

struct wait {
    int64_t start;
    unsigned looks;
};

/* Lets a moment pass; false if it is time to sleep. */
static bool look_again(struct wait *wait)
{
    enum { LOOKS_PER_CLOCK = 16 };
    if (patience == 0)
        return false;
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
    if (wait->looks++ % LOOKS_PER_CLOCK != 0)
        return true;
    const int64_t now = nanoseconds_now();
    if (wait->start == 0)
        wait->start = now;
    return now - wait->start < patience;
}

/* ------------------------------------------------------------------ working */

static _Thread_local bool is_at_work; /* on items of a shared job */

static bool has_item(const struct team *team, int worker)
{
    const uint64_t ticket = atomic_load(&team->ticket);
    return (ticket & TICKET_ITEMS) != 0 && (uint64_t)worker < ticket >> TICKET_BITS;
}

static bool take_item(struct team *team, int worker, int64_t *item)
{
    uint64_t ticket = atomic_load(&team->ticket);
    while ((ticket & TICKET_ITEMS) != 0 && (uint64_t)worker < ticket >> TICKET_BITS)
        if (atomic_compare_exchange_weak(&team->ticket, &ticket, ticket - 1)) {
            *item = team->count - (int64_t)(ticket & TICKET_ITEMS);
            return true;
        }
    return false;
}

static void work_items(struct team *team, int worker)
{
    is_at_work = true;
    for (int64_t item; take_item(team, worker, &item);) {
        team->work(team->context, item, worker);
        if (atomic_fetch_sub(&team->pending, 1) == 1 && atomic_load(&team->owner_sleeps)) {
            (void)pthread_mutex_lock(&team->mutex);
            (void)pthread_cond_signal(&team->wake_owner);
            (void)pthread_mutex_unlock(&team->mutex);
        }
    }
    is_at_work = false;
}

static void leave(struct team *team)
{
    if (atomic_fetch_sub(&team->members, 1) > 1)
        return;
    (void)pthread_cond_destroy(&team->wake_owner);
    (void)pthread_cond_destroy(&team->wake_helpers);
    (void)pthread_mutex_destroy(&team->mutex);
    free(team);
}

static void sleep_until_called(struct team *team, int worker)
{
    (void)pthread_mutex_lock(&team->mutex);
    atomic_fetch_add(&team->sleeping, 1);
    while (!has_item(team, worker) && !atomic_load(&team->ended))
        (void)pthread_cond_wait(&team->wake_helpers, &team->mutex);
    atomic_fetch_sub(&team->sleeping, 1);
    (void)pthread_mutex_unlock(&team->mutex);
}

struct helper {
    struct team *team;
    int worker;
};

static void *help(void *item)
{
    const struct helper helper = *(struct helper *)item;
    struct team *const team = helper.team;
    free(item);
    while (!atomic_load(&team->ended)) {
        struct wait wait = {0};
        work_items(team, helper.worker);
        while (!has_item(team, helper.worker) && !atomic_load(&team->ended))
            if (!look_again(&wait))
                sleep_until_called(team, helper.worker);
    }
    leave(team);
    return NULL;
}

/* -------------------------------------------------------------------- teams */

static _Thread_local struct team *own_team;
static _Thread_local unsigned own_generation; /* of forks, when the team was made */
static pthread_key_t key;                     /* its destructor ends a thread's team */
static pthread_once_t once = PTHREAD_ONCE_INIT;
static bool is_ready;
static _Atomic unsigned generation;

static void count_fork(void)
{
    atomic_fetch_add(&generation, 1);
}

static void wake_helpers(struct team *team)
{
    if (atomic_load(&team->sleeping) == 0)
        return;
    (void)pthread_mutex_lock(&team->mutex);
    (void)pthread_cond_broadcast(&team->wake_helpers);
    (void)pthread_mutex_unlock(&team->mutex);
}

static void end_team(void *item)
{
    struct team *const team = item;
    if (own_generation != atomic_load(&generation))
        return; /* the parent's; its helpers are not here to leave it */
    atomic_store(&team->ended, true);
    wake_helpers(team);
    leave(team);
}

static void prepare(void)
{
    choose_patience();
    is_ready =
        pthread_key_create(&key, end_team) == 0 && pthread_atfork(NULL, NULL, count_fork) == 0;
}

static struct team *make_team(void)
{
    struct team *const team = aligned_alloc(CACHE_LINE, sizeof *team);
    if (team == NULL)
        return NULL;
    *team = (struct team){.members = 1};
    if (pthread_mutex_init(&team->mutex, NULL) != 0 ||
        pthread_cond_init(&team->wake_helpers, NULL) != 0 ||
        pthread_cond_init(&team->wake_owner, NULL) != 0 || pthread_setspecific(key, team) != 0) {
        free(team);
        return NULL;
    }
    own_team = team;
    own_generation = atomic_load(&generation);
    return team;
}

static bool add_helper(struct team *team)
{
    struct helper *const helper = malloc(sizeof *helper);
    pthread_t thread;
    if (helper == NULL)
        return false;
    *helper = (struct helper){team, team->helpers + 1};
    atomic_fetch_add(&team->members, 1);
    if (pthread_create(&thread, NULL, help, helper) != 0) {
        atomic_fetch_sub(&team->members, 1);
        free(helper);
        return false;
    }
    (void)pthread_detach(thread);
    team->helpers++;
    return true;
}

/* The signals of the program are not for helpers. */
static void add_helpers(struct team *team, int count)
{
    sigset_t all, before;
    (void)sigfillset(&all);
    if (pthread_sigmask(SIG_SETMASK, &all, &before) != 0)
        return;
    while (team->helpers < count && add_helper(team))
        continue;
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
}

/* NULL: there are no helpers to be had. */
static struct team *find_team(int workers)
{
    (void)pthread_once(&once, prepare);
    if (!is_ready)
        return NULL;
    struct team *team = own_team;
    if (team == NULL || own_generation != atomic_load(&generation))
        team = make_team();
    if (team != NULL && team->helpers < workers - 1)
        add_helpers(team, workers - 1);
    return team == NULL || team->helpers == 0 ? NULL : team;
}

static void wait_for_helpers(struct team *team)
{
    struct wait wait = {0};
    while (atomic_load(&team->pending) > 0)
        if (!look_again(&wait)) {
            (void)pthread_mutex_lock(&team->mutex);
            atomic_store(&team->owner_sleeps, true);
            while (atomic_load(&team->pending) > 0)
                (void)pthread_cond_wait(&team->wake_owner, &team->mutex);
            atomic_store(&team->owner_sleeps, false);
            (void)pthread_mutex_unlock(&team->mutex);
        }
}

static void share(struct team *team, int64_t count, int workers,
                  void (*work)(void *context, int64_t item, int worker), void *context)
{
    team->work = work;
    team->context = context;
    team->count = count;
    atomic_store(&team->pending, count);
    atomic_store(&team->ticket, (uint64_t)workers << TICKET_BITS | (uint64_t)count);
    wake_helpers(team);
    work_items(team, 0);
    wait_for_helpers(team);
}

int mpm_workers_asleep(void)
{
    if (own_team == NULL || own_generation != atomic_load(&generation))
        return 0;
    return atomic_load(&own_team->sleeping);
}

void mpm_workers_run(int64_t count, int workers,
                     void (*work)(void *context, int64_t item, int worker), void *context)
{
    const int useful = (int64_t)workers < count ? workers : (int)count;
    const int allowed = useful < WORKERS_MAX ? useful : WORKERS_MAX;
    struct team *team = NULL;
    if (allowed > 1 && !is_at_work)
        team = find_team(allowed);
    if (team != NULL) {
        share(team, count, allowed, work, context);
        return;
    }
    for (int64_t item = 0; item < count; item++)
        work(context, item, 0);
}
