/**
 * @file
 * @brief Configuration of cairo and pixman for the page.
 */
#include "cairo-features.h"
#define HAVE_STDINT_H 1
#define HAVE_INTTYPES_H 1
#define HAVE_SYS_TYPES_H 1
#define HAVE_UINT64_T 1
#define HAVE_PTHREAD_H 1
#define CAIRO_HAS_PTHREAD 1
#define CAIRO_HAS_REAL_PTHREAD 1
#define HAVE_UNISTD_H 1
#define HAVE_LOCALE_H 1
#define HAVE_FCNTL_H 1
#define HAVE_SYS_STAT_H 1
#define HAVE_STRNDUP 1
#define HAVE_CTIME_R 1
#define HAVE_GMTIME_R 1
#define HAVE_LOCALTIME_R 1
#define HAVE_CXX11_ATOMIC_PRIMITIVES 1
#define SIZEOF_INT 4
#define SIZEOF_LONG 4
#define SIZEOF_LONG_LONG 8
#define SIZEOF_VOID_P 4
#define SIZEOF_SIZE_T 4
#define CAIRO_NO_MUTEX 0
#undef CAIRO_NO_MUTEX
#define PACKAGE "pixman"
#define PACKAGE_VERSION "0.42.2"
#define PACKAGE_NAME "pixman"
#define PACKAGE_BUGREPORT ""
#define TLS __thread
#define HAVE_PTHREADS 1
#define HAVE_GCC_VECTOR_EXTENSIONS 1
#define HAVE_BUILTIN_CLZ 1
#define HAVE_FENV_H 1
