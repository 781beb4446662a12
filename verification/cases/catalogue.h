/* The catalogue: folders <family>/<case>/ with case.yaml, README.md, and what the
 * case needs (scene.yaml, *.gp, *.dat). Everything that the suite will run and judge
 * is declared here and checked before anything runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CASES_CATALOGUE_H
#define VERIFICATION_CASES_CATALOGUE_H

#include "verification/measures/comparison/agreement.h"
#include "verification/measures/comparison/comparison.h"
#include "verification/measures/comparison/evidence.h"
#include "verification/measures/verdict.h"
#include "verification/programs/programs.h"

#include <stdbool.h>

enum tier { TIER_CI, TIER_FULL }; /* variants of tier ci run in full, too */

struct case_parameter {
    char *name, *value;
};

struct method;

struct case_variant {
    char *name;
    char *title;                 /* of one that is no method; may be NULL */
    const struct method *method; /* that it was made from, or NULL; not of the file */
    enum tier tier;
    char *timeout_text;
    double timeout; /* seconds */
    char **settings;
    unsigned settings_count;
    struct case_parameter *parameters;
    unsigned parameters_count;
};

/* Adds one variant for each method of methods.yaml that `names` selects and `except` does
 * not. */
struct case_methods {
    char **names, **except; /* globs */
    unsigned names_count, except_count;
    enum tier tier;
    char **full; /* globs: those of them that run at the full size alone */
    unsigned full_count;
    char *timeout_text;
    double timeout;
    char **settings; /* after the method's own */
    unsigned settings_count;
    struct case_parameter *parameters;
    unsigned parameters_count;
};

enum case_basis {
    BASIS_THEORY,
    BASIS_ROUND_OFF,
    BASIS_LITERATURE,
    BASIS_INDEPENDENT, /* a calculation by other means; the case describes it */
    BASIS_MEASURED
};
enum case_outcome { OUTCOME_PASS, OUTCOME_FAIL };

struct case_check {
    char *name, *title;
    char **variants; /* globs */
    unsigned variants_count;
    char *quantity, *unit, *norm;
    char *expected_text, *low_text, *high_text;
    char *fails_low_text, *fails_high_text, *initial_text;
    enum case_basis basis;
    char *why;
    char *headroom;              /* why its band is as far from the values as it is; may be NULL */
    enum case_evidence evidence; /* NOT_STATED: that of the case */
    enum case_outcome outcome;
    struct verdict_band band;
};

struct case_figure {
    char *name, *script, *title, *caption, *reference;
    char **needs; /* globs over variants whose data files the script reads */
    unsigned needs_count;
};

/* What the pictures of a case show; every case with a scene has some. */
enum picture_field {
    PICTURE_BY_LAW, /* none is stated: what matters to the scene's laws */
    PICTURE_SPEED,
    PICTURE_VELOCITY_X,
    PICTURE_VELOCITY_Y,
    PICTURE_DISPLACEMENT,
    PICTURE_DISPLACEMENT_X,
    PICTURE_DISPLACEMENT_Y,
    PICTURE_VON_MISES,
    PICTURE_PRESSURE,
    PICTURE_STRESS_XX,
    PICTURE_STRESS_YY,
    PICTURE_STRESS_ZZ,
    PICTURE_STRESS_XY,
    PICTURE_VOLUME_RATIO,
    PICTURE_TEMPERATURE,
    PICTURE_CONCENTRATION,
    PICTURE_PLASTIC_STRAIN,
    PICTURE_INTERNAL_ENERGY,
    PICTURE_STATE_TEMPERATURE,
    PICTURE_FRINGE,
    PICTURE_FIELD_COUNT,
};

struct case_picture {
    char *variant; /* whose run is shown; NULL: the first of tier ci, else the first */
    enum picture_field field;
    int64_t simulation; /* which of its program's, from 1 on; 0: the first */
    char *time_text, *magnify_text;
    double time;    /* of the state shown, or of a motion's last frame; NAN: the last one */
    double magnify; /* of displacements; NAN: by their size */
    int64_t frames; /* of a motion, 0: none */
    bool strip;     /* is it in the strip of the index? */
    char *caption;  /* what to see, in a sentence; may be NULL */
};

struct case_column {
    char *quantity, *title, *unit;
    enum comparison_better better;
    char *tolerance_text, *floor_text; /* NULL if not given */
    double tolerance, floor;
    char *limit_text; /* NULL: no limit */
    double limit;     /* a variant with a worse number takes no part */
    char *beyond;     /* what such a number means ("broke at"); may be NULL */
    char *missing;    /* what a number that failed means ("not reached"); may be NULL */
    char *about;      /* what the column is, in a line; may be NULL */
    char *case_name;  /* that reports it; NULL: this one */
    char *where;      /* quantity of a column: counts only where that is equal to the best */
};

