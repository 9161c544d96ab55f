/* What a host can say of a run: its memory, its GL state, an image. */
#ifndef RUBBLE_HOSTS_REPORT_H
#define RUBBLE_HOSTS_REPORT_H
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { GL_STATE_VALUES = 256 };
/* Values of the GL's state, in the order of a table of report.c. */
struct gl_state {
    int32_t values[GL_STATE_VALUES];
};
/* Reads the state of the current context. get: finds GL functions by name. [render-thread] */
void read_gl_state(void* (*get)(const char* name), struct gl_state* out);
/* Writes to standard error what differs; returns how many values do. */
int compare_gl_states(const struct gl_state* before, const struct gl_state* after);

/* Memory of this process in KiB, as the system counts it (resident). */
uint64_t resident_kib(void);

/* Writes pixels as PNG: three bytes each, rows from the bottom, as glReadPixels() gives them. 0: it cannot. */
int write_png(const char* path, uint32_t width, uint32_t height, const uint8_t* rgb);

#ifdef __cplusplus
}
#endif
#endif
