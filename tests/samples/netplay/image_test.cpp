// Clients that draw: what they show of one world at one moment.
#include <gtest/gtest.h>

#include <cstdlib>

#include "samples/netplay/app/player_view.h"
#include "tests/samples/netplay/game.h"

namespace netplay {
namespace {

using Pixels = std::vector<uint8_t>;

constexpr Size kSize = {192, 108};
constexpr int kFrames = 12;  // until light has gathered

/// The mean difference of two images' values, of 255, after the means of 4 by 4 pixels: smoothing of edges, which
/// moves with the number of a frame, does not count.
double meanDifference(const Pixels& a, const Pixels& b) {
    constexpr int kBlock = 4, kRow = 3 * kSize.width;
    double sum = 0.0;
    for (int y = 0; y < kSize.height; y += kBlock)
        for (int x = 0; x < kRow; x += 3 * kBlock)
            for (int channel = 0; channel < 3; ++channel) {
                int difference = 0;
                for (int dy = 0; dy < kBlock; ++dy)
                    for (int dx = 0; dx < kBlock; ++dx) {
                        const auto at = size_t((y + dy) * kRow + x + 3 * dx + channel);
                        difference += int(a[at]) - int(b[at]);
                    }
                sum += std::abs(difference);
            }
    return sum / double(a.size());
}

/// How many pixels differ by much.
int pixelsThatDiffer(const Pixels& a, const Pixels& b) {
    int count = 0;
    for (size_t i = 0; i < a.size(); i += 3)
        count += std::abs(a[i] - b[i]) + std::abs(a[i + 1] - b[i + 1]) + std::abs(a[i + 2] - b[i + 2]) > 60;
    return count;
}

/// One house, a server, and clients whose views are drawn in turn, from one place.
class NetplayImage : public testing::Test {
protected:
    NetplayImage() {
        m_camera.position = {-9.0, 4.0, 8.0};
        m_camera.lookAt({0.0, 3.5, 0.0});
        add(), add();
    }
    void add() {
        Seat& seat = m_game.add();
        seat.isPlaying = false;
        m_views.push_back(std::make_unique<PlayerView>(seat.world, seat.client, *m_screen, "fast"));
    }
    /// Runs steps, of each of which all clients draw a frame; the images of the last one.
    std::vector<Pixels> play(int steps) {
        std::vector<Pixels> images;
        for (int i = 0; i < steps; ++i) {
            m_game.run(1);
            images.clear();
            for (const auto& view : m_views) {
                view->drawFrom(m_camera, 0.0);
                images.push_back(m_screen->read());
            }
        }
        return images;
    }
    /// A player looks at something and clicks.
    void blast(size_t player, const Vec3& target) {
        m_views[player]->lookAt(target);
        m_views[player]->act({}, Tool::Blast, true);
    }
    void keep(const std::string& name, const std::vector<Pixels>& images) const {
        if (const char* folder = std::getenv("RUBBLE_IMAGES"))
            for (size_t i = 0; i < images.size(); ++i)
                writeImage(std::string(folder) + "/" + name + std::to_string(i) + ".png", kSize, images[i]);
    }

    std::unique_ptr<Screen> m_screen = Screen::inMemory(kSize);
    Game m_game{{.rows = 1, .world = drawnWorld()}};
    std::vector<std::unique_ptr<PlayerView>> m_views;
    rubble::Camera m_camera;
};

TEST_F(NetplayImage, TwoClientsSeeOneHouseFallAndALateOneWhatIsLeft) {
    m_game.run(60);
    const std::vector<Pixels> before = play(kFrames);
    keep("before", before);
    EXPECT_LT(meanDifference(before[0], before[1]), 0.5);
    for (const auto& view : m_views) view->follow();
    const std::vector<Pixels> others = play(2);
    keep("others", others);
    EXPECT_GT(pixelsThatDiffer(before[0], others[0]), 3) << "the second player flies behind the house";
    for (int i = 0; i < 20; ++i) {  // along three walls: the first player has two before him, the second the third
        blast(0, i < 10 ? Vec3{-3.0, 0.8, -2.9 + 0.65 * i} : Vec3{-2.9 + 0.65 * (i - 10), 0.8, 3.0});
        blast(1, {-2.9 + 0.3 * i, 0.8, -3.0});
        m_game.run(12);
        const std::vector<Pixels> falling = play(4);
        keep("falling" + std::to_string(i) + "_", falling);
        EXPECT_LT(meanDifference(falling[0], falling[1]), 0.5) << "blast " << i;
    }
    m_game.run(240);
    add();
    m_game.run(60);
    const std::vector<Pixels> after = play(3 * kFrames);
    keep("after", after);
    EXPECT_GT(meanDifference(before[0], after[0]), 5.0) << "the hole";
    EXPECT_LT(meanDifference(after[0], after[1]), 0.5);
    EXPECT_LT(meanDifference(after[0], after[2]), 1.0) << "who has seen it happen shows no more than who comes late";
    EXPECT_EQ(difference(m_game.world(), m_game.seats()[1]->world), "");
}

}  // namespace
}  // namespace netplay
