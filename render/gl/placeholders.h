#pragma once
#include <vector>

#include "render/gl/texture.h"

namespace rubble {

/// Textures of a few texels, one of each kind that was asked for. Samplers read them where a scene has no texture for
/// them: drivers build a program again when it first draws with another kind of texture, and a game would stop there.
/// [render-thread]
class Placeholders {
public:
    /// The texture itself, or one of its kind if it holds none.
    const Texture& orOfItsKind(const Texture& texture);
    /// The same for arrays of texels.
    const BufferTexture& orOfItsKind(const BufferTexture& texture);

private:
    std::vector<Texture> m_textures;
    std::vector<BufferTexture> m_arrays;
};

}  // namespace rubble
