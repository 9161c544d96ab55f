-- Drill: holds on, and bores a round hole that grows as deep as an arm.
local feel = require("feel")
local sounds = require("sounds")
local belt = require("toolbelt")

local depth, spin = 0, 0

local drill = {
    name = "Drill",
    tip = "Bores deep; hold it",
    reach = 2.4,
    cooldown = 0.07,
    isAutomatic = true,
    marksUndo = false,
    turn = {2, 4, 0},
    hold = Vec(-0.005, 0.0, 0.0),
    model = {
        size = {9, 18, 40},
        origin = {4, 12, 22},
        palette = {{0.85, 0.55, 0.08, roughness = 0.5}, {0.13, 0.13, 0.14, roughness = 0.6},
            {0.55, 0.56, 0.58, roughness = 0.25, metallic = 0.8}, {0.38, 0.39, 0.41, roughness = 0.3, metallic = 0.7}},
        boxes = {{1, 9, 16, 7, 15, 36, 1}, {0, 10, 18, 8, 14, 34, 1}, {2, 0, 26, 6, 8, 31, 2}, {1, 9, 34, 7, 15, 36, 2},
            {2, 10, 12, 6, 14, 15, 2}, {3, 11, 4, 5, 13, 11, 3}, {3, 11, 1, 4, 12, 3, 4}, {4, 12, 0, 4, 12, 0, 3},
            {3, 13, 5, 3, 13, 6, 4}, {5, 11, 8, 5, 11, 9, 4}, {4, 8, 24, 4, 8, 25, 4}},
        muzzle = Vec(0, 0.5, -22),
    },
}

function drill:use(aim)
    sounds.loop("motor", belt.muzzle(), 0.8, aim.hit and 1 or 1.3)
    belt.recoil(0.12 * (math.random() - 0.3))
    feel.shake(0.03)
    spin = spin + 1
    if not aim.hit then return end
    if not self.at or VecLength(self.at - aim.pos) > 0.45 + depth then self.at, depth = aim.pos, 0 end
    depth = math.min(0.9, depth + 0.06)
    MakeHoleLine(self.at, self.at + depth * aim.dir, 0.13, 0.13, 0.06)
    feel.debris(aim, 0.5)
    if aim.body ~= 0 and IsBodyDynamic(aim.body) then
        ApplyBodyImpulse(aim.body, aim.pos, VecScale(aim.dir, math.min(25, 0.5 * GetBodyMass(aim.body))))
    end
end

function drill:tick()
    if InputPressed("usetool") then AddUndoMark() end
    if not InputDown("usetool") then self.at = nil end
end

return drill
