#include "render/shader_library/uniforms_as_varyings.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string_view>

#include "render/passes/fullscreen.h"
#include "tests/render/gbuffer_fixture.h"

namespace rubble {
namespace {

constexpr const char* kFragment = R"(#version 330 core
layout(std140) uniform FrameBlock {
vec4 sunColor;
ivec4 counters;
} frame;
uniform vec3 uTint;  // linear
uniform sampler2D uImage;
uniform bool uOn;
uniform vec4 uRipples[4];
uniform float uUnused;
out vec4 color;
void main() {
    color = vec4(uTint, 1.0) * frame.sunColor + texelFetch(uImage, ivec2(0), 0) + (uOn ? uRipples[0] : frame.sunColor);
}
)";

TEST(UniformsAsVaryings, ReadUniformsComeFromTheVertexProgram) {
    ShaderSource vertex{"#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n", {}, {}},
        fragment{kFragment, {}, {}};
    passUniformsAsVaryings(vertex, fragment);
    EXPECT_EQ(fragment.text, R"(#version 330 core
flat in vec4 frame_sunColor; layout(std140) uniform FrameBlock {
vec4 sunColor;
ivec4 counters;
} frame;
flat in vec3 flat_uTint;  // linear
uniform sampler2D uImage;
uniform bool uOn;
uniform vec4 uRipples[4];
flat in float flat_uUnused;
out vec4 color;
void main() {
    color = vec4(flat_uTint, 1.0) * frame_sunColor + texelFetch(uImage, ivec2(0), 0))"
                             R"( + (uOn ? uRipples[0] : frame_sunColor);
}
)");
    EXPECT_EQ(vertex.text, R"(#version 330 core
void place() { gl_Position = vec4(0.0); }
layout(std140) uniform FrameBlock {
vec4 sunColor;
ivec4 counters;
} frame;
uniform vec3 uTint;
uniform float uUnused;
flat out vec3 flat_uTint;
flat out float flat_uUnused;
flat out vec4 frame_sunColor;
void main() {
    place();
    flat_uTint = uTint;
    flat_uUnused = uUnused;
    frame_sunColor = frame.sunColor;
}
)");
}

TEST(UniformsAsVaryings, VertexUniformsAreNotDeclaredTwice) {
    ShaderSource vertex{"uniform vec3 uTint;\nvoid main() { gl_Position = vec4(uTint, 1.0); }\n", {}, {}},
        fragment{kFragment, {}, {}};
    passUniformsAsVaryings(vertex, fragment);
    const std::string_view text = vertex.text, declaration = "uniform vec3 uTint;";
    EXPECT_EQ(text.find(declaration), text.rfind(declaration));
}

TEST(UniformsAsVaryings, StayUniformsWhereThereIsNoRoom) {
    ShaderSource vertex{"void main() { gl_Position = vec4(0.0); }\n", {}, {}}, fragment{kFragment, {}, {}};
    passUniformsAsVaryings(vertex, fragment, 1);
    EXPECT_NE(fragment.text.find("flat in vec3 flat_uTint;"), std::string::npos) << fragment.text;
    EXPECT_NE(fragment.text.find("uniform float uUnused;"), std::string::npos) << fragment.text;
    EXPECT_NE(fragment.text.find("vec4(flat_uTint, 1.0) * frame.sunColor"), std::string::npos) << fragment.text;
    EXPECT_EQ(vertex.text.find("frame_sunColor"), std::string::npos) << vertex.text;
}

/// That images are the same to the bit: tests/golden/fullscreen_test.cpp, as compute programs keep their uniforms.
class UniformsAsVaryingsGlTest : public GBufferTest {};

TEST_F(UniformsAsVaryingsGlTest, EveryPassBuilds) {
    size_t passes = 0;
    for (const auto& file : std::filesystem::directory_iterator(shaderFolder() + "/passes")) {
        if (file.path().extension() != ".frag") continue;
        const auto source = readShader(shaderFolder(), "passes/" + file.path().filename().string());
        ASSERT_TRUE(source) << source.error();
        if (source->text.find("in vec2 uv") == std::string::npos) continue;  // not full-screen
        ShaderSource vertex = *readShader(shaderFolder(), "lib/fullscreen.vert"), fragment = *source;
        ShaderSource allOfVertex = vertex, all = fragment;
        passUniformsAsVaryings(allOfVertex, all);
        EXPECT_FALSE(std::regex_search(all.text, std::regex(R"(\bframe\.(?!glsl)[a-z])"))) << file.path();
        passUniformsAsVaryings(vertex, fragment, varyingVectors());
        EXPECT_EQ(std::count(fragment.text.begin(), fragment.text.end(), '\n'),
                  std::count(source->text.begin(), source->text.end(), '\n'));
        std::string log;
        bool vertexFailed = false;
        EXPECT_TRUE(Program(vertex.text, fragment.text, log, vertexFailed)) << file.path() << ": " << log;
        ++passes;
    }
    EXPECT_GE(passes, 15u);
}

}  // namespace
}  // namespace rubble
