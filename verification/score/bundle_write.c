/* A bundle, written.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/failure.h"
#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/common/scene_json.h"
#include "verification/score/bundle.h"
#include "verification/score/bundle_convert.h"
#include "verification/score/bundle_folder.h"
#include "verification/score/lateness.h"
#include "verification/score/references.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FORCE_PER_INSTANT = 4, NUMBER_SIZE = 32, LATE_PART = 20 };

/* What is being written. */
struct writing {
    const struct catalogue_case *entry;
    const struct case_bundle *bundle;
    struct reference_problem problem;
    json_t *scene;
    struct score_format format;
    struct lattice lattice;
};

static enum mpm_geometry geometry_of(const char *name)
{
    return strcmp(name, "axisymmetric") == 0   ? MPM_AXISYMMETRIC
           : strcmp(name, "plane_stress") == 0 ? MPM_PLANE_STRESS
                                               : MPM_PLANE_STRAIN;
}

/* ------------------------------------------------------------------------ tables */

static void add_name(GString *text, const struct writing *writing, enum score_column column)
{
    char *unit = score_column_unit(column, &writing->format.units);
    g_string_append_printf(text, "%s%s [%s]", text->len > 0 ? "," : "",
                           score_column_name(column, writing->format.geometry), unit);
    g_free(unit);
}

static void add_number(GString *text, bool first, double value)
{
    char number[NUMBER_SIZE];
    g_ascii_formatd(number, sizeof number, "%.12g", value);
    g_string_append_printf(text, "%s%s", first ? "" : ",", number);
}

static bool is_force(enum score_column column)
{
    return column == SCORE_FORCE_X || column == SCORE_FORCE_Y;
}

/* The columns of the reference that are forces, or those that are none. */
static size_t columns_of(const struct reference *reference, bool forces,
                         enum score_column columns[SCORE_COLUMNS])
{
    size_t count = 0;
    for (size_t i = 0; reference->columns[i] != SCORE_TIME; i++)
        if (is_force(reference->columns[i]) == forces)
            columns[count++] = reference->columns[i];
    return count;
}

static void add_instant(GString *text, const struct writing *writing, double time,
                        const enum score_column *columns, size_t count)
{
    const struct lattice *lattice = &writing->lattice;
    for (size_t p = 0; p < lattice->count[0] * lattice->count[1]; p++) {
        double place[2], values[SCORE_COLUMNS];
        lattice_point(lattice, p, place);
        writing->problem.reference->evaluate(&writing->problem, place, time, values);
        if (!writing->bundle->rest)
            add_number(text, true, time);
        add_number(text, writing->bundle->rest, place[0]);
        add_number(text, false, place[1]);
        for (size_t c = 0; c < count; c++)
            add_number(text, false, values[columns[c]]);
        g_string_append_c(text, '\n');
    }
}

/* A table of all points at `steps` times after 0, and 0; once at rest. g_free. */
static char *table_text(const struct writing *writing, const enum score_column *columns,
                        size_t count, size_t steps)
{
    const struct case_bundle *bundle = writing->bundle;
    GString *text = g_string_new(NULL);
    if (!bundle->rest)
        add_name(text, writing, SCORE_TIME);
    add_name(text, writing, SCORE_INITIAL_X);
    add_name(text, writing, SCORE_INITIAL_Y);
    for (size_t c = 0; c < count; c++)
        add_name(text, writing, columns[c]);
    g_string_append_c(text, '\n');
    if (bundle->rest)
        add_instant(text, writing, bundle->end, columns, count);
    for (size_t k = 0; !bundle->rest && k <= steps; k++)
        add_instant(text, writing, bundle->end * (double)k / (double)steps, columns, count);
    return g_string_free(text, FALSE);
}

/* ------------------------------------------------------------------- time levels */

/* A part of the time between two instants; 0 at rest. */
static double late_by(const struct case_bundle *bundle)
{
    return bundle->rest ? 0.0 : bundle->end / ((double)bundle->instants * LATE_PART);
}

