/* Results of other solvers: what each reader makes of a file, and what it refuses with which
 * message.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"

#include "verification/score/results.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

static const struct score_format planar = {MPM_PLANE_STRAIN, {"mm", "g", "ms", "K"}, 0};

/* The same three points at time 2 in every format. */
static const double places[3][2] = {{0, 1}, {1, 1}, {2, 1.5}};
static const double tensor[3][9] = {{1, 4, 0, 4, 2, 0, 0, 0, 3},
                                    {10, 40, 0, 40, 20, 0, 0, 0, 30},
                                    {-1, -4, 0, -4, -2, 0, 0, 0, -3}};

/* The same as xx yy zz xy yz xz. */
static const double symmetric[3][6] = {
    {1, 2, 3, 4, 0, 0}, {10, 20, 30, 40, 0, 0}, {-1, -2, -3, -4, 0, 0}};

static char *csv_text(void)
{
    GString *text = g_string_new("# comment\n\ntime [ms], x [mm], y, displacement_x [mm], "
                                 "displacement_y,stress_xx [g mm^-1 ms^-2],stress_yy,stress_zz,"
                                 "stress_xy, pressure\r\n");
    for (size_t p = 0; p < 3; p++)
        g_string_append_printf(text, "2,%g,%g,0.5,0.25,%g,%g,%g,%g,7\n", places[p][0], places[p][1],
                               tensor[p][0], tensor[p][4], tensor[p][8], tensor[p][1]);
    return g_string_free(text, FALSE);
}

static char *vtk_text(void)
{
    GString *text = g_string_new("# vtk DataFile Version 3.0\npoints\nASCII\nDATASET POLYDATA\n"
                                 "FIELD FieldData 1\nTIME 1 1 double\n2\nPOINTS 3 double\n");
    for (size_t p = 0; p < 3; p++)
        g_string_append_printf(text, "%g %g 0\n", places[p][0], places[p][1]);
    g_string_append(text, "VERTICES 3 6\n1 0 1 1 1 2\nPOINT_DATA 3\nVECTORS displacement double\n"
                          "0.5 0.25 0 0.5 0.25 0 0.5 0.25 0\nTENSORS stress double\n");
    for (size_t p = 0; p < 3; p++)
        for (size_t c = 0; c < 9; c++)
            g_string_append_printf(text, "%g%s", tensor[p][c], c % 3 == 2 ? "\n" : " ");
    g_string_append(text, "SCALARS pressure double 1\nLOOKUP_TABLE default\n7 7 7\n");
    return g_string_free(text, FALSE);
}

/* An array as ASCII or as base64 with its count of bytes before it. */
static void add_array(GString *text, bool binary, const char *name, size_t components,
                      const double *values, size_t count)
{
    g_string_append_printf(text,
                           "<DataArray type=\"Float64\" Name=\"%s\" NumberOfComponents=\"%zu\" "
                           "format=\"%s\">\n",
                           name, components, binary ? "binary" : "ascii");
    if (binary) {
        const guint32 bytes = (guint32)(count * sizeof *values);
        guchar *data = g_malloc(sizeof bytes + bytes);
        memcpy(data, &bytes, sizeof bytes);
        memcpy(data + sizeof bytes, values, bytes);
        char *code = g_base64_encode(data, sizeof bytes + bytes);
        g_string_append(text, code);
        g_free(code);
        g_free(data);
    }
    for (size_t i = 0; !binary && i < count; i++)
        g_string_append_printf(text, "%.17g ", values[i]);
    g_string_append(text, "\n</DataArray>\n");
}

