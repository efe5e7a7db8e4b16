/**
 * @file
 * @brief Tests of the reader of OBJ texts: every rule of the format, its numbers, what is left out,
 *        and what is refused with a line.
 *
 * A rule is tested by two texts, an awkward one and its plain twin, which must give the same mesh
 * to the bit. The plain twins use single blanks, `v x y z` and positive indices only.
 */
#include "testing.h"

#include "assets/meshes/mesh_builder.h"
#include "assets/meshes/obj_reader.h"
#include "assets/meshes/obj_text.h"

#include <math.h>
#include <stdlib.h>

/** Three vertices. */
#define THREE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
/** Three vertices and their triangle. */
#define TRIANGLE THREE "f 1 2 3\n"

// --- helpers -------------------------------------------------------------------------------------

/** Takes no progress. See #MeshSink.report_progress. */
static void ignore_progress(void *context, double fraction) {
    (void)context;
    assert_true(fraction >= 0 && fraction <= 1);
}

/** Reads bytes from a copy of exactly their size, so that a sanitizer sees every overrun.
 *  @param[out] builder The mesh; to be released. @return Whether they were read. */
static bool read_bytes(const char *bytes, size_t size, MeshBuilder *builder, Error *error) {
    char *copy = malloc(size + !size);
    const MeshSink sink = {builder, mesh_builder_add, ignore_progress};
    assert_non_null(copy);
    memcpy(copy, bytes, size);
    mesh_builder_init(builder, error);
    bool is_read = obj_read(copy, size, &sink, &builder->repairs, error);
    free(copy);
    return is_read;
}

/** Reads a text that must be valid. @param[out] builder The mesh; to be released. */
static void read_valid(const char *text, MeshBuilder *builder) {
    Error error = {0};
    if (!read_bytes(text, strlen(text), builder, &error)) {
        fail_msg("%s\nline %zu: %s", text, error.line, error.message);
    }
}

/** @return Whether two welders have the same points in the same order. */
static bool is_same_set(const VertexWelder *a, const VertexWelder *b) {
    return a->count == b->count &&
           (a->count == 0 ||
            memcmp(a->points, b->points, a->count * a->dimension * sizeof *a->points) == 0);
}

/** @return Whether two lists of triangles are the same. */
static bool is_same_list(const MeshTriangle *a, const MeshTriangle *b, size_t count) {
    return count == 0 || memcmp(a, b, count * sizeof *a) == 0;
}

/** @return Whether two meshes are the same, to the bit. */
static bool is_same_mesh(const MeshBuilder *a, const MeshBuilder *b) {
    return a->count == b->count && is_same_set(&a->positions, &b->positions) &&
           is_same_set(&a->normals, &b->normals) && is_same_set(&a->uvs, &b->uvs) &&
           is_same_list(a->triangles, b->triangles, a->count) &&
           is_same_list(a->triangle_normals, b->triangle_normals, a->count) &&
           is_same_list(a->triangle_uvs, b->triangle_uvs, a->count);
}

// --- rules ---------------------------------------------------------------------------------------

