// What the editor's commands cost on large levels: strokes of a brush and undo in processor time, memory of the
// history, opening by the clock. Its argument is the town that write_town writes.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "editor/core/editor.h"

namespace editor {
namespace {

constexpr double kMega = 1e6;

double secondsOf(const std::function<void()>& work) {
    const auto before = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

void run(Editor& editor, const std::string& line) {
    const Outcome outcome = editor.run(line);
    if (!outcome.isDone) throw std::runtime_error(outcome.text);
}

double processorSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Milliseconds of processor time of a line.
double costOf(Editor& editor, const std::string& line) {
    const double before = processorSeconds();
    run(editor, line);
    return 1e3 * (processorSeconds() - before);
}

void printTimes(const std::string& what, std::vector<double> times, const std::string& target) {
    std::sort(times.begin(), times.end());
    fmt::print("{:<46} median {:8.3f}, 95 % {:8.3f}, worst {:8.3f} ms   (target {})\n", what, times[times.size() / 2],
               times[times.size() * 95 / 100], times.back(), target);
}

double allocated() {
    return double(mallinfo2().uordblks + mallinfo2().hblkhd);
}

/// Strokes over rolling ground: of one colour, so that each changes what is there.
class Strokes {
public:
    Strokes(std::string shape, int width, int height) : m_shape(std::move(shape)), m_width(width), m_height(height) {}
    std::string next(int radius) {
        static constexpr const char* kOperations[] = {"add", "erase", "paint", "replace"};
        const auto below = [&](int n) { return int(m_random() % unsigned(n)); };
        const int side = m_width - 2 * radius;
        return fmt::format("sphere {},{},{} {} {} {} shape={}", radius + below(side),
                           m_height - radius / 2 + below(radius), radius + below(side), radius, kOperations[below(4)],
                           1 + below(255), m_shape);
    }

private:
    std::string m_shape;
    int m_width, m_height;
    std::mt19937 m_random{24};
};

/// A static body with one shape of 1024 x 256 x 1024 cells, of which `height` layers are full of ground that strokes
/// have made uneven and many-coloured.
void makeGround(Editor& editor, int height) {
    run(editor, fmt::format("create 1024,{},1024 index=3 static=yes name=ground", height));
    run(editor, "resize 0,0,0 1024,256,1024 ground");
    Strokes strokes("ground", 1024, height);
    for (int i = 0; i < 300; ++i) run(editor, strokes.next(8 + i % 40));
}

void measureStrokes(Editor& editor, const std::string& where, Strokes strokes, const std::string& target) {
    std::vector<double> strokeTimes, undoTimes;
    for (int i = 0; i < 200; ++i) strokeTimes.push_back(costOf(editor, strokes.next(16)));
    printTimes("stroke of radius 16 " + where, strokeTimes, target);
    for (int i = 0; i < 200; ++i) undoTimes.push_back(costOf(editor, "undo"));
    printTimes("its undo", undoTimes, "of larger ones, below");
}

void measureUndo(Editor& editor) {
    for (const int side : {100, 200}) {
        std::vector<double> times;
        const double megavoxels = double(side) * side * side / kMega;
        for (int i = 0; i < 9; ++i) {
            run(editor, fmt::format("box 9,9,9 {0},{0},{0} replace {1} shape=ground", side + 8, 1 + i));
            times.push_back(costOf(editor, "undo") / megavoxels);
        }
        printTimes(fmt::format("undo a megavoxel, of {:.0f}", megavoxels), times, "1");
    }
}

/// Memory of 1,000 steps, against the bricks that they changed, 512 bytes of voxels each.
void measureMemory(Editor& editor) {
    const rubble_shape ground = editor.world().find_by_name(RUBBLE_KIND_BODY, "ground").at(0);
    rubble_brick_changes query{};
    query.struct_size = sizeof query;
    query.shape = editor.world().get_objects_of(ground, RUBBLE_KIND_SHAPE).at(0);
    uint64_t bricks = 0, version = 0;
    std::vector<rubble_brick> changed(1 << 20);
    const auto changedBricks = [&] {
        uint32_t count = 0;
        query.since = version;
        rubble::check(rubble::api().get_changed_bricks(editor.world().handle(), &query, &version, changed.data(),
                                                       uint32_t(changed.size()), &count));
        return count;
    };
    changedBricks();
    Strokes strokes("ground", 1024, 128);
    const double before = allocated();
    for (int i = 0; i < 1000; ++i) {
        run(editor, strokes.next(16));
        bricks += changedBricks();
    }
    const double after = allocated();
    fmt::print("{:<46} {:.1f} MB; {} bricks changed, whose voxels are {:.1f} MB\n",
               "memory of 1,000 strokes of radius 16", (after - before) / kMega, bricks,
               double(bricks) * 512.0 / kMega);
}

void measureOpening(const std::string& what, const std::string& path, const std::string& target) {
    Editor editor;
    fmt::print("{:<46} {:.3f} s   (target {})\n", "opening " + what, secondsOf([&] { run(editor, "open " + path); }),
               target);
    fmt::print("{:<46} {}\n", "  its voxels", editor.world().get_voxel_accounting().standing);
}

void measure(const std::string& town, const std::string& folder) {
    const std::string ground = folder + "/ground.rubble";
    measureOpening("the town", town, "2 s");
    {
        Editor editor;
        run(editor, "open " + town);
        run(editor, "create 64,64,64 0,20,0 static=yes name=block");
        measureStrokes(editor, "in the town", Strokes("block", 64, 32), "4");
    }
    {
        Editor editor;
        makeGround(editor, 96);
        run(editor, "save " + ground);
    }
    measureOpening("1e8 voxels", ground, "5 s");
    Editor editor;
    makeGround(editor, 128);
    measureStrokes(editor, "on 1024 x 256 x 1024", Strokes("ground", 1024, 128), "4");
    measureUndo(editor);
    measureMemory(editor);
}

}  // namespace
}  // namespace editor

int main(int argc, char** argv) {
    if (argc != 2) return fmt::print(stderr, "usage: bench_editor TOWN.rubble\n"), 1;
    const std::string folder = (std::filesystem::temp_directory_path() / "rubble_editor_costs").string();
    std::filesystem::create_directories(folder);
    try {
        editor::measure(argv[1], folder);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    std::filesystem::remove_all(folder);
    return 0;
}
