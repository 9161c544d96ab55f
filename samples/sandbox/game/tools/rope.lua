-- Rope: two clicks tie one between two places. The right button ties the last one shorter, or gives up.
local feel = require("feel")
local belt = require("toolbelt")

local kLongest = 25
local first = nil

local rope = {
    name = "Rope",
    tip = "Two clicks tie a rope between two places",
    reach = 25,
    ammo = 20,
    cooldown = 0.2,
    turn = {16, -14, 0},
    hold = Vec(-0.01, -0.01, 0.03),
    model = {
        size = {17, 17, 7},
        origin = {8, 8, 3},
        palette = {{0.66, 0.54, 0.36, roughness = 0.9}, {0.54, 0.43, 0.27, roughness = 0.9},
            {0.45, 0.46, 0.48, roughness = 0.3, metallic = 0.7}},
        boxes = {{3, 0, 1, 13, 2, 5, 1}, {3, 14, 1, 13, 16, 5, 1}, {0, 3, 1, 2, 13, 5, 1}, {14, 3, 1, 16, 13, 5, 1},
            {1, 1, 1, 3, 3, 5, 2}, {13, 1, 1, 15, 3, 5, 2}, {1, 13, 1, 3, 15, 5, 2}, {13, 13, 1, 15, 15, 5, 2},
            {3, 0, 3, 13, 2, 3, 2}, {3, 14, 3, 13, 16, 3, 2}, {15, 8, 6, 16, 12, 6, 3}},
        muzzle = Vec(0, 0, -6),
    },
}

function rope:use(aim)
    if not aim.hit or aim.shape == 0 then return false end
    belt.recoil(0.4)
    local place = {pos = aim.pos, shape = aim.shape}
    if not first then first = place return false end
    local a, length = first, VecLength(place.pos - first.pos)
    first = nil
    if length < 0.3 or length > kLongest or not IsHandleValid(a.shape) then return false end
    CreateRope(a.shape, a.pos, place.shape, place.pos, 1.02 * length, 60000)
end

function rope:alt()
    first = nil
end
rope.release = rope.alt

function rope:tick(aim)
    if not first then return end
    local isGood = aim.hit and VecLength(aim.pos - first.pos) <= kLongest
    DrawLine(first.pos, aim.pos, isGood and 0.9 or 1, isGood and 0.8 or 0.3, 0.4, 0.9)
end

return rope
