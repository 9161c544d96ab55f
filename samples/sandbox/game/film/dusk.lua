-- Dusk: the house burns in the rain, and the lights die.
local camera = require("film/camera")
local effects = require("film/effects")
local sounds = require("sounds")

local keys = {{0, Vec(9.2, 1.1, 50.2), Vec(21, 2.6, 37), 54}, {3.6, Vec(7.2, 2.6, 52.6), Vec(22, 3.6, 36), 54}}

local function light(pos)
    for i = 0, 5 do SpawnFire(pos + Vec(0.5 * (i % 3), 0.1, 0.6 * math.floor(i / 3))) end
end

-- Switches all lights of a shape, and what glows on it.
local function switch(name, isOn)
    local shape = FindShape(name)
    if shape == 0 then return end
    for _, light in ipairs(GetShapeLights(shape)) do SetLightEnabled(light, isOn) end
    SetShapeEmissiveScale(shape, isOn and 1 or 0)
end

-- They flicker and go out.
local function die(name)
    for i = 1, 4 do
        switch(name, false)
        wait(0.03 + 0.03 * (i % 3))
        switch(name, true)
        wait(0.05 + 0.05 * (i % 2))
    end
    switch(name, false)
end

-- Drops before the camera, and what they throw up where they fall.
local function rain(t)
    sounds.loop("rain", nil, 0.5)
    sounds.loop("wind", nil, 0.2)
    local eyePos, target = camera.path(keys, math.max(t, 0))
    local frame = Transform(eyePos, QuatLookAt(eyePos, target))
    for _ = 1, 10 do
        local p = frame * Vec(11 * (math.random() - 0.5), 0, -1.5 - 11 * math.random())
        effects.particle(Vec(p.x, eyePos.y + 4, p.z), Vec(1.2, -11, 0.3), {type = "spark",
            color = {0.008, 0.010, 0.013}, radius = {0.005, 0.005}, alpha = 0.45, life = 0.75, stretch = 0.035})
    end
    for _ = 1, 5 do
        local p = frame * Vec(12 * (math.random() - 0.5), 0, -2 - 10 * math.random())
        local hit, dist = QueryRaycast(Vec(p.x, 4, p.z), Vec(0, -1, 0), 6)
        if hit then
            for _ = 1, 3 do
                effects.particle(Vec(p.x, 4.02 - dist, p.z), Vec(math.random() - 0.5, 0.8 + 0.6 * math.random(),
                    math.random() - 0.5), {type = "glint", color = {0.25, 0.28, 0.33}, radius = {0.012, 0.008},
                    alpha = 0.6, life = 0.25})
            end
        end
    end
end

return {
    name = "dusk",
    seconds = 3.6,
    unseen = 6.5,
    begin = function()
        SetEnvironment({clouds = 0.7, sun = Vec(-0.75, 0.03, -0.5), exposure = 1.7, wetness = 1, fogDensity = 0.008,
            fogHeight = 9, fogDistance = 110})
        SetRules({fireSpread = 4, fireTime = 0.16})
        for _, pos in ipairs({Vec(20, 0.3, 36.5), Vec(22, 3.0, 36.5), Vec(20, 3.0, 35), Vec(25, 5.8, 35)}) do
            light(pos)
        end
        for _, name in ipairs({"house", "floor light"}) do switch(name, true) end
    end,
    camera = function(t) return camera.held(keys, t, 0.7) end,
    cues = {
        {1.0, function() die("street light side") end},
        {1.7, function() die("shop") end},
        {2.5, function() die("street light corner") end},
    },
    update = rain,
}
