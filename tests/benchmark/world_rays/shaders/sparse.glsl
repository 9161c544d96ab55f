// Teardown's sparse walk: fixed steps, a level finer where a cell is occupied and a level coarser where it is empty.
bool traceCells(vec3 origin, vec3 direction, float tMax) {
    tMax = leaveVolume(origin, direction, tMax);
    int level = 0;
    for (float t = 0.5; t < tMax;) {
        if (!solidAt(origin + direction * t, level)) {
            t += level == 0 ? 1.0 : level == 1 ? 4.0 : 8.0;
            level = min(level + 1, 2);
        } else {
            if (level == 0) return true;
            level -= 1;
        }
    }
    return false;
}
