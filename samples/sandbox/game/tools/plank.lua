-- Plank: two clicks nail a board between two places.
local feel = require("feel")
local belt = require("toolbelt")

local kLongest, kNail = 5, 30000
local first = nil

local function plankModel(length)
    local cells = math.max(3, math.floor(10 * length + 0.5))
    return {
        voxel = 0.1, size = {2, 1, cells},
        palette = {{0.56, 0.40, 0.24, material = "wood"}, {0.50, 0.35, 0.20, material = "wood"},
            {0.61, 0.45, 0.28, material = "wood"}},
        boxes = {{0, 0, 0, 1, 0, cells - 1, 1}, {0, 0, 1, 0, 0, cells - 3, 2}, {1, 0, cells // 3, 1, 0, cells // 2, 3}},
    }
end

local function nail(shape, place)
    if place.shape ~= 0 and IsHandleValid(place.shape) then CreateNail(shape, place.shape, place.pos, kNail) end
end

local function build(a, b)
    local length = VecLength(b.pos - a.pos)
    local middle = VecLerp(a.pos, b.pos, 0.5) + 0.03 * (a.normal + b.normal)
    local _, shape = CreateModel(plankModel(length + 0.2), Transform(middle, QuatLookAt(a.pos, b.pos)), true)
    nail(shape, a)
    nail(shape, b)
    for _, end_ in ipairs({a, b}) do feel.debris({hit = true, shape = 0, pos = end_.pos, normal = end_.normal}, 0.2) end
end

local plank = {
    name = "Plank",
    tip = "Two clicks nail a board between two places",
    reach = 6,
    ammo = 24,
    cooldown = 0.2,
    turn = {6, -22, 8},
    hold = Vec(-0.02, -0.02, 0.02),
    model = {
        size = {6, 3, 46},
        origin = {3, 1, 26},
        palette = {{0.56, 0.40, 0.24, roughness = 0.7}, {0.48, 0.33, 0.19, roughness = 0.7},
            {0.62, 0.46, 0.29, roughness = 0.7}, {0.6, 0.6, 0.62, roughness = 0.3, metallic = 0.7}},
        boxes = {{0, 0, 0, 5, 1, 45, 1}, {1, 1, 2, 1, 1, 40, 2}, {4, 1, 8, 4, 1, 44, 3}, {3, 1, 0, 3, 1, 22, 2},
            {2, 2, 3, 2, 2, 3, 4}, {4, 2, 4, 4, 2, 4, 4}},
        muzzle = Vec(0, 0, -24),
    },
}

function plank:use(aim)
    if not aim.hit or aim.shape == 0 then return false end
    local place = {pos = aim.pos, normal = aim.normal, shape = aim.shape}
    belt.recoil(0.5)
    if not first then first = place return false end
    local length = VecLength(place.pos - first.pos)
    if length < 0.3 or length > kLongest then first = nil return false end
    build(first, place)
    first = nil
end

function plank:alt()
    first = nil
end
plank.release = plank.alt

-- A line where the board will be; red where it would be too long.
function plank:tick(aim)
    if not first then return end
    local isGood = aim.hit and VecLength(aim.pos - first.pos) <= kLongest
    DrawLine(first.pos + 0.03 * first.normal, aim.pos + 0.03 * (aim.normal or Vec(0, 1, 0)), isGood and 0.5 or 1,
        isGood and 1 or 0.3, 0.4, 0.9)
end

return plank