/** Awkward texts and their plain twins. */
static const struct {
    const char *awkward; /**< A text that uses a rule of the format. */
    const char *plain;   /**< The same mesh in plain words. */
    size_t skipped;      /**< Statements of the awkward text that are left out. */
    size_t line;         /**< Line of the first of those. */
} twins[] = {
    // Blanks and tabs before, between and behind words; no newline at the end.
    {" v 0 0 0\n\tv\t1  0 0 \nv 0 1 0\t\n \t f  1\t2 3 ", TRIANGLE, 0, 0},
    {"  v 9 9 9\n" THREE "f 2 3 4\n", "v 9 9 9\n" THREE "f 2 3 4\n", 0, 0},
    // Ends of lines: CR LF, CR, empty lines; a byte order mark.
    {"v 0 0 0\r\nv 1 0 0\r\n\r\nv 0 1 0\r\nf 1 2 3\r\n", TRIANGLE, 0, 0},
    {"v 0 0 0\rv 1 0 0\r\rv 0 1 0\rf 1 2 3\r", TRIANGLE, 0, 0},
    {"\xEF\xBB\xBF" TRIANGLE, TRIANGLE, 0, 0},
    // Comments: alone, behind words, without a blank, with a backslash at their end.
    {"# v 5 5 5\n" THREE "f 1 2 3 # note\n", TRIANGLE, 0, 0},
    {THREE "f 1 2 3#note\n", TRIANGLE, 0, 0},
    {"v 0 0 0# f 1\nv 1 0 0 #\n v 0 1 0\n#\nf 1 2 3\n", TRIANGLE, 0, 0},
    {"# C:\\models\\\n" TRIANGLE, TRIANGLE, 0, 0},
    // Lines that go on.
    {"v 0 \\\n0 0\nv 1 0\\\r\n 0\nv \\\n \\\n 0 1 0\nf 1 2\\\n3\n", TRIANGLE, 0, 0},
    {THREE "g a \\\nf 3 2 1\nf 1 2 3\\", TRIANGLE, 0, 0},
    // Numbers.
    {"v .5 -.5 +.5\nv 1. +1 1e-3\nv 1E2 -2.5e+1 0003\nf 1 2 3\n",
     "v 0.5 -0.5 0.5\nv 1 1 0.001\nv 100 -25 3\nf 1 2 3\n", 0, 0},
    // A weight and colours behind a position, the depth of (u, v), (u) alone.
    {"v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 2 1 1 1\nf 1 2 3\n", TRIANGLE, 0, 0},
    {THREE "vt 0.5\nvt 0.25 1 7\nf 1/1 2/2 3/1\n", THREE "vt 0.5 0\nvt 0.25 1\nf 1/1 2/2 3/1\n", 0,
     0},
    // References of all kinds; parts that are left out.
    {THREE "vt 0 0\nvn 0 0 1\nf 1/ 2// 3/\n", TRIANGLE, 0, 0},
    {THREE "vt 0 1\nvn 0 0 1\nf 1//1 2//1 3//1\nf 3/1 2/1 1/1\nf 1/1/1 2/1/1 3/1/1\n",
     "vn 0 0 1\nvt 0 1\n" THREE "f 1//1 2//1 3//1\nf 3/1/ 2/1/ 1/1/\nf 1/1/1 2/1/1 3/1/1\n", 0, 0},
    // Normals and (u, v) that were stripped from the file.
    {THREE "f 1/1/1 2/2/2 3/3/3\n", TRIANGLE, 0, 0},
    // Relative references count back from the statement, positive ones from the start.
    {THREE "f -3 -2 -1\nv 0 0 1\nf -4 -3 -1\n", TRIANGLE "v 0 0 1\nf 1 2 4\n", 0, 0},
    {THREE "vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 1 0\nf -3/-2/-2 -2/-1/-2 -1/-1/-1\nvn 1 0 0\nvt 1 1\n",
     THREE "vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 1 0\nf 1/1/1 2/2/1 3/2/2\n", 0, 0},
    {"f 1 2 3\n" THREE, TRIANGLE, 0, 0},
    // Words of version 2; groups, materials, lines, points and display: no triangles, and known.
    {THREE "fo 1 2 3\n", TRIANGLE, 0, 0},
    {"mtllib a b.mtl\no a b\ng a b\ns 1\ns off\nusemtl\nusemap off\nmg 1 0.5\nbevel on\n"
     "c_interp on\nd_interp on\nlod 5\nshadow_obj a\ntrace_obj a\nmaplib a\nvp 0 1\nl 1 2\np "
     "1\n" TRIANGLE,
     TRIANGLE, 0, 0},
    // What is not known, and surfaces that are not polygons, are counted with the first line.
    {"foo\nlod 1\nparm u 0 1\n" TRIANGLE "flat\nV 1 2 3\n", TRIANGLE, 4, 1},
    {TRIANGLE "cstype bezier\ndeg 3 3\nsurf 0 1 0 1 1 2 3\nparm u 0 1\nend\n", TRIANGLE, 5, 5},
    {"\n#\n" THREE "t crease 2\nf 1 2 3\n", TRIANGLE, 1, 6},
    {THREE "f\nf 1\nf 1 2\nf 1 2 3\n", TRIANGLE, 3, 4},
    {"call a.obj\\\n b\n" TRIANGLE "csh ls\n", TRIANGLE, 2, 1},
    // Vertices that are not understood keep their number, if no face names them.
    {"v 1 2\nv nan 0 0\nv 1 2 inf\nv 1e999 0 0\nv 1 2 3.1+e2\nv a b c\nv\nv 1,0 0 0\n" THREE
     "f 9 10 11\n",
     TRIANGLE, 8, 1},
    {"v 1e16 0 0\n" THREE "f 2 3 4\n", TRIANGLE, 1, 1},
    // A concave polygon.
    {"v 0 0 0\nv 2 2 0\nv 0 1 0\nv -2 2 0\nf 1 2 3 4\n",
     "v 0 0 0\nv 2 2 0\nv 0 1 0\nv -2 2 0\nf 1 2 3\nf 3 4 1\n", 0, 0},
};

