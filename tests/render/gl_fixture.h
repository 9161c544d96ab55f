#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "generated/paths.h"
#include "render/gl/gl.h"
#include "samples/support/gl_context.h"

namespace rubble {

/// The kind of the tests' contexts: OSMesa, unless RUBBLE_TEST_GL names another.
inline GlContext::Kind testContextKind() {
    const char* kind = std::getenv("RUBBLE_TEST_GL");
    return GlContext::kindOf(kind ? kind : "osmesa");
}
/// One context for all tests of the program.
inline GlContext& testContext() {
    static const auto context = [] {
        auto made = GlContext::create(testContextKind());
        if (!made || !loadGl(made.value()->loader())) std::abort();
        return std::move(made).value();
    }();
    return *context;
}

class GlTest : public ::testing::Test {
protected:
    void SetUp() override { testContext(); }
    void TearDown() override { EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)); }
    static std::string shaderFolder() { return RUBBLE_SOURCE_DIR "/shaders"; }
};

}  // namespace rubble
