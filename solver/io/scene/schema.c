/* The table and the list behind `mpm schema`, from the same descriptors that the checks use.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/schema.h"

#include "io/scene/scene_schema.h"
#include "io/units.h"
#include "mpm_words.h"

#include <glib.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CELL_SIZE = 256, HELP_SIZE = 1024 };

/* Calls visit(context, key, path) for the keys of a group, each before its children. */
static void visit_keys(const struct mpm_key *group, const char *prefix,
                       void (*visit)(void *context, const struct mpm_key *key, const char *path),
                       void *context)
{
    for (const struct mpm_key *key = group->children; key->name != NULL; key++) {
        char path[CELL_SIZE], inner[CELL_SIZE];
        (void)snprintf(path, sizeof path, "%s%s", prefix, key->name);
        visit(context, key, path);
        (void)snprintf(inner, sizeof inner, "%.200s%s.", path,
                       key->shape == MPM_KEY_LIST ? "[]" : "");
        if (key->children != NULL)
            visit_keys(key, inner, visit, context);
    }
}

/* -------------------------------------------------------------------- table */

enum { TABLE_WIDTH = 80, KEY_WIDTH = 32, FACTS_SIZE = 4 * MPM_ALLOWED_SIZE };

struct table {
    FILE *out;
    char *filter; /* in lower case, or NULL */
    size_t count;
};

/* "number, length; default 1; above 0" */
static void put_facts(const struct mpm_key *key, char facts[FACTS_SIZE])
{
    char range[MPM_ALLOWED_SIZE], unit[MPM_UNIT_SIZE];
    (void)mpm_key_range(key, range);
    mpm_dimension_text(key->dimension, unit);
    (void)snprintf(facts, FACTS_SIZE, "%s%s%s%s%s%s%s", mpm_key_type(key),
                   unit[0] != '\0' ? ", " : "", unit,
                   key->required           ? "; required"
                   : key->fallback != NULL ? "; default "
                                           : "",
                   !key->required && key->fallback != NULL ? key->fallback : "",
                   range[0] != '\0' ? "; " : "", range);
}

static bool is_chosen(const struct table *table, const char *path, const char *facts,
                      const char *help)
{
    if (table->filter == NULL)
        return true;
    const char *const texts[] = {path, facts, help};
    bool found = false;
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        char *const text = g_utf8_strdown(texts[i], -1);
        found = found || strstr(text, table->filter) != NULL;
        g_free(text);
    }
    return found;
}

static void put_row(FILE *out, const char *path, const char *facts, const char *help)
{
    const size_t length = strlen(path);
    (void)fputs(path, out);
    if (length + 1 > KEY_WIDTH)
        (void)fputc('\n', out);
    (void)fprintf(out, "%*s", (int)(KEY_WIDTH - (length + 1 > KEY_WIDTH ? 0 : length)), "");
    mpm_words_wrap(out, facts, KEY_WIDTH, KEY_WIDTH, TABLE_WIDTH);
    (void)fprintf(out, "%*s", KEY_WIDTH, "");
    mpm_words_wrap(out, help, KEY_WIDTH, KEY_WIDTH, TABLE_WIDTH);
}

static void put_key(void *context, const struct mpm_key *key, const char *path)
{
    static const char *const places[] = {
        [MPM_ANYWHERE] = "",
        [MPM_ONLY_PLANAR] = " (planar scenes only)",
        [MPM_ONLY_AXISYMMETRIC] = " (axisymmetric scenes only)",
    };
    struct table *const table = context;
    char help[HELP_SIZE], facts[FACTS_SIZE];
    (void)snprintf(help, sizeof help, "%s%s", key->help, places[key->where]);
    put_facts(key, facts);
    if (!is_chosen(table, path, facts, help))
        return;
    put_row(table->out, path, facts, help);
    table->count++;
}

char *mpm_schema_text(const char *filter, size_t *count)
{
    char *text = NULL;
    size_t size;
    struct table table = {.out = open_memstream(&text, &size),
                          .filter = filter != NULL ? g_utf8_strdown(filter, -1) : NULL};
    bool written = table.out != NULL;
    if (written) {
        put_row(table.out, "KEY", "TYPE, UNIT; DEFAULT; RANGE", "MEANING");
        visit_keys(&mpm_scene_root, "", put_key, &table);
        written = ferror(table.out) == 0;
        written = fclose(table.out) == 0 && written;
    }
    *count = table.count;
    g_free(table.filter);
    if (written)
        return text;
    free(text);
    return NULL;
}

