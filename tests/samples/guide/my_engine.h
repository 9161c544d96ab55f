/* The engine that the guides are written for: as little as their programs need. */
#ifndef MY_ENGINE_H
#define MY_ENGINE_H
#include <rubble/rubble.h>

/* A level of one block on the ground, 1.6 m wide. */
extern const char my_level[];
/* Ends the program. */
void my_fail(const char* why);
/* Writes a message. */
void my_log(const char* message);

/* OpenGL, in gl_engine.c. */

extern unsigned my_framebuffer, my_width, my_height;
extern const double my_camera_position[3], my_camera_rotation[4], my_projection[16];
/* Makes the context current, and the framebuffer. */
void my_open_window(void);
/* For rubble_host. */
void* my_gl_get_proc_address(const char* name);
/* What is drawn before the world. */
void my_draw_opaque(void);
/* What is blended over it. */
void my_draw_transparent(void);
/* Says once that the player fires, and where. */
int my_player_fires(double position[3]);

/* Meshes. */

struct my_shape {
    rubble_shape handle;
    uint64_t version;
};
/* A new shape without meshes. */
struct my_shape* my_add(rubble_shape handle);
/* The shape of a handle; null: there is none. */
struct my_shape* my_find(rubble_shape handle);
/* Forgets a shape. */
void my_remove(rubble_shape handle);
/* Forgets its meshes. */
void my_drop_meshes(struct my_shape* shape);
/* Replaces the mesh of a brick. */
void my_upload(struct my_shape* shape, const int32_t brick[3], const rubble_mesh_vertex* vertices, uint32_t count);
/* Where a shape is drawn. */
void my_place(rubble_shape shape, const double position[3], const double rotation[4]);
/* Of all that was uploaded. */
uint32_t my_triangle_count(void);

/* Physics: bodies fall freely and stop at the ground. */

/* Makes a body, or gives it another collider. */
void my_set_collider(const rubble_rigid_body* body, const rubble_body_box* boxes, uint32_t count);
/* Places a body. */
void my_set_motion(const rubble_rigid_body* body);
/* Removes a body, if there is one. */
void my_remove_body(rubble_body body);
/* Changes the velocity of a body; position: where the impulse acts. */
void my_push(rubble_body body, const double position[3], const double impulse[3]);
/* Moves all bodies. */
void my_step_physics(double seconds);
/* Writes the free bodies; returns how many. */
uint32_t my_get_moved_bodies(rubble_body_state* out, uint32_t capacity);
/* Writes what hit what; returns how many. */
uint32_t my_get_impacts(rubble_impact* out, uint32_t capacity);
/* How many bodies there are. */
uint32_t my_body_count(void);

/* Network: what is sent arrives in order. */

/* Room for so many bytes, until the next call with more. */
uint8_t* my_buffer(uint64_t size);
/* Sends a message. */
void my_send(const uint8_t* bytes, uint64_t size);
/* The next message; null: there is none. */
const uint8_t* my_receive(uint64_t* size);
/* Says once that a client fires, and where. */
int my_receive_shot(double position[3]);
#endif