static char *vtu_text(bool binary, bool timed)
{
    double points[9] = {0}, displacement[9] = {0}, volume[27] = {0};
    const double time = 2;
    for (size_t p = 0; p < 3; p++) {
        points[3 * p] = places[p][0];
        points[3 * p + 1] = places[p][1];
        displacement[3 * p] = 0.5;
        displacement[3 * p + 1] = 0.25;
        for (size_t c = 0; c < 9; c += 4)
            volume[9 * p + c] = 0.5;
    }
    GString *text = g_string_new("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
                                 "version=\"0.1\" byte_order=\"LittleEndian\">\n"
                                 "<UnstructuredGrid>\n");
    if (timed) {
        g_string_append(text, "<FieldData>\n");
        add_array(text, binary, "TimeValue", 1, &time, 1);
        g_string_append(text, "</FieldData>\n");
    }
    g_string_append(text, "<Piece NumberOfPoints=\"3\" NumberOfCells=\"0\">\n<PointData>\n");
    add_array(text, binary, "displacement", 3, displacement, 9);
    if (binary)
        add_array(text, binary, "stress", 6, &symmetric[0][0], 18);
    else
        add_array(text, binary, "stress", 9, &tensor[0][0], 27);
    add_array(text, binary, "deformation_gradient", 9, volume, 27);
    g_string_append(text, "</PointData>\n<Points>\n");
    add_array(text, binary, "Points", 3, points, 9);
    g_string_append(text,
                    "</Points>\n<Cells></Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    return g_string_free(text, FALSE);
}

static char *vtu_ascii(void)
{
    return vtu_text(false, true);
}

static char *vtu_binary(void)
{
    return vtu_text(true, true);
}

static void assert_points(const struct score_table *table)
{
    ck_assert_uint_eq(table->rows, 3);
    for (size_t p = 0; p < 3; p++) {
        ck_assert_double_eq(score_table_value(table, SCORE_TIME, p), 2);
        ck_assert_double_eq(score_table_value(table, SCORE_INITIAL_X, p), places[p][0] - 0.5);
        ck_assert_double_eq(score_table_value(table, SCORE_INITIAL_Y, p), places[p][1] - 0.25);
        ck_assert_double_eq(score_table_value(table, SCORE_STRESS_XX, p), tensor[p][0]);
        ck_assert_double_eq(score_table_value(table, SCORE_STRESS_YY, p), tensor[p][4]);
        ck_assert_double_eq(score_table_value(table, SCORE_STRESS_ZZ, p), tensor[p][8]);
        ck_assert_double_eq(score_table_value(table, SCORE_STRESS_XY, p), tensor[p][1]);
        if (score_table_has(table, SCORE_RELATIVE_VOLUME))
            ck_assert_double_eq(score_table_value(table, SCORE_RELATIVE_VOLUME, p), 0.125);
    }
}

START_TEST(every_format_gives_the_same_points)
{
    char *folder = test_folder_create();
    struct mpm_error error = {.message = ""};
    char *texts[] = {csv_text(), vtk_text(), vtu_text(false, true), vtu_text(true, true),
                     vtu_text(true, false)};
    static const char *const names[] = {"a.csv", "b.vtk", "c.vtu", "d.vtu", "sub/e.vtu"};
    char *below = test_folder_path(folder, "sub");
    ck_assert_int_eq(g_mkdir(below, 0700), 0);
    g_free(below);
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++) {
        g_free(test_folder_write(folder, names[i], texts[i]));
        g_free(texts[i]);
    }
    g_free(test_folder_write(folder, "sub/all.pvd",
                             "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"2\" "
                             "part=\"0\" file=\"e.vtu\"/></Collection></VTKFile>"));
    static const char *const read[] = {"a.csv", "b.vtk", "c.vtu", "d.vtu", "sub/all.pvd", "sub"};
    for (size_t i = 0; i < G_N_ELEMENTS(read); i++) {
        char *path = test_folder_path(folder, read[i]);
        struct score_table table;
        ck_assert_msg(results_read(path, &planar, &table, &error) == MPM_OK, "%s", error.message);
        assert_points(&table);
        ck_assert_uint_eq(table.unread->len, i < 2 ? 1 : 0); /* the pressure */
        score_table_close(&table);
        g_free(path);
    }
    test_folder_remove(folder);
}
END_TEST

