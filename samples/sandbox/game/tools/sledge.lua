-- Sledgehammer: a short swing that caves in what is soft and chips what is not.
local feel = require("feel")
local belt = require("toolbelt")

return {
    name = "Sledgehammer",
    tip = "Breaks wood, plaster and glass",
    reach = 3.2,
    cooldown = 0.42,
    isAutomatic = true,
    turn = {22, 8, -12},
    hold = Vec(0.01, -0.035, 0.03),
    stroke = {pos = Vec(-0.07, -0.01, -0.09), turn = {-62, 18, 22}},
    model = {
        size = {8, 28, 12},
        origin = {4, 8, 6},
        palette = {{0.45, 0.30, 0.17, roughness = 0.6}, {0.36, 0.37, 0.40, roughness = 0.35, metallic = 0.6},
            {0.52, 0.53, 0.55, roughness = 0.3, metallic = 0.6}, {0.55, 0.12, 0.08, roughness = 0.7}},
        boxes = {{3, 0, 5, 4, 22, 6, 1}, {3, 0, 5, 4, 5, 6, 4}, {2, 20, 1, 5, 25, 10, 2}, {2, 20, 0, 5, 25, 0, 3},
            {2, 20, 11, 5, 25, 11, 3}, {3, 26, 5, 4, 26, 6, 1}},
        muzzle = Vec(0, 16, -6),
    },
    use = function(self, aim)
        belt.swing(0.38)
        start(function()
            wait(0.09)
            local now = belt.aim(self.reach)
            if not now.hit then return end
            MakeHole(now.pos + 0.05 * now.dir, 0.30, 0.18, 0)
            Crack(now.pos + 0.08 * now.dir, 0.62, 0.42, 0)  -- ragged, as the matter breaks
            if now.body ~= 0 and IsBodyDynamic(now.body) then
                ApplyBodyImpulse(now.body, now.pos, VecScale(now.dir, math.min(420, 6 * GetBodyMass(now.body))))
            end
            local material = feel.debris(now, 1.6)
            if material:find("metal") then
                feel.flash(now.pos + 0.1 * now.normal, {1, 0.7, 0.3}, 2.5, 0.05)
            end
            feel.kick(-1.4)
            feel.shake(0.22)
        end)
    end,
}
