-- Pistol: a small deep hole where it hits, and a push.
local feel = require("feel")
local sounds = require("sounds")
local belt = require("toolbelt")

return {
    name = "Pistol",
    tip = "R reloads",
    ammo = 12,
    cooldown = 0.16,
    turn = {2, 3, 0},
    hold = Vec(-0.01, 0.005, 0.0),
    model = {
        size = {5, 13, 20},
        origin = {2, 8, 14},
        palette = {{0.13, 0.14, 0.15, roughness = 0.4, metallic = 0.5},
            {0.23, 0.24, 0.26, roughness = 0.3, metallic = 0.6},
            {0.10, 0.08, 0.07, roughness = 0.8}, {0.9, 0.9, 0.85, emission = 1.5}},
        boxes = {{1, 8, 0, 3, 10, 17, 2}, {1, 6, 2, 3, 7, 17, 1}, {1, 0, 13, 3, 6, 17, 3}, {2, 4, 8, 2, 4, 12, 1},
            {2, 5, 8, 2, 6, 8, 1}, {2, 11, 1, 2, 11, 1, 4}, {1, 11, 16, 1, 11, 17, 1}, {3, 11, 16, 3, 11, 17, 1}},
        muzzle = Vec(0, 1, -15),
    },
    use = function(self, aim)
        Shoot(aim.eye, aim.dir, "bullet", 0.55, 120)
        local muzzle = belt.muzzle()
        sounds.play("shot", muzzle)
        feel.flash(muzzle + 0.45 * aim.dir, {1, 0.75, 0.4}, 2.2, 0.05)
        feel.burst(muzzle, aim.dir, {type = "flame", count = 3, speed = 1.5, spread = 0.15, life = 0.06,
            color = {1, 0.7, 0.3}, radius = {0.03, 0.012}, alpha = 0.95, emissive = 0.3})
        feel.burst(muzzle, aim.dir + Vec(0, 0.3, 0), {type = "smoke", count = 2, speed = 0.6, life = 0.6,
            color = {0.5, 0.5, 0.5}, radius = {0.012, 0.06}, alpha = 0.16})
        feel.debris(aim, 0.7)
        feel.kick(1.1)
        belt.recoil(0.9)
    end,
}