/** Awkward texts give the mesh of their plain twins, and say what they left out. */
static void test_twins(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT(twins); i++) {
        MeshBuilder awkward, plain;
        read_valid(twins[i].awkward, &awkward);
        read_valid(twins[i].plain, &plain);
        bool is_same = is_same_mesh(&awkward, &plain);
        if (!is_same || awkward.repairs.skipped_statements != twins[i].skipped ||
            awkward.repairs.skipped_line != twins[i].line) {
            fail_msg("%s\n%s, %zu left out, the first in line %zu", twins[i].awkward,
                     is_same ? "same mesh" : "another mesh", awkward.repairs.skipped_statements,
                     awkward.repairs.skipped_line);
        }
        assert_true(plain.count > 0 && plain.repairs.skipped_statements == 0);
        mesh_builder_deinit(&awkward);
        mesh_builder_deinit(&plain);
    }
}

/** A normal or (u, v) that is not understood is missing, and keeps its number. */
static void test_missing(void **state) {
    (void)state;
    MeshBuilder builder;
    Mesh counts;
    read_valid(THREE "vn nan nan nan\nvn 0 0 1\nvt x\nvt 1 1\nf 1/1/1 2/2/2 3/2/2\n", &builder);
    assert_true(mesh_builder_finish(&builder, &counts));
    assert_int_equal(counts.repairs.missing_normals, 1);
    assert_int_equal(counts.repairs.missing_uvs, 1);
    assert_int_equal(counts.repairs.skipped_statements, 2);
    assert_int_equal(counts.repairs.skipped_line, 4);
    assert_true(builder.normals.points[2] == 1 && builder.uvs.points[0] == 1);
    mesh_builder_deinit(&builder);
}

// --- numbers -------------------------------------------------------------------------------------

/** Asserts that a number is read as strtod reads it, to the bit. */
static void assert_number(const char *word) {
    ObjText text = obj_text_start(word, strlen(word));
    double number = -1, wanted = strtod(word, NULL);
    if (!obj_text_number(&text, &number) || text.next != text.end ||
        memcmp(&number, &wanted, sizeof number) != 0) {
        fail_msg("%s is read as %.17g instead of %.17g", word, number, wanted);
    }
}