/* What a criterion has of the reference read late. */
static double late_agreement(const struct writing *writing, const struct case_criterion *criterion)
{
    enum score_column columns[SCORE_COLUMNS];
    const struct lateness lateness = {&writing->problem, &writing->lattice, writing->bundle->end,
                                      late_by(writing->bundle), (size_t)writing->bundle->instants};
    for (unsigned c = 0; c < criterion->columns_count; c++)
        columns[c] = score_column_find(criterion->columns[c], writing->format.geometry);
    return lateness_agreement(&lateness, columns, criterion->columns_count, criterion->norm);
}

/* -------------------------------------------------------------------------- JSON */

static json_t *numbers_json(const double pair[2])
{
    return json_pack("[f, f]", pair[0], pair[1]);
}

static json_t *points_json(const struct writing *writing)
{
    const struct lattice *lattice = &writing->lattice;
    const char *across = score_column_name(SCORE_INITIAL_X, writing->format.geometry);
    const char *along = score_column_name(SCORE_INITIAL_Y, writing->format.geometry);
    json_t *points = json_object();
    if (lattice->polar)
        json_object_set_new(points, "axes", json_pack("[s, s]", "radius", "angle"));
    else
        json_object_set_new(points, "axes", json_pack("[s, s]", across, along));
    json_object_set_new(points, "from", numbers_json(lattice->from));
    json_object_set_new(points, "to", numbers_json(lattice->to));
    json_object_set_new(
        points, "count",
        json_pack("[I, I]", (json_int_t)lattice->count[0], (json_int_t)lattice->count[1]));
    json_object_set_new(points, "polar", json_boolean(lattice->polar));
    json_object_set_new(points, "interpolation", json_string(lattice->linear ? "linear" : "cubic"));
    return points;
}

static json_t *criterion_json(const struct writing *writing, const struct case_criterion *criterion)
{
    json_t *object = json_object(), *columns = json_array();
    for (unsigned i = 0; i < criterion->columns_count; i++)
        json_array_append_new(columns, record_text_of(criterion->columns[i]));
    json_object_set_new(object, "criterion", record_text_of(criterion->name));
    json_object_set_new(object, "title", record_text_of(criterion->title));
    json_object_set_new(object, "columns", columns);
    json_object_set_new(object, "norm", json_string(agreement_norm_names[criterion->norm]));
    json_object_set_new(object, "norm_in_words",
                        json_string(agreement_norm_words(criterion->norm)));
    json_object_set_new(object, "unit", json_string("%"));
    json_object_set_new(object, "expected", json_real(100));
    json_object_set_new(object, "low", json_real(100 - criterion->within));
    json_object_set_new(object, "high", json_real(100 + criterion->within));
    json_object_set_new(object, "why", record_text_of(criterion->why));
    if (!writing->bundle->rest)
        json_object_set_new(object, "late",
                            json_pack("{s: f, s: f}", "by", late_by(writing->bundle), "agreement",
                                      late_agreement(writing, criterion)));
    return object;
}

/* What a solver must write: where points were, and what the criteria use. */
static json_t *columns_json(const struct writing *writing)
{
    bool wanted[SCORE_COLUMNS] = {false};
    json_t *columns = json_array();
    wanted[SCORE_TIME] = !writing->bundle->rest;
    for (unsigned a = 0; a < 2; a++)
        wanted[SCORE_INITIAL_X + a] = writing->lattice.polar || writing->lattice.count[a] > 1;
    for (unsigned i = 0; i < writing->bundle->criteria_count; i++)
        for (unsigned c = 0; c < writing->bundle->criteria[i].columns_count; c++) {
            const enum score_column column = score_column_find(
                writing->bundle->criteria[i].columns[c], writing->format.geometry);
            if (column < SCORE_COLUMNS)
                wanted[column] = true;
        }
    for (int c = 0; c < SCORE_COLUMNS; c++) {
        if (!wanted[c])
            continue;
        char *unit = score_column_unit((enum score_column)c, &writing->format.units);
        json_array_append_new(
            columns, json_pack("{s: s, s: s}", "name",
                               score_column_name((enum score_column)c, writing->format.geometry),
                               "unit", unit));
        g_free(unit);
    }
    return columns;
}

