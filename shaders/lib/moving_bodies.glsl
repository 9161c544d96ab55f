// Bodies are drawn between two steps, but the shadow volume holds the newest one (render/scene/moving_bodies.cpp). The
// floor before a body, and the body's own faces, then lie inside its shadow cells, and would be black. So rays start
// where their place lies relative to the body in the shadow volume: places on it move with it, those beside it along
// their own surface or away from it, the less the farther they are.
#include "lib/constants.glsl"

uniform int uMovingVectors;
// kVectorsPerMovingBody each: xyz centre of its box as drawn, world, w metres around it within which places move; its
// axes, w half its size along them; xyz move of the centre; xyz turn, an axis as long as the angle.
uniform vec4 uMovingBodies[kVectorsPerMovingBody * kMaxMovingBodies];

const float kOnBody = 0.02;  // metres

/// Where rays start for a place of a surface. moving: 1 if its body moves.
vec3 placeInShadows(vec3 position, vec3 normal, float moving) {
    float most = 0.0;
    vec3 shift = vec3(0.0);
    bool isOn = false;
    int i = loopBegin();
    do {
        if (uMovingVectors == 0) break;
        vec3 fromCentre = position - uMovingBodies[i].xyz;
        vec3 local = vec3(dot(fromCentre, uMovingBodies[i + 1].xyz), dot(fromCentre, uMovingBodies[i + 2].xyz),
                          dot(fromCentre, uMovingBodies[i + 3].xyz));
        vec3 halfSize = vec3(uMovingBodies[i + 1].w, uMovingBodies[i + 2].w, uMovingBodies[i + 3].w);
        float beside = length(max(abs(local) - halfSize, vec3(0.0)));
        float share = 1.0 - beside / uMovingBodies[i].w;
        bool isNearest = share > most;
        most = max(most, share);
        vec3 move = uMovingBodies[i + 4].xyz + cross(uMovingBodies[i + 5].xyz, fromCentre);
        shift = isNearest ? move * share : shift;
        isOn = isNearest ? moving > 0.5 && beside < kOnBody : isOn;
    } while ((i += kVectorsPerMovingBody) < uMovingVectors);
    return position + shift - (isOn ? vec3(0.0) : normal * min(dot(shift, normal), 0.0));
}
