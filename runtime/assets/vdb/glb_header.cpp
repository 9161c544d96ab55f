#include "runtime/assets/vdb/glb_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "runtime/assets/vdb/mesh.h"

namespace rubble {
namespace {

using nlohmann::json;
using Bytes = std::span<const uint8_t>;

constexpr size_t kNoEntry = SIZE_MAX;
constexpr size_t kMaxDepth = 256;  ///< nodes from a root down
constexpr uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr size_t kByte = 5121, kShort = 5123, kWord = 5125, kFloat = 5126;  ///< componentType

template <class... Args>
[[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) {
    throw std::runtime_error(fmt::format(text, std::forward<Args>(args)...));
}

uint32_t wordAt(Bytes bytes, size_t at) {
    uint32_t word = 0;
    if (at + sizeof word > bytes.size()) fail("byte {}: expected more bytes, found the end of the file", at);
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

/// A whole number, as counts, offsets and places in lists are.
size_t wholeOf(const json& value, const std::string& where) {
    if (value.is_number_unsigned() && value.get<uint64_t>() <= UINT32_MAX) return value.get<size_t>();
    fail("{}: expected a whole number from 0 on, found {}", where, value.dump().substr(0, 40));
}

size_t wholeOf(const json& object, const char* key, size_t otherwise, const std::string& where) {
    const auto found = object.find(key);
    return found == object.end() ? otherwise : wholeOf(*found, where + ", " + key);
}

/// A list of the file; empty if it is absent.
const json& listOf(const json& object, const char* key) {
    static const json kEmpty = json::array();
    const auto found = object.find(key);
    if (found == object.end()) return kEmpty;
    if (!found->is_array()) fail("{}: expected a list, found another value", key);
    return *found;
}

const json& elementOf(const json& list, size_t index, const std::string& where) {
    if (index < list.size()) return list[index];
    fail("{}: expected a number below {}, found {}", where, list.size(), index);
}

/// The chunks of a file, and what is wrong with them.
class GlbFile {
public:
    explicit GlbFile(Bytes bytes) {
        if (wordAt(bytes, 0) != kMagic) fail("expected a binary glTF file, which begins with 'glTF'");
        if (const uint32_t version = wordAt(bytes, 4); version != 2) fail("expected version 2, found {}", version);
        for (size_t at = 12; at < bytes.size();) {
            const size_t size = wordAt(bytes, at), left = bytes.size() - std::min(at + 8, bytes.size());
            const uint32_t kind = wordAt(bytes, at + 4);
            if (size > left) fail("byte {}: expected a chunk of at most {} bytes, found {}", at, left, size);
            const Bytes chunk = bytes.subspan(at + 8, size);
            if (at == 12 && kind == kJsonChunk) m_json = json::parse(chunk.begin(), chunk.end());
            if (at > 12 && kind == kBinaryChunk && m_binary.empty()) m_binary = chunk;
            at += 8 + size;
        }
        if (!m_json.is_object()) fail("byte 12: expected a chunk of JSON with an object, found none");
    }

    void check() {
        checkExtensions();
        checkNodes();
        const json& meshes = listOf(m_json, "meshes");
        for (size_t m = 0; m < meshes.size(); ++m) {
            const json& primitives = listOf(meshes[m], "primitives");
            for (size_t p = 0; p < primitives.size(); ++p)
                checkPrimitive(primitives[p], fmt::format("mesh {}, primitive {}", m, p));
        }
    }

private:
    void checkExtensions() const {
        for (const json& each : listOf(m_json, "extensionsRequired"))
            if (each == "KHR_draco_mesh_compression" || each == "EXT_meshopt_compression")
                fail("extensionsRequired: expected meshes that are not compressed, found {}", each.dump());
    }

    /// A node has one parent at most, and roots have none: then each is visited once.
    void checkNodes() const {
        const json& nodes = listOf(m_json, "nodes");
        std::vector<size_t> parents(nodes.size(), kNoEntry);
        for (size_t i = 0; i < nodes.size(); ++i)
            for (const json& each : listOf(nodes[i], "children")) {
                const size_t child = wholeOf(each, fmt::format("node {}, children", i));
                elementOf(nodes, child, fmt::format("node {}, children", i));
                if (parents[child] != kNoEntry)
                    fail("node {}: expected one parent, found node {} and node {}", child, parents[child], i);
                parents[child] = i;
            }
        checkDepth(parents);
        const json& scenes = listOf(m_json, "scenes");
        for (size_t s = 0; s < scenes.size(); ++s) {
            const std::string where = fmt::format("scene {}, nodes", s);
            std::vector<bool> isRoot(nodes.size(), false);
            for (const json& each : listOf(scenes[s], "nodes")) {
                const size_t root = wholeOf(each, where);
                elementOf(nodes, root, where);
                if (parents[root] != kNoEntry)
                    fail("{}: expected nodes without a parent, found node {}, a child of node {}", where, root,
                         parents[root]);
                if (isRoot[root]) fail("{}: expected each node once, found node {} twice", where, root);
                isRoot[root] = true;
            }
        }
    }

    static void checkDepth(const std::vector<size_t>& parents) {
        for (size_t i = 0; i < parents.size(); ++i) {
            size_t depth = 0;
            for (size_t at = parents[i]; at != kNoEntry; at = parents[at])
                if (++depth > kMaxDepth)
                    fail("node {}: expected at most {} nodes above it, found more: a cycle?", i, kMaxDepth);
        }
    }

    void checkPrimitive(const json& primitive, const std::string& where) {
        const json& accessors = listOf(m_json, "accessors");
        const auto attributes = primitive.find("attributes");
        if (attributes == primitive.end() || !attributes->is_object() || !attributes->contains("POSITION")) return;
        const json& points = elementOf(accessors, wholeOf((*attributes)["POSITION"], where), where + ", POSITION");
        if (const json type = points.value("componentType", json()); type != kFloat)
            fail("{}, POSITION: expected componentType {} (float), found {}", where, kFloat, type.dump().substr(0, 40));
        const size_t index = wholeOf(primitive, "indices", kNoEntry, where);
        if (index == kNoEntry) return;
        elementOf(accessors, index, where + ", indices");
        const size_t count = wholeOf(points, "count", 0, where + ", POSITION");
        const auto [largest, isNew] = m_largest.try_emplace(index, 0);
        if (isNew) largest->second = largestIndex(accessors[index], fmt::format("accessor {}", index));
        if (largest->second >= int64_t(count))
            fail("{}: expected indices below {}, its count of vertices, found {}", where, count, largest->second);
    }

    /// Of the indices of an accessor; -1: it has none, or they are in another file.
    int64_t largestIndex(const json& accessor, const std::string& where) {
        const size_t view = wholeOf(accessor, "bufferView", kNoEntry, where);
        if (view == kNoEntry) return -1;
        const json& from = elementOf(listOf(m_json, "bufferViews"), view, where + ", bufferView");
        const size_t buffer = wholeOf(from, "buffer", 0, where);
        if (buffer != 0 || elementOf(listOf(m_json, "buffers"), buffer, where).contains("uri")) return -1;
        const size_t type = wholeOf(accessor, "componentType", 0, where);
        if (type != kByte && type != kShort && type != kWord)
            fail("{}: expected componentType {}, {} or {} of indices, found {}", where, kByte, kShort, kWord, type);
        const size_t size = type == kByte ? 1 : type == kShort ? 2 : 4;
        const size_t count = wholeOf(accessor, "count", 0, where);
        const size_t at = wholeOf(from, "byteOffset", 0, where) + wholeOf(accessor, "byteOffset", 0, where);
        if (at + count * size > m_binary.size())
            fail("{}: expected data within the {} bytes of the file, found {} bytes from {} on", where, m_binary.size(),
                 count * size, at);
        m_indices += count;
        if (m_indices > 3 * kMaxMeshTriangles)
            fail("{}: expected at most {} indices in all, found more", where, 3 * kMaxMeshTriangles);
        int64_t largest = -1;
        for (size_t i = 0; i < count; ++i) {
            uint32_t index = 0;
            std::memcpy(&index, m_binary.data() + at + i * size, size);
            largest = std::max(largest, int64_t(index));
        }
        return largest;
    }

    json m_json;
    Bytes m_binary;
    std::map<size_t, int64_t> m_largest;  ///< index of accessors
    size_t m_indices = 0;                 ///< read
};

}  // namespace

std::string glbError(std::span<const uint8_t> bytes) {
    try {
        GlbFile(bytes).check();
    } catch (const json::exception& error) {
        return fmt::format("expected glTF in JSON, found other text: {}", error.what());
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace rubble
