-- The office tower loses its front columns and comes down under its own weight.
local camera = require("film/camera")
local effects = require("film/effects")

local corner = Vec(28.4, 0, 15.2)  -- low corner on the ground; a side has 6.4 m
local keys = {{0, Vec(34.6, 1.3, 52.5), Vec(31.4, 12.0, 20), 64}, {2.2, Vec(37.0, 1.3, 55.0), Vec(31.6, 9.5, 26), 60},
    {5.0, Vec(43.0, 2.4, 59.5), Vec(32.4, 4.4, 38), 56}}
local dust = {0.44, 0.41, 0.37}

-- Cuts through the ground floor from z0 to z1, between two heights, with holes of a radius.
local function notch(z0, z1, low, high, radius)
    for z = z0 + radius, z1, 1.2 * radius do
        for y = low + radius, math.max(high, low + radius), 1.2 * radius do
            MakeHoleLine(corner + Vec(-0.3, y, z), corner + Vec(6.7, y, z), radius, radius, radius)
        end
    end
end

-- First the columns on the side that it shall fall to, then those in the middle; a thin cut through the others makes
-- the hinge.
local function fell()
    for _, x in ipairs({0.25, 3.2, 6.15}) do
        effects.blast(corner + Vec(x, 0.9, 6.15), 1.7, {ground = 0, dust = dust})
        wait(0.08)
    end
    notch(4.6, 6.6, 0.4, 2.5, 0.4)
    wait(0.1)
    for _, x in ipairs({0.25, 3.2, 6.15}) do effects.blast(corner + Vec(x, 0.8, 3.2), 1.6, {dust = dust}) end
    notch(1.2, 4.6, 0.5, 1.4, 0.4)
    wait(0.2)
    notch(-0.2, 1.4, 0.6, 0.6, 0.11)
end

-- Its parts break to rubble where they strike.
local function shatter()
    QueryRequire("dynamic")
    for _, body in ipairs(QueryAabbBodies(Vec(22, 0, 20), Vec(44, 14, 58))) do
        if GetBodyMass(body) > 8000 then
            local center = GetBodyTransform(body) * GetBodyCenterOfMass(body)
            for _, shape in ipairs(GetBodyShapes(body)) do
                for _, aside in ipairs({Vec(0, 0, 0), Vec(-2.5, 0, 1.5), Vec(2.5, 0, -1.5)}) do
                    local isThere, at = GetShapeClosestPoint(shape, Vec(center.x, 0, center.z) + aside)
                    if isThere then Crack(at, 1.3, 1.3, 0.6) end
                end
            end
        end
    end
end

-- The air that it drives away rolls along the street and takes the dust with it.
local function wave()
    shatter()
    for i = 1, 10 do
        for _ = 1, 9 do
            local side = 2 * math.random() - 1
            local shade = 0.85 + 0.3 * math.random()
            effects.particle(Vec(31.8 + 4.5 * side, 0.3 + 0.5 * math.random(), 34 + 10 * math.random()),
                Vec(4 * side, 0.5, 3 + 6 * math.random()), {type = "smoke", gravity = -1.45,
                    color = {dust[1] * shade, dust[2] * shade, dust[3] * shade},
                    radius = {0.25 + 0.3 * math.random(), 1.2 + 0.9 * math.random()},
                    alpha = 0.16 + 0.2 * math.random(), life = 2.5 + 2 * math.random(), spin = 0.5})
        end
        if i == 4 then shatter() end
        wait(0.06)
    end
end

local kLands = 3.5  -- seconds after the cut

return {
    name = "tower",
    seconds = 5.0,
    unseen = 3.6,
    begin = function()
        SetEnvironment({clouds = 0.4, sun = Vec(-0.80, 0.30, 0.52), exposure = 0.9, fogDensity = 0.002, fogHeight = 12})
        SetRules({stress = true, contactTime = 0.0015})
        start(fell)
    end,
    camera = function(t) return camera.held(keys, t, 0.8 + camera.jolt(t, kLands, 14)) end,
    speed = function(t) return 1 - 0.55 * camera.ease(t, 1.0, 1.8) + 0.5 * camera.ease(t, 3.0, 4.2) end,
    cues = {{kLands, wave}},
}
