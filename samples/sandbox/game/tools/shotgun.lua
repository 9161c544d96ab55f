-- Shotgun: nine pellets that spread, each with a hole of its own.
local feel = require("feel")
local sounds = require("sounds")
local belt = require("toolbelt")

return {
    name = "Shotgun",
    tip = "R reloads",
    ammo = 8,
    cooldown = 0.7,
    turn = {1, 3, 0},
    hold = Vec(-0.005, 0.005, 0.03),
    model = {
        size = {5, 11, 52},
        origin = {2, 7, 34},
        palette = {{0.16, 0.16, 0.17, roughness = 0.35, metallic = 0.6}, {0.42, 0.27, 0.14, roughness = 0.5},
            {0.33, 0.20, 0.10, roughness = 0.55}, {0.62, 0.50, 0.22, roughness = 0.3, metallic = 0.7}},
        boxes = {{1, 7, 0, 3, 9, 33, 1}, {1, 5, 2, 3, 6, 30, 1}, {1, 4, 8, 3, 6, 17, 2}, {1, 4, 28, 3, 9, 36, 1},
            {1, 2, 35, 3, 7, 41, 3}, {1, 0, 40, 3, 6, 51, 2}, {2, 10, 1, 2, 10, 1, 4}, {2, 3, 32, 2, 3, 35, 1}},
        muzzle = Vec(0, 1, -35),
    },
    use = function(self, aim)
        local right, up = aim.rot * Vec(1, 0, 0), aim.rot * Vec(0, 1, 0)
        for i = 0, 8 do
            local angle, far = 2.4 * i, 0.014 * math.sqrt(i)
            local dir = VecNormalize(aim.dir + (far * math.cos(angle)) * right + (far * math.sin(angle)) * up)
            Shoot(aim.eye, dir, "bullet", 0.45, 40)
        end
        if aim.hit and aim.dist < 12 then Crack(aim.pos, 0.34, 0.2, 0) end
        local muzzle = belt.muzzle()
        sounds.play("blast", muzzle)
        feel.flash(muzzle + 0.5 * aim.dir, {1, 0.72, 0.36}, 4, 0.06)
        feel.burst(muzzle, aim.dir, {type = "flame", count = 6, speed = 2.5, spread = 0.25, life = 0.08,
            color = {1, 0.7, 0.3}, radius = {0.045, 0.015}, alpha = 0.95, emissive = 0.5})
        feel.burst(muzzle, aim.dir + Vec(0, 0.2, 0), {type = "smoke", count = 4, speed = 0.9, life = 0.9,
            color = {0.5, 0.5, 0.5}, radius = {0.02, 0.12}, alpha = 0.18, drag = 2})
        if aim.dist and aim.dist < 40 then feel.debris(aim, 2) end
        feel.kick(2.8)
        feel.shake(0.3)
        belt.recoil(1.6)
    end,
}
