#pragma once
#include "runtime/assets/byte_reader.h"
#include "runtime/assets/vox_file.h"

namespace rubble {

/// Reads the voxels of a TDCZ chunk, as Teardown writes it instead of XYZI, into a model whose size is known: a zlib
/// stream (RFC 1950) of one palette index for each cell, x fastest, then y. The stream need not be closed; what follows
/// the last cell is not looked at. Fails in the reader.
void readPackedVoxels(ByteReader& in, VoxModel& model);

}  // namespace rubble
