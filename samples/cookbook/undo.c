/* Undo in an editor: a mark before each change, and one step back. */
#include "cookbook.h"

int main(void) {
    rubble_carve cut = {.struct_size = sizeof cut, .position = {0, 1, 0.1}, .radii = {0.5, 0.5, 0.5}};
    uint64_t gone;
    begin();
    OK(api->set_undo_limit(world, 20));
    make_box(make_body(-2, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 40, 25, 3, BRICK);
    steps(1);
    OK(api->add_undo_mark(world)); /* the world as the last step left it */
    OK(api->carve(world, &cut));
    steps(1);
    gone = voxels_gone();
    OK(api->undo(world));
    steps(1);
    printf("%d voxels were gone, %d are now\n", (int)gone, (int)voxels_gone());
    require(gone > 0 && voxels_gone() == 0, "the cut is taken back");
    OK(api->destroy_world(world));
    return 0;
}
