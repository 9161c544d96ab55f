-- Builds bodies of voxels, wheels and joints. A model has x to the right, y up, and its front at the low end of z;
-- cells are 0.1 m, boxes have both corners in.
local build = {}

-- Colours (sRGB), material and further fields of a palette's entries.
local surfaces = {
    red = {{0xb23a2e, 0xac372b, 0xb64034}, "metal", roughness = 0.22, metallic = 0.15},
    blue = {{0x2f5d8a, 0x2b5783, 0x33638f}, "metal", roughness = 0.22, metallic = 0.15},
    cream = {{0xd9d4c8, 0xd3cec2, 0xcfc9bb}, "metal", roughness = 0.25, metallic = 0.1},
    green = {{0x4c6b4a, 0x486646, 0x52714f}, "metal", roughness = 0.3, metallic = 0.1},
    yellow = {{0xd0a024, 0xc99a22, 0xd6a82c, 0xbf9426}, "metal", roughness = 0.35, metallic = 0.1},
    orange = {{0xc4622a, 0xbd5c26, 0xca6a31}, "metal", roughness = 0.35, metallic = 0.1},
    black = {{0x2e2f31, 0x343538, 0x29292c}, "plastic", roughness = 0.65},
    steel = {{0x6f7780, 0x78818a, 0x666e77}, "metal", roughness = 0.45, metallic = 0.6},
    dark = {{0x3d4246, 0x454a4f, 0x373b3f}, "metal", roughness = 0.55, metallic = 0.5},
    chrome = {{0xa8adb2, 0xb0b5ba}, "metal", roughness = 0.18, metallic = 0.85},
    weight = {{0x4a4d50, 0x54585b, 0x434649}, "heavy metal", roughness = 0.45, metallic = 0.5},
    worn = {{0x8a8177, 0x93897e, 0x7a7066, 0x7d5a40}, "hard metal", roughness = 0.5, metallic = 0.5},
    rust = {{0x8a5a3a, 0x7a4a30, 0x96643f}, "metal", roughness = 0.9, metallic = 0.2},
    rubber = {{0x2b2b2d, 0x303032, 0x262628}, "rubber", roughness = 0.92},
    tread = {{0x1f1f21, 0x232325}, "rubber", roughness = 0.95},
    cloth = {{0x6a6257, 0x625a50, 0x70685c}, "plastic", roughness = 0.95},
    wood = {{0x8b6845, 0x7f5e3d, 0x97724c, 0x74563a}, "wood", roughness = 0.75},
    plank = {{0xa98a62, 0x9c7e58, 0xb4956c}, "wood", roughness = 0.6},
    white = {{0xd3d0c6, 0xcbc8be, 0xd8d5cc}, "wood", roughness = 0.4},
    navy = {{0x2b4560, 0x284059, 0x2f4b67}, "wood", roughness = 0.4},
    plate = {{0xc4c1b6}, "plastic", roughness = 0.5},
    glass = {{0xdfeeee, 0xd6e8e8}, "glass", roughness = 0.05, opacity = 0.16},
    lamp = {{0xf2eedc, 0xeae4d0}, "glass", roughness = 0.15, emission = 0.9},
    amber = {{0xd98a1e}, "glass", roughness = 0.2, emission = 0.6},
    tail = {{0xb01810, 0xa4150e}, "glass", roughness = 0.2, emission = 0.5},
    port = {{0xb01810}, "glass", roughness = 0.2, emission = 1.5},
    brick = {{0x8a4b3a, 0x95543f, 0x7c4234, 0x9c6048}, "brick", roughness = 0.9},
    mortar = {{0xa89a8c, 0xb3a493}, "brick", roughness = 0.95},
    concrete = {{0x8f8d86, 0xa09d94, 0x97948c}, "concrete", roughness = 0.9},
    tile = {{0x4d4f57, 0x565a63, 0x45464d, 0x5a4a45}, "brick", roughness = 0.8},
    pane = {{0xdfeeee, 0xd6e8e8}, "glass", roughness = 0.03, opacity = 0.12},
    bulb = {{0xfff0d0}, "glass", roughness = 0.3, emission = 9},
    starboard = {{0x1a8a3a}, "glass", roughness = 0.2, emission = 1.5},
}

local Model = {}
Model.__index = Model

-- An empty model of `size` cells; `origin`: the cell at the body's frame.
function build.model(size, origin, voxel)
    local model = {size = size, origin = origin, voxel = voxel or 0.1, boxes = {}, palette = {}, firsts = {}}
    return setmetatable(model, Model)
end

