-- Extinguisher: a cloud that puts out fires and keeps things from burning for a while.
local feel = require("feel")
local sounds = require("sounds")
local belt = require("toolbelt")

return {
    name = "Extinguisher",
    tip = "Puts out fires",
    reach = 7,
    cooldown = 0.04,
    isAutomatic = true,
    marksUndo = false,
    turn = {8, 10, -6},
    hold = Vec(0.0, -0.03, 0.02),
    model = {
        size = {9, 30, 22},
        origin = {4, 16, 12},
        palette = {{0.72, 0.09, 0.07, roughness = 0.3}, {0.12, 0.12, 0.13, roughness = 0.6},
            {0.62, 0.63, 0.65, roughness = 0.3, metallic = 0.7}, {0.92, 0.90, 0.84, roughness = 0.6}},
        boxes = {{1, 0, 9, 7, 21, 17, 1}, {0, 1, 10, 8, 20, 16, 1}, {1, 8, 8, 7, 14, 8, 4}, {0, 9, 10, 8, 13, 16, 4},
            {3, 22, 12, 5, 24, 14, 3}, {3, 25, 9, 5, 26, 20, 2}, {3, 22, 15, 5, 22, 20, 2}, {3, 24, 2, 5, 25, 9, 2},
            {2, 23, 0, 6, 26, 2, 2}},
        muzzle = Vec(0, 9, -13),
    },
    use = function(self, aim)
        local muzzle = belt.muzzle()
        sounds.loop("jet", muzzle, 0.7)
        feel.burst(muzzle, aim.dir, {type = "smoke", count = 4, speed = 8, spread = 0.2, life = 1.1,
            color = {0.86, 0.89, 0.92}, radius = {0.02, 0.28}, alpha = 0.13, drag = 2.2, gravity = -0.4})
        local reach = aim.hit and aim.dist or self.reach
        for far = 1, math.ceil(reach) do
            Extinguish(aim.eye + math.min(far, reach) * aim.dir, 0.8 + 0.1 * far, 12)
        end
        if aim.hit and aim.body ~= 0 and IsBodyDynamic(aim.body) and GetBodyMass(aim.body) < 60 then
            ApplyBodyImpulse(aim.body, aim.pos, VecScale(aim.dir, 6))
        end
        belt.recoil(0.03)
    end,
}
