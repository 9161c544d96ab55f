#pragma once
#include <memory>
#include <vector>

#include "render/frame/frame_camera.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/test_scene.h"

namespace rubble {

/// The G-buffer alone: scene, camera and pass, and its targets read back.
class GBufferTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        shaders = std::make_unique<ShaderLibrary>(shaderFolder());
        pass = std::make_unique<GBufferPass>(*shaders);
        ASSERT_TRUE(shaders->errors().empty()) << shaders->errors().front();
    }
    void TearDown() override {
        glUseProgram(0);
        GlTest::TearDown();
    }
    void draw(Scene& scene, const View& view, float alpha = 1.0f, bool jittered = false) {
        uploaded = scene.beginFrame(alpha, view.position);
        targets.beginFrame(view.size, view.size, view.cut);
        camera.begin(view, view.size, jittered, scene.origin(), block);
        scene.describe(block);
        glBindBuffer(GL_UNIFORM_BUFFER, blockBuffer.get());
        glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, blockBuffer.get());
        figures = {};
        pass->draw(context(scene));
    }
    FrameContext context(const Scene& scene) {
        return {block, settings, scene, targets, noise, figures, emptyVertexArray};
    }
    /// Its pixels, rows from the bottom.
    std::vector<glm::vec4> read(const Texture& texture) {
        std::vector<glm::vec4> out(size_t(texture.size().x) * size_t(texture.size().y));
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, out.data());
        return out;
    }

    std::unique_ptr<ShaderLibrary> shaders;
    std::unique_ptr<GBufferPass> pass;
    TargetPool targets;
    FrameCamera camera;
    FrameBlock block{};
    RenderSettings settings;
    RenderStats figures;
    Texture noise;
    GlName<BufferKind> blockBuffer = makeBlockBuffer();
    VertexArray emptyVertexArray = VertexArray::make();
    uint64_t uploaded = 0;

private:
    static GlName<BufferKind> makeBlockBuffer() {
        testContext();
        return GlName<BufferKind>::make();
    }
};

}  // namespace rubble
