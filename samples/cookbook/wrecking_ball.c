/* A wrecking ball on a rope swings into a wall, which breaks where it is hit. */
#include "cookbook.h"

int main(void) {
    rubble_joint_settings rope = {.struct_size = sizeof rope, .kind = RUBBLE_JOINT_ROPE, .rope_length = 4};
    rubble_shape_settings ball = {.struct_size = sizeof ball, .source = RUBBLE_SHAPE_SPHERE, .index = METAL};
    rubble_joint made;
    begin();
    make_box(make_body(-2, 0, 0.4, RUBBLE_BODY_STATIC), 0, 0, 0, 40, 25, 2, BRICK);
    rope.shapes[0] = make_box(make_body(-0.2, 5.5, -0.2, RUBBLE_BODY_STATIC), 0, 0, 0, 4, 4, 4, METAL);
    ball.body = make_body(-0.5, 5, -4.5, 0);
    ball.size[0] = ball.size[1] = ball.size[2] = 10;
    OK(api->create_shape(world, &ball, &rope.shapes[1]));
    rope.position[1] = 5.6; /* the beam; the other end is at the ball's side */
    rope.rope_end[1] = 5.5, rope.rope_end[2] = -3.55;
    OK(api->create_joint(world, &rope, &made));
    steps(150);
    printf("%d voxels gone\n", (int)voxels_gone());
    require(voxels_gone() > 0, "the wall is hit");
    OK(api->destroy_world(world));
    return 0;
}