/** Numbers are the nearest doubles, however they are written. */
static void test_numbers(void **state) {
    (void)state;
    static const char *const awkward[] = {"0",
                                          "-0",
                                          ".5",
                                          "5.",
                                          "+1",
                                          "1e5",
                                          "1E-5",
                                          "1e+05",
                                          "0.1",
                                          "123456.789",
                                          "9007199254740993",
                                          "999999999999999",
                                          "0.000000000000000000000001",
                                          "1e22",
                                          "1e23",
                                          "1e-22",
                                          "1e-23",
                                          "1e308",
                                          "1e309",
                                          "-1e400",
                                          "1e-324",
                                          "4.9e-324",
                                          "2.2250738585072011e-308",
                                          "1e-99999999",
                                          "1e99999999999999999999",
                                          "18446744073709551616",
                                          "99999999999999999999999999",
                                          "0.30000000000000004",
                                          "1.00000000000000011102230246251565404236316680908203125",
                                          "0000000000000000000000000000001.5",
                                          "0.00000000000000000000000000000000000000015e40"};
    static const char *const formats[] = {"%.6f", "%.17g", "%.3e", "%.9g", "%g", "%.25f"};
    for (size_t i = 0; i < COUNT(awkward); i++) {
        assert_number(awkward[i]);
    }
    uint64_t seed = 1;
    for (int i = 0; i < 60000; i++) {
        char word[400];
        double size = pow(10, 40 * random_unit_double(&seed) - 20);
        snprintf(word, sizeof word, formats[i % (int)COUNT(formats)],
                 (2 * random_unit_double(&seed) - 1) * size);
        assert_number(word);
    }
}

/** Words that are no numbers are none, and the position stays. */
static void test_no_numbers(void **state) {
    (void)state;
    static const char *const words[] = {"",    ".",     "+",   "-.",     "e5",  "1e",
                                        "1e+", "1.2.3", "1,5", "0x10",   "nan", "inf",
                                        "1f",  "--1",   "1-",  "3.1+e2", "\\1"};
    for (size_t i = 0; i < COUNT(words); i++) {
        ObjText text = obj_text_start(words[i], strlen(words[i]));
        double number;
        if (obj_text_number(&text, &number) || text.next != words[i]) {
            fail_msg("%s is read as a number", words[i]);
        }
    }
    char *digits = calloc(100000, 1);
    memset(digits, '7', 99999);
    ObjText text = obj_text_start(digits, 99999);
    double number;
    assert_false(obj_text_number(&text, &number));
    free(digits);
}

/** Positions are doubles: a triangle of a tenth of a millimetre lies 123 kilometres away. */
static void test_precision(void **state) {
    (void)state;
    MeshBuilder builder;
    read_valid("v 123456.789 0 0\nv 123456.7891 0 0\nv 123456.789 0.0001 0\nf 1 2 3\n", &builder);
    assert_int_equal(builder.count, 1);
    assert_true(builder.positions.points[0] == 123456.789 &&
                builder.positions.points[3] == 123456.7891);
    mesh_builder_deinit(&builder);
}

/** A triangle whose corners are on a straight line in decimal has no area, a thin one has. */
static void test_straight(void **state) {
    (void)state;
    uint64_t seed = 3;
    for (int i = 0; i < 20000; i++) {
        char text[512];
        // Points a + t b of integers, written with six decimals: exactly on a line.
        long a[3], b[3];
        int length = 0, times[] = {0, 3, 7};
        for (int k = 0; k < 3; k++) {
            a[k] = (long)(2e9 * (random_unit_double(&seed) - 0.5));
            b[k] = (long)(2e6 * (random_unit_double(&seed) - 0.5));
        }
        for (int k = 0; k < 3; k++) {
            length +=
                snprintf(text + length, sizeof text - (size_t)length, "v %lde-6 %lde-6 %lde-6\n",
                         a[0] + times[k] * b[0], a[1] + times[k] * b[1], a[2] + times[k] * b[2]);
        }
        snprintf(text + length, sizeof text - (size_t)length, "f 1 2 3\n");
        MeshBuilder builder;
        read_valid(text, &builder);
        if (builder.count != 0 || builder.repairs.degenerate_triangles != 1) {
            fail_msg("%s has an area", text);
        }
        mesh_builder_deinit(&builder);
    }
    static const char *const thin[] = {"v 0 0 0\nv 1 0 0\nv 0.5 1e-30 0\nf 1 2 3\n",
                                       "v 1e6 0 0\nv 1e6 1 0\nv 1000000.00000001 0.5 0\nf 1 2 3\n"};
    for (size_t i = 0; i < COUNT(thin); i++) {
        MeshBuilder builder;
        read_valid(thin[i], &builder);
        assert_int_equal(builder.count, 1);
        mesh_builder_deinit(&builder);
    }
}

