/**
 * @file
 * @brief Leaks that are not ours, for the leak sanitizer. Included by one file of a program.
 */
#ifndef DIOPTRE_TESTS_FONTCONFIG_LEAK_H
#define DIOPTRE_TESTS_FONTCONFIG_LEAK_H

#ifdef __SANITIZE_ADDRESS__
/** libfontconfig's cache hides its pointers (tests/screen.sh). See the leak sanitizer. @return Its
 *  leaks. */
const char *__lsan_default_suppressions(void);

const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}
#endif

#endif
