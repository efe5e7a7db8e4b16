/**
 * @file
 * @brief Renders a picture with a fragment shader and measures its time, to compare sphere tracing
 *        in OpenGL.
 *
 * Usage: `peer-fragment WIDTH HEIGHT FRAMES PICTURE.bmp SHADER.frag...`; the parts of the shader
 * are concatenated. Prints the median milliseconds per frame, then the OpenGL renderer. Needs a
 * display; `LIBGL_ALWAYS_SOFTWARE=1` and `LP_NUM_THREADS` make Mesa render on the CPU.
 */
#define GL_GLEXT_PROTOTYPES
#include <SDL.h>
#include <SDL_opengl.h>
#include <stdbool.h>
#include <stdlib.h>
#include <time.h>

/** Largest number of parts of a shader, with its first line. */
enum { PARTS_MAXIMUM = 8 };
/** Bytes per pixel. */
enum { CHANNELS = 3 };

/**
 * A vertex shader of one triangle that covers the picture; positions follow from the vertex index.
 */
static const char *const vertex_shader =
    "#version 330 core\n"
    "void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); "
    "}\n";

/** Prints an error and ends the program. */
static _Noreturn void exit_with_error(const char *what, const char *why) {
    fprintf(stderr, "fragment: %s: %s\n", what, why);
    exit(1);
}

/** Ends the program if a call of SDL failed. @param is_good Whether it succeeded. */
static void check_sdl(bool is_good) {
    if (!is_good) {
        exit_with_error("SDL", SDL_GetError());
    }
}

/** Adds a shader to a program; ends on failure. @param count Parts of its text. */
static void add_shader(GLuint program, GLenum kind, int count, const char *const *parts) {
    char log[4096];
    GLint is_good = 0;
    GLuint shader = glCreateShader(kind);
    glShaderSource(shader, count, parts, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_good);
    if (!is_good) {
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        exit_with_error("shader", log);
    }
    glAttachShader(program, shader);
    glDeleteShader(shader);
}

/**
 * Links a shader program and uses it.
 * @param files  Files of the fragment shader.
 * @return The program.
 */
static GLuint use_program(int count, char **files) {
    const char *parts[PARTS_MAXIMUM] = {"#version 330 core\n"};
    GLuint program = glCreateProgram();
    for (int i = 0; i < count && i + 1 < PARTS_MAXIMUM; i++) {
        parts[i + 1] = SDL_LoadFile(files[i], NULL);
        check_sdl(parts[i + 1] != NULL);
    }
    add_shader(program, GL_VERTEX_SHADER, 1, &vertex_shader);
    add_shader(program, GL_FRAGMENT_SHADER, count + 1, parts);
    for (int i = 0; i < count; i++) {
        SDL_free((void *)(uintptr_t)parts[i + 1]);
    }
    glLinkProgram(program);
    glUseProgram(program);
    return program;
}

/** Creates a framebuffer of 8-bit colours and binds it. */
static void use_buffer(int width, int height) {
    GLuint frame = 0, colors = 0, corners = 0;
    glGenVertexArrays(1, &corners);
    glBindVertexArray(corners);
    glGenRenderbuffers(1, &colors);
    glBindRenderbuffer(GL_RENDERBUFFER, colors);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colors);
    glViewport(0, 0, width, height);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        exit_with_error("OpenGL", "no buffer to draw into");
    }
}

/** @return Time of one frame, milliseconds. */
static double time_frame(void) {
    struct timespec start, end;
    clock_gettime(CLOCK_MONOTONIC, &start);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
    clock_gettime(CLOCK_MONOTONIC, &end);
    return 1e3 * (double)(end.tv_sec - start.tv_sec) + 1e-6 * (double)(end.tv_nsec - start.tv_nsec);
}

/** @return The order of two numbers, for qsort(). */
static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/**
 * @return Median time of frames, milliseconds. The first frame compiles the shader and is not
 *         counted.
 */
static double time_frames(int count) {
    double *times = calloc((size_t)count, sizeof *times);
    if (!times) {
        exit_with_error("times", "no memory");
    }
    time_frame();
    for (int i = 0; i < count; i++) {
        times[i] = time_frame();
    }
    qsort(times, (size_t)count, sizeof *times, compare_numbers);
    double median = times[count / 2];
    free(times);
    return median;
}

/** Saves the rendered picture. */
static void save_picture(const char *path, int width, int height) {
    void *pixels = malloc((size_t)width * (size_t)height * CHANNELS);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    if (pixels) {
        glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    }
    SDL_Surface *surface = SDL_CreateRGBSurfaceWithFormatFrom(
        pixels, width, height, 8 * CHANNELS, width * CHANNELS, SDL_PIXELFORMAT_RGB24);
    check_sdl(pixels && surface && SDL_SaveBMP(surface, path) == 0);
    SDL_FreeSurface(surface);
    free(pixels);
}

/** Times a shader. @return 0; on errors the program exits with 1. */
int main(int count, char **arguments) {
    int width = count > 5 ? atoi(arguments[1]) : 0, height = count > 5 ? atoi(arguments[2]) : 0;
    int frames = count > 5 ? atoi(arguments[3]) : 0;
    if (width < 1 || height < 1 || frames < 1) {
        exit_with_error("usage", "peer-fragment WIDTH HEIGHT FRAMES PICTURE.bmp SHADER.frag...");
    }
    check_sdl(SDL_Init(SDL_INIT_VIDEO) == 0);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_Window *window =
        SDL_CreateWindow("fragment", 0, 0, 64, 64, SDL_WINDOW_OPENGL | SDL_WINDOW_HIDDEN);
    SDL_GLContext context = window ? SDL_GL_CreateContext(window) : NULL;
    check_sdl(context != NULL);
    GLuint program = use_program(count - 5, arguments + 5);
    use_buffer(width, height);
    glUniform2f(glGetUniformLocation(program, "size"), (float)width, (float)height);
    printf("%.3f %s\n", time_frames(frames), (const char *)glGetString(GL_RENDERER));
    save_picture(arguments[4], width, height);
    SDL_GL_DeleteContext(context);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return 0;
}
