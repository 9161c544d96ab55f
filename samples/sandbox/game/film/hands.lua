-- A spray can marks a wall, a hammer goes through the mark.
local camera = require("film/camera")
local effects = require("film/effects")
local sounds = require("sounds")

local face = Vec(18.0, 1.55, 30.52)  -- of the wall, which looks to -x
local tools = {spray = require("tools/spray").model, sledge = require("tools/sledge").model}
tools.spray.palette[2] = {0.98, 0.78, 0.1, roughness = 0.4}  -- the can shows its colour
local bodies = {}
local paint = {0.98, 0.80, 0.12}
local hits = {1.95, 2.5, 3.05}
local holes = {Vec(0, 0.02, 0.03), Vec(0, 0.24, -0.22), Vec(0, -0.2, 0.12)}
local keys = {{0, Vec(16.2, 1.5, 31.9), Vec(18, 1.56, 30.5), 42}, {1.8, Vec(15.9, 1.6, 31.3), Vec(18, 1.52, 30.55), 44},
    {2.9, Vec(15.7, 1.65, 31.6), Vec(18, 1.45, 30.6), 45},
    {3.8, Vec(16.2, 1.55, 31.2), Vec(18, 1.5, 30.5), 44}}

-- Where the can points: two strokes of a cross, one after the other. nil: between strokes.
local function mark(t)
    local s, sign = (t - 0.3) / 0.5, 1
    if s > 1.25 then s, sign = s - 1.3, -1 end
    local isOn = s >= 0 and s <= 1
    s = camera.ease(s, 0, 1)
    return face + Vec(0, 0.36 - 0.72 * s, sign * (0.36 - 0.72 * s)), isOn
end

local function place(name, transform)
    local body = bodies[name]
    if not body or not IsHandleValid(body) then
        tools[name].voxel = name == "spray" and 0.014 or 0.026
        bodies[name] = CreateModel(tools[name], transform, false)
    else
        SetBodyTransform(body, transform)
    end
end

local function remove(name)
    if bodies[name] and IsHandleValid(bodies[name]) then Delete(bodies[name]) end
    bodies[name] = nil
end

local function strike(at)
    MakeHole(at + Vec(0.1, 0, 0), 0.34, 0.22, 0)
    Crack(at + Vec(0.1, 0, 0), 0.7, 0.5, 0)
    for _ = 1, 26 do
        effects.particle(at - Vec(0.05, 0, 0), Vec(-1.2 - 2.6 * math.random(), 2.2 * math.random() - 0.4,
            2.4 * math.random() - 1.2), {type = "crumb", color = {0.27, 0.12, 0.08}, radius = {0.008, 0.03}, alpha = 1,
            life = 1.4})
    end
    effects.haze(at - Vec(0.15, 0, 0), Vec(0.3, 0.3, 0.4), 4, {0.42, 0.3, 0.25}, 1.2)
end

return {
    name = "hands",
    seconds = 3.8,
    unseen = 0.5,
    begin = function()
        SetEnvironment({clouds = 0.36, sun = Vec(-0.86, 0.3, 0.42), exposure = 0.9})
    end,
    camera = function(t)
        local shake = 1
        for _, hit in ipairs(hits) do shake = shake + camera.jolt(t, hit, 5) end
        return camera.held(keys, t, shake)
    end,
    cues = {
        {hits[1], function() strike(face + holes[1]) end},
        {hits[2], function() strike(face + holes[2]) end},
        {hits[3], function()
            for _, aside in ipairs({holes[3], Vec(0, 0.15, 0.35), Vec(0, 0.3, -0.1), Vec(0, -0.25, -0.3)}) do
                strike(face + aside)
            end
        end},
    },
    update = function(t)
        sounds.loop("wind", nil, 0.15)
        if t < 1.75 then
            local at, isOn = mark(t)
            local lift = 0.8 * camera.ease(t, 1.45, 1.75)
            local can = at + Vec(-0.45, -0.02 - lift, 0.1)
            place("spray", Transform(can, QuatEuler(0, -90, 0) * QuatEuler(8, 0, 10)))
            if not isOn then return end
            sounds.loop("jet", can, 0.35, 1.4)
            PaintRGBA(at, 0.11, paint[1], paint[2], paint[3], 0.9, 0.8)
            for _ = 1, 3 do
                effects.particle(can + Vec(0.06, 0.12, 0), Vec(4, (math.random() - 0.5), math.random() - 0.5),
                    {type = "dust", color = {0.9, 0.6, 0.05}, radius = {0.006, 0.05}, alpha = 0.16, life = 0.12})
            end
            return
        end
        remove("spray")
        -- The hammer swings back before each hit, and through it.
        local turn, at = 55, holes[1]
        for i, hit in ipairs(hits) do
            if t > hit - 0.3 then at = holes[i] end
            if t > hit - 0.22 and t <= hit then turn = 55 - 75 * ((t - hit + 0.22) / 0.22) ^ 2 end
            if t > hit and t < hit + 0.34 then turn = -20 + 75 * camera.ease(t, hit, hit + 0.33) end
        end
        local enter = 1 - camera.ease(t, 1.7, 1.9) + camera.ease(t, 3.3, 3.7)
        local grip = face + at + Vec(-0.62, -0.42 - 0.9 * enter, 0.3)
        place("sledge", Transform(grip, QuatEuler(0, -90, 0) * QuatEuler(turn - 90 + 55, 0, 0)))
    end,
}
