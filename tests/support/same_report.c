/* Reports that differ in times alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/same_report.h"

#include "support/marks.h"
#include "verification/records/records.h"

#include <glib.h>
#include <string.h>

static bool is_time(const char *key)
{
    static const char *const times[] = {"seconds", "started", "command"};
    for (size_t i = 0; i < G_N_ELEMENTS(times); i++)
        if (strcmp(times[i], key) == 0)
            return true;
    return false;
}

static bool is_measured_time(const json_t *line)
{
    static const char *const quantities[] = {"seconds", "cpu_seconds", "peak_bytes"};
    for (size_t i = 0; i < G_N_ELEMENTS(quantities); i++)
        if (strcmp(record_text(line, "quantity"), quantities[i]) == 0)
            return true;
    return false;
}

static void remove_times(json_t *json)
{
    const char *key;
    json_t *value;
    void *next;
    size_t i;
    json_object_foreach_safe(json, next, key, value)
    {
        if (is_time(key))
            json_object_del(json, key);
        else
            remove_times(value);
    }
    json_array_foreach(json, i, value)
    {
        remove_times(value);
        if (is_measured_time(value))
            json_object_set_new(value, "value", json_null());
    }
}

void test_assert_same_report(const char *one, const char *other)
{
    const char *const folders[2] = {one, other};
    struct records records[2];
    struct mpm_error error;
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(records_read(folders[i], &records[i], &error), MPM_OK);
        remove_times(records[i].run);
        remove_times(records[i].checks);
        remove_times(records[i].measurements);
    }
    ck_assert(json_equal(records[0].run, records[1].run));
    ck_assert(json_equal(records[0].checks, records[1].checks));
    ck_assert(json_equal(records[0].measurements, records[1].measurements));
    records_clear(&records[0]);
    records_clear(&records[1]);
}
