# A yard to break: a click makes a hole, E an explosion, R begins again. Counts what the signals of VoxelWorld tell.
extends Spatial

var pieces = 0
var broken_voxels = 0
var hits = 0

onready var world = $VoxelWorld
onready var script_player = load("res://script_player.gd").new(self)

func _ready():
	if OS.get_environment("RUBBLE_SCRIPT") == "":
		Input.set_mouse_mode(Input.MOUSE_MODE_CAPTURED)

func _on_piece_made(_body, _position, _voxels):
	pieces += 1
	$Count.text = "%d pieces" % pieces

func _on_broken(_position, _radius, voxels):
	broken_voxels += voxels

func _on_hit(_position, _impulse, _speed):
	hits += 1

# Where the middle of the frame meets a voxel: [position, normal, body], or [].
func _target():
	var eyes = get_viewport().get_camera().global_transform
	return world.cast_ray(eyes.origin, eyes.origin - 100.0 * eyes.basis.z)

func _unhandled_input(event):
	if event is InputEventMouseButton and event.pressed:
		var hit = _target()
		if hit:
			world.break_at(hit[0], 1.0)
	if event is InputEventKey and event.pressed and not event.echo:
		var hit = _target()
		if event.scancode == KEY_E and hit:
			world.explode(hit[0], 1.5)
		if event.scancode == KEY_R:
			world.reload()
		if event.scancode == KEY_ESCAPE:
			get_tree().quit()

func _physics_process(_delta):
	script_player.step()
