/* Trees of YAML: from libyaml's events.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "io/yaml/names.h"
#include "io/yaml/tree.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

struct parsing {
    const struct mpm_source *source;
    struct mpm_origin origin; /* of all nodes but for the line */
    yaml_parser_t parser;
    const char *bytes;
    size_t length;
    struct mpm_error *error;
};

static enum mpm_status no_memory(struct parsing *parsing)
{
    return mpm_error_memory(parsing->error, parsing->length, "reading YAML");
}

static struct mpm_origin origin_at(const struct parsing *parsing, size_t line_index)
{
    struct mpm_origin origin = parsing->origin;
    origin.line = origin.setting == MPM_FROM_FILE ? (int)line_index + 1 : 0;
    return origin;
}

static size_t line_index_of(const struct parsing *parsing, size_t offset)
{
    size_t lines = 0;
    for (size_t i = 0; i < offset && i < parsing->length; i++)
        lines += parsing->bytes[i] == '\n';
    return lines;
}

static enum mpm_status refuse(struct parsing *parsing, const yaml_event_t *event,
                              const char *message)
{
    return mpm_tree_fault(parsing->error, parsing->source,
                          origin_at(parsing, event->start_mark.line), "", "%s", message);
}

static enum mpm_status refuse_yaml(struct parsing *parsing)
{
    const yaml_parser_t *parser = &parsing->parser;
    const char *problem = parser->problem != NULL ? parser->problem : "cannot be parsed";
    if (parser->error == YAML_MEMORY_ERROR)
        return no_memory(parsing);
    if (parser->error == YAML_READER_ERROR)
        return mpm_tree_fault(parsing->error, parsing->source,
                              origin_at(parsing, line_index_of(parsing, parser->problem_offset)),
                              "", "not YAML: %s; allowed: UTF-8 text", problem);
    return mpm_tree_fault(
        parsing->error, parsing->source, origin_at(parsing, parser->problem_mark.line), "",
        "not YAML: %s at column %zu%s%s", problem, parser->problem_mark.column + 1,
        parser->context != NULL ? ", " : "", parser->context != NULL ? parser->context : "");
}

static enum mpm_status next(struct parsing *parsing, yaml_event_t *event)
{
    return yaml_parser_parse(&parsing->parser, event) ? MPM_OK : refuse_yaml(parsing);
}

/* ------------------------------------------------------------------- nodes */

static enum mpm_status refuse_decorations(struct parsing *parsing, const yaml_event_t *event)
{
    const yaml_char_t *anchor = NULL, *tag = NULL;
    if (event->type == YAML_ALIAS_EVENT)
        return refuse(parsing, event, "an alias (*name); allowed: values written out");
    if (event->type == YAML_SCALAR_EVENT) {
        anchor = event->data.scalar.anchor;
        tag = event->data.scalar.tag;
    } else if (event->type == YAML_SEQUENCE_START_EVENT) {
        anchor = event->data.sequence_start.anchor;
        tag = event->data.sequence_start.tag;
    } else if (event->type == YAML_MAPPING_START_EVENT) {
        anchor = event->data.mapping_start.anchor;
        tag = event->data.mapping_start.tag;
    }
    if (anchor != NULL)
        return refuse(parsing, event, "an anchor (&name); allowed: values written out");
    if (tag != NULL)
        return refuse(parsing, event, "a tag (!name); allowed: plain values");
    return MPM_OK;
}

static enum mpm_status refuse_null_character(struct parsing *parsing, const yaml_event_t *scalar)
{
    if (strlen((const char *)scalar->data.scalar.value) == scalar->data.scalar.length)
        return MPM_OK; /* otherwise: "\0" in double quotes */
    return refuse(parsing, scalar, "a null character in a text; allowed: printable text");
}

static enum mpm_status read_scalar(struct parsing *parsing, const yaml_event_t *event,
                                   struct mpm_tree_node *node)
{
    MPM_TRY(refuse_null_character(parsing, event));
    const char *text = (const char *)event->data.scalar.value;
    node->quoted = event->data.scalar.style != YAML_PLAIN_SCALAR_STYLE;
    node->text = strdup(text);
    return node->text != NULL ? MPM_OK : no_memory(parsing);
}

