# Prints the properties and signals that Godot's inspector shows of the node classes of Rubble, beside those of a Spatial.
extends SceneTree

func _init():
	var usual = []
	var spatial = Spatial.new()
	for property in spatial.get_property_list():
		usual.append(property.name)
	spatial.free()
	for name in ["voxel_world", "voxel_body", "voxel_character", "voxel_world_runtime"]:
		var node = load("res://addons/rubble/" + name + ".gdns").new()
		for property in node.get_property_list():
			if property.usage & PROPERTY_USAGE_EDITOR and not usual.has(property.name):
				print("%s.%s: %s \"%s\"" % [name, property.name, node.get(property.name), property.hint_string])
		for each in ["piece_made", "broken", "hit", "destroyed"]:
			if node.has_signal(each):
				print("%s signals %s" % [name, each])
		node.free()
	quit()
