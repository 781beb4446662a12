/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/bundle_convert.h"

#include "verification/common/record.h"

#include <stdbool.h>
#include <string.h>

/* What a line is about: a part of a column's name, "" for any field, or none for numbers. */
static const struct line {
    const char *column;
    bool axisymmetric, numbers, moving; /* for these alone; moving: with time levels */
    const char *text;
} lines[] = {
    {"", false, false, false,
     "**Particles as VTK** (`.vtu`, `.vtp`, `.vtk`, one file for each instant, with a `.pvd`): "
     "read as they are if arrays have the names of docs/tutorial-score.md; rename `disp`, `vel`, "
     "`sigma` and the like. Without an array of displacements, give `id` and the file of time 0, "
     "or `initial_position`."},
    {"", false, false, false,
     "**Histories as CSV**, a file for each tracer or a line for each step: keep the lines at the "
     "instants above, add each point's initial position and the time to its line, and put all "
     "into one file. Nodes and Gauss points of finite elements are points as good as particles."},
    {"displacement", false, false, false,
     "**Positions**: displacement is position less initial position, of the particle's centre."},
    {"velocity", false, false, true,
     "**Velocities of particles**, not of nodes; codes with PIC, XPIC and the like often have two: "
     "take the one that particles carry on."},
    {"", false, false, true,
     "**Time levels**: a leapfrog has positions at step n and velocities at n - 1/2 or n + 1/2, "
     "other orders have stress of another time than positions. If so, add the columns "
     "`time_of_positions`, `time_of_velocities`, `time_of_stress` (of stress and "
     "`relative_volume`) with the times that the values are of; HDF5 files as attributes of "
     "`/mpm`. `time` stays the instant, and the reference is taken at the stated times. Mind where "
     "output is written: before or after the update of the step."},
    {"stress", false, false, false,
     "**Stress** is Cauchy's, tension positive, in units of the table: turn the sign of codes with "
     "compression positive, divide Kirchhoff stress by det F, multiply stress per density by the "
     "current density, and add -p to the diagonal of a deviator. Order xx, yy, zz, xy: Voigt's "
     "order xx, yy, zz, yz, xz, xy has xy last, VTK's six are xx, yy, zz, xy, yz, xz. In plane "
     "strain zz is not zero."},
    {"relative_volume", false, false, false,
     "**relative_volume** is det F, current over initial volume, initial over current density; in "
     "axisymmetry with the hoop stretch."},
    {"temperature", false, false, false,
     "**Temperatures** are those that particles carry, in the unit of the table; differences and "
     "absolute values count from the same zero as the initial state above."},
    {"", true, false, false,
     "**Axisymmetry**: r, z, hoop in the place of x, y, z; codes with the axis along x have both "
     "turned. Masses, forces and energies of the problem are those per radian: full revolution "
     "over 2 pi. Fields are the same."},
    {NULL, true, true, false,
     "**Axisymmetry**: sums such as mass, force and energy are per radian: those of the full "
     "revolution over 2 pi. Ratios are the same."},
    {NULL, false, true, false,
     "**Energies** of a leapfrog, whose velocities are at n - 1/2 or n + 1/2: take the mean of the "
     "kinetic energies of both beside strain energy at n. A ratio or a drift of sums that mix "
     "time levels swings with each vibration, though nothing is lost."},
    {NULL, false, true, false,
     "**Sums** are of all bodies that move, without rigid ones; in plane problems for the "
     "thickness 1 unless the problem has one. Stress is Cauchy's, tension positive."},
    {"", false, false, false,
     "**Units** are those of `problem.json`: a column in brackets, `velocity_x [m s^-1]`, is "
     "refused if it is in another one, and not converted."},
};

static bool has_column(const json_t *json, const char *part)
{
    const json_t *columns = json_object_get(json, "columns");
    for (size_t i = 0; i < json_array_size(columns); i++)
        if (strstr(record_text(json_array_get(columns, i), "name"), part) != NULL)
            return true;
    return false;
}

/* Whether positions, velocities or stress of other times can be meant. */
static bool has_levels(const json_t *json)
{
    static const char *const parts[] = {"displacement", "velocity", "stress", "relative_volume"};
    bool has = false;
    for (size_t k = 0; k < G_N_ELEMENTS(parts); k++)
        has = has || has_column(json, parts[k]);
    return has && !json_is_true(json_object_get(json, "at_rest"));
}

static bool applies(const struct line *line, const json_t *json)
{
    const bool axisymmetric = strcmp(record_text(json, "geometry"), "axisymmetric") == 0;
    const bool numbers = strcmp(record_text(json, "results"), "numbers") == 0;
    return line->numbers == numbers && (axisymmetric || !line->axisymmetric) &&
           (!line->moving || has_levels(json)) &&
           (numbers || *line->column == '\0' || has_column(json, line->column));
}

void bundle_words_of_conversion(GString *text, const json_t *json, double late)
{
    g_string_append(text, "\n## From what codes commonly write\n\n");
    for (size_t i = 0; i < G_N_ELEMENTS(lines); i++)
        if (applies(&lines[i], json))
            g_string_append_printf(text, "- %s\n", lines[i].text);
    if (late > 0.0)
        g_string_append_printf(text,
                               "\nEach criterion above states what the reference itself has when "
                               "it is read %g %s late. In proportion, that is what half a step of "
                               "your code costs where its time levels are not stated.\n",
                               late, record_text(json_object_get(json, "units"), "time"));
}