struct case_pareto {
    char *x, *y; /* quantities of columns */
};

/* The page that puts the variants beside each other. */
struct case_comparison {
    char *title, *summary; /* summary may be NULL */
    char **variants;       /* globs; none: all */
    unsigned variants_count;
    struct case_column *columns;
    unsigned columns_count;
    struct case_pareto *pareto; /* may be NULL */
    char *main;                 /* quantity of the column that decides; NULL: the first one */
    char *cost;   /* quantity of the column of costs; NULL: pareto's x, if there is one */
    char *setup;  /* the problem in a line; may be NULL */
    char *figure; /* of the case, shown in place of a picture; may be NULL */
    char **notes; /* to be known before one chooses */
    unsigned notes_count;
};

/* What another solver's results are held to: agreement with the reference of 100 % to within so
 * much. */
struct case_criterion {
    char *name, *title;
    char **columns; /* names as in verification/score/columns.h */
    unsigned columns_count;
    enum agreement_norm norm;
    char *within_text, *why;
    double within; /* % */
};

/* What `mpm-verify export` writes of a case for other solvers. */
struct case_bundle {
    char *reference; /* a name of verification/score/references.c */
    char *about;     /* what a solver has to do that README.md and the scene do not say */
    struct case_parameter *parameters; /* of the reference; win over those of the case */
    unsigned parameters_count;
    char *from_text[2], *to_text[2]; /* the lattice of initial positions */
    double from[2], to[2];
    int64_t points[2];
    bool polar, linear, rest; /* from and to are radius and angle; interpolation; a state of rest */
    char *end_text;
    double end;
    int64_t instants; /* at end / instants, ..., end */
    int64_t body;     /* of the scene, that is judged */
    struct case_criterion *criteria;
    unsigned criteria_count;
};

/* The same of a case that has no field: numbers, which each solver finds in its own way. */
struct case_numbers {
    char *about;  /* what a solver has to do that README.md and the scene do not say */
    char **files; /* of reference_data, that go with it */
    unsigned files_count;
    struct case_check *list; /* name, title, quantity (in words), unit, band, basis and why */
    unsigned list_count;
};

/* case.yaml as read; texts of numbers are stored beside their values. */
struct case_file {
    int64_t format;
    char *family, *name, *title, *summary;
    char **tags;
    unsigned tags_count;
    enum case_evidence evidence; /* of checks that state none of their own */
    char *calculation; /* the independent one that bands rest on, and how to repeat it; NULL */
    char *program_name;
    char *scene;
    struct case_parameter *parameters;
    unsigned parameters_count;
    struct case_methods *methods;  /* NULL if it has none */
    struct case_variant *variants; /* those of methods last */
    unsigned variants_count;
    struct case_check *checks;
    unsigned checks_count;
    struct case_figure *figures;
    unsigned figures_count;
    struct case_picture *picture; /* NULL: as if it were empty, or */
    char *no_picture;             /* why there is none; NULL in a case with a scene, as a rule */
    struct case_comparison *comparison; /* NULL if it has none */
    struct case_bundle *bundle;         /* a field for other solvers, or */
    struct case_numbers *numbers;       /* numbers, or */
    char *no_bundle;                    /* why it has neither; each may be NULL */
};

struct catalogue_case {
    struct case_file *file;
    char *folder;
    char *scene_path; /* of the variants that name none; NULL if it has none */
    char *readme;     /* Markdown */
    const struct measure_program *program;
    const struct method_table *methods; /* of the catalogue; NULL if it has none */
};

struct catalogue {
    char *folder;
    struct method_table *methods;
    struct catalogue_case *cases; /* sorted by family and name */
    size_t count;
};

/* Reads methods.yaml, if there is one, and every case under `folder`. MPM_BAD_INPUT: a message with
 * file, line where it is known, key, value and what is allowed. *catalogue is NULL on failure. */
enum mpm_status catalogue_read(const char *folder, struct program_table programs,
                               struct catalogue **catalogue, struct mpm_error *error);
void catalogue_free(struct catalogue *catalogue);

/* Path of the scene that a variant runs: its parameter `scene`, a file of the case's folder, or the
 * case's own; NULL if there is none. The caller frees it with g_free. */
char *catalogue_scene_path(const struct catalogue_case *entry, const struct case_variant *variant);

const char *basis_name(enum case_basis basis);
bool basis_find(const char *name, enum case_basis *basis); /* false: none has that name */
/* That of the check, or else of its case. */
enum case_evidence check_evidence(const struct case_file *file, const struct case_check *check);
const char *tier_name(enum tier tier);

/* Whether the comparison of a case has a row for the variant. */
bool comparison_has_variant(const struct case_comparison *comparison, const char *variant);

#endif
