/* A convergence study: a scene of the user's, a grid of settings and refinements, what is measured.
 *
 * It becomes a catalogue of its own (study_catalogue.h), one case for each run, which the suite
 * runs, resumes, launches and reports like any other; the tables (study_results.h) are made of the
 * records of that.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_STUDY_STUDY_H
#define VERIFICATION_STUDY_STUDY_H

#include "mpm_yaml.h"
#include "verification/common/failure.h"
#include "verification/measures/quantities.h"

#include <glib.h>
#include <inttypes.h>

enum { STUDY_LEVELS_MAX = 32, STUDY_RUNS_MAX = 1000, STUDY_MEASURES_MAX = 64 };

struct study_vary {
    char *path;
    char **values;
    unsigned values_count;
};

/* Where the error of a measure is counted from. */
enum study_against {
    AGAINST_RICHARDSON, /* none: order and limit of the last three levels */
    AGAINST_FINEST,     /* the finest level's number */
    AGAINST_NUMBER,
    AGAINST_EVALUATED, /* a formula or a file, which the run evaluates */
};

struct study_entry {
    char *name, *quantity, *take_text;
    char *at_text[2], *instant_text; /* a place, or a time */
    char *reference;                 /* may be NULL */
    char *unit;                      /* NULL until study_check() */
    char *order_text[2];             /* what the observed order has to lie in; may be NULL */
    /* by study_check(): */
    enum take take;
    enum study_against against;
    double number, order[2];
};

struct study {
    int64_t format;
    char *title; /* NULL until study_check(): that of the scene */
    char *scene; /* path */
    int64_t *refine;
    unsigned refine_count;
    struct study_vary *vary;
    unsigned vary_count;
    char **settings;
    unsigned settings_count;
    struct study_entry *measures;
    unsigned measures_count;
    char *timeout_text;
    double timeout;
    /* by study_check(): */
    char *length_unit, *scene_text;
    bool axisymmetric;
};

/* What the command line adds or replaces; NULL: nothing. */
struct study_arguments {
    const char *refine, *timeout;
    char **vary, **settings, **measures;
};

/* Is the file a study (it has the key `scene`), and no scene? */
enum mpm_status study_is_file(const char *path, bool *is_study, struct mpm_error *error);
enum mpm_status study_read(const char *path, struct study **study, struct mpm_error *error);
/* Of a scene and the command line alone. */
struct study *study_of_scene(const char *scene);
/* The arguments replace what the study has; --set comes after its settings. MPM_BAD_INPUT. */
enum mpm_status study_take_arguments(struct study *study, const struct study_arguments *given,
                                     struct mpm_error *error);
void study_free(struct study *study);

/* Everything that can be known without a run is checked, and what the scene states is filled in:
 * each run's scene is read, and each variant's first step is taken on its coarsest grid. */
enum mpm_status study_check(struct study *study, struct mpm_error *error);
/* The same but for the runs: what a study that was checked before needs to be used again. */
enum mpm_status study_complete(struct study *study, struct mpm_error *error);

/* As YAML (JSON, which is YAML), with paths from the root on; g_free. */
char *study_text(const struct study *study);

/* ------------------------------------------------------------------------- runs */

struct study_run {
    char *name;      /* "cpdi-r4": of its case */
    char *variant;   /* "method.shape=cpdi"; "" without --vary */
    size_t group;    /* number of the variant */
    int64_t level;   /* refinement */
    double cell;     /* size along the first axis */
    char **settings; /* all, in order */
};

/* Elements struct study_run, levels of a variant beside each other, with a clear function. */
enum mpm_status study_runs(const struct study *study, GArray **runs, struct mpm_error *error);

#endif
