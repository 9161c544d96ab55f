-- Draws a model for CreateModel() out of boxes in shades: bricks in courses, boards, windows. Cells of 0.1 m; corners
-- are both in. A large one takes some steps: draw within start().
local Blueprint = {}
Blueprint.__index = Blueprint

-- Shades of a material, 0xrrggbb each, as those of the town.
local kShades = {
    brick = {"brick", 0x8a4b3a, 0x95543f, 0x7c4234, 0x9c6048}, joint = {"brick", 0x6f4a3c, 0x7a5646},
    ochre = {"brick", 0xa98c5f, 0xb39668, 0x9b7f55}, soot = {"brick", 0x3a3230, 0x433a36},
    concrete = {"concrete", 0x8f8d86, 0xa09d94, 0x97948c}, slate = {"brick", 0x4d4f57, 0x565a63, 0x45464d, 0x5a4a45},
    timber = {"wood", 0x7a5a3c, 0x8b6845, 0x6b4c31}, door = {"wood", 0x2f5b46, 0x34644d, 0x2a523f},
    steel = {"metal", 0x3b3f44, 0x44484d}, earth = {"concrete", 0x5d7a3a, 0x6d8a45, 0x4f6a33},
}

-- The same number for the same cell on every machine.
local function hash(x, y, z)
    local h = (x * 73856093 ~ y * 19349663 ~ z * 83492791) & 0xffffffff
    h = (h ~ h >> 15) * 0x2c1b3c6d & 0xffffffff
    return h ~ h >> 13
end

local function make(size, voxel)
    return setmetatable({size = size, voxel = voxel or 0.1, boxes = {}, palette = {}, shades = {},
        from = {0, 0, 0}}, Blueprint)
end

-- The entries of a material's shades, as a list.
function Blueprint:entries(name)
    local list = self.shades[name]
    if list then return list end
    list = {}
    local row = kShades[name]
    for i = 2, #row do
        local c = row[i]
        table.insert(self.palette, {(c >> 16) / 255, (c >> 8 & 255) / 255, (c & 255) / 255, material = row[1],
            roughness = 0.85})
        list[i - 1] = #self.palette
    end
    self.shades[name] = list
    return list
end

function Blueprint:pick(name, x, y, z)
    local list = self:entries(name)
    return list[hash(x, y, z) % #list + 1]
end

function Blueprint:fill(x, y, z, x1, y1, z1, entry)
    local from = self.from
    self.boxes[#self.boxes + 1] = {x - from[1], y - from[2], z - from[3], x1 - from[1], y1 - from[2], z1 - from[3], entry}
end

function Blueprint:clear(x, y, z, x1, y1, z1)
    self:fill(x, y, z, x1, y1, z1, 0)
end

-- A block in patches of `grain` cells.
function Blueprint:block(name, x, y, z, x1, y1, z1, grain)
    grain = grain or 4
    for px = x, x1, grain do
        for py = y, y1, grain do
            for pz = z, z1, grain do
                self:fill(px, py, pz, math.min(px + grain - 1, x1), math.min(py + grain - 1, y1),
                    math.min(pz + grain - 1, z1), self:pick(name, px, py, pz))
            end
        end
    end
end

-- A wall of bricks three cells long with a joint between, every course shifted by half a brick.
function Blueprint:bricks(name, x, y, z, x1, y1, z1)
    local isAlongX = x1 - x >= z1 - z
    local from, to = isAlongX and x or z, isAlongX and x1 or z1
    local function strip(low, high, course, entry)
        if low > high then return end
        if isAlongX then return self:fill(low, course, z, high, course, z1, entry) end
        self:fill(x, course, low, x1, course, high, entry)
    end
    local joint = name == "brick" and "joint" or name
    for course = y, y1 do
        for at = from - course % 2 * 2, to, 4 do
            strip(math.max(at, from), math.min(at + 2, to), course, self:pick(name, at, course, isAlongX and z or x))
            if at + 3 <= to then strip(at + 3, at + 3, course, self:pick(joint, at, course, 7)) end
        end
    end
    wait(0)  -- a call into a script has a budget of work
end

-- Four walls of bricks around a rectangle, so thick.
function Blueprint:shaft(name, x, y, z, x1, y1, z1, thick)
    self:bricks(name, x, y, z, x1, y1, z + thick - 1)
    self:bricks(name, x, y, z1 - thick + 1, x1, y1, z1)
    self:bricks(name, x, y, z + thick, x + thick - 1, y1, z1 - thick)
    self:bricks(name, x1 - thick + 1, y, z + thick, x1, y1, z1 - thick)
end

-- A window in a wall along x (three cells thick from z on): steel bars with panes between, a sill and a lintel.
function Blueprint:window(x, y, z, width, height)
    local x1, y1 = x + width - 1, y + height - 1
    self:clear(x, y, z, x1, y1, z + 2)
    if not self.glass then
        table.insert(self.palette, {0.87, 0.93, 0.93, material = "glass", roughness = 0.05, opacity = 0.25})
        self.glass = #self.palette
    end
    self:fill(x, y, z + 1, x1, y1, z + 1, self.glass)
    local steel = self:entries("steel")[1]
    for bar = x, x1, 4 do self:fill(bar, y, z + 1, bar, y1, z + 1, steel) end
    for bar = y, y1, 4 do self:fill(x, bar, z + 1, x1, bar, z + 1, steel) end
    self:block("concrete", x - 1, y - 1, z, x1 + 1, y - 1, z + 3, 6)
    self:block("ochre", x - 1, y1 + 1, z, x1 + 1, y1 + 2, z + 2, 3)
end

-- Makes it, with cell 0, 0, 0 at a place. `from`: the cell that is the first of its grid.
function Blueprint:build(corner, isDynamic)
    local at = corner + VecScale(Vec(self.from[1], self.from[2], self.from[3]), self.voxel)
    return CreateModel({voxel = self.voxel, size = self.size, origin = {0, 0, 0}, boxes = self.boxes, palette = self.palette},
       
        Transform(at), isDynamic or false)
end

return make
