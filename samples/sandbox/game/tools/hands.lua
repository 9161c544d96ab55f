-- Hands: the left button takes a thing and holds it, the right one throws it, or pushes.
local feel = require("feel")
local belt = require("toolbelt")
local interact = require("interact")

local kMaxMass, kPush = 260, 5

return {
    name = "Hands",
    tip = "Right button: push",
    reach = 2.8,
    cooldown = 0.2,
    turn = {8, -10, 10},
    hold = Vec(0.0, -0.015, 0.05),
    stroke = {pos = Vec(-0.05, 0.02, -0.10), turn = {-8, 10, 0}},
    model = {
        size = {10, 9, 30},
        origin = {5, 4, 14},
        palette = {{0.80, 0.58, 0.45, roughness = 0.7}, {0.22, 0.28, 0.38, roughness = 0.9},
            {0.74, 0.52, 0.40, roughness = 0.7}, {0.16, 0.20, 0.28, roughness = 0.9}},
        boxes = {{2, 1, 14, 8, 7, 29, 2}, {1, 2, 14, 9, 6, 29, 2}, {1, 1, 14, 9, 7, 16, 4}, {2, 2, 6, 8, 5, 13, 1},
            {1, 2, 0, 2, 4, 6, 1}, {3, 2, -2, 4, 4, 6, 1}, {3, 2, 0, 4, 4, 6, 3}, {5, 2, 0, 6, 4, 6, 1},
            {7, 2, 1, 8, 4, 6, 3}, {0, 4, 4, 1, 6, 10, 1}},
        muzzle = Vec(0, 0, -14),
    },
    use = function(self, aim)
        if aim.body == 0 or not IsBodyDynamic(aim.body) or GetBodyMass(aim.body) > kMaxMass then return false end
        interact.take(aim)
    end,
    alt = function(self, aim)
        belt.swing(0.3)
        if aim.body == 0 or not IsBodyDynamic(aim.body) then return end
        AddUndoMark()
        local mass = GetBodyMass(aim.body)
        ApplyBodyImpulse(aim.body, aim.pos, VecScale(aim.dir, math.min(1400, kPush * mass)))
        feel.kick(-0.8)
        feel.shake(0.1)
    end,
}