START_TEST(initial_positions_follow_from_ids_and_other_bodies_are_left_out)
{
    char *folder = test_folder_create();
    struct mpm_error error = {.message = ""};
    struct score_table table;
    char *path = test_folder_write(folder, "a.csv",
                                   "time,id,body,x,y\n0,5,0,1,2\n0,6,1,9,9\n0,7,0,3,4\n"
                                   "1,7,0,3.5,4.25\n1,5,0,0.5,2\n1,6,1,9,9\n");
    ck_assert_msg(results_read(path, &planar, &table, &error) == MPM_OK, "%s", error.message);
    ck_assert_uint_eq(table.rows, 4);
    ck_assert_double_eq(score_table_value(&table, SCORE_INITIAL_X, 2), 3);
    ck_assert_double_eq(score_table_value(&table, SCORE_DISPLACEMENT_Y, 2), 0.25);
    ck_assert_double_eq(score_table_value(&table, SCORE_DISPLACEMENT_X, 3), -0.5);
    score_table_close(&table);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

START_TEST(a_column_has_as_many_values_as_the_table_has_rows)
{
    struct score_table table;
    score_table_open(&table);
    table.rows = 1;
    score_table_add(&table, SCORE_X)[0] = 7;
    table.rows = 5000;
    score_table_add(&table, SCORE_X);
    ck_assert_uint_eq(table.column[SCORE_X]->len, table.rows);
    ck_assert_double_eq(score_table_value(&table, SCORE_X, 0), 7);
    ck_assert_double_eq(score_table_value(&table, SCORE_X, 4999), 0);
    score_table_close(&table);
}
END_TEST

/* What writers put into files besides the values. */
static const struct extra {
    const char *name;
    char *(*good)(void);
    const char *from, *to;
} extras[] = {
    {"b.vtk", vtk_text, "VERTICES 3 6\n1 0 1 1 1 2",
     "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\n"
     "VERTICES 4 3\nOFFSETS vtktypeint64\n0 1 2 3\nCONNECTIVITY vtktypeint64\n0 1 2"},
    {"b.vtk", vtk_text, "VERTICES 3 6\n1 0 1 1 1 2",
     "VERTICES 1 0\nOFFSETS vtktypeint64\n0\nCONNECTIVITY vtktypeint64\n"},
    {"b.vtk", vtk_text, "FieldData 1\n",
     "FieldData 2\nb 1 1 int\n9\nMETADATA\r\nINFORMATION 0\r\n\r\n"},
    {"b.vtk", vtk_text, "7 7 7\n", "7 7 7\nMETADATA"},
    {"a.csv", csv_text, "# comment\n\n", "\xEF\xBB\xBF"},
    {"a.csv", csv_text, "# comment\n\n", "\xEF\xBB\xBF# comment\r\n"},
    /* an array that is named as the places are, and is none */
    {"b.vtk", vtk_text, "FieldData 1\n", "FieldData 2\nposition 3 0 double\n"},
    {"c.vtu", vtu_ascii, "\n</DataArray>\n<DataArray type=\"Float64\" Name=\"stress\"",
     "<InformationKey name=\"L2\"><Value index=\"0\">0</Value><Value>1</Value></InformationKey>"
     "</DataArray>\n<DataArray type=\"Float64\" Name=\"stress\""},
    {"c.vtu", vtu_ascii, "</Cells>",
     "<DataArray format=\"ascii\">0<InformationKey><Value>1</Value></InformationKey></DataArray>"
     "<DataArray Name=\"stress\" format=\"ascii\">0</DataArray></Cells>"},
};

START_TEST(what_writers_add_is_passed_over)
{
    const struct extra *extra = &extras[_i];
    char *folder = test_folder_create(), *good = extra->good();
    char **parts = g_strsplit(good, extra->from, 2);
    ck_assert_uint_eq(g_strv_length(parts), 2);
    char *text = g_strconcat(parts[0], extra->to, parts[1], NULL);
    char *path = test_folder_write(folder, extra->name, text);
    struct mpm_error error = {.message = ""};
    struct score_table table;
    ck_assert_msg(results_read(path, &planar, &table, &error) == MPM_OK, "%s", error.message);
    assert_points(&table);
    score_table_close(&table);
    g_free(path);
    g_free(text);
    g_strfreev(parts);
    g_free(good);
    test_folder_remove(folder);
}
END_TEST

START_TEST(axisymmetric_columns_have_names_of_their_own)
{
    ck_assert_int_eq(score_column_find("stress_zz", MPM_AXISYMMETRIC), SCORE_STRESS_YY);
    ck_assert_int_eq(score_column_find("stress_zz", MPM_PLANE_STRAIN), SCORE_STRESS_ZZ);
    ck_assert_int_eq(score_column_find("stress_tt", MPM_AXISYMMETRIC), SCORE_STRESS_ZZ);
    ck_assert_int_eq(score_column_find("stress_tt", MPM_PLANE_STRESS), SCORE_COLUMNS);
    char *unit = score_column_unit(SCORE_STRESS_XX, &planar.units);
    ck_assert_str_eq(unit, "g mm^-1 ms^-2");
    g_free(unit);
}
END_TEST

/* A good text with one part replaced. */
struct spoiled {
    const char *name; /* of the file; its suffix selects the reader */
    char *(*good)(void);
    const char *from, *to;
    const char *message; /* part of the refusal */
};

static char *ids_text(void)
{
    return g_strdup("time,id,x,y\n0,5,1,2\n0,6,3,4\n1,5,1,2\n1,6,3,4\n");
}

static char *pvd_text(void)
{
    return g_strdup("<VTKFile type=\"Collection\"><Collection>\n"
                    "<DataSet timestep=\"2\" file=\"e.vtu\"/></Collection></VTKFile>");
}

static char *vtp_without_points(void)
{
    return g_strdup("<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"9\"/></PolyData>"
                    "</VTKFile>");
}

static const struct spoiled spoils[] = {
    {"a.csv", csv_text, "x [mm]", "x [m]", "a.csv:3: x is in \"m\": allowed is \"mm\""},
    {"a.csv", csv_text, "#", "\xEF\xBB\xBFtime\n#", "a.csv:4: has 10 cells, the line of names 1"},
    {"a.csv", csv_text, "y,", "body,", "none of the 3 rows is of body 0, which the problem"},
    {"a.csv", ids_text, "1,6", "1,1e300", "a.csv: point 3 has id 1e+300: allowed are whole"},
    {"a.csv", ids_text, "1,6", "1,6.5", "a.csv: point 3 has id 6.5: allowed are whole"},
    {"a.csv", ids_text, "0,6", "0,5", "a.csv: two points have id 5 at time 0: allowed is one"},
    {"a.csv", csv_text, "y,", "x,", "a.csv:3: column x is there twice"},
    {"a.csv", csv_text, "\n2,1", "\n2,nan", "a.csv:5: x: \"nan\" is not a finite number"},
    {"a.csv", csv_text, "\n2,1", "\n2,1e999", "\"1e999\" is not a finite number"},
    {"a.csv", csv_text, "\n2,1", "\n2,1 mm", "\"1 mm\" is not a finite number"},
    {"a.csv", csv_text, "\n2,1", "\n2,", "a.csv:5: x: \"\" is not a finite number"},
    {"a.csv", csv_text, "\n2,1", "\n1", "a.csv:5: has 9 cells, the line of names 10"},
    {"b.vtk", vtk_text, "# vtk", "vtk", "b.vtk:1: no legacy VTK file"},
    {"b.vtk", vtk_text, "ASCII", "BINARY", "b.vtk:3: \"BINARY\": allowed is ASCII"},
    {"b.vtk", vtk_text, "POLYDATA", "STRUCTURED_GRID",
     "allowed are POLYDATA and UNSTRUCTURED_GRID"},
    {"b.vtk", vtk_text, "POINTS 3", "POINTS 4", "\"VERTICES\": allowed is a number"},
    {"b.vtk", vtk_text, "POINTS 3", "POINTS -3", "\"-3\": allowed is a number of things"},
    {"b.vtk", vtk_text, "POINT_DATA 3", "POINT_DATA 2", "as many rows as POINTS"},
    {"b.vtk", vtk_text, "POINTS 3", "POINTS 1 double\n0 0 0\nPOINTS 3",
     "b.vtk:10: \"POINTS\": a second time: allowed is once"},
    {"b.vtk", vtk_text, "POINTS 3", "POINT_DATA 0\nVECTORS velocity double\nPOINTS 3",
     "b.vtk:8: \"POINT_DATA\": allowed is POINTS before it"},
    {"b.vtk", vtk_text, "POINT_DATA", "CELL_DATA", "CELL_DATA is not read"},
    {"b.vtk", vtk_text, "VECTORS", "NORMALS", "b.vtk:15: \"NORMALS\": allowed are POINTS"},
    {"b.vtk", vtk_text, "1 4 0", "nan 4 0",
     "stress: component 0 of point 0 is nan: allowed are finite numbers"},
    {"b.vtk", vtk_text, "VECTORS displacement double",
     "SCALARS displacement double\nLOOKUP_TABLE x",
     "displacement has 1 components: allowed are 2, 3"},
    {"b.vtk", vtk_text, "7 7 7\n", "7 7\n", "\"\": allowed is a number"},
    {"c.vtu", vtu_ascii, "UnstructuredGrid\" ", "ImageData\" ",
     "c.vtu:3: type \"ImageData\": allowed are UnstructuredGrid and PolyData"},
    {"c.vtu", vtu_ascii, "byte_order", "compressor=\"z\" a", "compressed arrays are not read"},
    {"c.vtu", vtu_ascii, "LittleEndian", "BigEndian", "allowed is LittleEndian"},
    {"c.vtu", vtu_ascii, "Points=\"3\"", "Points=\"0\"", "NumberOfPoints \"0\""},
    {"c.vtu", vtu_ascii, "Points=\"3\"", "Points=\"100000001\"",
     "NumberOfPoints \"100000001\": allowed are whole numbers from 1 to 100000000"},
    {"c.vtu", vtu_ascii, "Points=\"3\"", "Points=\"2.5\"", "NumberOfPoints \"2.5\""},
    {"c.vtp", vtp_without_points, "9", "8", "c.vtp: the Piece has no array of Points"},
    {"b.vtk", vtk_text, "POINTS 3", "POINTS 100000001", "allowed are up to 1e8 points"},
    {"c.vtu", vtu_ascii, "Points=\"3\"", "Points=\"4\"", "has 9 values, not 4 points of 3"},
    {"c.vtu", vtu_ascii, "<Piece",
     "<Points><DataArray NumberOfComponents=\"3\" format=\"ascii\"></DataArray></Points><Piece",
     "c.vtu:9: an array of points before Piece"},
    {"c.vtu", vtu_ascii, "ascii\"", "appended\"", "format \"appended\": allowed are ascii and"},
    {"c.vtu", vtu_ascii, "</Points>", "</Point>", "c.vtu: "},
    {"c.vtu", vtu_ascii, "<Cells>", "<AppendedData>", "appended arrays are not read"},
    {"d.vtu", vtu_binary, "Float64", "Float16", "of type Float16 cannot be read as base64"},
    {"d.vtu", vtu_binary, "2AAAA", "2BAAA", "cannot be read as base64"},
    {"e.txt", csv_text, "#", "#", "e.txt: allowed are .csv, .hdf, .h5, .hdf5, .vtk"},
    {"f.hdf", csv_text, "#", "#", "f.hdf: is no HDF5 file"},
    {"g.pvd", csv_text, "#", "#", "g.pvd: "},
    {"h.pvd", pvd_text, "file", "files", "h.pvd:2: a DataSet needs the file (.vtu, .vtp, .vtk)"},
    {"h.pvd", pvd_text, "\"2\"", "\"two\"", "h.pvd:2: a DataSet needs the file"},
};

START_TEST(a_bad_file_is_refused_with_place_and_reason)
{
    const struct spoiled *spoil = &spoils[_i];
    char *folder = test_folder_create(), *good = spoil->good();
    char **parts = g_strsplit(good, spoil->from, 2);
    ck_assert_msg(g_strv_length(parts) == 2, "row %d changes nothing", _i);
    char *text = g_strconcat(parts[0], spoil->to, parts[1], NULL);
    char *path = test_folder_write(folder, spoil->name, text);
    struct score_table table;
    struct mpm_error error = {.message = "accepted"};
    const enum mpm_status status = results_read(path, &planar, &table, &error);
    ck_assert_msg(status == MPM_BAD_INPUT && strstr(error.message, spoil->message) != NULL, "%s",
                  error.message);
    g_free(path);
    g_free(text);
    g_strfreev(parts);
    g_free(good);
    test_folder_remove(folder);
}
END_TEST

/* Every text cut short after any of its bytes, and every byte replaced: read or refused, never a
 * crash and never a number that is not finite. */
START_TEST(files_cut_short_or_scrambled_never_crash_a_reader)
{
    static const struct {
        const char *name;
        char *(*good)(void);
    } files[] = {
        {"a.csv", csv_text}, {"b.vtk", vtk_text}, {"c.vtu", vtu_ascii}, {"d.vtu", vtu_binary}};
    enum { STRIDE = 7 };
    char *folder = test_folder_create(), *good = files[_i].good();
    const size_t length = strlen(good);
    for (size_t cut = 0; cut < length; cut += STRIDE)
        for (int scramble = 0; scramble < 2; scramble++) {
            char *text = g_strdup(good);
            text[cut] = scramble ? (char)('!' + (char)(cut % 90)) : '\0';
            char *path = test_folder_write(folder, files[_i].name, text);
            struct score_table table;
            struct mpm_error error = {.message = ""};
            if (results_read(path, &planar, &table, &error) == MPM_OK) {
                for (int c = 0; c < SCORE_COLUMNS; c++)
                    for (size_t p = 0; table.column[c] != NULL && p < table.rows; p++)
                        ck_assert(isfinite(score_table_value(&table, (enum score_column)c, p)));
                score_table_close(&table);
            } else {
                ck_assert_uint_gt(strlen(error.message), 0);
            }
            g_free(path);
            g_free(text);
        }
    g_free(good);
    test_folder_remove(folder);
}
END_TEST

Suite *suite_score_readers(void)
{
    Suite *suite = suite_create("score_readers");
    TCase *readers = tcase_create("readers");
    tcase_add_test(readers, every_format_gives_the_same_points);
    tcase_add_test(readers, initial_positions_follow_from_ids_and_other_bodies_are_left_out);
    tcase_add_test(readers, a_column_has_as_many_values_as_the_table_has_rows);
    tcase_add_loop_test(readers, what_writers_add_is_passed_over, 0, (int)G_N_ELEMENTS(extras));
    tcase_add_test(readers, axisymmetric_columns_have_names_of_their_own);
    tcase_add_loop_test(readers, a_bad_file_is_refused_with_place_and_reason, 0,
                        (int)G_N_ELEMENTS(spoils));
    tcase_add_loop_test(readers, files_cut_short_or_scrambled_never_crash_a_reader, 0, 4);
    suite_add_tcase(suite, readers);
    return suite;
}
