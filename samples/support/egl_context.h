#pragma once
#include "samples/support/gl_context.h"

namespace rubble {

/// EGL without a surface: on the first device that gives a core context, or on Mesa's surfaceless platform.
class EglContext final : public GlContext {
public:
    static Result<std::unique_ptr<GlContext>> create();
    ~EglContext() override;
    GlLoader loader() const override;
    const char* name() const override { return "EGL"; }

private:
    bool open(void* display);
    void* m_display = nullptr;
    void* m_context = nullptr;
};

}  // namespace rubble
