/* A GL context without a window, for hosts in C and C++. [render-thread] */
#ifndef RUBBLE_GL_HOST_H
#define RUBBLE_GL_HOST_H
#ifdef __cplusplus
extern "C" {
#endif

/* Makes a context current, which lives as long as the program, and returns how it finds functions, for rubble_host.
 * Ends the program if there is no GL. */
void* (*make_gl_context(void))(const char* name);
/* A framebuffer of colours and depth in that context, in pixels; all is white and far away. */
unsigned make_framebuffer(int width, int height);

#ifdef __cplusplus
}
#endif
#endif