static enum mpm_status read_node(struct parsing *parsing, const yaml_event_t *event, int depth,
                                 struct mpm_tree_node **node);

static enum mpm_status read_list(struct parsing *parsing, int depth, struct mpm_tree_node *list)
{
    for (;;) {
        yaml_event_t event;
        MPM_TRY(next(parsing, &event));
        struct mpm_tree_node *item = NULL;
        const bool end = event.type == YAML_SEQUENCE_END_EVENT;
        const enum mpm_status status = end ? MPM_OK : read_node(parsing, &event, depth + 1, &item);
        yaml_event_delete(&event);
        if (end || status != MPM_OK)
            return status;
        if (!mpm_tree_append(list, NULL, item))
            return no_memory(parsing);
    }
}

static enum mpm_status read_pair(struct parsing *parsing, const yaml_event_t *key, int depth,
                                 struct mpm_tree_node *mapping)
{
    if (key->type != YAML_SCALAR_EVENT && key->type != YAML_ALIAS_EVENT)
        return refuse(parsing, key, "a list or mapping as a key; allowed: plain keys");
    MPM_TRY(refuse_decorations(parsing, key));
    MPM_TRY(refuse_null_character(parsing, key));
    yaml_event_t event;
    MPM_TRY(next(parsing, &event));
    struct mpm_tree_node *value = NULL;
    const enum mpm_status status = read_node(parsing, &event, depth + 1, &value);
    yaml_event_delete(&event);
    if (status != MPM_OK || value == NULL)
        return status;
    value->origin = origin_at(parsing, key->start_mark.line);
    if (!mpm_tree_append(mapping, (const char *)key->data.scalar.value, value))
        return no_memory(parsing);
    return MPM_OK;
}

static enum mpm_status refuse_repeats(struct parsing *parsing, const struct mpm_tree_node *mapping)
{
    if (mapping->count < 2)
        return MPM_OK;
    struct mpm_indexed_name *names = malloc(mapping->count * sizeof *names);
    if (names == NULL)
        return no_memory(parsing);
    for (size_t i = 0; i < mapping->count; i++)
        names[i] = (struct mpm_indexed_name){.text = mapping->entries[i].key, .index = i};
    size_t first = 0, second = 0;
    const bool repeated = mpm_names_repeat(names, mapping->count, &first, &second);
    free(names);
    if (!repeated)
        return MPM_OK;
    char key[MPM_EXCERPT_SIZE];
    const struct mpm_origin origin = mapping->entries[second].value->origin;
    (void)mpm_excerpt(mapping->entries[second].key, key);
    if (origin.line == 0)
        return mpm_tree_fault(parsing->error, parsing->source, origin, "",
                              "key %s repeated; allowed: once", key);
    return mpm_tree_fault(parsing->error, parsing->source, origin, "",
                          "key %s repeated, first on line %d; allowed: once", key,
                          mapping->entries[first].value->origin.line);
}

static enum mpm_status read_mapping(struct parsing *parsing, int depth,
                                    struct mpm_tree_node *mapping)
{
    for (;;) {
        yaml_event_t key;
        MPM_TRY(next(parsing, &key));
        const bool end = key.type == YAML_MAPPING_END_EVENT;
        const enum mpm_status status =
            end ? refuse_repeats(parsing, mapping) : read_pair(parsing, &key, depth, mapping);
        yaml_event_delete(&key);
        if (end || status != MPM_OK)
            return status;
    }
}

static enum mpm_status read_content(struct parsing *parsing, const yaml_event_t *event, int depth,
                                    struct mpm_tree_node *node)
{
    if (node->kind == MPM_TREE_SCALAR)
        return read_scalar(parsing, event, node);
    if (depth > MPM_TREE_DEPTH_MAX)
        return mpm_tree_fault(parsing->error, parsing->source,
                              origin_at(parsing, event->start_mark.line), "",
                              "nested too deeply; allowed: %d levels", MPM_TREE_DEPTH_MAX);
    return node->kind == MPM_TREE_LIST ? read_list(parsing, depth, node)
                                       : read_mapping(parsing, depth, node);
}