// --- polygons ------------------------------------------------------------------------------------

/** Every triangle of a face is made, left out or said to be missing. */
static void test_polygons(void **state) {
    (void)state;
    static const struct {
        const char *text;  /**< A text with a face. */
        size_t triangles;  /**< Triangles. */
        size_t degenerate; /**< Triangles without area. */
        bool is_missing;   /**< Whether triangles are missing. */
    } polygons[] = {
        {THREE "f 1 2 3 3\n", 1, 1, false},
        {THREE "v 2 0 0\nf 1 2 4 2\n", 0, 2, false},
        {"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n", 3, 0, false},
        // A quadrilateral whose edges cross along every axis and along its normal: two of Spot's.
        {"v .2102 .7582 -.246\nv .1695 .7964 -.3702\nv .1705 .7938 -.3661\nv .2112 .7654 -.2395\n"
         "f 1 2 3 4\n",
         2, 0, false},
        // A pentagram cannot be cut.
        {"v 0 1 0\nv 3 0 0\nv 0 0 0\nv 1 2 0\nv 1 3 0\nf 1 2 3 4 5\n", 0, 0, true},
    };
    for (size_t i = 0; i < COUNT(polygons); i++) {
        MeshBuilder builder;
        read_valid(polygons[i].text, &builder);
        const MeshRepairs *repairs = &builder.repairs;
        bool is_missing = repairs->untriangulated_polygons > 0;
        bool is_right = is_missing == polygons[i].is_missing &&
                        (is_missing || (builder.count == polygons[i].triangles &&
                                        repairs->degenerate_triangles == polygons[i].degenerate));
        if (!is_right) {
            fail_msg("%s: %zu triangles, %zu without area, %zu missing", polygons[i].text,
                     builder.count, repairs->degenerate_triangles,
                     repairs->untriangulated_polygons);
        }
        mesh_builder_deinit(&builder);
    }
}

// --- refused texts -------------------------------------------------------------------------------

/** Invalid texts are refused with the line and a reason. */
static void test_refused(void **state) {
    (void)state;
    static const struct {
        const char *text;  /**< A text. */
        size_t line;       /**< Line of the error. */
        const char *words; /**< Part of the message. */
    } refused[] = {
        {THREE "f 1 2 4\n", 4, "vertex 4, but there are 3"},
        {THREE "\r\n\n\rf 1 2 0\n", 7, "vertex 0,"},
        {THREE "f 1 2 \\\n -4\nv 0 0 1\n", 4, "vertex -4, but there are 3"},
        {THREE "f 1 2 99999999999999999999\n", 4, "vertex 99999999999999999999,"},
        {THREE "f 1 2 -9223372036854775808\n", 4, "vertex -9223372036854775808,"},
        {THREE "f 1 2 18446744073709551617\n", 4, "vertex 18446744073709551617,"},
        {THREE "vt 0 0\nf 1/1 2/2 3/1\n", 5, "(u, v) 2, but there are 1"},
        {THREE "vn 0 0 1\nf 1//1 2//-2 3//1\n", 5, "normal -2, but there are 1"},
        {"f -3 -2 -1\n" THREE, 1, "vertex -3, but there are 0"},
        {THREE "f 1 2 x\n", 4, "`x` is no corner"},
        {THREE "f 1 2 3x\n", 4, "`3x` is no corner"},
        {THREE "f 1 2 3/1/1/1\n", 4, "`3/1/1/1` is no corner"},
        {THREE "f 1.0 2.0 3.0\n", 4, "`1.0` is no corner"},
        {THREE "f 1,2,3\n", 4, "`1,2,3` is no corner"},
        {THREE "f / / /\n", 4, "`/` is no corner"},
        {THREE "f 1 2 /3\n", 4, "`/3` is no corner"},
        {"\n" THREE "v 1 2\nf 1 2 4\n", 5, "three numbers, finite"},
        {"v nan 0 0\n" THREE "f 1 2 3\n", 1, "three numbers, finite"},
        {"v 0 0 \\\n inf\n" THREE "f 1 2 3\n", 1, "three numbers, finite"},
        {"v 1e16 0 0\n" THREE "f 1 2 3\n", 1, "at most 1e+15"},
        {"\xFE\xFF\0v", 0, "UTF-16"},
        {"\xFF\xFEv", 0, "UTF-16"},
    };
    for (size_t i = 0; i < COUNT(refused); i++) {
        MeshBuilder builder;
        Error error = {0};
        bool is_read = read_bytes(refused[i].text, strlen(refused[i].text), &builder, &error);
        if (is_read || error.status != STATUS_SCENE || error.line != refused[i].line ||
            !strstr(error.message, refused[i].words)) {
            fail_msg("%s\nline %zu: %s; wanted: line %zu: %s", refused[i].text, error.line,
                     error.message, refused[i].line, refused[i].words);
        }
        mesh_builder_deinit(&builder);
    }
}

