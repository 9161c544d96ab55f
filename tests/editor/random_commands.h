#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "editor/core/command.h"

namespace editor {

/// Random commands that say all that they depend on: none works on what is selected or was copied, so that the same
/// lines give the same level without those that were undone in between. Tools are left out: their cracks follow from
/// the number of the world's step, which no undo takes back.
class RandomCommands {
public:
    /// Equal seeds give equal lines.
    explicit RandomCommands(uint32_t seed) : m_random(seed) {
        for (const Command& each : allCommands())
            if ((each.kind == Kind::Edit || (each.kind == Kind::Tool && each.subject != "tools")) &&
                each.subject != "cells" && each.name != "import")
                m_commands.push_back(&each);
    }
    /// What a level begins with, so that most commands find something.
    static std::vector<std::string> first() {
        return {"create 12,12,12 0,0,0 name=crate", "create 30,20,3 0,0,2 index=7 name=wall static=yes",
                "create 8,20,1 8,0,2 name=door", "joint hinge door world 7.65,1,2 0,1,0 name=hinge",
                "light sphere 0,3,-2 name=glow"};
    }
    /// A line: a brush or its like, or any command of the table with any values.
    std::string next() { return below(3) ? usual() : any(*m_commands[size_t(below(int(m_commands.size())))]); }
    /// 0 to n - 1.
    int below(int n) { return int(m_random() % unsigned(n)); }

private:
    std::string cell() { return fmt::format("{},{},{}", below(16) - 3, below(16) - 3, below(16) - 3); }
    std::string some() {
        static constexpr const char* kSome[] = {"crate", "wall", "tag:more", "block", "door"};
        return kSome[below(std::size(kSome))];
    }

    std::string usual() {
        static constexpr const char* kOperations[] = {"add", "erase", "paint", "replace"};
        const std::string brush =
            fmt::format(" do={} index={} shape={}", kOperations[below(4)], 1 + below(12), below(2) ? "crate" : "wall");
        switch (below(14)) {
            case 0:
                return fmt::format("box {} {}{}", cell(), cell(), brush);
            case 1:
                return fmt::format("sphere {} {}{} mirror=xz", cell(), 1 + below(5), brush);
            case 2:
                return fmt::format("line {} {} {}{}", cell(), cell(), below(3), brush);
            case 3:
                return fmt::format("voxel {}{}", cell(), brush);
            case 4:
                return fmt::format("face {} +y 1{}", cell(), brush);
            case 5:
                return fmt::format("flood {}{}", cell(), brush);
            case 6:
                return fmt::format("create {},{},{} {},0,9 name=block", 1 + below(6), 1 + below(6), 1 + below(6),
                                   below(9));
            case 7:
                return fmt::format("move {},0,{} {}", below(5) - 2, below(5) - 2, some());
            case 8:
                return fmt::format("rotate 0,{},0 what={}", 15 * below(12), some());
            case 9:
                return fmt::format("entry {} color=#{:06x} shape={}", 1 + below(12), below(1 << 24), some());
            case 10:
                return fmt::format("duplicate 0,{},0 what=block", 1 + below(3));
            case 11:
                return fmt::format("tag more {} {}", below(4), some());
            case 12:
                return fmt::format("time {}", below(24));
            default:
                return below(2) ? "trim crate" : "delete block";
        }
    }

    /// All parameters that are required or name objects, and half of the others.
    std::string any(const Command& command) {
        std::string line(command.name);
        for (const Parameter& each : command.parameters)
            if (each.otherwise == kRequired || each.type == Type::Objects || below(2))
                line += fmt::format(" {}={}", each.name, valueOf(each));
        return line;
    }

    std::string valueOf(const Parameter& parameter) {
        const double low = std::max(parameter.low, -5.0), high = std::min(parameter.high, std::max(low, 0.0) + 10.0);
        const auto number = [&] { return low + (high - low) * below(1001) / 1000.0; };
        switch (parameter.type) {
            case Type::Number:
                return fmt::format("{}", number());
            case Type::Whole:
                return fmt::format("{}", int(low) + below(int(high - low) + 1));
            case Type::Flag:
                return below(2) ? "yes" : "no";
            case Type::Text: {
                static constexpr const char* kWords[] = {"crate", "wall", "block", "more", "wood", "glass", "glow"};
                return kWords[below(std::size(kWords))];
            }
            case Type::Pairs:
                return fmt::format("speed={}", below(4));
            case Type::Choice:
                return choiceOf(parameter.choices);
            case Type::Point:
                return fmt::format("{},{},{}", number(), number(), number());
            case Type::Cell:
                return parameter.low >= 1.0 ? fmt::format("{},{},{}", 1 + below(16), 1 + below(16), 1 + below(16))
                                            : cell();
            case Type::Color:
                return fmt::format("#{:06x}", below(1 << 24));
            case Type::Objects:
                return below(8) ? some() : std::string(below(2) ? "glow" : "hinge");
        }
        return "";
    }

    std::string choiceOf(std::string_view choices) {
        std::vector<std::string> all(1);
        for (const char c : choices) {
            if (c == ' ')
                all.emplace_back();
            else
                all.back() += c;
        }
        return all[size_t(below(int(all.size())))];
    }

    std::mt19937 m_random;
    std::vector<const Command*> m_commands;
};

}  // namespace editor
