-- The wall of a furnished room is blown in, and the low sun floods the room.
local camera = require("film/camera")
local effects = require("film/effects")

local wall = Vec(18.15, 1.35, 37.0)
local keys = {{0, Vec(22.75, 1.75, 34.95), Vec(18.2, 1.25, 37.3), 66}, {1.0, Vec(22.55, 1.7, 35.05), Vec(18.2, 1.3, 37.2), 66},
    {4.0, Vec(21.9, 1.55, 35.3), Vec(17.8, 1.5, 37.0), 68}}
local dust = {0.50, 0.40, 0.32}

return {
    name = "room",
    seconds = 4.0,
    unseen = 1.0,
    begin = function()
        SetEnvironment({clouds = 0.3, sun = Vec(-0.88, 0.34, 0.26), exposure = 1.15, fogDensity = 0.02, fogHeight = 6,
            fogForward = 0.5})
    end,
    camera = function(t) return camera.held(keys, t, 0.6 + camera.jolt(t, 0.9, 16)) end,
    speed = function(t) return t < 1.0 and 1 or 1 - 0.68 * camera.ease(t, 1.0, 1.35) + 0.4 * camera.ease(t, 3.0, 4.0) end,
    cues = {
        {0.88, function()
            effects.blast(wall + Vec(-0.55, 0, 0), 2.2, {dust = dust, way = Vec(1.2, 0, -0.3), fire = 0.7, light = 900})
            effects.haze(wall + Vec(0.8, 0, 0), Vec(1.6, 1.2, 1.8), 30, dust, 1.4)
        end},
    },
}
