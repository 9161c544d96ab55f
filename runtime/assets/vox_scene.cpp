#include "runtime/assets/vox_scene.h"

#include <fmt/format.h>

#include <charconv>
#include <set>
#include <string_view>

#include "runtime/assets/names.h"

namespace rubble {
namespace {

constexpr int kMaxDepth = 64;               // nested nodes
constexpr size_t kMaxInstances = 65536;     // objects of a level
constexpr size_t kMaxVisits = 1u << 20;     // nodes can share children, so a short file can describe a huge tree
constexpr int64_t kMaxOffset = 10'000'000;  // cells: 1,000 km of 0.1 m

std::string_view attribute(const VoxAttributes& attributes, const char* key) {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string_view() : found->second;
}

/// Parses the rotation byte: the column of the non-zero entry in rows 0 and 1 (two bits each), then a sign bit for each
/// row.
bool parseRotation(std::string_view text, VoxTransform& out) {
    unsigned bits = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), bits);
    if (code != std::errc{} || end != text.data() + text.size() || bits > 127) return false;
    const unsigned first = bits & 3, second = bits >> 2 & 3;
    if (first > 2 || second > 2 || first == second) return false;
    out.axis = {uint8_t(first), uint8_t(second), uint8_t(3 - first - second)};
    for (size_t row = 0; row < 3; ++row) out.sign[row] = bits >> (4 + row) & 1 ? -1 : 1;
    return true;
}

bool parseOffset(std::string_view text, VoxTransform& out) {
    const char* at = text.data();
    const char* end = at + text.size();
    for (int64_t& value : out.offset) {
        while (at != end && *at == ' ') ++at;
        const auto parsed = std::from_chars(at, end, value);
        if (parsed.ec != std::errc{} || value < -kMaxOffset || value > kMaxOffset) return false;
        at = parsed.ptr;
    }
    return at == end;
}

/// Visits the scene graph depth first, children in the file's order.
class SceneWalker {
public:
    SceneWalker(const VoxFile& file, const std::string& fileName) : m_file(file), m_fileName(fileName) {}

    struct State {
        VoxTransform transform;
        std::string name, layer;
        bool hidden = false;
        int skippedPoses = 0;
        int depth = 0;
    };

    void visit(int32_t id, State state, size_t fromOffset) {
        if (!m_error.empty()) return;
        const auto found = m_file.nodes.find(id);
        if (found == m_file.nodes.end())
            return fail(fromOffset, "a node of the scene as child", fmt::format("id {}, which does not exist", id));
        const VoxNode& node = found->second;
        if (++state.depth > kMaxDepth)
            return fail(node.offset, fmt::format("at most {} nested nodes", kMaxDepth), "more (a cycle?)");
        if (++m_visits > kMaxVisits)
            return fail(node.offset, fmt::format("at most {} nodes in all", kMaxVisits), "more");
        if (const auto name = attribute(node.attributes, "_name"); !name.empty()) state.name = printableName(name);
        state.hidden = state.hidden || attribute(node.attributes, "_hidden") == "1";
        if (node.kind == VoxNodeKind::Transform && !enterTransform(node, state)) return;
        if (node.kind == VoxNodeKind::Shape) return addShape(node, state);
        for (int32_t child : node.children) visit(child, state, node.offset);
    }

    Result<std::vector<VoxInstance>> take() {
        if (!m_error.empty()) return Error{m_error};
        return std::move(m_instances);
    }

private:
    bool enterTransform(const VoxNode& node, State& state) {
        VoxTransform local;
        if (!node.frames.empty()) {
            const std::string_view rotation = attribute(node.frames[0], "_r"), offset = attribute(node.frames[0], "_t");
            if (!rotation.empty() && !parseRotation(rotation, local))
                return fail(node.offset, "a rotation byte (two different columns and three signs)",
                            "'" + printableName(rotation) + "'"),
                       false;
            if (!offset.empty() && !parseOffset(offset, local))
                return fail(node.offset, fmt::format("a translation of three whole numbers up to {}", kMaxOffset),
                            "'" + printableName(offset) + "'"),
                       false;
            state.skippedPoses += int(node.frames.size()) - 1;
        }
        state.transform = state.transform * local;
        const auto layer = m_file.layers.find(node.layer);
        if (layer != m_file.layers.end()) {
            const std::string_view name = attribute(layer->second.attributes, "_name");
            state.layer = name.empty() ? std::to_string(node.layer) : printableName(name);
            state.hidden = state.hidden || attribute(layer->second.attributes, "_hidden") == "1";
        }
        return true;
    }

    void addShape(const VoxNode& node, const State& state) {
        for (size_t frame = 0; frame < node.children.size(); ++frame) {
            const int32_t model = node.children[frame];
            if (model < 0 || size_t(model) >= m_file.models.size())
                return fail(node.offset, fmt::format("a model number below {}", m_file.models.size()),
                            std::to_string(model));
            if (m_instances.size() == kMaxInstances)
                return fail(node.offset, fmt::format("at most {} objects", kMaxInstances), "more");
            for (int64_t value : state.transform.offset)
                if (value < -kMaxOffset || value > kMaxOffset)
                    return fail(node.offset, fmt::format("an object within {} cells of the origin", kMaxOffset),
                                std::to_string(value));
            m_instances.push_back({model, state.transform, state.name, state.layer, state.hidden || frame > 0,
                                   int(frame), frame ? 0 : state.skippedPoses});
        }
    }

    void fail(size_t offset, const std::string& expected, const std::string& found) {
        if (m_error.empty())
            m_error =
                fmt::format("{}: byte {}, scene node: expected {}, found {}", m_fileName, offset, expected, found);
    }

    const VoxFile& m_file;
    const std::string& m_fileName;
    std::vector<VoxInstance> m_instances;
    std::string m_error;
    size_t m_visits = 0;
};

}  // namespace

VoxTransform operator*(const VoxTransform& parent, const VoxTransform& child) {
    VoxTransform out;
    for (size_t i = 0; i < 3; ++i) {
        const size_t from = parent.axis[i];
        out.axis[i] = child.axis[from];
        out.sign[i] = int8_t(parent.sign[i] * child.sign[from]);
        out.offset[i] = parent.sign[i] * child.offset[from] + parent.offset[i];
    }
    return out;
}

Result<std::vector<VoxInstance>> voxInstances(const VoxFile& file, const std::string& fileName) {
    if (file.nodes.empty()) {
        std::vector<VoxInstance> instances;
        int64_t x = 0;
        for (size_t i = 0; i < file.models.size(); ++i) {
            const glm::ivec3 size = file.models[i].size;
            VoxInstance instance;
            instance.model = int(i);
            instance.transform.offset = {i ? x + size.x / 2 : 0, 0, size.z / 2};
            x = instance.transform.offset[0] - size.x / 2 + size.x + 1;
            instances.push_back(instance);
        }
        return instances;
    }
    SceneWalker walker(file, fileName);
    std::set<int32_t> children;
    for (const auto& [id, node] : file.nodes)
        if (node.kind != VoxNodeKind::Shape) children.insert(node.children.begin(), node.children.end());
    bool anyRoot = false;
    for (const auto& [id, node] : file.nodes)
        if (!children.contains(id)) walker.visit(id, {}, node.offset), anyRoot = true;
    if (!anyRoot)
        return Error{fmt::format("{}: byte {}, scene node: expected a node that is no child of another, found a cycle",
                                 fileName, file.nodes.begin()->second.offset)};
    return walker.take();
}

}  // namespace rubble
