/* A bullet hole: a ray finds what is hit, a carve there removes what a gun can break, and paint blackens its rim. */
#include "cookbook.h"

int main(void) {
    const double muzzle[3] = {0, 1.5, -5}, aim[3] = {0, 0, 1};
    rubble_carve hole = {.struct_size = sizeof hole, .tool = RUBBLE_TOOL_GUN, .radii = {0.15, 0.15, 0.05}};
    rubble_paint soot = {.struct_size = sizeof soot, .color = {20, 20, 20}, .radius = 0.3, .strength = 128};
    rubble_hit hit;
    begin();
    make_box(make_body(-2, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 40, 30, 2, BRICK);
    steps(1);
    OK(api->cast_ray(world, muzzle, aim, 100, &hit));
    memcpy(hole.position, hit.position, sizeof hole.position);
    memcpy(soot.position, hit.position, sizeof soot.position);
    OK(api->carve(world, &hole));
    OK(api->paint(world, &soot));
    steps(1);
    printf("hit at %.1f m, %d voxels gone\n", hit.distance, (int)voxels_gone());
    require(hit.hit && hit.distance == 5.0 && voxels_gone() > 0, "a hole in the wall");
    OK(api->destroy_world(world));
    return 0;
}
