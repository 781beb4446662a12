/* Tables of keys: search, and words for messages and lists.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/yaml/keys.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const struct mpm_key *mpm_key_find(const struct mpm_key *group, const char *name)
{
    for (const struct mpm_key *key = group->children; key->name != NULL; key++)
        if (strcmp(key->name, name) == 0)
            return key;
    return NULL;
}

const struct mpm_choice *mpm_key_choice(const struct mpm_key *key, const char *name)
{
    for (size_t i = 0; i < key->choice_count; i++)
        if (strcmp(name, key->choices[i].name) == 0)
            return &key->choices[i];
    return NULL;
}

static struct mpm_nearest nearest_key(const struct mpm_key *group, const char *word)
{
    struct mpm_nearest nearest = {.word = word};
    for (const struct mpm_key *key = group->children; key->name != NULL; key++)
        mpm_nearest_offer(&nearest, key->name);
    return nearest;
}

const char *mpm_key_nearest(const struct mpm_key *group, const char *word)
{
    return nearest_key(group, word).best;
}

const char *mpm_key_hint(const struct mpm_key *group, const char *word, char hint[MPM_HINT_SIZE])
{
    const struct mpm_nearest nearest = nearest_key(group, word);
    return mpm_nearest_hint(&nearest, hint);
}

/* Names are "a, b": each of them is ended where its comma is. */
const char *mpm_choice_hint(const struct mpm_key *key, const char *word, char hint[MPM_HINT_SIZE])
{
    struct mpm_nearest nearest = {.word = word};
    char names[MPM_ALLOWED_SIZE] = "";
    for (size_t i = 0; i < key->choice_count; i++)
        mpm_nearest_offer(&nearest, key->choices[i].name);
    if (key->value != NULL && key->value->names != NULL)
        (void)snprintf(names, sizeof names, "%s", key->value->names());
    for (char *name = names; *name != '\0';) {
        char *const end = name + strcspn(name, ",");
        const bool last = *end == '\0';
        *end = '\0';
        mpm_nearest_offer(&nearest, name);
        name = last ? end : end + 1 + strspn(end + 1, " ");
    }
    return mpm_nearest_hint(&nearest, hint);
}

struct mpm_key mpm_key_entry(const struct mpm_key *list)
{
    struct mpm_key entry = *list;
    entry.shape = list->shape == MPM_KEY_LIST     ? MPM_KEY_GROUP
                  : list->shape == MPM_KEY_POINTS ? MPM_KEY_PAIR
                                                  : MPM_KEY_ONE;
    if (list->shape != MPM_KEY_PAIR) /* the range was of how many */
        entry.range = (struct mpm_range){.low = -HUGE_VAL, .high = HUGE_VAL};
    return entry;
}

bool mpm_range_holds(const struct mpm_range *range, double value)
{
    return (range->low_open ? value > range->low : value >= range->low) &&
           (range->high_open ? value < range->high : value <= range->high);
}

/* ------------------------------------------------------------------ wording */

const char *mpm_key_type(const struct mpm_key *key)
{
    switch (key->shape) {
    case MPM_KEY_ONE:
        return key->value->one;
    case MPM_KEY_PAIR:
        return key->value->two;
    case MPM_KEY_VALUES:
        return "list of texts";
    case MPM_KEY_POINTS:
        return "list of 2 numbers";
    case MPM_KEY_CHOICE:
        return "choice";
    case MPM_KEY_GROUP:
        return "mapping";
    case MPM_KEY_LIST:
        return "list of mappings";
    }
    return "";
}

/* Writes numbers as a person would: 2147483648, 0.5. */
static void range_text(const struct mpm_range *range, char *buffer, size_t size)
{
    if (isinf(range->low) && isinf(range->high))
        (void)snprintf(buffer, size, "%s", "");
    else if (range->low == range->high)
        (void)snprintf(buffer, size, "%.16g", range->low);
    else if (isinf(range->high))
        (void)snprintf(buffer, size, "%s %.16g", range->low_open ? "above" : "at least",
                       range->low);
    else if (range->high_open)
        (void)snprintf(buffer, size, "between %.16g and %.16g, both excluded", range->low,
                       range->high);
    else if (range->low_open)
        (void)snprintf(buffer, size, "above %.16g, up to %.16g", range->low, range->high);
    else
        (void)snprintf(buffer, size, "from %.16g to %.16g", range->low, range->high);
}

static void choices_text(const struct mpm_key *key, char *buffer, size_t size)
{
    size_t used = 0;
    for (size_t i = 0; i < key->choice_count && used < size; i++)
        used += (size_t)snprintf(buffer + used, size - used, "%s%s", i > 0 ? " | " : "",
                                 key->choices[i].name);
}

const char *mpm_key_range(const struct mpm_key *key, char buffer[MPM_ALLOWED_SIZE])
{
    const struct mpm_value_kind *const value = key->value;
    buffer[0] = '\0';
    if (key->shape == MPM_KEY_CHOICE)
        choices_text(key, buffer, MPM_ALLOWED_SIZE);
    else if (key->shape == MPM_KEY_POINTS)
        (void)snprintf(buffer, MPM_ALLOWED_SIZE, "%.16g to %.16g points", key->range.low,
                       key->range.high);
    else if (key->shape == MPM_KEY_VALUES || (key->shape == MPM_KEY_LIST && key->range.low > 0.0))
        (void)snprintf(buffer, MPM_ALLOWED_SIZE, "of %.16g to %.16g entries", key->range.low,
                       key->range.high);
    else if (value != NULL && value->names != NULL)
        (void)snprintf(buffer, MPM_ALLOWED_SIZE, "%s", value->names());
    else if (value != NULL && value->allowed != NULL)
        (void)snprintf(buffer, MPM_ALLOWED_SIZE, "%s", value->allowed);
    else if (value != NULL && value->ranged)
        range_text(&key->range, buffer, MPM_ALLOWED_SIZE);
    return buffer;
}

const char *mpm_key_allowed(const struct mpm_key *key, char buffer[MPM_ALLOWED_SIZE])
{
    char range[MPM_ALLOWED_SIZE];
    (void)mpm_key_range(key, range);
    const char *type = mpm_key_type(key);
    if (strcmp(type, "choice") == 0 || key->value == &mpm_kind_boolean)
        type = "";
    const char *between = type[0] != '\0' && range[0] != '\0' ? " " : "";
    (void)snprintf(buffer, MPM_ALLOWED_SIZE, "%s%s%.400s", type, between, range);
    return buffer;
}

const char *mpm_key_children(const struct mpm_key *group, char buffer[MPM_ALLOWED_SIZE])
{
    size_t used = 0;
    for (const struct mpm_key *key = group->children; key->name != NULL; key++)
        if (used < MPM_ALLOWED_SIZE)
            used += (size_t)snprintf(buffer + used, MPM_ALLOWED_SIZE - used, "%s%s",
                                     used > 0 ? ", " : "", key->name);
    return buffer;
}
