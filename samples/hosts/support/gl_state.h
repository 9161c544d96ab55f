/* The state of the GL of a host, before and after a draw. */
#ifndef RUBBLE_HOSTS_GL_STATE_H
#define RUBBLE_HOSTS_GL_STATE_H
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { GL_STATE_VALUES = 256 };
/* Values of the GL's state, in the order of a table of gl_state.c. */
struct gl_state {
    int32_t values[GL_STATE_VALUES];
};
/* Reads the state of the current context. get: finds GL functions by name. [render-thread] */
void read_gl_state(void* (*get)(const char* name), struct gl_state* out);
/* Writes to standard error what differs; returns how many values do. */
int compare_gl_states(const struct gl_state* before, const struct gl_state* after);

#ifdef __cplusplus
}
#endif
#endif