-- The first entry of a surface, and how many it has.
function Model:surface(name)
    local style = surfaces[name] or error("no surface " .. tostring(name), 3)
    if not self.firsts[name] then
        self.firsts[name] = #self.palette + 1
        for _, hex in ipairs(style[1]) do
            local entry = {(hex >> 16 & 255) / 255, (hex >> 8 & 255) / 255, (hex & 255) / 255, material = style[2]}
            for _, field in ipairs({"roughness", "metallic", "opacity", "emission"}) do entry[field] = style[field] end
            self.palette[#self.palette + 1] = entry
        end
    end
    return self.firsts[name], #style[1]
end

function Model:box(x0, y0, z0, x1, y1, z1, name)
    local entry, shades = 0, 1
    if name then entry, shades = self:surface(name) end
    local s = self.scale or 1
    x0, y0, z0, x1, y1, z1 = s * x0, s * y0, s * z0, s * x1 + s - 1, s * y1 + s - 1, s * z1 + s - 1
    self.boxes[#self.boxes + 1] = {x0, y0, z0, x1, y1, z1, entry, shades}
end

-- The same model for parts that are drawn in cells of `scale` of its own.
function Model:coarse(scale)
    local size = {}
    for i = 1, 3 do size[i] = self.size[i] // scale end
    return setmetatable({size = size, scale = scale, boxes = self.boxes, palette = self.palette, firsts = self.firsts},
        Model)
end

function Model:clear(x0, y0, z0, x1, y1, z1)
    self:box(x0, y0, z0, x1, y1, z1)
end

-- A box and its mirror image at the other side.
function Model:pair(x0, y0, z0, x1, y1, z1, name)
    self:box(x0, y0, z0, x1, y1, z1, name)
    local last = self.size[1] - 1
    self:box(last - x1, y0, z0, last - x0, y1, z1, name)
end

-- A disc about x, from x0 to x1: its middle in cells, its radius in cells; without a name it is cleared.
function Model:disc(x0, x1, cy, cz, radius, name)
    for y = math.floor(cy - radius), math.ceil(cy + radius) do
        local half = radius * radius - (y + 0.5 - cy) ^ 2
        if half >= 0 then
            half = math.sqrt(half)
            local low, high = math.ceil(cz - half - 0.5), math.floor(cz + half - 0.5)
            if low <= high then self:box(x0, y, low, x1, y, high, name) end
        end
    end
end

function Model:pairDisc(x0, x1, cy, cz, radius, name)
    self:disc(x0, x1, cy, cz, radius, name)
    local last = self.size[1] - 1
    self:disc(last - x1, last - x0, cy, cz, radius, name)
end

-- A bar of square section between two cells, both in.
function Model:bar(a, b, thick, name)
    local steps = math.max(math.abs(b[1] - a[1]), math.abs(b[2] - a[2]), math.abs(b[3] - a[3]), 1)
    for i = 0, steps do
        local function at(k) return math.floor(a[k] + (b[k] - a[k]) * i / steps + 0.5) end
        local x, y, z = at(1), at(2), at(3)
        self:box(x, y, z, x + thick - 1, y + thick - 1, z + thick - 1, name)
    end
end

-- A cabin with sloping screens: from z0 to z1 at y = low, shorter by so many cells a layer before and behind; a cell of
-- wall, panes between pillars at `posts`.
function Model:cabin(c)
    for y = c.low, c.top do
        local z0 = math.floor(c.z0 + (y - c.low) * (c.front or 0) + 0.5)
        local z1 = math.floor(c.z1 - (y - c.low) * (c.back or 0) + 0.5)
        local isRoof = y == c.top
        self:box(c.x0, y, z0, c.x1, y, z1, isRoof and c.paint or c.glass or "glass")
        if not isRoof then
            self:clear(c.x0 + 1, y, z0 + 1, c.x1 - 1, y, z1 - 1)
            for _, z in ipairs({z0, z1}) do
                self:box(c.x0, y, z, c.x0, y, z, c.paint)
                self:box(c.x1, y, z, c.x1, y, z, c.paint)
            end
            for _, z in ipairs(c.posts or {}) do
                self:box(c.x0, y, z, c.x0, y, z, c.paint)
                self:box(c.x1, y, z, c.x1, y, z, c.paint)
            end
        end
    end
end

build.record = nil  -- a list: models go there with their transforms, and no body is made

-- A body of a model at a transform. `density`: what its materials weigh, times this.
function build.body(model, transform, density)
    if build.record then
        build.record[#build.record + 1] = {model = model, at = transform.pos, rot = transform.rot}
        return 0, 0
    end
    local body, shape = CreateModel({size = model.size, origin = model.origin, voxel = model.voxel, boxes = model.boxes,
        palette = model.palette}, transform, true)
    if density then SetShapeDensity(shape, density) end
    return body, shape
end

-- A tyre on a rim, its axle along x, in cells of half the size, so that it rolls.
function build.wheelModel(radius, width, rim, tyre)
    local across, wide = math.floor(radius / 0.025 + 0.5), math.floor(width / 0.05 + 0.5)
    local m, c = build.model({wide, across, across}, {wide / 2, across / 2, across / 2}, 0.05), across / 2
    m:disc(0, wide - 1, c, c, c, tyre or "rubber")
    for i = 0, 15 do  -- treads
        local a = i * math.pi / 8
        local y, z = math.floor(c + (c - 0.9) * math.sin(a)), math.floor(c + (c - 0.9) * math.cos(a))
        m:box(i % 2 * (wide // 2), y, z, i % 2 == 0 and wide // 2 - 1 or wide - 1, y, z, tyre or "tread")
    end
    m:disc(0, wide - 1, c, c, 0.62 * c, "dark")
    for _, x in ipairs({0, wide - 1}) do
        m:disc(x, x, c, c, 0.58 * c, rim or "chrome")
        m:disc(x, x, c, c, 0.2 * c, "dark")
        for i = 0, 4 do
            local a = i * 0.4 * math.pi
            local y, z = math.floor(c + 0.38 * c * math.sin(a)), math.floor(c + 0.38 * c * math.cos(a))
            m:box(x, y, z, x, y, z, "dark")
        end
    end
    return m
end

return build
