// Teardown's super-sparse walk: five single steps, three double ones, then half and quarter resolution to the end.
bool traceCells(vec3 origin, vec3 direction, float tMax) {
    tMax = leaveVolume(origin, direction, tMax);
    float t = 0.5;
    for (int i = 0; t < tMax; ++i) {
        int level = i < 8 ? 0 : i < 16 ? 1 : 2;
        if (solidAt(origin + direction * t, level)) return true;
        t += i < 5 ? 1.0 : i < 8 ? 2.0 : i < 16 ? 4.0 : 8.0;
    }
    return false;
}
