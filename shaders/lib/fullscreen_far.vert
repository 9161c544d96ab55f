// lib/fullscreen.vert at the far plane, where a depth test tells surfaces from sky. It has no `uv`: programs that may
// also run as compute shaders calculate it from the pixel (render/shader_library/fullscreen_source.h).
void main() { gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 1.0, 1.0); }
