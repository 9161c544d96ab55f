-- Vacuum: draws in small loose pieces and swallows them.
local feel = require("feel")
local sounds = require("sounds")
local belt = require("toolbelt")

local kReach, kMaxMass = 6, 90

local function swallow(body, at)
    Delete(body)
    feel.burst(at, Vec(0, 0, 0), {type = "dust", count = 1, speed = 0.4, spread = 1, life = 0.25,
        color = {0.5, 0.47, 0.42}, radius = {0.03, 0.06}, alpha = 0.12})
end

return {
    name = "Vacuum",
    tip = "Cleans up small pieces",
    reach = kReach,
    cooldown = 0.0,
    isAutomatic = true,
    marksUndo = false,
    turn = {4, 4, 0},
    hold = Vec(-0.005, -0.005, 0.02),
    model = {
        size = {11, 13, 40},
        origin = {5, 7, 24},
        palette = {{0.16, 0.45, 0.42, roughness = 0.4}, {0.13, 0.13, 0.14, roughness = 0.6},
            {0.75, 0.76, 0.78, roughness = 0.3, metallic = 0.6}, {0.55, 0.75, 0.72, roughness = 0.3}},
        boxes = {{1, 2, 22, 9, 11, 38, 1}, {0, 4, 24, 10, 9, 36, 1}, {3, 5, 6, 7, 9, 22, 3}, {1, 4, 0, 9, 10, 6, 2},
            {0, 5, 0, 10, 9, 3, 2}, {2, 12, 26, 8, 12, 34, 2}, {9, 5, 28, 10, 8, 33, 4}},
        muzzle = Vec(0, 0, -25),
    },
    use = function(self, aim)
        local muzzle = belt.muzzle()
        local middle = aim.eye + 0.5 * kReach * aim.dir
        local half = Vec(2.6, 2.6, 2.6)
        for _, body in ipairs(QueryAabbBodies(middle - half, middle + half)) do
            if IsBodyDynamic(body) and not HasTag(body, "viewmodel") and GetBodyMass(body) < kMaxMass then
                local at = GetBodyTransform(body) * GetBodyCenterOfMass(body)
                local to = muzzle - at
                local dist = VecLength(to)
                if dist < 0.9 then
                    swallow(body, at)
                elseif VecDot(VecNormalize(at - aim.eye), aim.dir) > 0.86 then
                    SetBodyVelocity(body, VecLerp(GetBodyVelocity(body), VecScale(to, 9 / dist), 0.35))
                end
            end
        end
        sounds.loop("motor", muzzle, 0.8, 1.6)
        feel.burst(muzzle + 1.4 * aim.dir, VecScale(aim.dir, -1), {type = "dust", count = 1, speed = 5, spread = 0.3,
            life = 0.24, color = {0.6, 0.58, 0.55}, radius = {0.05, 0.01}, alpha = 0.2})
        belt.recoil(0.02 * math.random())
    end,
    tick = function(self)
        if InputPressed("usetool") then AddUndoMark() end
    end,
}
