/* What the options of a host's script say. Each function returns 0 for text that it cannot take. */
#ifndef RUBBLE_HOSTS_OPTIONS_H
#define RUBBLE_HOSTS_OPTIONS_H
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A number of steps above 0. */
int read_steps(const char* text, uint64_t* steps);
/* WIDTHxHEIGHT in pixels, 1 to 4096 each. */
int read_size(const char* text, unsigned* width, unsigned* height);
/* Makes a folder for images, with those above it. */
int make_folder(const char* path);
/* Whether something can be the path of a folder: it is not empty, and not another option. */
int is_path(const char* text);

#ifdef __cplusplus
}
#endif
#endif
