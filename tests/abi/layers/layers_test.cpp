#include <gtest/gtest.h>

#include <string>

#include "tests/abi/run_command.h"

namespace rubble {
namespace {

/// What tests/abi/layers/layer_host.c says of a library, which it has loaded and unloaded three times.
std::string hostOf(const std::string& library) {
    int exitCode = 0;
    const std::string text = runCommand(RUBBLE_LAYER_HOST " " + library, exitCode);
    EXPECT_EQ(exitCode, 0) << text;
    return text;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Names of libraries of OpenGL and of windows.
bool hasGl(const std::string& text) {
    return has(text, "libGL") || has(text, "libEGL") || has(text, "libOSMesa") || has(text, "libglfw") ||
           has(text, "libX11");
}

TEST(Layers, TheRuntimeLoadsNeitherGlNorBullet) {
    const std::string text = hostOf(RUBBLE_RUNTIME);
    EXPECT_TRUE(has(text, "layers: 0\n")) << text;
    EXPECT_TRUE(has(text, "librubble-runtime")) << text;
    EXPECT_FALSE(has(text, "Bullet") || has(text, "LinearMath") || hasGl(text)) << text;
    EXPECT_TRUE(has(text, "refused: create_world: this library has no physics")) << text;
    EXPECT_TRUE(has(text, "refused: create_renderer: this library has no renderer")) << text;
}

TEST(Layers, PhysicsBringsBulletAndNoGl) {
    const std::string text = hostOf(RUBBLE_WITH_PHYSICS);
    EXPECT_TRUE(has(text, "layers: 1\n")) << text;
    EXPECT_TRUE(has(text, "librubble-physics") && has(text, "libBulletCollision")) << text;
    EXPECT_FALSE(hasGl(text)) << text;
    EXPECT_TRUE(has(text, "refused: create_renderer: this library has no renderer")) << text;
}

TEST(Layers, AllOfItHasBoth) {
    const std::string text = hostOf(RUBBLE_ALL);
    EXPECT_TRUE(has(text, "layers: 3\n")) << text;
    EXPECT_FALSE(hasGl(text)) << "the host brings GL: " << text;
}

/// No module of a layer that a library lacks is in it under another name: GL's functions and shaders are the
/// renderer's.
TEST(Layers, WhatALayerHasIsNotInTheOthers) {
    int exitCode = 0;
    const auto bytesOf = [&](const char* library) {
        return std::stoul(runCommand(std::string("stat -L -c %s ") + library, exitCode));
    };
    EXPECT_LT(bytesOf(RUBBLE_RUNTIME), bytesOf(RUBBLE_WITH_PHYSICS));
    EXPECT_LT(bytesOf(RUBBLE_WITH_PHYSICS), bytesOf(RUBBLE_ALL));
    for (const char* library : {RUBBLE_RUNTIME, RUBBLE_WITH_PHYSICS})
        EXPECT_EQ(runCommand(std::string("grep -c -a gl_Position ") + library, exitCode), "0\n") << library;
    EXPECT_NE(runCommand("grep -c -a gl_Position " RUBBLE_ALL, exitCode), "0\n");
}

}  // namespace
}  // namespace rubble
