/* The yard that hosts in C and C++ share: a world with the level of yard.py, a player who walks in it, and a script
 * that plays without one. A call that Rubble refuses ends the program with its words. [main-thread] */
#ifndef RUBBLE_HOSTS_YARD_H
#define RUBBLE_HOSTS_YARD_H
#include <rubble/rubble.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Steps of the script, which begins again after the last one. */
enum {
    SCRIPT_HOLE = 20,      /* a hole in the wall */
    SCRIPT_EXPLOSION = 40, /* an explosion at the wall's other end */
    SCRIPT_FELLED = 90,    /* an explosion under the wooden tower */
    SCRIPT_CYCLE = 300     /* the level is loaded again */
};

/* Where a player begins: metres, and radians to the left and up. */
struct yard_start {
    double position[3], yaw, pitch;
};

struct yard {
    const rubble_api* api;
    rubble_world world;
    const char* level;       /* path of the level */
    struct yard_start start; /* of the player in it */
    rubble_character player; /* walks in it */
    double position[3];      /* of the player's eyes, world, metres */
    double yaw, pitch;       /* radians: turned to the left, and up */
    uint64_t pieces;         /* that came off since yard_open() */
    uint64_t removed;        /* voxels that were removed */
    uint64_t steps;
};

/* Ends the program with the last error, unless a call came out. */
void yard_check(const struct yard* yard, rubble_result result, const char* what);
/* Makes the world, loads the level and places the player. host: services as for set_host(). */
void yard_open(struct yard* yard, const char* level, const rubble_host* host);
/* The same in a world that the host has made. start: null for that of the yard. */
void yard_enter(struct yard* yard, const char* level, const struct yard_start* start, const rubble_api* api,
                rubble_world world);
/* Loads the level again. */
void yard_restart(struct yard* yard);
/* Says where the player walks: metres a second forward and to the right. */
void yard_walk(struct yard* yard, double forward, double right, int jump);
/* Makes a hole where the player looks; nothing, where that is the sky. */
void yard_shoot(struct yard* yard);
/* Makes an explosion where the player looks; nothing, where that is the sky. */
void yard_explode(struct yard* yard);
/* Queues what the script does in the next step. */
void yard_play_script(struct yard* yard);
/* The name of the image after the last step of a script that ends after so many steps; null: there is none. */
const char* yard_image_name(const struct yard* yard, uint64_t end);
/* Plays a sixtieth of a second, counts what came off, and moves the eyes with the player. */
void yard_step(struct yard* yard);
/* Sets position, rotation and projection of a view: the player's eyes, in a frame of width by height pixels. */
void yard_look(const struct yard* yard, rubble_view* view);
/* Destroys the world. */
void yard_close(struct yard* yard);

#ifdef __cplusplus
}
#endif
#endif
