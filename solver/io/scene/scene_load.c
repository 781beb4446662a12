/* From a checked tree to C structs, by libcyaml.
 *
 * libcyaml reads text, not trees: libyaml writes it, every scalar in quotes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_load.h"

#include <cyaml/cyaml.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

/* ----------------------------------------------------------------- writing */

struct text {
    unsigned char *bytes;
    size_t length, capacity;
};

static int append(void *context, unsigned char *bytes, size_t length)
{
    struct text *text = context;
    if (length > text->capacity - text->length) {
        const size_t capacity = 2 * text->capacity + length;
        unsigned char *larger = realloc(text->bytes, capacity);
        if (larger == NULL)
            return 0;
        text->bytes = larger;
        text->capacity = capacity;
    }
    memcpy(text->bytes + text->length, bytes, length);
    text->length += length;
    return 1;
}

static bool emit(yaml_emitter_t *emitter, yaml_event_t *event, int initialised)
{
    return initialised && yaml_emitter_emit(emitter, event);
}

static bool write_scalar(yaml_emitter_t *emitter, const char *scalar)
{
    yaml_event_t event;
    return emit(emitter, &event,
                yaml_scalar_event_initialize(&event, NULL, NULL, (const yaml_char_t *)scalar,
                                             (int)strlen(scalar), 1, 1,
                                             YAML_DOUBLE_QUOTED_SCALAR_STYLE));
}

static bool write_node(yaml_emitter_t *emitter, const struct mpm_tree_node *node)
{
    if (node->kind == MPM_TREE_SCALAR)
        return write_scalar(emitter, node->text);
    const bool list = node->kind == MPM_TREE_LIST;
    yaml_event_t event;
    bool good = emit(
        emitter, &event,
        list ? yaml_sequence_start_event_initialize(&event, NULL, NULL, 1, YAML_FLOW_SEQUENCE_STYLE)
             : yaml_mapping_start_event_initialize(&event, NULL, NULL, 1, YAML_FLOW_MAPPING_STYLE));
    for (size_t i = 0; good && i < node->count; i++)
        good = (list || write_scalar(emitter, node->entries[i].key)) &&
               write_node(emitter, node->entries[i].value);
    return good && emit(emitter, &event,
                        list ? yaml_sequence_end_event_initialize(&event)
                             : yaml_mapping_end_event_initialize(&event));
}

static bool write_document(yaml_emitter_t *emitter, const struct mpm_tree_node *root)
{
    yaml_event_t event;
    return emit(emitter, &event, yaml_stream_start_event_initialize(&event, YAML_UTF8_ENCODING)) &&
           emit(emitter, &event,
                yaml_document_start_event_initialize(&event, NULL, NULL, NULL, 1)) &&
           write_node(emitter, root) &&
           emit(emitter, &event, yaml_document_end_event_initialize(&event, 1)) &&
           emit(emitter, &event, yaml_stream_end_event_initialize(&event));
}

static bool write_text(const struct mpm_tree_node *root, struct text *text)
{
    yaml_emitter_t emitter;
    if (!yaml_emitter_initialize(&emitter))
        return false;
    yaml_emitter_set_output(&emitter, append, text);
    yaml_emitter_set_unicode(&emitter, 1);
    yaml_emitter_set_width(&emitter, -1);
    const bool good = write_document(&emitter, root);
    yaml_emitter_delete(&emitter);
    return good;
}

/* ----------------------------------------------------------------- loading */

/* libcyaml gives NULL to the log for silence; it prints otherwise. */
static const cyaml_config_t config = {
    .log_fn = NULL, .mem_fn = cyaml_mem, .log_level = CYAML_LOG_ERROR, .flags = CYAML_CFG_NO_ALIAS};

enum mpm_status mpm_raw_load(const struct mpm_scene *scene, const struct mpm_tree_node *root,
                             struct mpm_raw_scene **raw, struct mpm_error *error)
{
    *raw = NULL;
    struct text text = {.capacity = 1024};
    text.bytes = malloc(text.capacity);
    if (text.bytes == NULL || !write_text(root, &text)) {
        free(text.bytes);
        return mpm_error_memory(error, text.capacity, "a scene's values");
    }
    cyaml_data_t *data = NULL;
    const cyaml_err_t problem =
        cyaml_load_data(text.bytes, text.length, &config, &mpm_scene_cyaml, &data, NULL);
    free(text.bytes);
    if (problem == CYAML_ERR_OOM)
        return mpm_error_memory(error, text.capacity, "a scene's values");
    if (problem != CYAML_OK || data == NULL)
        return mpm_scene_error(error, scene, 0, "", "cannot be loaded: %s",
                               cyaml_strerror(problem));
    *raw = data;
    return MPM_OK;
}

void mpm_raw_free(struct mpm_raw_scene *raw)
{
    if (raw != NULL)
        (void)cyaml_free(&config, &mpm_scene_cyaml, raw, 0);
}
