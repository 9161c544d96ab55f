/* Examples: undo, saved games, recordings, worlds that follow another. */
#include "example.h"

EXAMPLE(undo) {
    rubble_explosion bang = {.struct_size = sizeof bang, .position = {0, 1, 0}};
    uint64_t gone;
    OK(api->set_undo_limit(world, 10)); /* of marks; without it there are none */
    steps(1);
    OK(api->add_undo_mark(world));
    OK(api->explode(world, &bang));
    steps(1);
    gone = voxels_gone();
    OK(api->undo(world));
    steps(1);
    require(gone > 0 && voxels_gone() == 0, "the wall is whole again");
    OK(api->redo(world));
    steps(1);
    require(voxels_gone() == gone, "and broken again");
}

EXAMPLE(save_game) {
    uint64_t saved, loaded;
    OK(api->save_game(world, "slot1.rubble"));
    OK(api->get_state_hash(world, &saved));
    steps(60);
    OK(api->load_game(world, "slot1.rubble"));
    OK(api->get_state_hash(world, &loaded));
    require(saved == loaded, "the world as it was");
}

EXAMPLE(apply_edits) {
    rubble_body_change up = {
        .struct_size = sizeof up, .fields = RUBBLE_SET_POSE, .body = crate, .position = {0, 3, -2}};
    rubble_body_state there;
    OK(api->set_body(world, &up));
    OK(api->apply_edits(world)); /* no time passes: the crate hangs in the air */
    OK(api->get_body_state(world, crate, &there));
    require(there.position[1] == 3, "where it was put");
    OK(api->save_level(world, "edited.rubble", NULL));
    OK(api->load_level(world, "edited.rubble", NULL));
    steps(1);
}

EXAMPLE(has_changed) {
    rubble_body_change up = {
        .struct_size = sizeof up, .fields = RUBBLE_SET_POSE, .body = crate, .position = {0, 3, -2}};
    uint32_t changed;
    OK(api->set_undo_limit(world, 10));
    OK(api->add_undo_mark(world));
    OK(api->apply_edits(world));
    OK(api->has_changed(world, &changed));
    require(!changed, "nothing has come since the mark");
    OK(api->set_body(world, &up));
    OK(api->apply_edits(world));
    OK(api->has_changed(world, &changed));
    require(changed, "the crate is elsewhere");
}

EXAMPLE(get_level_hash) {
    uint64_t written, loaded;
    OK(api->get_level_hash(world, &written));
    OK(api->save_level(world, "hashed.rubble", NULL));
    OK(api->load_level(world, "hashed.rubble", NULL));
    OK(api->get_level_hash(world, &loaded));
    require(written == loaded, "the same level");
}

EXAMPLE(get_locations) {
    rubble_location places[8];
    rubble_level_script scripts[8];
    uint32_t count;
    OK(api->get_locations(world, places, 8, &count));
    require(count == 0, "this level names no place");
    OK(api->get_level_scripts(world, scripts, 8, &count)); /* for the host, who runs them */
    require(count == 0, "and no script");
}

EXAMPLE(set_level_scripts) {
    const rubble_level_script lift = {"lift.lua", "speed=2\nheight=6"};
    rubble_level_script scripts[8];
    uint32_t count;
    OK(api->set_level_scripts(world, &lift, 1));
    OK(api->apply_edits(world));
    OK(api->save_level(world, "with_lift.rubble", NULL));
    OK(api->load_level(world, "with_lift.rubble", NULL));
    OK(api->get_level_scripts(world, scripts, 8, &count));
    require(count == 1 && !strcmp(scripts[0].path, "lift.lua"), "the level names the script");
}

EXAMPLE(set_host_data) {
    const uint8_t score[2] = {7, 1};
    uint8_t read[2];
    uint64_t size;
    OK(api->set_host_data(world, "score", score, 2)); /* kept by saves */
    OK(api->save_game(world, "slot2.rubble"));
    OK(api->set_host_data(world, "score", NULL, 0)); /* forgotten */
    OK(api->load_game(world, "slot2.rubble"));
    OK(api->get_host_data(world, "score", read, 2, &size));
    require(size == 2 && read[0] == 7, "the score of that time");
}

