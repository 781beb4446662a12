/* A YAML file as JSON.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/scene_json.h"

#include "verification/common/failure.h"
#include "verification/common/rows.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <yaml.h>

static json_t *scalar_json(const yaml_node_t *node)
{
    const char *text = (const char *)node->data.scalar.value;
    double number;
    if (node->data.scalar.style == YAML_PLAIN_SCALAR_STYLE) {
        if (strcmp(text, "true") == 0 || strcmp(text, "false") == 0)
            return json_boolean(*text == 't');
        if (row_number(text, &number) && isfinite(number))
            return floor(number) < number || fabs(number) > 1e15 ? json_real(number)
                                                                 : json_integer((json_int_t)number);
    }
    return json_string(text);
}

/* NOLINTNEXTLINE(misc-no-recursion): the file nests a few levels */
static json_t *node_json(yaml_document_t *document, int index)
{
    const yaml_node_t *node = yaml_document_get_node(document, index);
    if (node == NULL)
        return json_null();
    if (node->type == YAML_SEQUENCE_NODE) {
        json_t *array = json_array();
        for (const yaml_node_item_t *item = node->data.sequence.items.start;
             item < node->data.sequence.items.top; item++)
            json_array_append_new(array, node_json(document, *item));
        return array;
    }
    if (node->type == YAML_MAPPING_NODE) {
        json_t *object = json_object();
        for (const yaml_node_pair_t *pair = node->data.mapping.pairs.start;
             pair < node->data.mapping.pairs.top; pair++) {
            const yaml_node_t *key = yaml_document_get_node(document, pair->key);
            if (key != NULL && key->type == YAML_SCALAR_NODE)
                json_object_set_new(object, (const char *)key->data.scalar.value,
                                    node_json(document, pair->value));
        }
        return object;
    }
    return scalar_json(node);
}

enum mpm_status scene_json_read(const char *path, json_t **json, struct mpm_error *error)
{
    FILE *stream = fopen(path, "rb");
    yaml_parser_t parser;
    yaml_document_t document;
    *json = NULL;
    if (stream == NULL)
        return failure_set(error, MPM_BAD_INPUT, "%s: cannot be read", path);
    if (yaml_parser_initialize(&parser)) {
        yaml_parser_set_input_file(&parser, stream);
        if (yaml_parser_load(&parser, &document)) {
            if (yaml_document_get_root_node(&document) != NULL)
                *json = node_json(&document, 1); /* nodes count from 1: the root */
            yaml_document_delete(&document);
        }
        yaml_parser_delete(&parser);
    }
    fclose(stream);
    if (json_is_object(*json))
        return MPM_OK;
    json_decref(*json);
    *json = NULL;
    return failure_set(error, MPM_BAD_INPUT, "%s: is no YAML of keys and values", path);
}
