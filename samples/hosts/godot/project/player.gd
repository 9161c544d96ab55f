# The eyes of a walking player: the mouse turns them, W A S D walk, space jumps.
extends Camera

func _unhandled_input(event):
	if event is InputEventMouseMotion and Input.get_mouse_mode() == Input.MOUSE_MODE_CAPTURED:
		rotation.y -= 0.003 * event.relative.x
		rotation.x = clamp(rotation.x - 0.003 * event.relative.y, -1.5, 1.5)

func _physics_process(_delta):
	var forward = float(Input.is_key_pressed(KEY_W)) - float(Input.is_key_pressed(KEY_S))
	var right = float(Input.is_key_pressed(KEY_D)) - float(Input.is_key_pressed(KEY_A))
	var velocity = 4.0 * (Vector3(right, 0, -forward).rotated(Vector3.UP, rotation.y))
	get_parent().move(velocity, Input.is_key_pressed(KEY_SPACE))
