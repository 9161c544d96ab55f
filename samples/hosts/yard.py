#!/usr/bin/env python3
"""Writes the level of the sample hosts, a yard of 10 by 10 metres, as a MagicaVoxel file: yard.py OUT.vox

Here x is right, y is away from the viewer and z is up, in voxels of 10 cm. In the host's world z comes towards the viewer.
The materials follow from the colours, as runtime/assets/vox_palette.cpp reads them.
"""

import pathlib
import struct
import sys

PAVING, RED_BRICK, DARK_BRICK, WOOD, CONCRETE, GLASS = range(1, 7)
COLORS = {
    PAVING: (122, 120, 112),
    RED_BRICK: (168, 82, 60),
    DARK_BRICK: (138, 62, 48),
    WOOD: (150, 105, 60),
    CONCRETE: (176, 174, 168),
    GLASS: (150, 190, 200),
}


def chunk(name, content, children=b""):
    """A chunk of the file, with those inside it."""
    return name + struct.pack("<ii", len(content), len(children)) + content + children


def text(value):
    """A string with its length."""
    return struct.pack("<i", len(value)) + value.encode()


def attributes(**pairs):
    """A dictionary of a chunk."""
    return struct.pack("<i", len(pairs)) + b"".join(text(key) + text(value) for key, value in pairs.items())


class Model:
    """Voxels in a box, whose first cell lies at `low` of the yard."""

    def __init__(self, low, size):
        self.low, self.size, self.cells = low, size, {}

    def fill(self, low, size, color):
        """Sets a box of cells; color: an index, a function of the cell, or 0 to clear."""
        for x in range(low[0], low[0] + size[0]):
            for y in range(low[1], low[1] + size[1]):
                for z in range(low[2], low[2] + size[2]):
                    self.cells[x, y, z] = color((x, y, z)) if callable(color) else color

    def chunks(self):
        """Its chunks SIZE and XYZI."""
        cells = [bytes((*cell, color)) for cell, color in self.cells.items() if color]
        return (chunk(b"SIZE", struct.pack("<iii", *self.size)) +
                chunk(b"XYZI", struct.pack("<i", len(cells)) + b"".join(cells)))


def bricks(cell):
    """Rows of bricks, three voxels high, each row shifted against the one below."""
    x, _, z = cell
    return DARK_BRICK if (x // 3 + z // 3) % 2 else RED_BRICK


def make_models():
    """Ground, a wall with a window, a wooden tower and a concrete gate."""
    ground = Model((-50, -50, -3), (100, 100, 3))
    ground.fill((0, 0, 0), ground.size, PAVING)
    wall = Model((-24, 8, 0), (48, 3, 26))
    wall.fill((0, 0, 0), wall.size, bricks)
    wall.fill((30, 0, 9), (10, 3, 10), 0)
    wall.fill((30, 1, 9), (10, 1, 10), GLASS)
    tower = Model((-40, -6, 0), (14, 14, 24))
    for x, y in ((0, 0), (11, 0), (0, 11), (11, 11)):
        tower.fill((x, y, 0), (3, 3, 16), WOOD)
    tower.fill((0, 0, 16), (14, 14, 2), WOOD)
    tower.fill((3, 3, 18), (8, 8, 6), CONCRETE)
    gate = Model((26, -4, 0), (18, 6, 22))
    gate.fill((0, 0, 0), (4, 6, 18), CONCRETE)
    gate.fill((14, 0, 0), (4, 6, 18), CONCRETE)
    gate.fill((0, 0, 18), (18, 6, 4), CONCRETE)
    return {"ground": ground, "wall": wall, "tower": tower, "gate": gate}


def scene_graph(models):
    """A root, a group, and for each model a transform and a shape. A transform places the middle of its model."""
    children = [2 + 2 * i for i in range(len(models))]
    nodes = chunk(b"nTRN", struct.pack("<i", 0) + attributes() + struct.pack("<iiii", 1, -1, -1, 1) + attributes())
    nodes += chunk(b"nGRP", struct.pack("<i", 1) + attributes() +
                   struct.pack(f"<i{len(children)}i", len(children), *children))
    for i, (name, model) in enumerate(models.items()):
        middle = " ".join(str(low + size // 2) for low, size in zip(model.low, model.size))
        nodes += chunk(b"nTRN", struct.pack("<i", 2 + 2 * i) + attributes(_name=name) +
                       struct.pack("<iiii", 3 + 2 * i, -1, 0, 1) + attributes(_t=middle))
        nodes += chunk(b"nSHP", struct.pack("<i", 3 + 2 * i) + attributes() + struct.pack("<ii", 1, i) + attributes())
    return nodes


def main():
    models = make_models()
    palette = b"".join(bytes((*COLORS.get(i, (75, 75, 75)), 255)) for i in range(1, 257))
    glass = struct.pack("<i", GLASS) + attributes(_type="_glass", _trans="0.7", _rough="0.05", _ior="0.4")
    content = b"".join(model.chunks() for model in models.values()) + scene_graph(models)
    content += chunk(b"RGBA", palette) + chunk(b"MATL", glass)
    pathlib.Path(sys.argv[1]).write_bytes(b"VOX " + struct.pack("<i", 150) + chunk(b"MAIN", b"", content))


if __name__ == "__main__":
    main()