static enum mpm_status read_node(struct parsing *parsing, const yaml_event_t *event, int depth,
                                 struct mpm_tree_node **node)
{
    MPM_TRY(refuse_decorations(parsing, event));
    const enum mpm_tree_kind kind = event->type == YAML_SCALAR_EVENT           ? MPM_TREE_SCALAR
                                    : event->type == YAML_SEQUENCE_START_EVENT ? MPM_TREE_LIST
                                                                               : MPM_TREE_MAPPING;
    struct mpm_tree_node *made = mpm_tree_new(kind, origin_at(parsing, event->start_mark.line));
    if (made == NULL)
        return no_memory(parsing);
    const enum mpm_status status = read_content(parsing, event, depth, made);
    if (status != MPM_OK) {
        mpm_tree_free(made);
        return status;
    }
    *node = made;
    return MPM_OK;
}

/* ---------------------------------------------------------------- document */

/* Reads events until one of the wanted type; those before it carry nothing. */
static enum mpm_status skip(struct parsing *parsing, yaml_event_t *event)
{
    for (;;) {
        MPM_TRY(next(parsing, event));
        if (event->type != YAML_STREAM_START_EVENT && event->type != YAML_DOCUMENT_START_EVENT &&
            event->type != YAML_DOCUMENT_END_EVENT)
            return MPM_OK;
        yaml_event_delete(event);
    }
}

static enum mpm_status read_document(struct parsing *parsing, struct mpm_tree_node **root)
{
    yaml_event_t event;
    MPM_TRY(skip(parsing, &event));
    enum mpm_status status = event.type == YAML_STREAM_END_EVENT
                                 ? refuse(parsing, &event, "empty; allowed: a YAML document")
                                 : read_node(parsing, &event, 1, root);
    yaml_event_delete(&event);
    MPM_TRY(status);
    MPM_TRY(skip(parsing, &event));
    if (event.type != YAML_STREAM_END_EVENT)
        status = refuse(parsing, &event, "a second YAML document; allowed: one");
    yaml_event_delete(&event);
    return status;
}

static enum mpm_status refuse_binary(struct parsing *parsing)
{
    const char *end = NULL;
    if (g_utf8_validate(parsing->bytes, (gssize)parsing->length, &end))
        return MPM_OK;
    const size_t offset = (size_t)(end - parsing->bytes);
    return mpm_tree_fault(parsing->error, parsing->source,
                          origin_at(parsing, line_index_of(parsing, offset)), "",
                          "not a text: byte %zu is 0x%02x; allowed: UTF-8", offset + 1,
                          (unsigned)(unsigned char)*end);
}

/* Some editors put a byte order mark first. libyaml would count it as a column. */
static void skip_mark(struct parsing *parsing)
{
    static const char mark[] = {'\xef', '\xbb', '\xbf'};
    if (parsing->length < sizeof mark || memcmp(parsing->bytes, mark, sizeof mark) != 0)
        return;
    parsing->bytes += sizeof mark;
    parsing->length -= sizeof mark;
}

enum mpm_status mpm_tree_parse(const struct mpm_source *source, struct mpm_origin origin,
                               const char *bytes, size_t length, struct mpm_tree_node **root,
                               struct mpm_error *error)
{
    *root = NULL;
    struct parsing parsing = {
        .source = source, .origin = origin, .bytes = bytes, .length = length, .error = error};
    MPM_TRY(refuse_binary(&parsing));
    skip_mark(&parsing);
    if (!yaml_parser_initialize(&parsing.parser))
        return no_memory(&parsing);
    yaml_parser_set_encoding(&parsing.parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&parsing.parser, (const unsigned char *)parsing.bytes,
                                 parsing.length);
    const enum mpm_status status = read_document(&parsing, root);
    yaml_parser_delete(&parsing.parser);
    if (status != MPM_OK) {
        mpm_tree_free(*root);
        *root = NULL;
    }
    return status;
}
