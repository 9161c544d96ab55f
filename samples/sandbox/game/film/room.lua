-- The wall of a furnished room is blown in, and the low sun floods the room.
local camera = require("film/camera")
local effects = require("film/effects")

local wall = Vec(18.2, 1.3, 36.9)
local low, high = Vec(17.5, 0, 34.4), Vec(24, 2.9, 39.2)  -- of the room
local keys = {{0, Vec(22.75, 1.75, 34.95), Vec(18.2, 1.2, 37.4), 66},
    {1.0, Vec(22.6, 1.7, 35.0), Vec(18.2, 1.25, 37.2), 66}, {4.0, Vec(21.7, 1.5, 35.3), Vec(17.6, 1.45, 36.9), 70}}
local dust = {0.50, 0.42, 0.35}
local kBlast = 0.85

local function isWithin(p)
    return p.x > low.x and p.y > low.y and p.z > low.z and p.x < high.x and p.y < high.y and p.z < high.z
end

-- The lights of the room do not glow, and stand for what floor and walls throw back of the light from outside: so much,
-- in W/sr.
local function fill(intensity)
    for _, light in ipairs(FindLights()) do
        if isWithin(GetLightTransform(light).pos) then
            SetLightColor(light, 1, 0.84, 0.66)
            SetLightIntensity(light, intensity)
        end
    end
    for _, name in ipairs({"house", "floor light"}) do
        if FindShape(name) ~= 0 then SetShapeEmissiveScale(FindShape(name), 0) end
    end
end

-- What has come off flies into the room.
local function throw()
    wait(0.03)
    QueryRequire("dynamic")
    for _, body in ipairs(QueryAabbBodies(wall - Vec(0.5, 1.3, 1.9), wall + Vec(0.7, 1.4, 1.7))) do
        local p = GetBodyTransform(body) * GetBodyCenterOfMass(body)
        local aside = p - (wall - Vec(1.4, 0.3, 0))
        local speed = 4 + 5 * math.random()
        SetBodyVelocity(body, VecScale(VecNormalize(aside), speed) + Vec(0, 1.2 * math.random(), 0))
        SetBodyAngularVelocity(body, Vec(9 * math.random() - 4, 9 * math.random() - 4, 9 * math.random() - 4))
    end
end

local function blow()
    for _, at in ipairs({Vec(0, 0, 0), Vec(0, 0.25, -0.95), Vec(0, 0.1, 0.9)}) do
        Crack(wall + at, 1.0, 1.0, 0)
        MakeHole(wall + at, 0.6, 0.45, 0, true)
    end
    effects.blast(wall - Vec(2.1, 0.5, 0.6), 1.0,
        {dust = dust, way = Vec(1.5, 0.2, -0.3), fire = 0.4, trails = 0.5, light = 1600, haze = 0})
    fill(3.5)
    throw()
    effects.haze(wall + Vec(0.2, -0.4, 0), Vec(1.0, 0.7, 1.7), 4, dust, 2.2)
end

return {
    name = "room",
    seconds = 4.0,
    unseen = 1.0,
    begin = function()
        SetEnvironment({clouds = 0.3, sun = Vec(-0.88, 0.36, 0.24), exposure = 1.5, fogDensity = 0.03, fogHeight = 6,
            fogForward = 0.5})
        fill(1)
    end,
    camera = function(t) return camera.held(keys, t, 0.6 + camera.jolt(t, kBlast, 16)) end,
    speed = function(t)
        return 1 - 0.7 * camera.ease(t, kBlast + 0.08, kBlast + 0.35) + 0.45 * camera.ease(t, 2.6, 4.0)
    end,
    cues = {{kBlast, blow}},
}
