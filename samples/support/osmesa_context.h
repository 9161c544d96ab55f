#pragma once
#include <memory>
#include <vector>

#include "samples/support/gl_context.h"

struct osmesa_context;

namespace rubble {

/// A context of Mesa's off-screen software renderer.
class OsMesaContext final : public GlContext {
public:
    enum class Profile { Core, Compatibility };
    /// An error if libosmesa provides no context of a wanted version.
    static Result<std::unique_ptr<GlContext>> create(Profile profile = Profile::Core);
    ~OsMesaContext() override;
    GlLoader loader() const override;
    void makeCurrent() override;

private:
    osmesa_context* m_context = nullptr;
    std::vector<unsigned char> m_pixels;  ///< the default framebuffer that OSMesa requires; never drawn into
};

}  // namespace rubble
