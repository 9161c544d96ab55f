#include "runtime/assets/vox_packed_model.h"

#include <zlib.h>

namespace rubble {
namespace {

/// Unpacks a zlib stream piece by piece.
class Inflater {
public:
    explicit Inflater(std::span<const uint8_t> packed) {
        m_stream.next_in = const_cast<Bytef*>(packed.data());
        m_stream.avail_in = uInt(packed.size());
        m_isOpen = inflateInit(&m_stream) == Z_OK;
    }
    ~Inflater() {
        if (m_isOpen) inflateEnd(&m_stream);
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    /// Fills all of `out`, or as much as the stream gives. Returns how many bytes that are.
    size_t read(std::span<uint8_t> out) {
        m_stream.next_out = out.data();
        m_stream.avail_out = uInt(out.size());
        while (m_isOpen && m_stream.avail_out > 0)
            if (inflate(&m_stream, Z_SYNC_FLUSH) != Z_OK) break;  // its end, damage, or no bytes left
        return out.size() - m_stream.avail_out;
    }

    /// Whether what follows is damaged: its data or, where the stream is closed, its checksum.
    bool endsDamaged() {
        uint8_t beyond;
        m_stream.next_out = &beyond;
        m_stream.avail_out = 1;
        return m_isOpen && inflate(&m_stream, Z_SYNC_FLUSH) == Z_DATA_ERROR;
    }

private:
    z_stream m_stream{};
    bool m_isOpen = false;
};

}  // namespace

void readPackedVoxels(ByteReader& in, VoxModel& model) {
    const size_t layerCells = size_t(model.size.x) * size_t(model.size.y);
    if (layerCells == 0 || model.size.z == 0) return;
    const size_t start = in.offset();
    Inflater inflater(in.readBytes(in.remaining()));
    VoxelGrid grid(model.size);
    GridWriter writer(grid);
    std::vector<uint8_t> layer(layerCells);
    for (int z = 0; z < model.size.z; ++z) {
        if (const size_t got = inflater.read(layer); got < layerCells)
            return in.fail(fmt::format("{} cells of a model of {}x{}x{}", layerCells * size_t(model.size.z),
                                       model.size.x, model.size.y, model.size.z),
                           fmt::format("{}: the packed data is damaged", layerCells * size_t(z) + got), start);
        for (size_t i = 0; i < layerCells; ++i)
            if (layer[i]) writer.set({int(i) % model.size.x, int(i) / model.size.x, z}, layer[i]);
        if (z % kBrickSize == kBrickSize - 1) writer.flush();
    }
    writer.flush();
    if (inflater.endsDamaged())
        return in.fail("a whole stream of packed cells", "damaged data or a wrong checksum behind them", start);
    if (in.takeMemory(grid.brickCount() * kBrickMemory)) model.grid = std::move(grid);
}

}  // namespace rubble