/* ---------------------------------------------------------- a list, as JSON */

enum { JSON_FORMAT = 1 };

static json_t *end_of_range(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

/* Of "neo_hookean, linear_elastic". */
static json_t *choices_named(const char *names)
{
    json_t *choices = json_array();
    for (const char *name = names; *name != '\0';) {
        const size_t length = strcspn(name, ",");
        (void)json_array_append_new(choices, json_stringn(name, length));
        name += length;
        name += strspn(name, ", ");
    }
    return choices;
}

static json_t *choices_of(const struct mpm_key *key)
{
    if (key->value != NULL && key->value->names != NULL)
        return choices_named(key->value->names());
    if (key->shape != MPM_KEY_CHOICE)
        return json_null();
    json_t *choices = json_array();
    for (size_t i = 0; i < key->choice_count; i++)
        (void)json_array_append_new(choices, json_string(key->choices[i].name));
    return choices;
}

static void append_key(void *list, const struct mpm_key *key, const char *path)
{
    static const char *const shapes[] = {
        [MPM_KEY_ONE] = "one",       [MPM_KEY_PAIR] = "pair",     [MPM_KEY_VALUES] = "values",
        [MPM_KEY_POINTS] = "points", [MPM_KEY_CHOICE] = "choice", [MPM_KEY_GROUP] = "group",
        [MPM_KEY_LIST] = "list",
    };
    static const char *const places[] = {
        [MPM_ANYWHERE] = NULL,
        [MPM_ONLY_PLANAR] = "planar",
        [MPM_ONLY_AXISYMMETRIC] = "axisymmetric",
    };
    char unit[MPM_UNIT_SIZE];
    mpm_dimension_text(key->dimension, unit);
    json_t *const described =
        json_pack("{ss ss ss? ss? sb ss ss? so so sb sb so ss}", "key", path, "shape",
                  shapes[key->shape], "value", key->value != NULL ? key->value->name : NULL,
                  "geometry", places[key->where], "required", (int)key->required, "unit", unit,
                  "default", key->fallback, "low", end_of_range(key->range.low), "high",
                  end_of_range(key->range.high), "low_open", (int)key->range.low_open, "high_open",
                  (int)key->range.high_open, "choices", choices_of(key), "help", key->help);
    (void)json_array_append_new(list, described);
}

static json_t *parameters_of(const struct mpm_material_law *law)
{
    json_t *list = json_array();
    for (size_t k = 0; k < law->parameter_count; k++) {
        const struct mpm_law_parameter *const own = &law->parameters[k];
        json_t *fallback =
            own->optional && isfinite(own->fallback) ? json_real(own->fallback) : json_null();
        (void)json_array_append_new(list, json_pack("{ss sb so}", "key",
                                                    mpm_parameter_key(own->which), "required",
                                                    (int)!own->optional, "default", fallback));
    }
    return list;
}

static json_t *variables_of(const struct mpm_material_law *law)
{
    json_t *list = json_array();
    for (size_t k = 0; k < law->variable_count; k++) {
        const struct mpm_law_variable *const own = &law->variables[k];
        char unit[MPM_UNIT_SIZE];
        mpm_dimension_text(own->dimension, unit);
        (void)json_array_append_new(list,
                                    json_pack("{ss ss sf ss}", "name", own->name, "unit", unit,
                                              "start", own->start, "help", own->description));
    }
    return list;
}

/* What the choices of materials[].law have. */
static json_t *describe_laws(void)
{
    const struct mpm_material_law *law;
    json_t *list = json_array();
    for (size_t k = 0; (law = mpm_material_law_at(k)) != NULL; k++)
        (void)json_array_append_new(
            list, json_pack("{ss ss so so sb sb}", "law", law->name, "help", law->description,
                            "parameters", parameters_of(law), "variables", variables_of(law),
                            "energy", (int)(law->energy != NULL), "plane_stress",
                            (int)mpm_material_law_has_plane_stress(law)));
    return list;
}

char *mpm_schema_list(void)
{
    json_t *list = json_array();
    visit_keys(&mpm_scene_root, "", append_key, list);
    json_t *schema =
        json_pack("{si so so}", "format", (int)JSON_FORMAT, "keys", list, "laws", describe_laws());
    char *text = json_dumps(schema, JSON_INDENT(1));
    json_decref(schema);
    return text;
}
