/* The browser host: a town to break, drawn by WebGL 2. script.js plays it where no player does.
 * A click makes a hole, E an explosion, W A S D and the mouse walk and look, space jumps, R begins again. */
#include <GLES3/gl3.h>
#include <emscripten.h>
#include <emscripten/heap.h>
#include <emscripten/html5.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "samples/hosts/support/gl_state.h"
#include "samples/hosts/support/own_meshes.h"
#include "samples/hosts/web/town.h"

static const char kCanvas[] = "#canvas", kLevel[] = "town.rubble";

static const rubble_api* api;
static rubble_world world;
static rubble_renderer renderer; /* 0: there is none, as while the context is lost */
static struct yard yard;
static struct { /* what the page has loaded */
    void* bytes;
    uint64_t size;
} level;
static struct { /* an image of its own: the canvas has no depth of 32-bit floats */
    GLuint framebuffer, color, depth;
    int width, height;
} image;
static char preset[16] = "balanced";
static int with_meshes = 1; /* the host's own triangles, with depth */
static int keys[4];         /* held: W, S, A, D */

static void check(rubble_result result, const char* what) {
    const struct yard failed = {.api = api};
    yard_check(&failed, result, what);
}

/* ---- services for the plugin ---- */

static void* find_gl(const char* name) {
    return emscripten_webgl_get_proc_address(name);
}

static uint64_t file_size(void* user, const char* path) {
    (void)user;
    return strcmp(path, kLevel) == 0 ? level.size : RUBBLE_FILE_ON_DISK;
}

static int32_t read_file(void* user, const char* path, void* out, uint64_t size) {
    (void)user, (void)path;
    memcpy(out, level.bytes, (size_t)size);
    return 1;
}

/* ---- drawing ---- */

static void make_texture(GLuint* texture, GLenum format, int attachment) {
    glGenTextures(1, texture);
    glBindTexture(GL_TEXTURE_2D, *texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, image.width, image.height);
    glFramebufferTexture2D(GL_FRAMEBUFFER, (GLenum)attachment, GL_TEXTURE_2D, *texture, 0);
}

