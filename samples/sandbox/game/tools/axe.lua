-- Axe: splits wood along its grain, a long thin cut at each stroke. Other matter only chips.
local feel = require("feel")
local belt = require("toolbelt")

-- Along which axis of its shape the wood of a place is the longest: its grain.
local function grainAt(aim)
    local frame = GetShapeWorldTransform(aim.shape)
    local inside = aim.pos - 0.05 * aim.normal
    local best, longest = frame.rot * Vec(0, 1, 0), -1
    for _, axis in ipairs({Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1)}) do
        local along, run = frame.rot * axis, 0
        for _, sign in ipairs({-1, 1}) do
            for i = 1, 9 do
                if GetShapeMaterialAtPosition(aim.shape, inside + (0.1 * i * sign) * along) ~= "wood" then break end
                run = run + 1
            end
        end
        if math.abs(VecDot(along, aim.normal)) < 0.7 and run > longest then best, longest = along, run end
    end
    return best
end

local function strike(self)
    wait(0.08)
    local now = belt.aim(self.reach)
    if not now.hit then return end
    local material = feel.debris(now, 1.2)
    local at = now.pos + 0.06 * now.dir
    if material == "wood" then
        local grain = grainAt(now)
        MakeHoleLine(at - 0.42 * grain, at + 0.42 * grain, 0.1, 0.05)
    else
        MakeHole(at, 0.16, 0.06)
    end
    if now.body ~= 0 and IsBodyDynamic(now.body) then
        ApplyBodyImpulse(now.body, now.pos, VecScale(now.dir, math.min(180, 3 * GetBodyMass(now.body))))
    end
    feel.kick(-1.0)
    feel.shake(0.14)
end

return {
    name = "Axe",
    tip = "Splits wood along its grain",
    reach = 3.0,
    cooldown = 0.34,
    isAutomatic = true,
    turn = {24, 6, -10},
    hold = Vec(0.01, -0.03, 0.03),
    stroke = {pos = Vec(-0.06, -0.005, -0.09), turn = {-58, 10, 16}},
    model = {
        size = {4, 30, 14},
        origin = {2, 9, 9},
        palette = {{0.52, 0.36, 0.20, roughness = 0.6}, {0.30, 0.31, 0.33, roughness = 0.4, metallic = 0.5},
            {0.72, 0.73, 0.75, roughness = 0.2, metallic = 0.8}, {0.60, 0.10, 0.08, roughness = 0.6}},
        boxes = {{1, 0, 9, 2, 29, 10, 1}, {1, 0, 9, 2, 3, 11, 1}, {1, 23, 3, 2, 28, 12, 4}, {1, 22, 2, 2, 29, 4, 2},
            {1, 21, 0, 2, 30, 1, 3}},
        muzzle = Vec(0, 16, -8),
    },
    use = function(self)
        belt.swing(0.32)
        start(strike, self)
    end,
}
