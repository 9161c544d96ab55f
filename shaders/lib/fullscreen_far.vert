// lib/fullscreen.vert at the far plane, where a depth test can tell pixels with a surface from those of the sky.
out vec2 uv;
void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(uv * 2.0 - 1.0, 1.0, 1.0);
}
