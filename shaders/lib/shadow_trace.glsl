// Rays through the shadow volume. (Content follows; the interface is final.)
// True if the ray from originWorld (metres, from the render origin) meets an occupied cell within tMax metres along the unit
// vector `direction`; t is where.
bool shadowTrace(vec3 originWorld, vec3 direction, float tMax, out float t) {
    t = tMax;
    return false;
}
// Where a ray leaves a surface so as not to meet its own cells.
vec3 shadowOrigin(vec3 positionWorld, vec3 normalWorld) { return positionWorld + normalWorld * 0.15; }
