#include "samples/hosts/support/own_meshes.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define FUNCTIONS(X)                                     \
    X(PFNGLCREATESHADERPROC, glCreateShader)             \
    X(PFNGLSHADERSOURCEPROC, glShaderSource)             \
    X(PFNGLCOMPILESHADERPROC, glCompileShader)           \
    X(PFNGLCREATEPROGRAMPROC, glCreateProgram)           \
    X(PFNGLATTACHSHADERPROC, glAttachShader)             \
    X(PFNGLLINKPROGRAMPROC, glLinkProgram)               \
    X(PFNGLGETPROGRAMIVPROC, glGetProgramiv)             \
    X(PFNGLUSEPROGRAMPROC, glUseProgram)                 \
    X(PFNGLGETUNIFORMLOCATIONPROC, glGetUniformLocation) \
    X(PFNGLUNIFORM4FPROC, glUniform4f)                   \
    X(PFNGLUNIFORMMATRIX4FVPROC, glUniformMatrix4fv)     \
    X(PFNGLGENVERTEXARRAYSPROC, glGenVertexArrays)       \
    X(PFNGLBINDVERTEXARRAYPROC, glBindVertexArray)
#define DECLARE(type, name) static type my_##name;
FUNCTIONS(DECLARE)

/* A vertex is made from its number: four triangles of a pyramid whose base is open. */
static const char* const kVertexShader =
    "precision highp float;\n"
    "uniform mat4 projection; uniform vec4 rotation, place, eye; flat out float shade;\n"
    "vec3 unturn(vec4 q, vec3 v) { return v + 2.0 * cross(-q.xyz, cross(-q.xyz, v) + q.w * v); }\n"
    "void main() {\n"
    "    float side = float(gl_VertexID / 3), corner = float(gl_VertexID % 3);\n"
    "    float angle = place.w + 1.5707963 * (side + corner);\n"
    "    vec3 point = corner == 2.0 ? vec3(0, 1.4, 0) : vec3(0.5 * cos(angle), 0, 0.5 * sin(angle));\n"
    "    shade = 0.6 + 0.4 * cos(place.w + 1.5707963 * side);\n"
    "    gl_Position = projection * vec4(unturn(rotation, place.xyz + point - eye.xyz), 1);\n"
    "}\n";
static const char* const kFragmentShader =
    "precision highp float;\n"
    "flat in float shade; out vec4 color;\n"
    "void main() { color = vec4(0.5 + 0.5 * shade, 0, 0.5 + 0.5 * shade, 1); }\n";

static GLuint program, vertices;

static GLuint compile(GLenum kind, const char* version, const char* source) {
    const char* const sources[2] = {version, source};
    const GLuint shader = my_glCreateShader(kind);
    my_glShaderSource(shader, 2, sources, NULL);
    my_glCompileShader(shader);
    return shader;
}

void make_own_meshes(void* (*get)(const char* name), const char* version) {
    GLint linked = 0;
#define LOAD(type, name) my_##name = (type)get(#name);
    FUNCTIONS(LOAD)
    program = my_glCreateProgram();
    my_glAttachShader(program, compile(GL_VERTEX_SHADER, version, kVertexShader));
    my_glAttachShader(program, compile(GL_FRAGMENT_SHADER, version, kFragmentShader));
    my_glLinkProgram(program);
    my_glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) fprintf(stderr, "the host's own program does not link\n"), exit(1);
    my_glGenVertexArrays(1, &vertices);
}

void draw_own_meshes(const rubble_view* view, const float places[2][3], double turn) {
    float projection[16];
    int i;
    for (i = 0; i < 16; ++i) projection[i] = (float)view->projection[i];
    my_glUseProgram(program);
    my_glBindVertexArray(vertices);
    glEnable(GL_DEPTH_TEST);
    my_glUniformMatrix4fv(my_glGetUniformLocation(program, "projection"), 1, GL_FALSE, projection);
    my_glUniform4f(my_glGetUniformLocation(program, "rotation"), (float)view->rotation[0], (float)view->rotation[1],
                   (float)view->rotation[2], (float)view->rotation[3]);
    my_glUniform4f(my_glGetUniformLocation(program, "eye"), (float)view->position[0], (float)view->position[1],
                   (float)view->position[2], 0.0f);
    for (i = 0; i < 2; ++i) {
        my_glUniform4f(my_glGetUniformLocation(program, "place"), places[i][0], places[i][1], places[i][2],
                       (float)turn);
        glDrawArrays(GL_TRIANGLES, 0, 12);
    }
}

uint32_t count_own_pixels(const uint8_t* rgb, uint32_t pixels) {
    uint32_t count = 0, i;
    for (i = 0; i < pixels; ++i, rgb += 3) count += rgb[0] > 90 && rgb[1] == 0 && rgb[2] > 90;
    return count;
}
