/* The host's own triangles: what a game draws beside the world. [render-thread] */
#ifndef RUBBLE_HOSTS_OWN_MESHES_H
#define RUBBLE_HOSTS_OWN_MESHES_H
#include <rubble/rubble.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Compiles the program and fills the buffers; ends the program if the GL cannot. version: the first line of its
 * shaders. */
void make_own_meshes(void* (*get)(const char* name), const char* version);
/* Draws two turning pyramids with depth, the middles of whose bases are at these places. turn: radians. */
void draw_own_meshes(const rubble_view* view, const float places[2][3], double turn);
/* Pixels of a frame that show the pyramids: they are magenta. rgb: three bytes each. */
uint32_t count_own_pixels(const uint8_t* rgb, uint32_t pixels);

#ifdef __cplusplus
}
#endif
#endif
