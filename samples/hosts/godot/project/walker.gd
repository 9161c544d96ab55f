# A walking player of Godot's own physics, for worlds in which Rubble moves nothing.
extends KinematicBody

var wish = Vector3()
var velocity = Vector3()

func move(desired, jump):
	wish = desired
	if jump and is_on_floor():
		velocity.y = 4.5

func _physics_process(delta):
	velocity = Vector3(wish.x, velocity.y - 9.8 * delta, wish.z)
	velocity = move_and_slide(velocity, Vector3.UP)
