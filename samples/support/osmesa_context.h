#pragma once
#include <vector>

#include "samples/support/gl_context.h"

struct osmesa_context;

namespace rubble {

/// Mesa's off-screen software renderer.
class OsMesaContext final : public GlContext {
public:
    static Result<std::unique_ptr<GlContext>> create();
    ~OsMesaContext() override;
    GlLoader loader() const override;
    const char* name() const override { return "OSMesa"; }

private:
    osmesa_context* m_context = nullptr;
    std::vector<unsigned char> m_pixels;  ///< OSMesa wants a default framebuffer in our memory, used or not
};

}  // namespace rubble
