// OpenVDB files (.vdb) as the library writes them, with lying contents: grids of wrong names, types, transforms and
// extents, wrong metadata. Their headers are also read with bytes changed. What the grids' own bytes hold is OpenVDB's.
#include <openvdb/openvdb.h>

#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "runtime/assets/file_bytes.h"
#include "runtime/assets/rubble_file.h"
#include "runtime/assets/vdb/level_json.h"
#include "runtime/assets/vdb/vdb_file.h"
#include "runtime/assets/vdb/vdb_header.h"
#include "runtime/world/world.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/random_world.h"
#include "tests/fuzz/scratch_folder.h"
#include "tests/fuzz/stages.h"

namespace rubble {
namespace {

using openvdb::Coord;
using openvdb::CoordBBox;
using openvdb::math::Transform;

/// Mostly with coordinates that are not negative: for each octant that is used the library makes 37,000 entries.
Coord randomCell(Decisions& decisions) {
    Coord cell;
    for (int i = 0; i < 3; ++i) {
        const bool isFar = decisions.oneIn(400), isNegative = decisions.oneIn(100);
        cell[i] = isFar ? int(uint32_t(decisions.bits())) : int(decisions.below(14)) * (isNegative ? -1 : 1);
    }
    return cell;
}

/// Sets some cells, and now and then all of a box. valueOf(): the value of the next.
template <class Grid, class ValueOf>
typename Grid::Ptr filledGrid(Decisions& decisions, ValueOf valueOf) {
    auto grid = Grid::create(typename Grid::ValueType(decisions.oneIn(16) ? valueOf() : typename Grid::ValueType(0)));
    for (uint32_t i = decisions.below(12); i-- > 0;) {
        if (decisions.oneIn(12))
            grid->tree().setValueOff(randomCell(decisions), valueOf());
        else
            grid->tree().setValueOn(randomCell(decisions), valueOf());
    }
    if (decisions.oneIn(8)) {  // large boxes are tiles of the library, or else they would be millions of cells
        const int side = decisions.oneIn(100) ? 4096 : decisions.oneIn(20) ? 128 : 8;
        const Coord low = randomCell(decisions) & -side;
        grid->sparseFill(CoordBBox(low, low.offsetBy(side - 1)), valueOf());
    }
    return grid;
}

openvdb::GridBase::Ptr gridOfAnyType(Decisions& decisions) {
    const auto real = [&] { return decisions.oneIn(2) ? float(decisions.unit()) : float(decisions.wild()); };
    switch (decisions.below(7)) {
        case 0:
            return filledGrid<openvdb::BoolGrid>(decisions, [&] { return decisions.oneIn(2); });
        case 1: {
            auto mask = openvdb::MaskGrid::create();
            for (uint32_t i = decisions.below(9); i-- > 0;) mask->tree().setValueOn(randomCell(decisions));
            return mask;
        }
        case 2:
            return filledGrid<openvdb::Vec3SGrid>(decisions, [&] { return openvdb::Vec3f(real(), real(), real()); });
        case 3:
            return filledGrid<openvdb::DoubleGrid>(decisions, [&] { return decisions.wild(); });
        default:
            return filledGrid<openvdb::FloatGrid>(decisions, real);
    }
}

openvdb::GridBase::Ptr indexGrid(Decisions& decisions) {
    return filledGrid<openvdb::Int32Grid>(decisions, [&] {
        return decisions.oneIn(200) ? int32_t(uint32_t(decisions.bits())) : int32_t(decisions.below(256));
    });
}

Transform::Ptr randomTransform(Decisions& decisions) {
    if (decisions.oneIn(64))
        return Transform::createFrustumTransform(openvdb::BBoxd(openvdb::Vec3d(0), openvdb::Vec3d(9)), 0.5, 2.0, 0.1);
    auto out = Transform::createLinearTransform(decisions.oneIn(16) ? decisions.wild() : 0.1);
    if (decisions.oneIn(4)) out->postRotate(decisions.unit(), openvdb::math::Y_AXIS);
    if (decisions.oneIn(16)) out->preScale(openvdb::Vec3d(decisions.wild(), 1.0, 1.0));
    if (decisions.oneIn(16)) out->postShear(decisions.wild(), openvdb::math::X_AXIS, openvdb::math::Z_AXIS);
    const glm::dvec3 at = decisions.place();
    out->postTranslate(openvdb::Vec3d(at.x, at.y, at.z));
    return out;
}

void finishGrid(Decisions& decisions, const std::string& name, openvdb::GridBase& grid) {
    grid.setName(decisions.oneIn(64) ? std::string(decisions.below(9), char(decisions.below(256))) : name);
    grid.setTransform(randomTransform(decisions));
    if (decisions.oneIn(3)) grid.setGridClass(openvdb::GridClass(decisions.below(4)));
    if (decisions.oneIn(16)) grid.setSaveFloatAsHalf(true);
}

/// The texts of a level's metadata with some fields and bytes changed.
std::map<std::string, std::string> randomTopics(Decisions& decisions, std::vector<std::string>& names) {
    Level level = randomLevel(decisions);
    const uint32_t cases = 1u << (5 + decisions.below(8));
    if (!decisions.oneIn(4)) Mutator(decisions, cases, true).mutate(level);
    size_t count = 0;
    for (const LevelBody& body : level.bodies) count += body.shapes.size();
    for (size_t i = 0; i < count; ++i) names.push_back("shape_" + std::to_string(i));
    std::map<std::string, std::string> topics = levelToJson(level, names);
    for (auto& [topic, text] : topics) {
        if (decisions.oneIn(200)) {
            const uint32_t depth = decisions.below(decisions.oneIn(2) ? 200 : 200'000);
            text = std::string(depth, '[') + std::string(depth, ']');
        }
        if (!decisions.oneIn(40)) continue;
        std::vector<uint8_t> bytes(text.begin(), text.end());
        mutateBytes(decisions, bytes);
        text.assign(bytes.begin(), bytes.end());
    }
    if (decisions.oneIn(16)) topics.erase(std::next(topics.begin(), decisions.below(uint32_t(topics.size()))));
    return topics;
}

void writeRandomFile(Decisions& decisions, const std::string& path) {
    openvdb::GridPtrVec grids;
    openvdb::MetaMap metadata;
    std::vector<std::string> names(1 + decisions.below(2), "a");
    if (decisions.oneIn(2)) {
        names.clear();
        metadata.insertMeta("rubble.version", openvdb::Int32Metadata(decisions.oneIn(32) ? 7 : 1));
        for (const auto& [topic, text] : randomTopics(decisions, names))
            metadata.insertMeta("rubble." + topic, openvdb::StringMetadata(text));
    }
    const char* suffixes[] = {"density", "color", "emission", "light_group", "paint", "odd"};
    for (const std::string& name : names) {
        if (!decisions.oneIn(16)) {
            grids.push_back(decisions.oneIn(16) ? gridOfAnyType(decisions) : indexGrid(decisions));
            finishGrid(decisions, name + ".palette_index", *grids.back());
        }
        if (!decisions.oneIn(4)) continue;
        const char* suffix = suffixes[decisions.below(6)];
        grids.push_back(decisions.oneIn(3) ? indexGrid(decisions) : gridOfAnyType(decisions));
        finishGrid(decisions, decisions.oneIn(8) ? suffix : name + "." + suffix, *grids.back());
    }
    openvdb::io::File file(path);
    file.setCompression(openvdb::io::COMPRESS_ACTIVE_MASK);
    file.write(grids, metadata);
    file.close();
}

}  // namespace

void fuzz(Decisions& decisions) {
    static const bool isReady = (openvdb::initialize(), true);
    const std::string path = scratchPath("fuzz.vdb");
    try {
        if (isReady) writeRandomFile(decisions, path);
    } catch (const std::exception&) {
        return;  // a transform that OpenVDB does not make, or a text that JSON cannot hold
    }
    std::vector<std::string> notes;
    const Result<Level> level = readVdbFile(path, notes);
    if (!level && level.error().empty()) std::abort();
    if (level) {
        reached("files accepted");
        const Result<Level> baked = levelFromRubble(levelToRubble(*level), "baked");
        if (!baked) std::abort();
        World world;
        world.load(*baked);
        requireReadableSave(world);
    }
    std::vector<uint8_t> bytes = *readFileBytes(path, 1 << 30);
    if (!scanVdbHeader(bytes, "fuzz.vdb")) std::abort();
    for (int i = 0; i < 8; ++i) {
        std::vector<uint8_t> changed = bytes;
        mutateBytes(decisions, changed);
        if (const auto entries = scanVdbHeader(changed, "fuzz.vdb"); !entries && entries.error().empty()) std::abort();
    }
}

}  // namespace rubble