static json_t *bundle_json(const struct writing *writing)
{
    const struct case_bundle *bundle = writing->bundle;
    json_t *object = bundle_facts(writing->entry, writing->scene, bundle->about, "fields");
    json_t *criteria = json_array();
    for (unsigned i = 0; i < bundle->criteria_count; i++)
        json_array_append_new(criteria, criterion_json(writing, &bundle->criteria[i]));
    json_object_set_new(object, "body", json_integer(bundle->body));
    json_object_set_new(object, "at_rest", json_boolean(bundle->rest));
    json_object_set_new(object, "end", json_real(bundle->end));
    json_object_set_new(object, "instants", json_integer(bundle->rest ? 1 : bundle->instants));
    json_object_set_new(object, "points", points_json(writing));
    json_object_set_new(object, "columns", columns_json(writing));
    json_object_set_new(object, "criteria", criteria);
    return object;
}

/* ------------------------------------------------------------------------- words */

static void add_columns(GString *text, const json_t *json)
{
    const json_t *columns = json_object_get(json, "columns");
    g_string_append(text, "| column | unit |\n|---|---|\n");
    for (size_t i = 0; i < json_array_size(columns); i++) {
        const json_t *column = json_array_get(columns, i);
        g_string_append_printf(text, "| `%s` | %s |\n", record_text(column, "name"),
                               record_text(column, "unit"));
    }
}

static void add_criteria(GString *text, const struct writing *writing)
{
    const struct case_bundle *bundle = writing->bundle;
    for (unsigned i = 0; i < bundle->criteria_count; i++) {
        const struct case_criterion *criterion = &bundle->criteria[i];
        g_string_append_printf(text, "- **%s** (`%s`), norm %s: 100 %% to within %s %%. %s",
                               criterion->title, criterion->name,
                               agreement_norm_names[criterion->norm], criterion->within_text,
                               criterion->why);
        if (!bundle->rest)
            g_string_append_printf(text, " Read %g %s late: %.4g %%.", late_by(bundle),
                                   writing->format.units.time, late_agreement(writing, criterion));
        g_string_append_c(text, '\n');
    }
}

static void add_times(GString *text, const struct case_bundle *bundle)
{
    if (bundle->rest)
        g_string_append(text, "The state of rest: one instant, the last one if there are more.");
    else
        g_string_append_printf(text,
                               "At %d instants, %g/%d apart from 0 (not scored) to %g, each to a "
                               "millionth of the end.",
                               (int)bundle->instants, bundle->end, (int)bundle->instants,
                               bundle->end);
}

static char *words_text(const struct writing *writing, const json_t *json)
{
    GString *text = bundle_words_begin(writing->entry, writing->bundle->about);
    g_string_append(
        text, "`problem.json` states geometry, units, material, bodies, conditions and loads, as "
              "the scene of the case has them; texts such as \"sin(pi*x/16)\" are formulas in the "
              "place and the time `t`. `reference.csv` is the reference: a row for each point "
              "and instant, named and ordered as results are.\n\n");
    bundle_words_of_laws(text, json);
    if (reference_has(writing->problem.reference, SCORE_FORCE_X))
        g_string_append(text,
                        "The motion has the body force of `body_force.csv`, per unit mass, at "
                        "each point's initial position; take what lies between points and times by "
                        "cubic polynomials.\n\n");
    g_string_append(text, "## What to write\n\n");
    add_times(text, writing->bundle);
    g_string_append(text, " At points of your own, which cover the body:\n\n");
    add_columns(text, json);
    g_string_append(text,
                    "\nas CSV, HDF5 or VTK files: docs/tutorial-score.md has the layouts. Then\n\n"
                    "    mpm-verify score BUNDLE RESULTS\n\n## Criteria\n\nAgreement with the "
                    "reference, taken between its points at yours.\n\n");
    add_criteria(text, writing);
    bundle_words_of_conversion(text, json, late_by(writing->bundle));
    return bundle_words_end(writing->entry, text);
}

