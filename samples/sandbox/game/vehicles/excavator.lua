-- An excavator: its house turns, boom, stick and bucket are on hinges, and the bucket's teeth dig.
local build = require("vehicles/build")
local feel = require("feel")
local parts = require("vehicles/parts")
local tracks = require("vehicles/tracks")

local excavator = {name = "excavator", camera = {height = 2.6, distance = 10}, exit = Vec(-2.1, 0.3, 0), pitch = 0.6,
    engine = {Vec(-0.6, 1.6, 0.8), Vec(0.6, 2.0, 1.3)}, engineIn = "house", isTracked = true, body = "house",
    keys = {{"turnleft turnright", "turn"}, {"boomup boomdown", "boom"}, {"liftup liftdown", "stick"},
        {"tiltup tiltdown", "bucket"}}}
local kBoom, kStick, kBucket = Vec(0.15, 1.95, -0.75), Vec(0.15, 3.05, -3.55), Vec(0.15, 1.25, -3.95)
local kTurn = QuatEuler(0, 0, 90)                           -- turns x to y
local kReach, kBite = 0.16, 0.3
local teeth = {}                                            -- and the floor of the bucket, which sinks in behind them
for _, z in ipairs({0.42, 0.1, -0.25}) do
    for _, x in ipairs({-0.38, -0.13, 0.13, 0.38}) do teeth[#teeth + 1] = Vec(x, -0.72, z) end
end

local function houseModel()
    local m = build.model({26, 20, 32}, {13, 0, 14})
    m:box(1, 0, 2, 24, 2, 30, "dark")
    m:box(1, 2, 12, 24, 9, 30, "yellow")
    m:clear(2, 3, 14, 23, 8, 27)
    m:box(7, 3, 21, 18, 8, 26, "dark")                      -- engine
    m:box(1, 1, 27, 24, 9, 31, "weight")
    m:box(1, 7, 27, 24, 9, 31, "yellow")
    m:box(3, 10, 16, 22, 10, 28, "yellow")
    m:box(17, 10, 22, 18, 14, 23, "dark")                   -- exhaust
    for z = 16, 24, 2 do m:pair(1, 4, z, 1, 7, z, "black") end
    m:box(1, 3, 3, 9, 8, 15, "yellow")                      -- cab
    m:clear(2, 4, 4, 8, 8, 14)
    m:cabin({x0 = 1, x1 = 9, low = 8, top = 19, z0 = 3, z1 = 15, front = 0.12, paint = "yellow", posts = {10}})
    m:box(1, 8, 3, 1, 8, 15, "yellow")
    m:box(9, 8, 3, 9, 8, 15, "yellow")
    m:box(3, 3, 9, 7, 6, 13, "cloth")
    m:box(3, 7, 13, 7, 13, 13, "cloth")
    m:pair(2, 3, 2, 3, 4, 2, "lamp")
    m:box(3, 19, 2, 4, 19, 2, "lamp")
    m:box(6, 19, 2, 7, 19, 2, "lamp")
    m:box(11, 2, 5, 12, 9, 13, "dark")                      -- brackets of the boom
    m:box(17, 2, 5, 18, 9, 13, "dark")
    m:box(18, 3, 5, 24, 6, 12, "yellow")
    m:pair(1, 3, 31, 3, 4, 31, "tail")
    return m
end

-- The boom goes up and then bends down; the stick hangs from its end. Both lie in the plane of x = 0.15.
local function armModels()
    local boom = build.model({4, 26, 34}, {2, 4, 30})
    boom:bar({0, 2, 28}, {0, 20, 14}, 4, "yellow")
    boom:bar({0, 20, 14}, {0, 13, 1}, 4, "yellow")
    boom:box(1, 18, 12, 2, 22, 16, "dark")
    boom:bar({1, 0, 25}, {1, 14, 14}, 1, "chrome")          -- pistons
    boom:bar({1, 24, 16}, {1, 19, 4}, 1, "chrome")
    boom:box(0, 2, 28, 3, 6, 32, "dark")
    local stick = build.model({4, 24, 8}, {2, 19, 4})
    stick:box(0, 0, 2, 3, 20, 4, "yellow")
    stick:box(0, 8, 2, 3, 20, 5, "yellow")
    stick:box(1, 20, 1, 2, 22, 4, "dark")
    stick:box(1, 4, 6, 1, 16, 6, "chrome")
    stick:box(0, 0, 2, 3, 2, 4, "dark")
    local bucket = build.model({10, 10, 9}, {5, 8, 4})
    bucket:box(0, 1, 0, 9, 7, 8, "worn")
    bucket:clear(1, 1, 1, 8, 6, 8)
    bucket:clear(0, 1, 6, 9, 2, 8)
    for x = 0, 9, 3 do bucket:box(x, 0, 7, x, 1, 8, "worn") end
    bucket:box(0, 1, 0, 9, 1, 8, "worn")
    bucket:box(3, 7, 2, 6, 9, 5, "dark")
    return boom, stick, bucket
end

function excavator.build(v, frame)
    tracks.build(v, frame, 38, 28, "dark", 0.55, {speed = 1.6, torque = 9000, turn = 1.2e5, breakForce = 4e5})
    parts.add(v, "house", houseModel(), frame * Transform(Vec(0, 1.4, 0)), 0.3)
    parts.joint(v, "house", "hinge", v.chassis, v.house, frame, Vec(0, 1.38, 0), kTurn, {reach = 0.5})
    local boom, stick, bucket = armModels()
    parts.add(v, "boom", boom, frame * Transform(kBoom), 0.16)
    parts.add(v, "stick", stick, frame * Transform(kStick), 0.16)
    parts.add(v, "bucket", bucket, frame * Transform(kBucket), 0.2)
    parts.joint(v, "boom", "hinge", v.house, v.boom, frame, kBoom, Quat(), {min = -0.75, max = 0.5, reach = 0.6})
    parts.joint(v, "stick", "hinge", v.boom, v.stick, frame, kStick, Quat(), {min = -0.9, max = 1.1, reach = 0.6})
    parts.joint(v, "bucket", "hinge", v.stick, v.bucket, frame, kBucket, Quat(), {min = -1.2, max = 1.2, reach = 0.6})
    parts.lamp(v, Vec(-0.8, 1.7, -1.3))
end

-- Teeth carve what they press on: what is within reach of a moving tooth.
local function dig(v)
    local bucket = v.bucket.body
    if not IsHandleValid(bucket) then return end
    local frame, own = GetBodyTransform(bucket), parts.there(v)
    for _, tooth in ipairs(teeth) do
        local at = frame * tooth
        QueryRejectBodies(own)
        local hit, pos, _, shape = QueryClosestPoint(at, kReach)
        if hit and VecLength(GetBodyVelocityAtPos(bucket, at)) > 0.05 then
            local material, r, g, b = GetShapeMaterialAtPosition(shape, pos)
            if MakeHole(at, kBite, kBite, 0.5 * kBite) > 0 then
                feel.burst(pos, Vec(0, 1, 0), {type = "crumb", count = 3, speed = 2, life = 0.8, gravity = -8,
                    color = {(r or 0.4) ^ 2, (g or 0.3) ^ 2, (b or 0.2) ^ 2}, radius = {0.05, 0.04}})
            end
        end
    end
end

function excavator.update(v, input)
    parts.move(v.house, 0.7 * input.turn, 2e5)
    parts.move(v.boom, 0.5 * input.boom, 1.3e5)
    parts.move(v.stick, 0.8 * input.lift, 8e4)
    parts.move(v.bucket, 1.2 * input.tilt, 6e4)
    if input.boom ~= 0 or input.lift ~= 0 or input.tilt ~= 0 or input.turn ~= 0 then dig(v) end
end

return excavator
