-- A crane on tracks: its house turns, the jib goes up and down, a wrecking ball hangs from its tip on a rope.
local build = require("vehicles/build")
local parts = require("vehicles/parts")
local tracks = require("vehicles/tracks")

local crane = {name = "crane", camera = {height = 3.4, distance = 15}, exit = Vec(-2.4, 0.3, 0), pitch = 0.5,
    engine = {Vec(-0.6, 1.6, 1.2), Vec(0.6, 2.0, 1.7)}, engineIn = "house", isTracked = true, body = "house",
    keys = {{"turnleft turnright", "turn"}, {"boomup boomdown", "jib"}, {"liftup liftdown", "rope"}}}
local kTurn = QuatEuler(0, 0, 90)
local kSlack = 0.02  -- metres of the stays
local kFoot, kSlope, kCells, kRope = Vec(0, 1.85, -0.9), 42, 106, 5.2

local function houseModel()
    local m = build.model({28, 24, 40}, {14, 0, 14})
    m:box(1, 0, 2, 26, 2, 37, "dark")
    m:box(1, 2, 12, 26, 10, 34, "red")
    m:clear(2, 3, 14, 25, 9, 30)
    m:box(8, 3, 24, 19, 8, 30, "dark")                      -- engine
    m:box(1, 1, 33, 26, 12, 39, "weight")
    m:box(1, 10, 33, 26, 12, 39, "red")
    for y = 3, 8, 2 do m:pair(1, y, 20, 1, y, 30, "black") end
    m:box(10, 11, 20, 17, 14, 26, "dark")                   -- winch
    m:pair(9, 11, 19, 9, 15, 27, "steel")
    m:box(1, 3, 2, 9, 8, 12, "red")                         -- cab
    m:clear(2, 4, 3, 8, 8, 11)
    m:cabin({x0 = 1, x1 = 9, low = 8, top = 18, z0 = 2, z1 = 12, front = 0.1, paint = "red", posts = {8}})
    m:box(3, 3, 7, 7, 6, 11, "cloth")
    m:box(3, 7, 10, 7, 12, 10, "cloth")
    m:pair(2, 4, 1, 3, 5, 1, "lamp")
    m:box(1, 4, 1, 4, 6, 1, "lamp")
    m:pair(11, 2, 3, 12, 6, 6, "dark")                      -- foot of the jib
    m:box(11, 2, 3, 16, 3, 6, "dark")
    m:pair(8, 10, 30, 9, 23, 31, "red")                     -- gantry
    m:box(8, 22, 30, 19, 23, 31, "red")
    m:pair(1, 3, 39, 3, 4, 39, "tail")
    return m
end

-- A lattice of four chords along -z, with its sheave at the tip.
local function jibModel()
    local m = build.model({7, 9, kCells}, {3.5, 4, kCells - 2})
    for _, y in ipairs({1, 7}) do m:pair(0, y, 2, 0, y, kCells - 8, "red") end
    for z = 2, kCells - 14, 6 do
        for _, y in ipairs({1, 7}) do m:box(0, y, z, 6, y, z, "red") end
        m:pair(0, 1, z, 0, 7, z, "red")
        m:bar({0, 1, z}, {0, 7, z + 6}, 1, "red")
        m:bar({6, 7, z}, {6, 1, z + 6}, 1, "red")
        m:bar({0, 7, z}, {6, 7, z + 6}, 1, "red")
    end
    m:box(0, 1, 0, 6, 7, 3, "dark")
    m:clear(2, 1, 0, 4, 7, 2)
    m:pair(0, 1, kCells - 9, 0, 7, kCells - 7, "dark")
    m:bar({0, 1, kCells - 8}, {2, 3, kCells - 3}, 2, "dark")
    m:bar({5, 1, kCells - 8}, {3, 3, kCells - 3}, 2, "dark")
    m:bar({0, 6, kCells - 8}, {2, 4, kCells - 3}, 2, "dark")
    m:bar({5, 6, kCells - 8}, {3, 4, kCells - 3}, 2, "dark")
    m:box(2, 2, kCells - 4, 4, 6, kCells - 1, "dark")
    m:box(2, 0, 0, 4, 2, 1, "steel")
    return m
end

local function ballModel()
    local m = build.model({11, 14, 11}, {5.5, 5.5, 5.5})
    for x = 0, 10 do
        local r = 5.5 * 5.5 - (x + 0.5 - 5.5) ^ 2
        if r > 0 then m:disc(x, x, 5.5, 5.5, math.sqrt(r), "weight") end
    end
    m:box(4, 10, 4, 6, 13, 6, "rust")
    return m
end

function crane.build(v, frame)
    tracks.build(v, frame, 50, 34, "dark", 0.7, {speed = 1.2, torque = 18000, turn = 3e5, breakForce = 6e5})
    parts.add(v, "house", houseModel(), frame * Transform(Vec(0, 1.4, 0)), 0.4)
    parts.joint(v, "house", "hinge", v.chassis, v.house, frame, Vec(0, 1.38, 0), kTurn, {reach = 0.5})
    local turned = frame * Transform(kFoot, QuatEuler(kSlope, 0, 0))
    parts.add(v, "jib", jibModel(), turned, 0.14)
    parts.joint(v, "jib", "hinge", v.house, v.jib, frame, kFoot, Quat(), {min = -0.6, max = 0.5, reach = 0.6})
    local tip = turned * Vec(0, 0, -0.1 * (kCells - 3.5))
    local top = tip - Vec(0, kRope, 0)
    parts.add(v, "ball", ballModel(), Transform(top - Vec(0, 0.8, 0), frame.rot), 0.45)
    if v.ball.shape == 0 then return end
    v.rope = {joint = CreateRope(v.jib.shape, tip, v.ball.shape, top, kRope)}
    v.stays = {}
    for i, x in ipairs({-0.45, 0.45}) do
        local from = frame * Vec(x, 3.8, 1.65)
        local to = turned * Vec(0.5 * x, 0.35, -0.1 * (kCells - 9))
        v.stays[i] = {joint = CreateRope(v.house.shape, from, v.jib.shape, to, VecLength(to - from) + kSlack)}
        v.stays[i].from = TransformToLocalPoint(frame * Transform(Vec(0, 1.4, 0)), from)
        v.stays[i].to = TransformToLocalPoint(turned, to)
    end
    parts.lamp(v, Vec(-1.1, 1.95, -1.4))
end

-- The stays are as long as the jib needs: they only hang from it.
local function tighten(v)
    for _, stay in ipairs(v.stays or {}) do
        if IsHandleValid(stay.joint) and IsHandleValid(v.house.body) and IsHandleValid(v.jib.body) then
            local from, to = GetBodyTransform(v.house.body) * stay.from, GetBodyTransform(v.jib.body) * stay.to
            SetJointMotorTarget(stay.joint, VecLength(to - from) + kSlack, 3, 1e4)
        end
    end
end

function crane.update(v, input)
    tighten(v)
    parts.move(v.house, 0.55 * input.turn, 1e6)
    parts.move(v.jib, 0.3 * input.boom, 2e6)
    parts.spin(v.rope, -0.9 * input.lift, 1e5)
end

return crane
