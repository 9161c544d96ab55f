-- The town late in the day, seen from the kerb and then from above the trees.
local camera = require("film/camera")
local effects = require("film/effects")
local sounds = require("sounds")

local keys = {{0, Vec(25.4, 0.85, 51.6), Vec(19.5, 2.4, 41), 54}, {1.5, Vec(21.5, 2.8, 55.4), Vec(21.5, 4.4, 38), 52},
    {3.6, Vec(13.0, 8.4, 58.6), Vec(26.6, 8.0, 31), 56}}

return {
    name = "town",
    seconds = 3.6,
    unseen = 1.5,
    begin = function()
        SetEnvironment({clouds = 0.36, sun = Vec(-0.82, 0.25, 0.36), exposure = 0.95, fogDistance = 220,
            fogDensity = 0.0015, fogHeight = 12, fogForward = 0.6})
    end,
    camera = function(t) return camera.held(keys, t, 0.5) end,
    -- Somebody is at home: the chimney smokes.
    update = function()
        sounds.loop("wind", nil, 0.25)
        if math.random() < 0.2 then
            effects.particle(Vec(27.4, 9.2, 34.2), Vec(0.5, 0.8, 0.1), {type = "smoke", color = {0.5, 0.5, 0.52},
                radius = {0.12, 0.8}, alpha = 0.22, life = 4, drag = 0.5, spin = 0.4})
        end
    end,
}
