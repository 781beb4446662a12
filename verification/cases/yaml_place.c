/* Where something stands in a YAML file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/yaml_place.h"

#include "verification/common/failure.h"

#include <glib.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

static bool document_load(const char *file, yaml_document_t *document)
{
    FILE *stream = fopen(file, "rb");
    if (stream == NULL)
        return false;
    yaml_parser_t parser;
    bool loaded = false;
    if (yaml_parser_initialize(&parser)) {
        yaml_parser_set_input_file(&parser, stream);
        loaded = yaml_parser_load(&parser, document) != 0;
        yaml_parser_delete(&parser);
    }
    fclose(stream);
    return loaded;
}

static bool is_scalar(const yaml_node_t *node, const char *text)
{
    return node != NULL && node->type == YAML_SCALAR_NODE &&
           strcmp((const char *)node->data.scalar.value, text) == 0;
}

static yaml_node_t *child_of(yaml_document_t *document, const yaml_node_t *node, const char *key)
{
    if (node->type == YAML_MAPPING_NODE) {
        for (yaml_node_pair_t *pair = node->data.mapping.pairs.start;
             pair < node->data.mapping.pairs.top; pair++)
            if (is_scalar(yaml_document_get_node(document, pair->key), key))
                return yaml_document_get_node(document, pair->value);
    } else if (node->type == YAML_SEQUENCE_NODE) {
        const long position = strtol(key, NULL, 10);
        if (position >= 0 &&
            position < node->data.sequence.items.top - node->data.sequence.items.start)
            return yaml_document_get_node(document, node->data.sequence.items.start[position]);
    }
    return NULL;
}

unsigned yaml_place_line(const char *file, const char *path)
{
    yaml_document_t document;
    if (!document_load(file, &document))
        return 0;
    yaml_node_t *node = yaml_document_get_root_node(&document);
    unsigned line = node == NULL ? 0 : (unsigned)node->start_mark.line + 1;
    char **keys = g_strsplit(path, ".", -1);
    for (char **key = keys; node != NULL && *key != NULL; key++) {
        node = child_of(&document, node, *key);
        if (node != NULL)
            line = (unsigned)node->start_mark.line + 1;
    }
    g_strfreev(keys);
    yaml_document_delete(&document);
    return line;
}

unsigned yaml_place_scalar(const char *file, const char *text, unsigned line, unsigned column)
{
    yaml_document_t document;
    if (!document_load(file, &document))
        return 0;
    unsigned found = 0;
    for (yaml_node_t *node = document.nodes.start; node < document.nodes.top; node++) {
        const unsigned at = (unsigned)node->start_mark.line + 1;
        const bool after =
            at > line || (at == line && (unsigned)node->start_mark.column + 1 >= column);
        if (after && is_scalar(node, text) && (found == 0 || at < found))
            found = at;
    }
    yaml_document_delete(&document);
    return found;
}

enum mpm_status yaml_refuse(const char *file, struct mpm_error *error, const char *place,
                            const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *text = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    failure_set(error, MPM_BAD_INPUT, "%s:%u: %s: %s", file, yaml_place_line(file, place), place,
                text);
    g_free(text);
    return MPM_BAD_INPUT;
}
