-- Blowtorch: lights what burns, and melts a way through thin metal.
local feel = require("feel")
local sounds = require("sounds")
local belt = require("toolbelt")

local burning = 0

return {
    name = "Blowtorch",
    tip = "Lights wood, cuts thin metal",
    reach = 2.2,
    cooldown = 0.05,
    isAutomatic = true,
    marksUndo = false,
    turn = {6, 2, 0},
    hold = Vec(0.0, -0.005, 0.01),
    model = {
        size = {7, 22, 26},
        origin = {3, 14, 16},
        palette = {{0.12, 0.30, 0.56, roughness = 0.35}, {0.70, 0.58, 0.28, roughness = 0.25, metallic = 0.8},
            {0.20, 0.20, 0.21, roughness = 0.5, metallic = 0.3}, {0.10, 0.22, 0.42, roughness = 0.4}},
        boxes = {{1, 0, 14, 5, 12, 20, 1}, {0, 0, 15, 6, 11, 19, 1}, {1, 5, 14, 5, 7, 20, 4}, {2, 13, 16, 4, 15, 18, 3},
            {2, 14, 6, 4, 16, 18, 2}, {3, 15, 1, 3, 15, 6, 2}, {2, 14, 0, 4, 16, 2, 3}, {2, 16, 19, 4, 16, 22, 3}},
        muzzle = Vec(0, 1.5, -17),
    },
    use = function(self, aim)
        burning = 0.1
        local muzzle = belt.muzzle()
        local jitter = 0.006 * Vec(math.random() - 0.5, math.random() - 0.5, math.random() - 0.5)
        for i = 1, 3 do
            DrawLine(muzzle, muzzle + (0.05 + 0.03 * i) * aim.dir + i * jitter, 0.3 + 0.2 * i, 0.55 + 0.14 * i, 1, 0.8)
        end
        sounds.loop("jet", muzzle, 0.35)
        feel.burst(muzzle, aim.dir, {type = "flame", count = 2, speed = 2.2, spread = 0.07, life = 0.14,
            color = {0.35, 0.55, 1}, radius = {0.012, 0.03}, alpha = 0.9, emissive = 0.08})
        if not aim.hit then return end
        local material = feel.material(aim)
        if material == "metal" or material == "wire" or material == "plastic" then
            MakeHole(aim.pos + 0.02 * aim.dir, 0.1, 0.1)
            feel.burst(aim.pos, aim.normal, {type = "spark", count = 3, speed = 3.5, spread = 0.8, life = 0.5,
                color = {1, 0.6, 0.2}, radius = {0.01, 0.004}, gravity = -6, emissive = 0.3, stretch = 0.03})
        elseif aim.shape ~= 0 then
            AddHeat(aim.shape, aim.pos, 0.12)
            feel.burst(aim.pos, aim.normal, {type = "smoke", count = 1, speed = 0.5, life = 1.1,
                color = {0.25, 0.24, 0.23}, radius = {0.04, 0.2}, alpha = 0.25, gravity = 0.6})
        end
        Paint(aim.pos, 0.13, "explosion", 0.25)
        PointLight(aim.pos + 0.12 * aim.normal, 0.8, 0.45, 0.16, 1)
    end,
    tick = function(self, aim, dt)
        burning = math.max(0, burning - dt)
        if InputPressed("usetool") then AddUndoMark() end
    end,
}
