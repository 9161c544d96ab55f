#include "render/gl/placeholders.h"

#include <algorithm>
#include <bit>

namespace rubble {
namespace {

/// The size of a placeholder: llvmpipe tells apart textures with sides that are powers of two.
glm::ivec2 smallSize(glm::ivec2 size) {
    const auto side = [](int texels) { return std::has_single_bit(unsigned(texels)) ? 2 : 3; };
    return {side(size.x), side(size.y)};
}

}  // namespace

const Texture& Placeholders::orOfItsKind(const Texture& texture) {
    if (texture || !texture.internalFormat()) return texture;
    const glm::ivec2 size = smallSize(texture.size());
    const auto found = std::find_if(m_textures.begin(), m_textures.end(), [&](const Texture& each) {
        return each.internalFormat() == texture.internalFormat() && each.size() == size &&
               each.filter() == texture.filter() && each.wrap() == texture.wrap();
    });
    if (found != m_textures.end()) return *found;
    return m_textures.emplace_back(texture.internalFormat(), size, texture.filter(), texture.wrap());
}

const BufferTexture& Placeholders::orOfItsKind(const BufferTexture& texture) {
    if (texture.name() || !texture.internalFormat()) return texture;
    const auto found = std::find_if(m_arrays.begin(), m_arrays.end(), [&](const BufferTexture& each) {
        return each.internalFormat() == texture.internalFormat();
    });
    if (found != m_arrays.end()) return *found;
    BufferTexture& made = m_arrays.emplace_back(texture.internalFormat());
    made.reserve(1);
    return made;
}

}  // namespace rubble
