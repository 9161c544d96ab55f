// The project of the Godot host, as Godot plays it: with Rubble's renderer, with Godot's physics and meshes, exported,
// and in a server that draws nothing.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "generated/paths.h"
#include "tests/samples/hosts/host_run.h"

namespace rubble {
namespace {

const char kProject[] = RUBBLE_BINARY_DIR "/hosts/godot";
const char kWindow[] = " --video-driver GLES3 --audio-driver Dummy --resolution 320x240 --fixed-fps 60 ";

std::string missing() {
    std::string text;
    for (const char* program : {"godot3", "godot3-server", "godot3-runner", "xvfb-run"})
        if (text.empty()) text = missingFor(std::string("/usr/bin/") + program, program);
    return text;
}

/// Godot without settings of a user, and what the script shall do.
std::string environment(const std::string& folder, int steps) {
    return "HOME=" + folder + " RUBBLE_SCRIPT=" + folder + " RUBBLE_STEPS=" + std::to_string(steps) + " ";
}

std::string windowed(const std::string& program) {
    return "xvfb-run -a -s '-screen 0 640x480x24' " + program;
}

/// Expects that GDScript has counted by signals what the world counts itself.
void expectSignals(const HostRun& run) {
    std::istringstream lines(run.output);
    unsigned pieces = 0, all = 0, hits = 0, voxels = 0, count = 0;
    for (std::string line; std::getline(lines, line);)
        if (std::sscanf(line.c_str(), "signals: pieces %u of %u, hits %u, broken voxels %u", &pieces, &all, &hits,
                        &voxels) == 4) {
            EXPECT_EQ(pieces, all) << line;
            ++count;
        }
    EXPECT_EQ(count, 4u) << run.output;
    EXPECT_GT(pieces, 50u) << "of the last image";
    EXPECT_GT(hits, 10u) << "of the last image";
    EXPECT_GT(voxels, 500u) << "of the last image";
    EXPECT_EQ(run.output.find("ERROR: rubble"), std::string::npos) << run.output;
    EXPECT_EQ(run.output.find("SCRIPT ERROR"), std::string::npos) << run.output;
}

TEST(HostGodot, PlaysAmongGodotsMeshes) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const std::string folder = hostFolder("godot").string();
    const HostRun run =
        runHost(environment(folder, 901) + windowed("godot3") + " --path " + kProject + kWindow + "res://yard.tscn");
    expectGoodRun(run, 4);
    expectSignals(run);
    if (run.images.size() != 4) return;
    expectDifferent(run.images[0], run.images[1], 0.005);  // a hole
    expectDifferent(run.images[1], run.images[2], 0.05);   // an explosion
}

TEST(HostGodot, PlaysWithGodotsPhysicsAndMeshes) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const std::string folder = hostFolder("godot_meshes").string();
    const HostRun run = runHost(environment(folder, 901) + windowed("godot3") + " --path " + kProject + kWindow +
                                "res://yard_meshes.tscn");
    expectGoodRun(run, 4);
    expectSignals(run);
    if (run.images.size() != 4) return;
    expectDifferent(run.images[0], run.images[1], 0.005);
    expectDifferent(run.images[1], run.images[2], 0.05);
}

TEST(HostGodot, AnExportedGameRuns) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const std::string folder = hostFolder("godot_export").string();
    const HostRun exported = runHost(std::string("HOME=") + folder + " godot3-server --path " + kProject +
                                     " --export Linux " + folder + "/yard");
    ASSERT_EQ(exported.exitCode, 0) << exported.output;
    const HostRun run = runHost(environment(folder, 601) + windowed(folder + "/yard") + kWindow);
    expectGoodRun(run, 4);
    expectSignals(run);
}

TEST(HostGodot, AServerPlaysBothKindsOfWorlds) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const std::string folder = hostFolder("godot_server").string();
    for (const char* scene : {"yard", "yard_meshes"})
        expectSignals(runHost(environment(folder, 301) + "godot3-server --path " + kProject + " --fixed-fps 60 res://" +
                              scene + ".tscn"));
}

/// The script of docs/guide/godot.md.
std::string scriptOfThePage() {
    std::ifstream page(RUBBLE_SOURCE_DIR "/docs/guide/godot.md");
    const std::string text(std::istreambuf_iterator<char>(page), {});
    const std::string begin = "```gdscript\n";
    const size_t at = text.find(begin);
    return at == std::string::npos ? "" : text.substr(at + begin.size(), text.find("```", at + 3) - at - begin.size());
}

const char kPageScene[] = R"([gd_scene load_steps=4 format=2]
[ext_resource path="res://page.gd" type="Script" id=1]
[ext_resource path="res://addons/rubble/voxel_world.gdns" type="Script" id=2]
[ext_resource path="res://click.gd" type="Script" id=3]
[node name="Game" type="Spatial"]
script = ExtResource( 1 )
[node name="VoxelWorld" type="Spatial" parent="."]
script = ExtResource( 2 )
level = "res://yard.vox"
[node name="Camera" type="Camera" parent="."]
transform = Transform( 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 1, 4 )
current = true
[node name="Click" type="Node" parent="."]
script = ExtResource( 3 )
)";

