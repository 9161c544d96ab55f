/* OpenGL of the guides' engine: a context without a window. */
#include "my_engine.h"
#include "tests/support/gl_host.h"

unsigned my_framebuffer, my_width = 64, my_height = 36;
const double my_camera_position[3] = {0.0, 1.5, 6.0}, my_camera_rotation[4] = {0.0, 0.0, 0.0, 1.0};
const double my_projection[16] = {1.2, 0, 0, 0, 0, 2.1, 0, 0, 0, 0, -1.002, -1, 0, 0, -0.2, 0};
static void* (*load)(const char*);

void my_open_window(void) {
    load = make_gl_context();
    my_framebuffer = make_framebuffer((int)my_width, (int)my_height);
}

void* my_gl_get_proc_address(const char* name) {
    return load(name);
}

void my_draw_opaque(void) {}

void my_draw_transparent(void) {}
