/**
 * @file
 * @brief What the page's C library (musl) does not declare of GNU's; included before every file.
 *
 * The functions are in libc/system.c.
 */
#ifndef DIOPTRE_WEB_LIBC_GNU_H
#define DIOPTRE_WEB_LIBC_GNU_H

#ifndef __cplusplus
/** Flag of #renameat2: an existing file is not replaced. */
#define RENAME_NOREPLACE 1u

/** Renames a file, as of Linux. @return 0, or -1 with errno set. */
int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags);

/** Number of the call of Linux that opens a file beneath a folder. */
#define SYS_openat2 437

/** Calls the system by number: #SYS_openat2 alone. @return -1 with errno set to ENOSYS for others.
 */
long syscall(long number, ...);
#endif

#endif
