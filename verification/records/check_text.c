/* Texts of checks and runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/records/check_text.h"

#include "verification/common/text.h"

#include <string.h>

static bool is_weakness(const json_t *check)
{
    return json_is_number(json_object_get(check, "fails_low"));
}

char *text_band(const json_t *check)
{
    const bool weakness = is_weakness(check);
    return text_range(record_number(check, weakness ? "fails_low" : "low"),
                      record_number(check, weakness ? "fails_high" : "high"),
                      record_text(check, "unit"));
}

char *text_value(const json_t *check)
{
    const bool weakness = is_weakness(check);
    const double value = record_number(check, "value");
    const char *unit = record_text(check, "unit");
    if (!verdict_is_red(record_status(check)))
        return text_quantity(value, unit);
    return text_beside_range(value, record_number(check, weakness ? "fails_low" : "low"),
                             record_number(check, weakness ? "fails_high" : "high"), unit);
}

char *text_verdict(const struct record_counts *counts)
{
    const size_t judged = counts->total - counts->skipped;
    const size_t known = counts->of[VERDICT_EXPECTED_FAIL];
    char *total = text_count(judged, "check");
    GString *text = g_string_new(NULL);
    if (counts->failed > 0)
        g_string_append_printf(text, "%zu of %s %s not hold", counts->failed, total,
                               counts->failed == 1 ? "does" : "do");
    else if (judged == 0)
        g_string_append(text, "Nothing was verified: every check was skipped");
    else
        g_string_append_printf(text, judged == 1 ? "The one check holds" : "All %s hold", total);
    if (counts->failed == 0 && known > 0)
        g_string_append_printf(text, ", %zu of them by showing a known weakness", known);
    if (judged > 0 && counts->skipped > 0)
        g_string_append_printf(text, " (%zu skipped)", counts->skipped);
    g_free(total);
    return g_string_free(text, FALSE);
}

char *text_check_name(const json_t *check)
{
    return g_strdup_printf("%s/%s [%s]", record_text(check, "case"), record_text(check, "check"),
                           record_text(check, "variant"));
}

char *text_command(const char *name, const char *variant, bool full, const json_t *run)
{
    if (json_is_true(json_object_get(run, "score"))) /* of another solver's results */
        return g_strdup(record_text(run, "command"));
    const char *kernels = record_text(run, "kernels");
    const bool by_default =
        *kernels == '\0' || strcmp(kernels, mpm_kernels_name(MPM_KERNELS_AUTO)) == 0;
    return g_strdup_printf("mpm-verify run%s --case %s --variant %s%s%s --output DIR",
                           full ? " --tier full" : "", name, variant,
                           by_default ? "" : " --kernels ", by_default ? "" : kernels);
}
