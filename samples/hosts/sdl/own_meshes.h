/* The host's own triangles: what a game draws beside the world. [render-thread] */
#ifndef RUBBLE_HOSTS_SDL_OWN_MESHES_H
#define RUBBLE_HOSTS_SDL_OWN_MESHES_H
#include <rubble/rubble.h>

/* Compiles the program and fills the buffers; ends the program if the GL cannot. */
void make_own_meshes(void* (*get)(const char* name));
/* Draws two turning pyramids, one before the wall and one that reaches through it, with depth. turn: radians. */
void draw_own_meshes(const rubble_view* view, double turn);
/* Pixels of a frame that show the pyramids: they are magenta. rgb: three bytes each. */
uint32_t count_own_pixels(const uint8_t* rgb, uint32_t pixels);
#endif
