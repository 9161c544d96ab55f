#pragma once
#include <zlib.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

namespace rubble {

/// Writes .vox files chunk by chunk. It checks nothing, so it can write invalid files too.
class VoxWriter {
public:
    using Bytes = std::vector<uint8_t>;
    using Attributes = std::map<std::string, std::string>;

    /// Appends 32 bits, little-endian.
    static void put(Bytes& out, uint32_t value) {
        for (int i = 0; i < 4; ++i) out.push_back(uint8_t(value >> (8 * i)));
    }
    /// Appends a length and a text.
    static void put(Bytes& out, const std::string& text) {
        put(out, uint32_t(text.size()));
        out.insert(out.end(), text.begin(), text.end());
    }
    /// Appends a number of pairs and the pairs.
    static void put(Bytes& out, const Attributes& attributes) {
        put(out, uint32_t(attributes.size()));
        for (const auto& [key, value] : attributes) put(out, key), put(out, value);
    }

    /// Adds a chunk of any kind.
    VoxWriter& chunk(const char* kind, const Bytes& content) {
        m_chunks.insert(m_chunks.end(), kind, kind + 4);
        put(m_chunks, uint32_t(content.size()));
        put(m_chunks, 0u);
        m_chunks.insert(m_chunks.end(), content.begin(), content.end());
        return *this;
    }
    /// Adds SIZE and XYZI; voxels as x, y, z, colour index.
    VoxWriter& model(glm::ivec3 size, const std::vector<std::array<uint8_t, 4>>& voxels) {
        Bytes content;
        for (int i = 0; i < 3; ++i) put(content, uint32_t(size[i]));
        chunk("SIZE", content);
        content.clear();
        put(content, uint32_t(voxels.size()));
        for (const auto& voxel : voxels) content.insert(content.end(), voxel.begin(), voxel.end());
        return chunk("XYZI", content);
    }
    /// Adds a TDCZ chunk, as Teardown writes it, and a SIZE chunk before it if wished: cells with x fastest, then y.
    /// The zlib stream is not closed.
    VoxWriter& packedModel(glm::ivec3 size, const Bytes& cells, bool hasSize = true) {
        Bytes sizes;
        for (int i = 0; i < 3; ++i) put(sizes, uint32_t(size[i]));
        if (hasSize) chunk("SIZE", sizes);
        z_stream stream{};
        deflateInit(&stream, Z_BEST_COMPRESSION);
        Bytes packed(deflateBound(&stream, uLong(cells.size())) + 64);
        stream.next_in = const_cast<Bytef*>(cells.data()), stream.avail_in = uInt(cells.size());
        stream.next_out = packed.data(), stream.avail_out = uInt(packed.size());
        deflate(&stream, Z_SYNC_FLUSH);
        packed.erase(packed.end() - std::ptrdiff_t(stream.avail_out), packed.end());
        deflateEnd(&stream);
        Bytes content = sizes;
        content.insert(content.end(), packed.begin(), packed.end());
        return chunk("TDCZ", content);
    }
    /// Adds an nTRN node: a pose for each frame.
    VoxWriter& transform(int id, int child, const std::vector<Attributes>& frames, const Attributes& attributes = {},
                         int layer = -1) {
        Bytes content;
        put(content, uint32_t(id)), put(content, attributes), put(content, uint32_t(child)), put(content, uint32_t(-1)),
            put(content, uint32_t(layer));
        put(content, uint32_t(frames.size()));
        for (const auto& frame : frames) put(content, frame);
        return chunk("nTRN", content);
    }
    /// Adds an nGRP node.
    VoxWriter& group(int id, const std::vector<int>& children) {
        Bytes content;
        put(content, uint32_t(id)), put(content, Attributes{}), put(content, uint32_t(children.size()));
        for (int child : children) put(content, uint32_t(child));
        return chunk("nGRP", content);
    }
    /// Adds an nSHP node: a model for each frame.
    VoxWriter& shape(int id, const std::vector<int>& models) {
        Bytes content;
        put(content, uint32_t(id)), put(content, Attributes{}), put(content, uint32_t(models.size()));
        for (size_t i = 0; i < models.size(); ++i)
            put(content, uint32_t(models[i])), put(content, Attributes{{"_f", std::to_string(i * 10)}});
        return chunk("nSHP", content);
    }
    /// Adds a chunk of an id and attributes (LAYR, MATL, rCAM).
    VoxWriter& described(const char* kind, int id, const Attributes& attributes) {
        Bytes content;
        put(content, uint32_t(id)), put(content, attributes);
        if (std::string(kind) == "LAYR") put(content, uint32_t(-1));
        return chunk(kind, content);
    }
    /// Adds RGBA, or the first colours of one.
    VoxWriter& colors(const std::array<std::array<uint8_t, 4>, 256>& colors, size_t count = 256) {
        Bytes content;
        for (size_t i = 0; i < count; ++i) content.insert(content.end(), colors[i].begin(), colors[i].end());
        return chunk("RGBA", content);
    }
    /// The file: header, MAIN and all chunks.
    Bytes file(uint32_t version = 150) const {
        Bytes out{'V', 'O', 'X', ' '};
        put(out, version);
        out.insert(out.end(), {'M', 'A', 'I', 'N'});
        put(out, 0u), put(out, uint32_t(m_chunks.size()));
        out.insert(out.end(), m_chunks.begin(), m_chunks.end());
        return out;
    }

private:
    Bytes m_chunks;
};

}  // namespace rubble
