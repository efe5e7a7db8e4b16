/**
 * @file
 * @brief A stand-in for the mesh module (-DMESHES) or the picture module of a worker that a file
 * has got hold of. The environment variable HOSTILE says what it does; see #deeds.
 */
#include "assets/images/image_plugin.h"
#include "assets/meshes/mesh_plugin.h"
#include "assets/meshes/mesh_worker.h"
#include "assets/process/worker_protocol.h"

#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

/** A memory mapping that can be written. */
typedef struct Mapping {
    char *low;  /**< Its first byte. */
    char *high; /**< The byte after its last. */
} Mapping;

/** Largest number of mappings that are noted. */
enum { MAPPINGS_MAXIMUM = 1024 };
/** Mappings above this size are scribbled on at their start only, bytes. */
static const long SCRIBBLE_MAXIMUM = 64L << 20;

/** The mappings, noted while files may still be opened. */
static Mapping mappings[MAPPINGS_MAXIMUM];
/** Number of #mappings. */
static int mapping_count;

/** Notes all mappings of the process, when the module is loaded. */
__attribute__((constructor)) static void note_mappings(void) {
    char line[1024], rights[8];
    FILE *maps = fopen("/proc/self/maps", "re");
    while (maps && mapping_count < MAPPINGS_MAXIMUM && fgets(line, sizeof line, maps)) {
        void *low, *high;
        if (sscanf(line, "%p-%p %7s", &low, &high, rights) == 3 && rights[1] == 'w') {
            mappings[mapping_count++] = (Mapping){low, high};
        }
    }
    if (maps) {
        fclose(maps);
    }
}

/** Writes over a mapping. */
static void scribble_on(const Mapping *mapping, int byte) {
    long size = mapping->high - mapping->low;
    memset(mapping->low, byte, (size_t)(size < SCRIBBLE_MAXIMUM ? size : SCRIBBLE_MAXIMUM));
}

/** Writes over all mappings, its own stack and data last. */
static void scribble(int byte) {
    for (int i = 0; i < mapping_count; i++) {
        bool is_own = (mappings[i].low <= (char *)&i && (char *)&i < mappings[i].high) ||
                      (mappings[i].low <= (char *)mappings && (char *)mappings < mappings[i].high);
        if (!is_own) {
            scribble_on(&mappings[i], byte);
        }
    }
    for (int i = 0; i < mapping_count; i++) {
        scribble_on(&mappings[i], byte);
    }
}

/**
 * Sends a result in place of the worker: report and block of one byte value. The reports of both
 * modules have the same size: a flag and an error.
 */
static void answer(int byte, size_t report_size, size_t block_size) {
    static char bytes[1 << 16];
    const WorkerFrame frame = {
        .kind = WORKER_FRAME_RESULT, .report_size = report_size, .block_size = block_size};
    memset(bytes, byte, sizeof bytes);
    send(WORKER_SOCKET, &frame, sizeof frame, 0);
    send(WORKER_SOCKET, bytes, report_size, 0);
    for (size_t sent = 0; sent < block_size; sent += sizeof bytes) {
        size_t left = block_size - sent;
        send(WORKER_SOCKET, bytes, left < sizeof bytes ? left : sizeof bytes, 0);
    }
    pause();
}

/** Opens a file that was not sent along. @return Whether it could. */
static bool open_other_file(void) {
    return open(getenv("SECRET"), O_RDONLY) >= 0;
}

/** Writes a new file. @return Whether it could. */
static bool create_file(void) {
    return open(getenv("OWNED"), O_CREAT | O_WRONLY, 0600) >= 0;
}

/** Connects to a port of this machine. @return Whether it could. */
static bool connect_somewhere(void) {
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons(9)};
    int connection = socket(AF_INET, SOCK_STREAM, 0);
    return connect(connection, (struct sockaddr *)&address, sizeof address) == 0;
}

/** Runs a program. @return false: it failed. */
static bool run_program(void) {
    char name[] = "/usr/bin/touch", *words[] = {name, getenv("OWNED"), NULL};
    return execv(name, words) == 0;
}

/** Runs a program in a process of its own. @return Whether it could. */
static bool run_shell(void) {
    char command[512];
    snprintf(command, sizeof command, "touch %s", getenv("OWNED"));
    return system(command) == 0;
}

/** Ends the program that started the worker. @return Whether it could. */
static bool kill_parent(void) {
    return kill(getppid(), SIGKILL) == 0;
}

/** Takes memory until there is none. @return false: there is none. */
static bool take_memory(void) {
    for (;;) {
        char *bytes = malloc(64 << 20);
        if (!bytes) {
            return false;
        }
        memset(bytes, 1, 64 << 20);
    }
}

/** Writes over everything. @return Nothing: it does not return. */
static bool scribble_ones(void) {
    scribble(0xFF);
    return true;
}

/** Writes over everything. @return Nothing: it does not return. */
static bool scribble_zeros(void) {
    scribble(0);
    return true;
}

/** Sends a result of ones: flags that are no bools, texts without an end, huge counts. */
static bool answer_ones(void) {
    answer(0xFF, sizeof(MeshWorkerReport), 4096);
    return true;
}

/** Sends a result of small numbers. */
static bool answer_twos(void) {
    answer(2, sizeof(MeshWorkerReport), 1 << 20);
    return true;
}

/** Sends a report larger than any. */
static bool answer_much(void) {
    answer(1, 1 << 20, 0);
    return true;
}

/** Something that a hostile file makes the worker do. */
typedef struct Deed {
    const char *name;     /**< Value of HOSTILE. */
    bool (*commit)(void); /**< Does it. @return Whether it worked. */
} Deed;

/** All deeds. */
static const Deed deeds[] = {
    {"open", open_other_file},    {"create", create_file},      {"connect", connect_somewhere},
    {"exec", run_program},        {"shell", run_shell},         {"kill", kill_parent},
    {"memory", take_memory},      {"ones", scribble_ones},      {"zeros", scribble_zeros},
    {"answer-ones", answer_ones}, {"answer-twos", answer_twos}, {"answer-much", answer_much}};

/** Does what HOSTILE says, and says how it went. */
static void commit(char *message, size_t size) {
    const char *name = getenv("HOSTILE");
    snprintf(message, size, "nothing was tried");
    for (size_t i = 0; name && i < sizeof deeds / sizeof *deeds; i++) {
        if (strcmp(name, deeds[i].name) == 0) {
            errno = 0;
            bool is_done = deeds[i].commit();
            snprintf(message, size, "%s: %s", is_done ? "DONE" : "refused", strerror(errno));
        }
    }
}

#ifdef MESHES

/** Reads no mesh. See #MeshPlugin.read. @return false */
static bool hostile_read(const MeshSource *source, const MeshSink *sink, MeshImportResult *result) {
    (void)source;
    (void)sink;
    commit(result->message, sizeof result->message);
    return false;
}

/** The module. */
__attribute__((visibility("default")))
const MeshPlugin dioptre_mesh_plugin = {.version = MESH_PLUGIN_VERSION, .read = hostile_read};

#else

/** Opens no picture. See #ImagePlugin.open. @return NULL */
static ImageReader *hostile_open(int file, const char *format, ImageHeader *header,
                                 ImagePluginMessage *message) {
    (void)file;
    (void)format;
    (void)header;
    commit(message->text, sizeof message->text);
    return NULL;
}

/** The module. */
__attribute__((visibility("default")))
const ImagePlugin dioptre_image_plugin = {.version = IMAGE_PLUGIN_VERSION, .open = hostile_open};

#endif
