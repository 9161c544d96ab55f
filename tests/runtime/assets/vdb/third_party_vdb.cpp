#include "tests/runtime/assets/vdb/third_party_vdb.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <regex>
#include <stdexcept>

namespace rubble {
namespace {

using openvdb::Coord;
using openvdb::CoordBBox;

template <class Grid>
typename Grid::Ptr named(typename Grid::Ptr grid, const char* name) {
    grid->setName(name);
    return grid;
}

openvdb::BoolGrid::Ptr threeBools(const char* name) {
    auto grid = named<openvdb::BoolGrid>(openvdb::BoolGrid::create(false), name);
    auto cells = grid->getAccessor();
    cells.setValue(Coord(-5, 0, 0), true);
    cells.setValue(Coord(3, 2, 1), true);
    cells.setValue(Coord(3, 2, 2), true);
    cells.setValueOn(Coord(0, 0, 0), false);  // active, but false
    return grid;
}

openvdb::FloatGrid::Ptr fog(const char* name) {
    auto grid = named<openvdb::FloatGrid>(openvdb::FloatGrid::create(0.0f), name);
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    grid->fill(CoordBBox(Coord(0), Coord(9)), 0.25f);
    grid->fill(CoordBBox(Coord(0), Coord(4, 9, 9)), 0.75f);
    return grid;
}

openvdb::Vec3SGrid::Ptr twoColors(const char* name) {
    auto grid = named<openvdb::Vec3SGrid>(openvdb::Vec3SGrid::create(openvdb::Vec3f(0)), name);
    grid->fill(CoordBBox(Coord(0), Coord(9)), openvdb::Vec3f(1, 0, 0));
    grid->fill(CoordBBox(Coord(0), Coord(1, 9, 9)), openvdb::Vec3f(0, 0, 1));
    return grid;
}

openvdb::Int32Grid::Ptr indices(int value) {
    auto grid = named<openvdb::Int32Grid>(openvdb::Int32Grid::create(0), "door.palette_index");
    grid->fill(CoordBBox(Coord(0), Coord(2, 0, 0)), 7);
    grid->tree().setValue(Coord(1, 1, 0), value);
    return grid;
}

openvdb::GridPtrVec gridsOf(const std::string& kind) {
    using Transform = openvdb::math::Transform;
    if (kind == "deep list") return {threeBools("blob")};
    if (kind == "bool") {
        auto grid = threeBools("blob");
        grid->setTransform(Transform::createLinearTransform(0.25));
        return {grid};
    }
    if (kind == "mask tile") {
        auto grid = named<openvdb::MaskGrid>(openvdb::MaskGrid::create(), "block");
        grid->denseFill(CoordBBox(Coord(0), Coord(127)), true);
        grid->pruneGrid();
        return {grid};
    }
    if (kind == "level set")
        return {named<openvdb::FloatGrid>(
            openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(2.0f, openvdb::Vec3f(1, 2, 3), 0.1f), "surface")};
    if (kind == "fog")
        return {fog("density"), twoColors("color"), fog("temperature"),
                named<openvdb::DoubleGrid>(openvdb::DoubleGrid::create(1.0), "odd")};
    if (kind == "odd type") {
        using Bytes = openvdb::Grid<openvdb::tree::Tree4<uint8_t, 5, 4, 3>::Type>;
        if (!Bytes::isRegistered()) Bytes::registerGrid();
        return {threeBools("blob"), named<Bytes>(Bytes::create(0), "bytes")};
    }
    if (kind == "indices") return {indices(255)};
    if (kind == "wrong index") return {indices(300)};
    auto grid = threeBools("blob");
    if (kind == "stretched") {
        auto transform = Transform::createLinearTransform(0.1);
        transform->preScale(openvdb::Vec3d(1, 2, 1));
        grid->setTransform(transform);
    } else if (kind == "far away") {
        auto transform = Transform::createLinearTransform(0.1);
        transform->postTranslate(openvdb::Vec3d(1e12, 0, 0));
        grid->setTransform(transform);
    } else if (kind == "huge box") {
        grid->tree().setValue(Coord(100000, 0, 0), true);
    } else if (kind == "huge tile") {
        grid->sparseFill(CoordBBox(Coord(0), Coord(4095)), true);
    } else if (kind == "turned") {
        auto transform = Transform::createLinearTransform(0.1);
        transform->postRotate(0.7, openvdb::math::Y_AXIS);
        transform->postTranslate(openvdb::Vec3d(5, 6, 7));
        grid->setTransform(transform);
    } else {
        throw std::invalid_argument("unknown kind of file: " + kind);
    }
    return {grid};
}

}  // namespace

void writeThirdPartyVdb(const std::string& kind, const std::string& path) {
    openvdb::initialize();
    openvdb::MetaMap metadata;
    if (kind == "deep list") {
        constexpr size_t kDepth = 100'000;
        metadata.insertMeta("rubble.version", openvdb::Int32Metadata(1));
        metadata.insertMeta("rubble.bodies",
                            openvdb::StringMetadata(std::string(kDepth, '[') + std::string(kDepth, ']')));
    }
    openvdb::io::File file(path);
    file.write(gridsOf(kind), metadata);
    file.close();
}

void removeField(const std::string& path, const std::string& field) {
    openvdb::initialize();
    openvdb::io::File file(path);
    file.open();
    const openvdb::GridPtrVecPtr grids = file.getGrids();
    openvdb::MetaMap metadata(*file.getMetadata());
    file.close();
    const std::regex pattern("\"" + field + "\":[^,}]*,|,\"" + field + "\":[^,}]*");
    for (auto item = metadata.beginMeta(); item != metadata.endMeta(); ++item)
        if (item->second->typeName() == "string") {
            auto& text = static_cast<openvdb::StringMetadata&>(*item->second).value();
            text = std::regex_replace(text, pattern, "");
        }
    openvdb::io::File(path).write(*grids, metadata);
}

}  // namespace rubble