/* ------------------------------------------------------------------------- files */

static enum mpm_status write_table(const struct writing *writing, const char *home,
                                   const char *name, bool forces, struct mpm_error *error)
{
    enum score_column columns[SCORE_COLUMNS];
    const size_t count = columns_of(writing->problem.reference, forces, columns);
    const size_t steps = (size_t)writing->bundle->instants * (forces ? FORCE_PER_INSTANT : 1);
    if (count == 0)
        return MPM_OK;
    char *text = table_text(writing, columns, count, steps);
    const enum mpm_status status = output_write(home, name, text, error);
    g_free(text);
    return status;
}

static enum mpm_status write_files(const struct writing *writing, const char *home,
                                   struct mpm_error *error)
{
    json_t *json = bundle_json(writing);
    char *words = words_text(writing, json);
    enum mpm_status status = write_table(writing, home, "reference.csv", false, error);
    if (status == MPM_OK)
        status = write_table(writing, home, "body_force.csv", true, error);
    if (status == MPM_OK)
        status = bundle_describe(home, words, json, error);
    g_free(words);
    json_decref(json);
    return status;
}

/* Criteria may use columns of the reference alone. */
static enum mpm_status check_criteria(const struct writing *writing, struct mpm_error *error)
{
    for (unsigned i = 0; i < writing->bundle->criteria_count; i++)
        for (unsigned c = 0; c < writing->bundle->criteria[i].columns_count; c++) {
            const char *name = writing->bundle->criteria[i].columns[c];
            const enum score_column column = score_column_find(name, writing->format.geometry);
            if (column == SCORE_COLUMNS || is_force(column) ||
                !reference_has(writing->problem.reference, column))
                return failure_set(error, MPM_BAD_INPUT,
                                   "case %s: bundle: criterion %s: \"%s\" is no column of the "
                                   "reference %s",
                                   writing->entry->file->name, writing->bundle->criteria[i].name,
                                   name, writing->problem.reference->name);
        }
    return MPM_OK;
}

static enum mpm_status prepare(struct writing *writing, struct mpm_error *error)
{
    const struct case_bundle *bundle = writing->bundle;
    TRY(reference_open(writing->entry, &writing->problem, error));
    TRY(scene_json_read(writing->entry->scene_path, &writing->scene, error));
    const json_t *units = json_object_get(writing->scene, "units");
    writing->format =
        (struct score_format){geometry_of(record_text(writing->scene, "geometry")),
                              {record_text(units, "length"), record_text(units, "mass"),
                               record_text(units, "time"), record_text(units, "temperature")},
                              (int)bundle->body};
    writing->lattice =
        (struct lattice){.count = {(size_t)bundle->points[0], (size_t)bundle->points[1]},
                         .polar = bundle->polar,
                         .linear = bundle->linear};
    memcpy(writing->lattice.from, bundle->from, sizeof bundle->from);
    memcpy(writing->lattice.to, bundle->to, sizeof bundle->to);
    return check_criteria(writing, error);
}

enum mpm_status bundle_write(const struct catalogue_case *entry, const char *folder,
                             struct mpm_error *error)
{
    struct writing writing = {.entry = entry, .bundle = entry->file->bundle};
    char *home = NULL;
    enum mpm_status status = prepare(&writing, error);
    if (status == MPM_OK)
        status = bundle_home(entry, folder, &home, error);
    if (status == MPM_OK)
        status = write_files(&writing, home, error);
    json_decref(writing.scene);
    g_free(home);
    return status;
}
