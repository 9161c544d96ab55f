// Writes the town as a level: write_town FILE.rubble
#include <cstdio>

#include "runtime/assets/assets.h"
#include "samples/scenes/town.h"

int main(int argc, char** argv) {
    if (argc != 2) return std::fputs("usage: write_town FILE.rubble\n", stderr), 1;
    const auto written = rubble::writeRubble(argv[1], rubble::makeTown(1));
    if (!written) std::fprintf(stderr, "%s\n", written.error().c_str());
    return written ? 0 : 1;
}