EXAMPLE(save_game_data) {
    uint64_t size;
    OK(api->save_game_data(world, NULL, 0, &size)); /* how many bytes it takes */
    require(size <= sizeof bytes, "room for them");
    OK(api->save_game_data(world, bytes, sizeof bytes, &size));
    OK(api->load_game_data(world, bytes, size));
}

EXAMPLE(translate_handle) {
    rubble_world second;
    rubble_body same;
    uint64_t size;
    OK(api->create_world(NULL, &second));
    OK(api->save_game_data(world, bytes, sizeof bytes, &size));
    OK(api->load_game_data(second, bytes, size));
    OK(api->translate_handle(second, crate, &same)); /* `crate` names it in the world that was saved */
    OK(api->destroy_body(second, same));
    OK(api->destroy_world(second));
}

EXAMPLE(start_recording) {
    rubble_explosion bang = {.struct_size = sizeof bang, .position = {0, 1, 0}};
    uint64_t steps_played;
    OK(api->start_recording(world, "game.rubblelog"));
    OK(api->explode(world, &bang));
    steps(30);
    OK(api->stop_recording(world));
    OK(api->play_recording(world, "game.rubblelog", &steps_played));
    require(steps_played == 30, "all steps came out as they were recorded");
}

EXAMPLE(play_recording_data) {
    uint64_t size, steps_played;
    OK(api->start_recording(world, "game.rubblelog"));
    steps(30);
    OK(api->stop_recording(world));
    size = read_file("game.rubblelog");
    OK(api->play_recording_data(world, bytes, size, &steps_played));
    require(steps_played == 30, "all steps");
}

EXAMPLE(get_voxel_hash) {
    rubble_world_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_WORLD_HOST_PHYSICS};
    rubble_row_list list = {.struct_size = sizeof list, .kind = RUBBLE_ROWS_MOVED_BODIES};
    rubble_explosion bang = {.struct_size = sizeof bang, .position = {0, 1, 0}};
    static rubble_body_state moved[100];
    uint64_t size, here, there;
    uint32_t count, i;
    rubble_world client;
    OK(api->create_world(&settings, &client));
    OK(api->keep_deltas(world, RUBBLE_DELTAS_EDITS));
    OK(api->save_game_data(world, bytes, sizeof bytes, &size));
    OK(api->load_game_data(client, bytes, size));
    OK(api->explode(world, &bang));
    steps(2);
    OK(api->take_deltas(world, bytes, sizeof bytes, &size)); /* what went off, without where it flies */
    OK(api->apply_deltas(client, bytes, size));
    OK(api->read_rows(world, &list, moved, 100, &count)); /* which goes its own way, as the network allows */
    for (i = 0; i < count; ++i) OK(api->translate_handle(client, moved[i].body, &moved[i].body));
    OK(api->set_body_states(client, moved, count));
    OK(api->get_voxel_hash(world, &here));
    OK(api->get_voxel_hash(client, &there));
    require(here == there, "the client has the same voxels");
    OK(api->destroy_world(client));
}

EXAMPLE(apply_deltas) {
    rubble_explosion bang = {.struct_size = sizeof bang, .position = {0, 1, 0}};
    uint64_t size, here, there;
    rubble_world client;
    OK(api->create_world(NULL, &client));
    OK(api->keep_deltas(world, RUBBLE_DELTAS_ALL));
    OK(api->save_game_data(world, bytes, sizeof bytes, &size)); /* what the client begins with */
    OK(api->load_game_data(client, bytes, size));
    OK(api->explode(world, &bang));
    steps(2);
    OK(api->take_deltas(world, bytes, sizeof bytes, &size)); /* what goes over the network */
    OK(api->apply_deltas(client, bytes, size));
    OK(api->get_resolved_hash(world, &here));
    OK(api->get_resolved_hash(client, &there));
    require(here == there, "the client has the same world");
    OK(api->destroy_world(client));
}
