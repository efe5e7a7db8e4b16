/**
 * @file
 * @brief The descriptors of standard input, output and error.
 */
#ifndef DIOPTRE_BASE_STANDARD_STREAMS_H
#define DIOPTRE_BASE_STANDARD_STREAMS_H

/**
 * Opens `/dev/null` in place of each of the descriptors 0, 1 and 2 that is closed. Otherwise the
 * next file gets its number: a message would be written into a picture. To be called first in main.
 */
void standard_streams_open(void);

#endif
