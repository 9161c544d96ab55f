#include "samples/hosts/support/gl_state.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <stdio.h>
#include <string.h>

struct row {
    GLenum name;
    int count;
    const char* text;
};
#define ROW(name, count) \
    { name, count, #name }
static const struct row kRows[] = {
    ROW(GL_BLEND, 1),
    ROW(GL_CULL_FACE, 1),
    ROW(GL_DEPTH_TEST, 1),
    ROW(GL_DITHER, 1),
    ROW(GL_SCISSOR_TEST, 1),
    ROW(GL_STENCIL_TEST, 1),
    ROW(GL_FRAMEBUFFER_SRGB, 1),
    ROW(GL_MULTISAMPLE, 1),
    ROW(GL_PRIMITIVE_RESTART, 1),
    ROW(GL_DEPTH_CLAMP, 1),
    ROW(GL_POLYGON_OFFSET_FILL, 1),
    ROW(GL_RASTERIZER_DISCARD, 1),
    ROW(GL_SAMPLE_ALPHA_TO_COVERAGE, 1),
    ROW(GL_COLOR_LOGIC_OP, 1),
    ROW(GL_TEXTURE_CUBE_MAP_SEAMLESS, 1),
    ROW(GL_CURRENT_PROGRAM, 1),
    ROW(GL_VERTEX_ARRAY_BINDING, 1),
    ROW(GL_ARRAY_BUFFER_BINDING, 1),
    ROW(GL_ELEMENT_ARRAY_BUFFER_BINDING, 1),
    ROW(GL_UNIFORM_BUFFER_BINDING, 1),
    ROW(GL_COPY_READ_BUFFER, 1),
    ROW(GL_DRAW_FRAMEBUFFER_BINDING, 1),
    ROW(GL_READ_FRAMEBUFFER_BINDING, 1),
    ROW(GL_RENDERBUFFER_BINDING, 1),
    ROW(GL_PIXEL_PACK_BUFFER_BINDING, 1),
    ROW(GL_PIXEL_UNPACK_BUFFER_BINDING, 1),
    ROW(GL_PACK_ALIGNMENT, 1),
    ROW(GL_UNPACK_ALIGNMENT, 1),
    ROW(GL_UNPACK_ROW_LENGTH, 1),
    ROW(GL_ACTIVE_TEXTURE, 1),
    ROW(GL_VIEWPORT, 4),
    ROW(GL_SCISSOR_BOX, 4),
    ROW(GL_DEPTH_FUNC, 1),
    ROW(GL_DEPTH_WRITEMASK, 1),
    ROW(GL_COLOR_WRITEMASK, 4),
    ROW(GL_BLEND_SRC_RGB, 1),
    ROW(GL_BLEND_DST_RGB, 1),
    ROW(GL_BLEND_SRC_ALPHA, 1),
    ROW(GL_BLEND_DST_ALPHA, 1),
    ROW(GL_BLEND_EQUATION_RGB, 1),
    ROW(GL_CULL_FACE_MODE, 1),
    ROW(GL_FRONT_FACE, 1),
    ROW(GL_STENCIL_FUNC, 1),
    ROW(GL_STENCIL_REF, 1),
    ROW(GL_STENCIL_WRITEMASK, 1),
    ROW(GL_DEPTH_RANGE, 2),
    ROW(GL_COLOR_CLEAR_VALUE, 4),
    ROW(GL_DEPTH_CLEAR_VALUE, 1),
};
/* Of each texture unit. */
static const struct row kUnitRows[] = {ROW(GL_TEXTURE_BINDING_2D, 1), ROW(GL_TEXTURE_BINDING_3D, 1),
                                       ROW(GL_TEXTURE_BINDING_BUFFER, 1), ROW(GL_TEXTURE_BINDING_CUBE_MAP, 1),
                                       ROW(GL_SAMPLER_BINDING, 1)};
enum { ROWS = sizeof kRows / sizeof kRows[0], UNIT_ROWS = sizeof kUnitRows / sizeof kUnitRows[0], UNITS = 32 };

void read_gl_state(void* (*get)(const char* name), struct gl_state* out) {
    void (*get_integer)(GLenum, GLint*) = (void (*)(GLenum, GLint*))get("glGetIntegerv");
    void (*activate)(GLenum) = (void (*)(GLenum))get("glActiveTexture");
    int32_t* value = out->values;
    GLint active, i, unit;
    memset(out, 0, sizeof *out);
    for (i = 0; i < ROWS; value += kRows[i++].count) get_integer(kRows[i].name, value);
    get_integer(GL_ACTIVE_TEXTURE, &active);
    for (unit = 0; unit < UNITS; ++unit) {
        activate((GLenum)(GL_TEXTURE0 + unit));
        for (i = 0; i < UNIT_ROWS; ++i) get_integer(kUnitRows[i].name, value++);
    }
    activate((GLenum)active);
}

int compare_gl_states(const struct gl_state* before, const struct gl_state* after) {
    int differences = 0, at = 0, i, j;
    for (i = 0; i < ROWS; ++i)
        for (j = 0; j < kRows[i].count; ++j, ++at)
            if (before->values[at] != after->values[at])
                ++differences, fprintf(stderr, "GL state: %s was %d, is %d\n", kRows[i].text, (int)before->values[at],
                                       (int)after->values[at]);
    for (i = 0; i < UNITS * UNIT_ROWS; ++i, ++at)
        if (before->values[at] != after->values[at])
            ++differences, fprintf(stderr, "GL state: %s of unit %d was %d, is %d\n", kUnitRows[i % UNIT_ROWS].text,
                                   i / UNIT_ROWS, (int)before->values[at], (int)after->values[at]);
    return differences;
}
