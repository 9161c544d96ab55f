// lib/fullscreen.vert at the far plane, where a depth test can tell pixels with a surface from those of the sky. Of programs that compute
// may draw too: their `uv` is that of the pixel's middle in both (render/shader_library/fullscreen_source.h).
void main() { gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 1.0, 1.0); }
