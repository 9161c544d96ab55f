#pragma once
#include <memory>

#include "samples/support/gl_context.h"

namespace rubble {

/// A context by EGL without a surface: on the first device that provides one, else on Mesa's surfaceless platform.
class EglContext final : public GlContext {
public:
    /// isEmbedded: of OpenGL ES 3.0. An error if no device provides that, or a core context of a wanted version.
    static Result<std::unique_ptr<GlContext>> create(bool isEmbedded = false);
    ~EglContext() override;
    GlLoader loader() const override;
    void makeCurrent() override;

private:
    bool open(void* display, bool isEmbedded);
    void* m_display = nullptr;
    void* m_context = nullptr;
};

}  // namespace rubble
