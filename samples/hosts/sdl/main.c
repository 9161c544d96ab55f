/* A host of SDL2 in plain C99: a window, or without a display a script that writes images.
 *     host_sdl LEVEL [--script FOLDER] [--steps N] [--size WIDTHxHEIGHT]
 * W A S D and the mouse walk and look, a click makes a hole, E an explosion, space jumps, R begins again. */
#include <GL/gl.h>
#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "samples/hosts/support/gl_state.h"
#include "samples/hosts/support/options.h"
#include "samples/hosts/support/own_meshes.h"
#include "samples/hosts/support/report.h"
#include "samples/hosts/support/yard.h"

struct options {
    const char *level, *folder; /* folder: for the images of a script; null: a window */
    uint64_t steps;             /* of the script */
    unsigned width, height;
};

/* One before the wall, one that reaches through it. */
static const float kPyramids[2][3] = {{0.2f, 0.3f, 0.6f}, {1.75f, 0.2f, -1.0f}};
static SDL_Window* window;
static struct yard yard;
static rubble_renderer renderer;

static void fail(const char* what) {
    fprintf(stderr, "host_sdl: %s: %s\n", what, SDL_GetError());
    exit(1);
}

static const char usage[] = "usage: host_sdl LEVEL [--script FOLDER] [--steps N] [--size WIDTHxHEIGHT]\n";

static void refuse(const char* expected, const char* found) {
    fprintf(stderr, "host_sdl: expected %s, found \"%s\"\n%s", expected, found, usage);
    exit(2);
}

static struct options read_options(int argc, char** argv) {
    struct options options = {.steps = SCRIPT_CYCLE, .width = 960, .height = 540};
    int i;
    for (i = 1; i < argc; ++i) {
        const char* const value = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(argv[i], "--help") == 0) {
            fputs(usage, stdout);
            exit(0);
        }
        if (argv[i][0] != '-') {
            if (options.level) refuse("one level", argv[i]);
            options.level = argv[i];
            continue;
        }
        if (strcmp(argv[i], "--script") == 0) {
            options.folder = value;
            if (!is_path(value)) refuse("a folder for the script's images", value);
        } else if (strcmp(argv[i], "--steps") == 0) {
            if (!read_steps(value, &options.steps)) refuse("a number of steps above 0", value);
        } else if (strcmp(argv[i], "--size") == 0) {
            if (!read_size(value, &options.width, &options.height)) refuse("a size in pixels", value);
        } else {
            refuse("an option", argv[i]);
        }
        ++i;
    }
    if (!options.level) refuse("a level", "none");
    return options;
}

