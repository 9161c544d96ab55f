#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "generated/paths.h"
#include "runtime/world/edits/edit.h"
#include "runtime/world/edits/edit_error.h"

namespace rubble {
namespace {

std::string textOf(const std::string& path) {
    std::ifstream file(RUBBLE_SOURCE_DIR "/" + path);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_FALSE(text.str().empty()) << path;
    return text.str();
}

/// The names of all functions of the table.
const std::set<std::string>& tableFunctions() {
    static const std::set<std::string> names = [] {
        const std::string header = textOf("runtime/plugin/include/rubble/rubble.h");
        const std::string table = header.substr(header.find("typedef struct rubble_api"));
        const std::regex function(R"(\(\*(\w+)\)\()");
        std::set<std::string> out;
        for (std::sregex_iterator i(table.begin(), table.end(), function), end; i != end; ++i) out.insert((*i)[1]);
        return out;
    }();
    return names;
}

/// Edits that no host gives by themselves, and why.
const std::map<std::string, std::string> kOtherEdits = {
    {"impact load", "what physics makes of an impact: a host's is apply_impulse()"},
};

/// World's const functions: the functions of the table that reach what they say, or why no host needs them, in
/// brackets.
const std::map<std::string, std::string> kReads = {
    {"state", "save_game"},
    {"data", "[the rest of this table says what of it is reached]"},
    {"id", "[part of every handle]"},
    {"step", "get_events"},
    {"settings", "get_settings get_bounds"},
    {"hash", "get_state_hash"},
    {"bodies", "get_body_states get_body_properties get_objects"},
    {"shapes", "get_shape_states get_shape_state get_shape_properties get_anchors get_palette read_voxels"},
    {"lights", "get_lights get_light_settings"},
    {"lightGroups", "get_light_group get_objects"},
    {"waters", "get_waters"},
    {"triggers", "get_triggers get_trigger_bodies get_trigger_events"},
    {"characters", "get_character_states get_character_state"},
    {"joints", "get_joint_states get_rope_points get_ropes"},
    {"materials", "get_material get_material_count find_material"},
    {"environment", "get_environment"},
};

/// Free functions that answer questions about a World: the same.
const std::map<std::string, std::string> kQuestions = {
    {"jointMovement", "get_joint_properties"},
    {"isJointedToStatic", "[of the damage by impacts]"},
    {"isAlive", "translate_handle"},
    {"nameOf", "get_name"},
    {"tagsOf", "get_tags"},
    {"castRay", "cast_ray"},
    {"castRays", "cast_rays"},
    {"castShape", "cast_shapes"},
    {"castShapes", "cast_shapes"},
    {"overlappingShapes", "overlap_shapes"},
    {"overlappingBodies", "overlap_bodies"},
    {"overlapsBody", "overlap_bodies"},
    {"shapesInBox", "overlap_shapes"},
    {"bodiesInBox", "overlap_bodies"},
    {"shapesNear", "overlap_shapes"},
    {"closestPoint", "find_closest_point"},
    {"bodyBounds", "get_body_properties"},
    {"voxelAccounting", "get_voxel_accounting"},
    {"stateHash", "get_state_hash"},
    {"resolvedHash", "[of recordings; get_state_hash() holds all of it]"},
    {"voxelHash", "[of comparisons between machines, by the project's own tools]"},
    {"findFires", "get_fires find_closest_fire count_fires"},
    {"remainingStrength", "[of the stress analysis]"},
    {"bodyMass", "get_body_properties"},
};

/// Expects that the table of reads names what the source has and nothing else, and functions that exist.
void expectReached(const std::set<std::string>& found, const std::map<std::string, std::string>& reads) {
    for (const std::string& name : found) EXPECT_TRUE(reads.contains(name)) << name << " is reached by no function";
    for (const auto& [name, reached] : reads) {
        EXPECT_TRUE(found.contains(name)) << name << " is not there any more";
        if (reached.starts_with('[')) continue;
        std::istringstream functions(reached);
        for (std::string function; functions >> function;)
            EXPECT_TRUE(tableFunctions().contains(function)) << name << ": " << function << " is not in the table";
    }
}

template <size_t... kIndex>
std::vector<std::string> editNames(std::index_sequence<kIndex...>) {
    return {editName(Edit(std::variant_alternative_t<kIndex, AnyEdit>{}))...};
}

TEST(Coverage, EachKindOfEditIsAFunctionOfTheTable) {
    const auto names = editNames(std::make_index_sequence<std::variant_size_v<AnyEdit>>());
    for (const std::string& name : names)
        EXPECT_TRUE(tableFunctions().contains(name) || kOtherEdits.contains(name)) << name;
    for (const auto& [name, reason] : kOtherEdits) EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
}

TEST(Coverage, WhatAWorldSaysIsReachedByTheTable) {
    const std::string header = textOf("runtime/world/world.h");
    const size_t begin = header.find("public:"), end = header.find("private:");
    const std::string part = header.substr(begin, end - begin);
    const std::regex read(R"((\w+)\(\) const)");
    std::set<std::string> found;
    for (std::sregex_iterator i(part.begin(), part.end(), read), last; i != last; ++i)
        if ((*i)[1] != "WorldData") found.insert((*i)[1]);
    expectReached(found, kReads);
}

TEST(Coverage, QuestionsAboutAWorldAreReachedByTheTable) {
    const std::regex question(R"((\w+)\(const World(?:Data|State|Objects)& \w+)");
    std::set<std::string> found;
    for (const char* file :
         {"queries/joint_queries.h", "queries/notes.h", "queries/query.h", "queries/voxel_accounting.h",
          "queries/world_hash.h", "state/fires.h", "objects/body_mass.h"}) {
        const std::string text = textOf(std::string("runtime/world/") + file);
        for (std::sregex_iterator i(text.begin(), text.end(), question), last; i != last; ++i) found.insert((*i)[1]);
    }
    expectReached(found, kQuestions);
}

}  // namespace
}  // namespace rubble
