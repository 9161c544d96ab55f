#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "render/gl/offscreen.h"
#include "render/renderer.h"
#include "samples/support/image.h"
#include "tests/golden/lit_scene.h"
#include "tests/render/gl_fixture.h"

namespace rubble {

/// A test fixture with a renderer and an offscreen target, which draws scenes and reads what any pass has written.
class Drawing : public GlTest {
protected:
    /// Makes the renderer and the target and loads the scene.
    void start(const LitScene& scene, glm::ivec2 size, const RenderSettings& settings = {}) {
        auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
        ASSERT_TRUE(made) << made.error();
        renderer = std::move(made).value();
        renderer->apply(scene.snapshot());
        target = std::make_unique<Offscreen>(size);
    }
    /// Draws `frames` frames and returns the last one as the view `pass` shows it.
    Image draw(const Camera& camera, int frames = 1, const char* pass = "final") {
        EXPECT_TRUE(renderer->showPass(pass)) << pass;
        for (int i = 0; i < frames; ++i) renderer->draw(camera.view(target->size(), target->framebuffer()), 1.0f);
        Image image(target->size().x, target->size().y);
        image.rgb = target->readRgb();
        return image;
    }
    /// A target's numbers. A name that no pass has drawn fails the test and gives an empty image.
    FloatImage read(const char* name) const {
        auto image = renderer->readTarget(name);
        EXPECT_TRUE(image) << image.error();
        return image ? std::move(*image) : FloatImage();
    }
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<Offscreen> target;
};

}  // namespace rubble
