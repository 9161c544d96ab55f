// What the program rubble-vdb answers: random output in random portions, and any end that waitpid() may tell.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "runtime/assets/vdb_reply.h"
#include "runtime/core/utf8.h"
#include "tests/fuzz/decisions.h"
#include "tests/fuzz/stages.h"

namespace rubble {
namespace {

std::string randomLine(Decisions& decisions) {
    const char* beginnings[] = {
        "note: ", "error: ", "note: a\nerror: b", "", "note:", "\nerror: ", "\n\n", "note: \xc3"};
    std::string line = beginnings[decisions.below(8)];
    const uint32_t length = decisions.below(decisions.oneIn(40) ? 30'000 : 30);
    if (decisions.oneIn(3))
        line.append(length, char(decisions.below(256)));
    else
        for (uint32_t i = std::min(length, 200u); i-- > 0;) line += char(decisions.below(256));
    if (!decisions.oneIn(8)) line += '\n';
    return line;
}

/// Text that a host may print.
void requirePrintable(const std::string& text, bool isLine) {
    const bool hasControl = std::any_of(text.begin(), text.end(),
                                        [&](char c) { return (uint8_t(c) < 32 && (isLine || c != '\n')) || c == 127; });
    if (hasControl || !isUtf8(text)) std::abort();
}

}  // namespace

void fuzz(Decisions& decisions) {
    constexpr size_t kMaxText = 128 << 10;
    VdbReply reply;
    for (uint32_t i = decisions.below(20); i-- > 0;) {
        const std::string line = randomLine(decisions);
        const size_t cut = decisions.below(uint32_t(line.size() + 1));
        reply.append(std::string_view(line).substr(0, cut));
        reply.append(std::string_view(line).substr(cut));
    }
    if (decisions.oneIn(8)) reply.stop(decisions.bits());
    if (!decisions.oneIn(8)) reply.end(int(decisions.oneIn(2) ? decisions.below(3) << 8 : decisions.below(1 << 16)));
    const Result<std::string> result = reply.result("tool");
    if (!result) {
        if (result.error().empty() || result.error().size() > kMaxText) std::abort();
        return requirePrintable(result.error(), false);
    }
    reached("answers accepted");
    if (result->size() > kMaxText) std::abort();
    for (const std::string& note : notesOf(*result)) requirePrintable(note, true);
}

}  // namespace rubble
