-- Rocket launcher: a rocket that flies, trails smoke and explodes where it arrives.
local feel = require("feel")
local sounds = require("sounds")
local belt = require("toolbelt")
local bombs = require("tools/bombs")

local kSpeed, kSize, kRange = 38, 1.7, 150

-- Flies until something is in its way.
local function fly(pos, dir)
    local gone = 0
    while gone < kRange do
        local step = kSpeed / 60
        belt.rejectModel()
        local hit, dist = QueryRaycast(pos, dir, step + 0.2, 0.1)
        if hit then
            local at = pos + dist * dir
            return bombs.blast(at - 0.1 * dir, kSize)
        end
        pos = pos + step * dir
        gone = gone + step
        feel.burst(pos, VecScale(dir, -1), {type = "flame", count = 2, speed = 3, spread = 0.15, life = 0.12,
            color = {1, 0.6, 0.25}, radius = {0.06, 0.02}, alpha = 0.9, emissive = 2})
        feel.burst(pos, VecScale(dir, -1), {type = "smoke", count = 2, speed = 0.8, spread = 0.3, life = 1.6,
            color = {0.62, 0.6, 0.58}, radius = {0.07, 0.34}, alpha = 0.3, drag = 2})
        sounds.loop("rocket", pos)
        PointLight(pos, 60, 34, 14, 1)
        wait(0)
    end
end

return {
    name = "Rocket launcher",
    tip = "R reloads",
    ammo = 4,
    cooldown = 0.8,
    turn = {0, 4, 0},
    hold = Vec(0.02, 0.015, 0.05),
    model = {
        size = {7, 13, 44},
        origin = {3, 7, 24},
        palette = {{0.25, 0.29, 0.18, roughness = 0.7}, {0.17, 0.20, 0.13, roughness = 0.7},
            {0.10, 0.10, 0.10, roughness = 0.6}, {0.62, 0.50, 0.13, roughness = 0.5}},
        boxes = {{1, 6, 0, 5, 10, 43, 1}, {0, 7, 0, 6, 9, 43, 1}, {0, 5, 0, 6, 11, 2, 2}, {0, 5, 40, 6, 11, 43, 2},
            {2, 7, 0, 4, 9, 0, 3}, {0, 6, 14, 6, 10, 15, 4}, {2, 0, 20, 4, 5, 22, 3}, {2, 1, 10, 4, 5, 11, 3},
            {5, 11, 12, 6, 12, 17, 3}},
        muzzle = Vec(0, 1, -25),
    },
    use = function(self, aim)
        local muzzle = belt.muzzle()
        local dir = VecNormalize(aim.pos - muzzle)
        start(fly, muzzle, dir)
        sounds.play("launch", muzzle)
        feel.flash(muzzle + 0.6 * aim.dir, {1, 0.7, 0.4}, 10, 0.1)
        feel.burst(belt.frame() * Vec(0, 0, 0.2), VecScale(aim.dir, -1), {type = "smoke", count = 12, speed = 3,
            spread = 0.4, life = 0.9, color = {0.7, 0.68, 0.66}, radius = {0.05, 0.35}, alpha = 0.3, drag = 3})
        feel.kick(2.6)
        feel.shake(0.3)
        belt.recoil(1.6)
    end,
}
