#include "editor/core/command.h"

#include <algorithm>
#include <numeric>

namespace editor {
namespace {

std::vector<Command> gather() {
    std::vector<Command> all;
    for (const auto subject :
         {sessionCommands,     fileCommands,        selectionCommands,     viewCommands,  voxelCommands,
          clipboardCommands,   shapeCommands,       shapePropertyCommands, bodyCommands,  placementCommands,
          paletteCommands,     paletteToolCommands, imageCommands,         lightCommands, jointCommands,
          environmentCommands, modelCommands,       regionCommands,        nameCommands,  scriptCommands,
          toolCommands}) {
        std::vector<Command> some = subject();
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

/// How many letters must be changed, added or taken away.
size_t distance(std::string_view a, std::string_view b) {
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t(0));
    for (size_t i = 0; i < a.size(); ++i) {
        size_t before = row[0]++;
        for (size_t j = 0; j < b.size(); ++j) {
            const size_t changed = before + (a[i] != b[j]);
            before = row[j + 1];
            row[j + 1] = std::min({changed, before + 1, row[j] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::span<const Command> allCommands() {
    static const std::vector<Command> all = gather();
    return all;
}

const Command* findCommand(std::string_view name) {
    for (const Command& each : allCommands())
        if (each.name == name) return &each;
    return nullptr;
}

std::string_view similarCommand(std::string_view name) {
    std::string_view best;
    size_t least = std::max<size_t>(2, name.size() / 3) + 1;
    for (const Command& each : allCommands())
        if (const size_t d = distance(each.name, name); d < least) best = each.name, least = d;
    return best;
}

}  // namespace editor