/* An image as large as the canvas. */
static void fit_image(void) {
    int width, height;
    emscripten_get_canvas_element_size(kCanvas, &width, &height);
    if (image.framebuffer && width == image.width && height == image.height) return;
    if (image.framebuffer) {
        glDeleteTextures(1, &image.color), glDeleteTextures(1, &image.depth);
        glDeleteFramebuffers(1, &image.framebuffer);
    }
    image.width = width, image.height = height;
    glGenFramebuffers(1, &image.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, image.framebuffer);
    make_texture(&image.color, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    make_texture(&image.depth, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    glBindTexture(GL_TEXTURE_2D, 0);
}

/* What read_gl_state() asks for is more than WebGL has. */
static void take_gl_errors(void) {
    while (glGetError() != GL_NO_ERROR) continue;
}

/* Draws the host's triangles, then the world among them. Returns how many values of the GL's state differ after it, if
 * that is to be compared. */
static int draw_frame(double alpha, int with_world, int compares) {
    static struct gl_state before, after;
    rubble_view view = {.struct_size = sizeof view, .alpha = alpha};
    int differences = 0;
    if (!renderer) return 0;
    fit_image();
    if (with_meshes) view.flags = RUBBLE_VIEW_DEPTH;
    view.framebuffer = image.framebuffer, view.width = (uint32_t)image.width, view.height = (uint32_t)image.height;
    yard_look(&yard, &view);
    glBindFramebuffer(GL_FRAMEBUFFER, image.framebuffer);
    glViewport(0, 0, image.width, image.height);
    glClearColor(0.4f, 0.5f, 0.6f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (with_meshes) draw_own_meshes(&view, kTownPyramids, 0.02 * (double)yard.steps);
    if (with_world) {
        if (compares) read_gl_state(find_gl, &before), take_gl_errors();
        check(api->draw(renderer, &view), "draw");
        if (compares)
            read_gl_state(find_gl, &after), take_gl_errors(), differences = compare_gl_states(&before, &after);
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, image.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, image.width, image.height, 0, 0, image.width, image.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return differences;
}

static uint32_t count_own(void) {
    const uint32_t pixels = (uint32_t)(image.width * image.height);
    uint8_t* const rgba = malloc(4 * (size_t)pixels);
    uint32_t i, count;
    glBindFramebuffer(GL_FRAMEBUFFER, image.framebuffer);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    for (i = 0; i < pixels; ++i) memmove(rgba + 3 * i, rgba + 4 * i, 3);
    count = count_own_pixels(rgba, pixels);
    free(rgba);
    return count;
}

/* What is gone with a lost context, and comes back with a new one. */
static void make_drawing(void) {
    rubble_renderer_settings settings = {.struct_size = sizeof settings, .preset = preset};
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_get_current_context();
    settings.flags = RUBBLE_RENDERER_COMPILE_LATE;
    emscripten_webgl_enable_extension(context, "EXT_color_buffer_float");
    emscripten_webgl_enable_extension(context, "OES_texture_float_linear");
    emscripten_webgl_enable_extension(context, "WEBGL_debug_renderer_info"); /* says whether there is a GPU */
    memset(&image, 0, sizeof image);
    make_own_meshes(find_gl, "#version 300 es\n");
    check(api->create_renderer(world, &settings, &renderer), "create_renderer");
}

static void destroy_renderer(void) {
    if (renderer) check(api->destroy_renderer(renderer), "destroy_renderer");
    renderer = 0;
}

static EM_BOOL on_context_lost(int type, const void* reserved, void* user) {
    (void)type, (void)reserved, (void)user;
    destroy_renderer();
    printf("the WebGL context was lost\n");
    return EM_TRUE; /* it may come back */
}

static EM_BOOL on_context_restored(int type, const void* reserved, void* user) {
    (void)type, (void)reserved, (void)user;
    make_drawing();
    yard_step(&yard); /* which shows the world to the new renderer */
    printf("the WebGL context is back\n");
    return EM_TRUE;
}

/* ---- input ---- */

static EM_BOOL on_mouse(int type, const EmscriptenMouseEvent* event, void* user) {
    EmscriptenPointerlockChangeEvent lock = {0};
    (void)user;
    if (type == EMSCRIPTEN_EVENT_MOUSEDOWN) {
        emscripten_request_pointerlock(kCanvas, EM_FALSE);
        yard_shoot(&yard);
        return EM_TRUE;
    }
    emscripten_get_pointerlock_status(&lock);
    if (!lock.isActive) return EM_FALSE;
    yard.yaw -= 0.003 * event->movementX;
    yard.pitch -= 0.003 * event->movementY;
    yard.pitch = yard.pitch < -1.5 ? -1.5 : yard.pitch > 1.5 ? 1.5 : yard.pitch;
    return EM_TRUE;
}

static EM_BOOL on_key(int type, const EmscriptenKeyboardEvent* event, void* user) {
    static const char* const codes[4] = {"KeyW", "KeyS", "KeyA", "KeyD"};
    const int is_down = type == EMSCRIPTEN_EVENT_KEYDOWN;
    int i;
    (void)user;
    for (i = 0; i < 4; ++i)
        if (strcmp(event->code, codes[i]) == 0) keys[i] = is_down;
    if (is_down && !event->repeat && strcmp(event->code, "KeyE") == 0) yard_explode(&yard);
    if (is_down && !event->repeat && strcmp(event->code, "KeyR") == 0) yard_restart(&yard);
    yard_walk(&yard, 4.0 * (keys[0] - keys[1]), 4.0 * (keys[3] - keys[2]),
              is_down && strcmp(event->code, "Space") == 0);
    return EM_TRUE;
}

/* ---- what the page calls ---- */

/* Plays steps of 1/60 s. */
EMSCRIPTEN_KEEPALIVE void host_step(int steps) {
    for (; steps > 0; --steps) yard_step(&yard);
}

/* Draws a frame. alpha: 0 to 1 between the last two steps. */
EMSCRIPTEN_KEEPALIVE void host_draw(double alpha) {
    draw_frame(alpha, 1, 0);
}

/* Draws an image of the world as it is now, whose light has gathered over some frames, and says what it shows. */
EMSCRIPTEN_KEEPALIVE void host_image(const char* name, int frames) {
    uint32_t alone, among;
    int frame, differences = 0;
    draw_frame(1.0, 0, 0);
    alone = count_own();
    for (frame = 0; frame < frames; ++frame) differences += draw_frame(1.0, 1, frame == 0);
    among = count_own();
    printf("%s: pieces %u, removed voxels %u, own pixels %u of %u, changed GL state %d\n", name, (unsigned)yard.pieces,
           (unsigned)yard.removed, (unsigned)among, (unsigned)alone, differences);
    draw_frame(1.0, 1, 0); /* the canvas */
}

/* Says how much memory is used, with textures and without the free part of the heap, which never shrinks. */
EMSCRIPTEN_KEEPALIVE void host_memory(void) {
    rubble_draw_stats stats = {.struct_size = sizeof stats};
    if (renderer) check(api->get_draw_stats(renderer, &stats), "get_draw_stats");
    printf("memory after %u steps: %u KiB, of a heap of %u KiB\n", (unsigned)yard.steps,
           (unsigned)((mallinfo().uordblks + stats.texture_bytes) / 1024),
           (unsigned)(emscripten_get_heap_size() / 1024));
}

/* Draws with another preset from now on, with the host's own triangles or without. */
EMSCRIPTEN_KEEPALIVE void host_quality(const char* name, int meshes) {
    snprintf(preset, sizeof preset, "%s", name);
    with_meshes = meshes;
    destroy_renderer();
    make_drawing();
    yard_step(&yard); /* which shows the world to the new renderer */
}

/* Begins with a level of the page, which stays its own. */
EMSCRIPTEN_KEEPALIVE void host_begin(void* bytes, int size) {
    EmscriptenWebGLContextAttributes attributes;
    rubble_host host = {.struct_size = sizeof host, .gl_get_proc_address = find_gl};
    rubble_world_settings settings = {.struct_size = sizeof settings};
    level.bytes = bytes, level.size = (uint64_t)size;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = attributes.depth = attributes.antialias = EM_FALSE;
    if (emscripten_webgl_make_context_current(emscripten_webgl_create_context(kCanvas, &attributes)) !=
        EMSCRIPTEN_RESULT_SUCCESS) {
        fprintf(stderr, "this browser has no WebGL 2\n");
        exit(1);
    }
    check(rubble_get_api(RUBBLE_VERSION, &api), "rubble_get_api");
    host.file_size = file_size, host.read_file = read_file;
    check(api->set_host(&host), "set_host");
    settings.flags = RUBBLE_WORLD_SHADOW_INLINE; /* a page of a plain server has no threads */
    check(api->create_world(&settings, &world), "create_world");
    yard_enter(&yard, kLevel, &kTownStart, api, world);
    make_drawing();
    emscripten_set_mousedown_callback(kCanvas, NULL, EM_FALSE, on_mouse);
    emscripten_set_mousemove_callback(kCanvas, NULL, EM_FALSE, on_mouse);
    emscripten_set_keydown_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, NULL, EM_FALSE, on_key);
    emscripten_set_keyup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, NULL, EM_FALSE, on_key);
    emscripten_set_webglcontextlost_callback(kCanvas, NULL, EM_FALSE, on_context_lost);
    emscripten_set_webglcontextrestored_callback(kCanvas, NULL, EM_FALSE, on_context_restored);
}
