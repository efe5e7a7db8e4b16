/**
 * @file
 * @brief Tests of the file of answers: its lines, and that a file which others have cut, locked or
 * filled up loses nothing.
 */
#include "fixtures.h"

#include "base/clock.h"
#include "view/lesson/answer_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/resource.h>

/** Names of the columns. */
#define HEADER "time,lesson,question,choice,right\n"

/** The file of a test. */
static const char *path;
/** Text of the file, as read last. */
static char text[4096];

/** Writes a text into the file. */
static void write_text(const char *content) {
    write_file(path, content, strlen(content));
}

/** Creates a folder with an empty file. @return 0 if it could. */
static int set_up(void **state) {
    int failed = fixture_set_up(state);
    path = fixture_path(state, "answers.csv");
    write_text("");
    return failed;
}

/** @return The file's text. */
static const char *read_text(void) {
    FILE *file = fopen(path, "re");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    return text;
}

/** Appends the second choice, which is right, of question 3. @return As answer_file_append(). */
static bool answer(const char *to, const char *lesson, Error *error) {
    const AnswerRecord record = {.lesson = lesson, .question = 3, .answer = 2, .is_right = true};
    return answer_file_append(to, &record, error);
}

/** The first line has the names; each answer has its time, the lesson in quotes, and numbers. */
static void test_lines(void **state) {
    (void)state;
    Error error = {0};
    int year, offset;
    assert_true(answer_file_prepare(path, &error));
    assert_string_equal(read_text(), HEADER);
    assert_true(answer_file_prepare(path, &error));
    assert_true(answer(path, "light", &error));
    const char *line = read_text() + strlen(HEADER);
    assert_int_equal(sscanf(line, "%4d-%*2d-%*2dT%*2d:%*2d:%*2d%5d", &year, &offset), 2);
    assert_in_range(year, 2020, 9999);
    assert_string_equal(strchr(line, ','), ",\"light\",3,2,1\n");
    assert_memory_equal(text, HEADER, strlen(HEADER));
    const AnswerRecord wrong = {.lesson = "light", .question = 2, .answer = 3};
    assert_true(answer_file_append(path, &wrong, &error));
    line = strrchr(read_text(), 'T');
    assert_string_equal(strchr(line, ','), ",\"light\",2,3,0\n");
}

/** A name stays one field, and no formula. */
static void test_names(void **state) {
    (void)state;
    static const struct {
        const char *name;  /**< Of the lesson. */
        const char *field; /**< In the file. */
    } names[] = {{"a,b", ",\"a,b\",3"},
                 {"say \"x\"", ",\"say \"\"x\"\"\",3"},
                 {"=HYPERLINK(1)", ",\"'=HYPERLINK(1)\",3"},
                 {"@x", ",\"'@x\",3"},
                 {"two\nlines", "two lines"},
                 {"", ",\"\",3"}};
    for (size_t i = 0; i < COUNT(names); i++) {
        Error error = {0};
        write_text("");
        assert_true(answer(path, names[i].name, &error));
        assert_non_null(strstr(read_text(), names[i].field));
    }
    // As long as a file's name can be, and longer.
    char name[1000];
    memset(name, '"', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    write_text("");
    Error error = {0};
    assert_true(answer(path, name, &error));
    size_t length = strlen(read_text());
    assert_string_equal(text + length - strlen("\",3,2,1\n"), "\",3,2,1\n");
    size_t quotes = strspn(strchr(text + strlen(HEADER), '"'), "\"");
    assert_true(quotes > 500 && quotes % 2 == 0);
}

/** A file that ends within a line goes on in a new one. */
static void test_cut_file(void **state) {
    (void)state;
    Error error = {0};
    write_text(HEADER "2026-01-01T08:00:00+0100,\"li");
    assert_true(answer_file_prepare(path, &error));
    assert_true(answer(path, "light", &error));
    assert_true(answer(path, "glass", &error));
    assert_memory_equal(read_text(), HEADER "2026-01-01T08:00:00+0100,\"li\n2",
                        strlen(HEADER "2026-01-01T08:00:00+0100,\"li\n2"));
    const char *light = strstr(text, "\"light\",3,2,1\n");
    assert_non_null(light);
    assert_non_null(strstr(light, "\"glass\",3,2,1\n"));
    assert_null(strstr(text, "\n\n"));
}

/** A lock of another program is waited for, and not for long. */
static void test_lock(void **state) {
    (void)state;
    Error error = {0};
    int other = open(path, O_RDWR | O_CLOEXEC);
    assert_true(other >= 0);
    assert_int_equal(flock(other, LOCK_EX), 0);
    double start = clock_now_seconds();
    alarm(60); // Ends a test that waits for ever.
    assert_false(answer(path, "light", &error));
    alarm(0);
    assert_true(clock_now_seconds() - start > 0.3);
    assert_int_equal(error.status, STATUS_FAILED);
    assert_non_null(strstr(error.message, path));
    assert_non_null(strstr(error.message, "another program has locked it"));
    assert_string_equal(read_text(), "");
    // One that is held for a moment only costs that moment.
    pid_t holder = fork();
    if (holder == 0) {
        usleep(50000);
        flock(other, LOCK_UN);
        _exit(0);
    }
    assert_true(answer(path, "light", &error));
    close(other);
}

/** Where the disk is full, no half line stays. */
static void test_full_disk(void **state) {
    (void)state;
    Error error = {0};
    struct rlimit before;
    write_text(HEADER "first\n");
    getrlimit(RLIMIT_FSIZE, &before);
    const struct rlimit limit = {strlen(HEADER "first\n") + 10, before.rlim_max};
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
    bool is_written = answer(path, "light", &error);
    setrlimit(RLIMIT_FSIZE, &before);
    assert_false(is_written);
    assert_string_equal(read_text(), HEADER "first\n");
    assert_false(answer("/dev/full", "light", &error));
    assert_non_null(strstr(error.message, "No space left on device"));
    assert_false(answer_file_prepare("/tmp", &error));
    assert_non_null(strstr(error.message, "Is a directory"));
    assert_true(error.status == STATUS_FAILED && strstr(error.message, "cannot write '/tmp': "));
    assert_false(answer_file_prepare("/none/answers.csv", &error));
    assert_non_null(strstr(error.message, "No such file"));
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_lines, set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_names, set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_cut_file, set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_lock, set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_full_disk, set_up, fixture_tear_down),
    };
    return cmocka_run_group_tests_name("file of answers", tests, NULL, NULL);
}
