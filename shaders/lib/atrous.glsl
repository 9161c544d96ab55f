// What edge-avoiding a-trous filters share (Dammertz et al. 2010): taps at a stride, and how far a tap lies off the
// plane of a pixel's surface. Needs lib/frame, surface_history.

/// Tukey's biweight: 1 for no difference, 0 from twice the scale on.
float biweight(float x) {
    float y = max(0.0, 1.0 - 0.25 * x * x);
    return y * y;
}

/// Offset of tap i in strides: the pixel itself, then its four neighbours in row and column or on the diagonals.
ivec2 tapOffset(int i, bool diagonal) {
    ivec2 offset = ivec2(i == 1 ? 1 : i == 2 ? -1 : 0, i == 3 ? 1 : i == 4 ? -1 : 0);
    return diagonal ? ivec2(offset.x + offset.y, offset.x - offset.y) : offset;
}

/// The plane of the pixel's surface. Height of a tap over it = dot(normal, ray) x depth - the pixel's own, and
/// dot(normal, ray) is linear in pixels; of an orthographic view dot(normal, where the ray begins) is.
struct Plane {
    float facing, facingX, facingY;  // dot(normal, ray) of the pixel, and the change from pixel to pixel
    float depth, scale;
};

/// centre: of the target "surface".
Plane planeOf(vec2 uv, vec4 centre) {
    vec3 normal = unpackNormal(centre.y);
    float facing = dot(normal, viewRay(uv));
    float facingX = dot(normal, frame.cameraRight.xyz) * 2.0 * frame.cameraRight.w * frame.targetSize.z;
    float facingY = dot(normal, frame.cameraUp.xyz) * 2.0 * frame.cameraUp.w * frame.targetSize.w;
    return Plane(facing, facingX, facingY, centre.x, 1.0 / (0.01 + 0.0015 * centre.x));
}

float planeWeight(Plane plane, vec2 away, float depth) {
    float height = plane.facing * (depth - plane.depth) +
                   (plane.facingX * away.x + plane.facingY * away.y) * viewScale(depth);
    return max(0.0, 1.0 - abs(height) * plane.scale);
}
