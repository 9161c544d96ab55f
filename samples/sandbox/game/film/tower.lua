-- The office tower loses its front columns and comes down under its own weight.
local camera = require("film/camera")
local effects = require("film/effects")

local corner = Vec(28.4, 0, 15.2)  -- low corner on the ground; a side has 6.4 m
local keys = {{0, Vec(24.2, 1.5, 47.2), Vec(31, 12.5, 18), 62}, {2.4, Vec(23.8, 1.6, 48.6), Vec(31, 9.5, 24), 62},
    {5.0, Vec(22.8, 2.4, 51.0), Vec(30.6, 4.0, 36), 60}}
local dust = {0.44, 0.41, 0.37}

-- Cuts the ground floor from z0 to z1, between two heights.
local function notch(z0, z1, low, high)
    for z = z0 + 0.25, z1, 0.5 do
        for y = low + 0.25, high, 0.5 do
            MakeHoleLine(corner + Vec(-0.2, y, z), corner + Vec(6.6, y, z), 0.42, 0.42, 0.42)
        end
    end
end

local function fell()
    for _, x in ipairs({0.25, 3.2, 6.15}) do
        effects.blast(corner + Vec(x, 0.9, 6.15), 1.7, {ground = 0, dust = dust})
        wait(0.08)
    end
    notch(4.4, 6.6, 0.2, 2.2)
    wait(0.1)
    for _, x in ipairs({0.25, 3.2, 6.15}) do effects.blast(corner + Vec(x, 0.8, 3.2), 1.6, {dust = dust}) end
    notch(1.4, 4.4, 0.3, 1.3)
    wait(0.2)
    notch(-0.2, 1.4, 0.5, 0.7)
end

return {
    name = "tower",
    seconds = 5.0,
    unseen = 1.0,
    begin = function()
        SetEnvironment({clouds = 0.4, sun = Vec(-0.80, 0.30, 0.52), exposure = 0.9, fogDensity = 0.002, fogHeight = 12})
        SetRules({stress = true, contactTime = 0.0015})
        start(fell)
    end,
    camera = function(t) return camera.held(keys, t, 0.8 + camera.jolt(t, 2.9, 8)) end,
    speed = function(t) return 1 - 0.6 * camera.ease(t, 1.6, 2.4) end,
}
