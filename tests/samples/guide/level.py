#!/usr/bin/env python3
"""Writes the level of the guides, a block of 16 x 16 x 16 voxels, as a MagicaVoxel file: level.py OUT.vox"""

import pathlib
import struct
import sys

SIDE = 16
cells = b"".join(bytes((x, y, z, 1)) for z in range(SIDE) for y in range(SIDE) for x in range(SIDE))


def chunk(name, content, children=b""):
    """A chunk of the file, with those inside it."""
    return name + struct.pack("<ii", len(content), len(children)) + content + children


size = chunk(b"SIZE", struct.pack("<iii", SIDE, SIDE, SIDE))
voxels = chunk(b"XYZI", struct.pack("<i", SIDE**3) + cells)
pathlib.Path(sys.argv[1]).write_bytes(b"VOX " + struct.pack("<i", 150) + chunk(b"MAIN", b"", size + voxels))