static void open_window(const struct options* options) {
    const char* const wanted = SDL_getenv("SDL_VIDEODRIVER");
    if (options->folder) {
        SDL_setenv("SDL_VIDEODRIVER", "offscreen", 0);
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1"); /* a script reads no events: signals end it */
    }
    if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no video");
    if (!options->folder && !wanted && strcmp(SDL_GetCurrentVideoDriver(), "offscreen") == 0)
        refuse("a display for the window, or --script FOLDER", "none"); /* SDL would go on where nobody sees it */
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    window = SDL_CreateWindow("Rubble in SDL2", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, (int)options->width,
                              (int)options->height, SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
    if (!window || !SDL_GL_CreateContext(window)) fail("no window with OpenGL 3.3");
}

static void start(const struct options* options) {
    rubble_host host = {.struct_size = sizeof host, .gl_get_proc_address = SDL_GL_GetProcAddress};
    rubble_renderer_settings settings = {.struct_size = sizeof settings, .preset = "fast"};
    settings.flags = RUBBLE_RENDERER_COMPILE_LATE;
    open_window(options);
    make_own_meshes(SDL_GL_GetProcAddress, "#version 330 core\n");
    yard_open(&yard, options->level, &host);
    yard_check(&yard, yard.api->create_renderer(yard.world, &settings, &renderer), "create_renderer");
}

/* Draws the host's triangles, then the world among them. Returns how many values of the GL's state differ after it. */
static int draw_frame(double alpha, int with_world) {
    static struct gl_state before, after;
    rubble_view view = {.struct_size = sizeof view, .flags = RUBBLE_VIEW_DEPTH, .alpha = alpha};
    int width, height;
    SDL_GL_GetDrawableSize(window, &width, &height);
    view.width = (uint32_t)width, view.height = (uint32_t)height;
    yard_look(&yard, &view);
    glViewport(0, 0, width, height);
    glClearColor(0.4f, 0.5f, 0.6f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_own_meshes(&view, kPyramids, 0.02 * (double)yard.steps);
    if (!with_world) return 0;
    read_gl_state(SDL_GL_GetProcAddress, &before);
    yard_check(&yard, yard.api->draw(renderer, &view), "draw");
    read_gl_state(SDL_GL_GetProcAddress, &after);
    return compare_gl_states(&before, &after);
}

/* Writes a frame as an image and says how much of the host's triangles is seen, with the world and without. */
static void write_image(const struct options* options, const char* name) {
    const uint32_t pixels = options->width * options->height;
    uint8_t* const rgb = malloc(3 * (size_t)pixels);
    char path[4096];
    uint32_t alone, among;
    int frame, differences = 0;
    snprintf(path, sizeof path, "%s/%s.png", options->folder, name);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    draw_frame(1.0, 0);
    glReadPixels(0, 0, (GLsizei)options->width, (GLsizei)options->height, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    alone = count_own_pixels(rgb, pixels);
    for (frame = 0; frame < 4; ++frame) differences += draw_frame(1.0, 1); /* light gathers over some frames */
    glReadPixels(0, 0, (GLsizei)options->width, (GLsizei)options->height, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    among = count_own_pixels(rgb, pixels);
    if (!write_png(path, options->width, options->height, rgb)) refuse("a folder to write images to", options->folder);
    free(rgb);
    printf("%s: pieces %u, removed voxels %u, own pixels %u of %u, changed GL state %d\n", path, (unsigned)yard.pieces,
           (unsigned)yard.removed, (unsigned)among, (unsigned)alone, differences);
    SDL_GL_SwapWindow(window);
}

/* Plays the script as fast as it can. Images are of the first cycle; later ones draw every 100 steps. */
static void run_script(const struct options* options) {
    if (!make_folder(options->folder)) refuse("a folder to write images to", options->folder);
    while (yard.steps < options->steps) {
        const uint64_t step = yard.steps % SCRIPT_CYCLE;
        const char* image;
        yard_play_script(&yard);
        yard_step(&yard);
        if ((image = yard_image_name(&yard, options->steps))) write_image(options, image);
        if (step % 100 == 0) draw_frame(1.0, 1);
        if (step == SCRIPT_CYCLE - 1)
            printf("memory after %u steps: %u KiB\n", (unsigned)yard.steps, (unsigned)resident_kib());
    }
}

/* Acts on what the player does; 0: the player leaves. */
static int read_input(void) {
    const Uint8* const keys = SDL_GetKeyboardState(NULL);
    SDL_Event event;
    while (SDL_PollEvent(&event)) {
        const SDL_Keycode key = event.type == SDL_KEYDOWN && !event.key.repeat ? event.key.keysym.sym : 0;
        if (event.type == SDL_QUIT || key == SDLK_ESCAPE) return 0;
        if (event.type == SDL_MOUSEMOTION) {
            yard.yaw -= 0.003 * event.motion.xrel;
            yard.pitch -= 0.003 * event.motion.yrel;
            yard.pitch = yard.pitch < -1.5 ? -1.5 : yard.pitch > 1.5 ? 1.5 : yard.pitch;
        }
        if (event.type == SDL_MOUSEBUTTONDOWN) yard_shoot(&yard);
        if (key == SDLK_e) yard_explode(&yard);
        if (key == SDLK_r) yard_restart(&yard);
    }
    yard_walk(&yard, 4.0 * (keys[SDL_SCANCODE_W] - keys[SDL_SCANCODE_S]),
              4.0 * (keys[SDL_SCANCODE_D] - keys[SDL_SCANCODE_A]), keys[SDL_SCANCODE_SPACE]);
    return 1;
}

/* Plays in real time: as many steps of 1/60 s as have passed, at most four a frame. */
static void run_window(void) {
    Uint64 last = SDL_GetPerformanceCounter();
    double waiting = 0.0;
    SDL_SetRelativeMouseMode(SDL_TRUE);
    SDL_GL_SetSwapInterval(1);
    yard_step(&yard);
    while (read_input()) {
        const Uint64 now = SDL_GetPerformanceCounter();
        waiting += (double)(now - last) / (double)SDL_GetPerformanceFrequency() * 60.0;
        last = now;
        if (waiting > 4.0) waiting = 4.0;
        for (; waiting >= 1.0; waiting -= 1.0) yard_step(&yard);
        draw_frame(waiting, 1);
        SDL_GL_SwapWindow(window);
    }
}

int main(int argc, char** argv) {
    const struct options options = read_options(argc, argv);
    start(&options);
    if (options.folder)
        run_script(&options);
    else
        run_window();
    yard_check(&yard, yard.api->destroy_renderer(renderer), "destroy_renderer");
    yard_close(&yard);
    SDL_Quit();
    return 0;
}
