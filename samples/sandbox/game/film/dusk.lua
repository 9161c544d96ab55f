-- Dusk: the house burns in the rain, and the lamps die.
local camera = require("film/camera")
local effects = require("film/effects")

local keys = {{0, Vec(9.2, 1.1, 50.2), Vec(21, 2.6, 37), 54}, {3.6, Vec(7.2, 2.6, 52.6), Vec(22, 3.6, 36), 54}}
local lamps = {}

local function light(pos)
    for i = 0, 5 do SpawnFire(pos + Vec(0.5 * (i % 3), 0.1, 0.6 * math.floor(i / 3))) end
end

-- A lamp flickers and goes out.
local function die(lamp)
    for _, seconds in ipairs({0.05, 0.08, 0.04, 0.15, 0.03, 0.06}) do
        SetLightEnabled(lamp, false)
        wait(seconds)
        SetLightEnabled(lamp, true)
        wait(seconds * 1.4)
    end
    SetLightEnabled(lamp, false)
end

return {
    name = "dusk",
    seconds = 3.6,
    unseen = 7,
    begin = function()
        SetEnvironment({clouds = 0.7, sun = Vec(-0.75, 0.03, -0.5), exposure = 1.7, wetness = 1, fogDensity = 0.008,
            fogHeight = 9, fogDistance = 110})
        SetRules({fireSpread = 5, fireTime = 0.14})
        for _, pos in ipairs({Vec(20, 0.3, 36.5), Vec(22, 3.0, 36.5), Vec(20, 3.0, 35), Vec(25, 5.8, 35)}) do light(pos) end
        lamps = FindLights()
    end,
    camera = function(t) return camera.held(keys, t, 0.7) end,
    cues = {{1.2, function() if lamps[1] then die(lamps[1]) end end}},
    update = function()
        local eye = GetCameraTransform()
        for _ = 1, 14 do
            local ahead = eye.rot * Vec(9 * (math.random() - 0.5), 0, -1 - 9 * math.random())
            effects.particle(eye.pos + ahead + Vec(0, 3.5, 0), Vec(1.2, -11, 0.3), {type = "spark",
                color = {0.010, 0.012, 0.016}, radius = {0.006, 0.006}, alpha = 0.5, life = 0.7, stretch = 0.035})
        end
    end,
}