const char kClickScript[] = R"(extends Node
var steps = 0
func _physics_process(_delta):
	steps += 1
	if steps == 5:
		var click = InputEventMouseButton.new()
		click.pressed = true
		get_parent()._unhandled_input(click)
	if steps == 30:
		get_tree().quit()
)";

TEST(HostGodot, TheScriptOfThePageBreaksAndListens) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const std::filesystem::path folder = hostFolder("godot_page");
    std::filesystem::create_directory_symlink(std::string(kProject) + "/addons", folder / "addons");
    std::filesystem::copy(std::string(kProject) + "/yard.vox", folder / "yard.vox");
    std::ofstream(folder / "project.godot") << "config_version=4\n[application]\nrun/main_scene=\"res://page.tscn\"\n";
    std::ofstream(folder / "page.gd") << scriptOfThePage();
    std::ofstream(folder / "page.tscn") << kPageScene;
    std::ofstream(folder / "click.gd") << kClickScript;
    const HostRun run =
        runHost("HOME=" + folder.string() + " godot3-server --path " + folder.string() + " --fixed-fps 60");
    EXPECT_NE(run.output.find("a piece of "), std::string::npos) << run.output;
    EXPECT_EQ(run.output.find("SCRIPT ERROR"), std::string::npos) << run.output;
}

TEST(HostGodot, TheInspectorShowsPropertiesAndSignals) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const std::string folder = hostFolder("godot_inspector").string();
    const HostRun run = runHost("HOME=" + folder + " godot3-server --path " + kProject +
                                " -s " RUBBLE_SOURCE_DIR "/tests/samples/hosts/godot_inspect.gd");
    for (const char* line :
         {"voxel_world.level:  \"*.rubble,*.vox\"", "voxel_world.preset: fast \"draft,fast,balanced,accurate\"",
          "voxel_world.godot_lights: True", "voxel_world signals piece_made", "voxel_world signals broken",
          "voxel_world signals hit", "voxel_body.size: (10, 10, 10)", "voxel_body.material: wood \"wood,brick",
          "voxel_body.static: False", "voxel_body signals destroyed", "voxel_character.height: 1.8 \"0.5,3,0.05\"",
          "voxel_world_runtime.level:"})
        EXPECT_NE(run.output.find(line), std::string::npos) << "expected " << line << "\n" << run.output;
}

/// A scene without a level: a floor, a crate and a script, which breaks the crate and loads the world again.
constexpr char kSceneWithoutLevel[] = R"([gd_scene load_steps=4 format=2]
[ext_resource path="res://addons/rubble/voxel_world_runtime.gdns" type="Script" id=1]
[ext_resource path="res://addons/rubble/voxel_body_runtime.gdns" type="Script" id=2]
[ext_resource path="res://main.gd" type="Script" id=3]
[node name="Main" type="Spatial"]
script = ExtResource( 3 )
[node name="World" type="Spatial" parent="."]
script = ExtResource( 1 )
[node name="Floor" type="Spatial" parent="World"]
script = ExtResource( 2 )
size = Vector3( 40, 4, 40 )
static = true
[node name="Crate" type="Spatial" parent="World"]
transform = Transform( 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0 )
script = ExtResource( 2 )
size = Vector3( 12, 12, 12 )
)";
constexpr char kScriptOfReload[] = R"(extends Spatial
var steps = 0
func _physics_process(_delta):
	steps += 1
	if steps == 10: $World.explode(Vector3(0, 1, 0), 1.0)
	if steps == 60: print("bodies before: ", $World.body_count())
	if steps == 60: $World.reload()
	if steps == 70: print("bodies after: ", $World.body_count())
	if steps == 70: get_tree().quit()
)";

TEST(HostGodot, ReloadWithoutALevelKeepsTheNodesBodiesAlone) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const std::filesystem::path folder = hostFolder("godot_reload");
    std::filesystem::copy(std::string(kProject) + "/addons", folder / "addons",
                          std::filesystem::copy_options::recursive);
    std::ofstream(folder / "project.godot") << "config_version=4\n[application]\nrun/main_scene=\"res://main.tscn\"\n";
    std::ofstream(folder / "main.tscn") << kSceneWithoutLevel;
    std::ofstream(folder / "main.gd") << kScriptOfReload;
    const HostRun run = runHost("HOME=" + folder.string() + " godot3-server --fixed-fps 60 --path " + folder.string());
    EXPECT_EQ(run.exitCode, 0) << run.output;
    const size_t before = run.output.find("bodies before: ");
    ASSERT_NE(before, std::string::npos) << run.output;
    EXPECT_GT(std::atoi(run.output.c_str() + before + 15), 3) << "the crate is in pieces";
    EXPECT_NE(run.output.find("bodies after: 2\n"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace rubble
