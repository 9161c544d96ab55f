-- Timed bomb: thrown, it blinks ever faster and goes off after three seconds.
local feel = require("feel")
local belt = require("toolbelt")
local bombs = require("tools/bombs")

local kSeconds = 3
local prop = {
    voxel = 0.05, size = {5, 4, 6},
    palette = {{0.55, 0.10, 0.08, material = "plastic"}, {0.14, 0.14, 0.15, material = "plastic"},
        {1.0, 0.15, 0.1, material = "plastic", emission = 4}},
    boxes = {{0, 0, 0, 4, 2, 5, 1}, {1, 3, 1, 3, 3, 4, 2}, {2, 3, 2, 2, 3, 2, 3}},
}

local function blink(body)
    while IsHandleValid(body) do
        local left = bombs.left(body) or kSeconds
        local at = bombs.center(body) + Vec(0, 0.15, 0)
        PointLight(at, 5, 0.7, 0.4, 1)
        wait(0.03)
        PointLight(at, 3, 0.4, 0.2, 1)
        wait(math.max(0.08, 0.12 * left))
    end
end

return {
    name = "Timed bomb",
    tip = "Goes off after three seconds",
    ammo = 10,
    cooldown = 0.5,
    turn = {14, -18, 0},
    hold = Vec(-0.01, -0.01, 0.02),
    model = {
        size = {11, 9, 14},
        origin = {5, 4, 7},
        palette = {{0.55, 0.10, 0.08, roughness = 0.6}, {0.13, 0.13, 0.14, roughness = 0.5},
            {1.0, 0.2, 0.12, emission = 3}, {0.75, 0.72, 0.62, roughness = 0.7}},
        boxes = {{0, 0, 0, 2, 6, 13, 1}, {4, 0, 0, 6, 6, 13, 1}, {8, 0, 0, 10, 6, 13, 1}, {0, 0, 3, 10, 6, 4, 4},
            {0, 0, 10, 10, 6, 11, 4}, {2, 7, 3, 8, 8, 10, 2}, {4, 9, 5, 6, 8, 6, 3}, {4, 8, 5, 6, 8, 6, 3}},
        muzzle = Vec(0, 0, -8),
    },
    use = function(self, aim)
        local body = bombs.throw(prop, aim, "timebomb", 9)
        bombs.light(body, kSeconds)
        start(blink, body)
        belt.raise = 1
    end,
    resume = function()
        for _, body in ipairs(FindBodies("timebomb")) do
            if HasTag(body, "timebomb") then start(blink, body) end
        end
    end,
}
