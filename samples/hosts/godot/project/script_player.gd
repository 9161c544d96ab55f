# Plays without a player, for tests and for machines without a display: with RUBBLE_SCRIPT=FOLDER in the environment it
# breaks the yard at fixed steps, writes images into the folder, and says what it saw. RUBBLE_STEPS: how long, 300 at first.
# Godot 3 reads the environment as ASCII: other letters of the folder, and %, are written as in URLs, %C3%BC.
extends Reference

const HOLE = 20
const EXPLOSION = 40
const FELLED = 90
const CYCLE = 300
const IMAGES = {10: "1_start", 40: "2_hole", 55: "3_flying", 300: "4_end"}

var game
var folder = OS.get_environment("RUBBLE_SCRIPT").percent_decode()
var last = int(max(1, int(OS.get_environment("RUBBLE_STEPS")))) if OS.has_environment("RUBBLE_STEPS") else CYCLE
var steps = 0
var busy = false
var ended = false

func _init(of):
	game = of
	if folder != "":
		VisualServer.render_loop_enabled = false

func step():
	if folder == "" or busy:
		return
	var at = steps % CYCLE
	if at == 0 and steps > 0:
		_say_memory()
	if steps == last:
		if last < CYCLE and not IMAGES.has(last) and not ended:
			ended = true
			_write_image(IMAGES[CYCLE])
			return
		game.get_tree().quit()
		return
	if at == 0 and steps > 0:
		game.world.reload()
	if at == HOLE:
		_click(Vector3(-0.9, 1.4, -0.8))
	if at == EXPLOSION:
		game.world.explode(Vector3(-1.9, 0.7, -0.8), 1.5)
	if at == FELLED:
		game.world.explode(Vector3(-3.3, 0.3, 0.0), 2.0)
	if at % 100 == 60 and not OS.has_feature("Server"):
		VisualServer.force_draw()
	steps += 1
	if IMAGES.has(steps):
		_write_image(IMAGES[steps])

# Looks at a place and clicks, as a player does.
func _click(place):
	var eyes = game.get_viewport().get_camera()
	var before = eyes.transform
	eyes.look_at(place, Vector3.UP)
	var click = InputEventMouseButton.new()
	click.button_index = BUTTON_LEFT
	click.pressed = true
	game._unhandled_input(click)
	eyes.transform = before

func _say_memory():
	var file = File.new()
	file.open("/proc/self/statm", File.READ)
	var pages = file.get_line().split(" ")[1]
	print("memory after %d steps: %d KiB" % [steps, int(pages) * 4])

# How many pixels show Godot's own meshes, which are magenta.
func _own_pixels(image):
	var count = 0
	image.lock()
	for y in image.get_height():
		for x in image.get_width():
			var color = image.get_pixel(x, y)
			if color.r > 1.5 * color.g and color.b > 1.5 * color.g and color.r > 0.1:
				count += 1
	image.unlock()
	return count

func _grab():
	yield(VisualServer, "frame_post_draw")
	yield(VisualServer, "frame_post_draw")
	var image = game.get_viewport().get_texture().get_data()
	image.flip_y()
	return image

func _write_image(name):
	busy = true
	game.get_tree().paused = true
	VisualServer.render_loop_enabled = true
	if not OS.has_feature("Server"):
		game.world.visible = false
		var alone = _own_pixels(yield(_grab(), "completed"))
		game.world.visible = true
		for _frame in 3:  # light gathers over some frames
			yield(VisualServer, "frame_post_draw")
		var image = yield(_grab(), "completed")
		if image.save_png(folder + "/" + name + ".png") != OK:
			print("RUBBLE_SCRIPT: expected a folder to write images to, found \"%s\"" % folder)
			return game.get_tree().quit(1)
		print("%s/%s.png: pieces %d, removed voxels %d, own pixels %d of %d, changed GL state %d" % [folder, name,
			game.pieces, game.world.removed_voxels(), _own_pixels(image), alone, game.world.changed_gl_state()])
	print("signals: pieces %d of %d, hits %d, broken voxels %d" % [game.pieces, game.world.piece_count(), game.hits,
		game.broken_voxels])
	VisualServer.render_loop_enabled = false
	game.get_tree().paused = false
	busy = false