// --- any bytes -----------------------------------------------------------------------------------

/** A text with every kind of statement. */
static const char everything[] =
    "# all\r\nmtllib a\no b\n" THREE
    " v 0.5 -.5e-1 1 1\nvt 0 1\nvt .5\nvn 0 0 1\nf 1/1/1 2/2/1 \\\n"
    "3/1/1\nf -4//-1 -3//1 -1\nf 1 2 3 4 # quad\ncstype b\ns 1\nl 1 2\nf 4/2 3/1 2/1";

/** Reads bytes: whatever they are, the reader stays within them and ends. */
static void read_anything(const char *bytes, size_t size) {
    MeshBuilder builder;
    Error error = {0};
    bool is_read = read_bytes(bytes, size, &builder, &error);
    assert_int_equal(is_read, error.status == STATUS_OK);
    mesh_builder_deinit(&builder);
}

/** A text that is cut anywhere, or has any byte changed, is read or refused. */
static void test_changed_bytes(void **state) {
    (void)state;
    static const char bytes[] = {'\0', '\n', '\r', ' ', '\\', '#', '/',
                                 '-',  '9',  '.',  'e', 'f',  'v', (char)0xFF};
    char text[sizeof everything];
    for (size_t size = 0; size < sizeof everything; size++) {
        read_anything(everything, size);
    }
    for (size_t i = 0; i + 1 < sizeof everything; i++) {
        for (size_t k = 0; k < COUNT(bytes); k++) {
            memcpy(text, everything, sizeof everything);
            text[i] = bytes[k];
            read_anything(text, sizeof everything - 1);
        }
    }
}

/** Counts triangles, and stops. See #MeshSink.add_triangle. */
static bool stop_at_second(void *context, const MeshCorner corners[3]) {
    (void)corners;
    return ++*(int *)context < 2;
}

/** A sink can stop the reader. */
static void test_stop(void **state) {
    (void)state;
    static const char text[] = THREE "f 1 2 3\nf 3 2 1\nf 2 1 3\n";
    int count = 0;
    MeshRepairs repairs = {0};
    Error error = {0};
    const MeshSink sink = {&count, stop_at_second, ignore_progress};
    assert_false(obj_read(text, sizeof text - 1, &sink, &repairs, &error));
    assert_int_equal(count, 2);
    assert_int_equal(error.status, STATUS_OK);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_twins),         cmocka_unit_test(test_missing),
        cmocka_unit_test(test_numbers),       cmocka_unit_test(test_no_numbers),
        cmocka_unit_test(test_precision),     cmocka_unit_test(test_straight),
        cmocka_unit_test(test_polygons),      cmocka_unit_test(test_refused),
        cmocka_unit_test(test_changed_bytes), cmocka_unit_test(test_stop),
    };
    return cmocka_run_group_tests_name("obj reader", tests, NULL, NULL);
}
