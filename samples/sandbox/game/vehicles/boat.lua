-- A motor boat of wood: it floats by its own weight, a screw pushes it and a rudder turns it.
local build = require("vehicles/build")
local parts = require("vehicles/parts")

local boat = {name = "boat", camera = {height = 2.0, distance = 9}, exit = Vec(0, 1.2, 0.8), pitch = 0.9,
    engine = {Vec(-0.3, 0.75, 1.5), Vec(0.3, 0.95, 1.9)}, isBoat = true}
local kThrust, kLength, kWidth = 30000, 62, 22
local kPlank = 0.25
local kTurn = QuatEuler(0, 0, 90)

-- Half the width of the hull, in metres, at a place along it and a height: a stem that rakes forward, and
-- sides of planks that lap over each other.
local function halfWidth(z, y)
    y = kPlank * math.floor(y / kPlank)
    local stem = math.max(0, 0.55 - 0.45 * y)                -- where the hull begins at that height
    local share = math.min(1, math.max(0, (z - stem) / 2.9))
    local bow = math.sin(0.5 * math.pi * share) ^ 0.8
    local side = math.min(1, 0.6 + 0.42 * math.min(1, y / 0.45))
    return 0.05 * kWidth * bow * side
end

-- The upper edge, in metres: it rises towards the bow.
local function sheerAt(z)
    return 1.0 + 0.4 * math.max(0, 1 - z / 2.4) ^ 1.6
end

-- In cells of half the size, so that the bow is a curve.
local function hull(m)
    local middle, length = kWidth, 2 * kLength
    for k = 0, length - 1 do
        local z = 0.05 * (k + 0.5)
        local sheer = math.floor(20 * sheerAt(z))
        for y = 0, sheer do
            local half = math.floor(20 * halfWidth(z, 0.05 * y) + 0.5)
            local name = y <= 9 and "navy" or y <= 11 and "wood" or y >= sheer - 1 and "plank" or "white"
            if half > 0 then m:box(middle - half, y, k, middle + half - 1, y, k, name) end
        end
        if z > 2.4 and k < length - 4 then                   -- cockpit
            local half = math.floor(20 * halfWidth(z, 0.8)) - 4
            m:clear(middle - half, 14, k, middle + half - 1, sheer, k)
            m:box(middle - half, 12, k, middle + half - 1, 13, k, k % 6 == 0 and "wood" or "plank")
        elseif z <= 2.4 then                                 -- deck
            local half = math.floor(20 * halfWidth(z, 0.05 * sheer)) - 2
            if half > 0 then
                m:box(middle - half, sheer, k, middle + half - 1, sheer, k, k % 8 == 0 and "wood" or "plank")
            end
        end
    end
end

local function model()
    local fine = build.model({2 * kWidth, 44, 2 * kLength}, {kWidth, 0, kLength}, 0.05)
    hull(fine)
    local m = fine:coarse(2)
    m:cabin({x0 = 3, x1 = 18, low = 11, top = 18, z0 = 18, z1 = 38, front = 0.6, paint = "white", posts = {27, 33}})
    m:clear(4, 11, 36, 17, 17, 40)                           -- open behind
    m:pair(3, 11, 37, 3, 18, 37, "white")
    m:box(3, 18, 22, 18, 18, 38, "white")
    m:box(4, 18, 26, 17, 18, 34, "navy")
    m:box(4, 7, 24, 17, 11, 26, "wood")                      -- helm
    m:box(6, 12, 27, 9, 13, 27, "black")
    m:pair(5, 7, 31, 8, 8, 34, "cloth")
    m:box(4, 7, 52, 17, 8, 55, "cloth")
    m:box(8, 7, 44, 13, 10, 50, "dark")                      -- engine
    m:box(7, 10, 44, 14, 10, 50, "white")
    m:box(10, 19, 30, 11, 21, 30, "chrome")
    m:box(10, 21, 30, 11, 21, 30, "lamp")
    m:box(4, 18, 21, 5, 18, 21, "port")
    m:box(16, 18, 21, 17, 18, 21, "starboard")
    m:box(8, 19, 22, 9, 19, 23, "lamp")
    m:box(12, 19, 22, 13, 19, 23, "lamp")
    m:box(10, 13, 3, 11, 13, 4, "dark")                      -- bollard
    m:box(10, 1, kLength - 3, 11, 2, kLength - 1, "dark")    -- shaft
    return fine
end

function boat.build(v, frame)
    parts.add(v, "chassis", model(), frame, 0.55)
    local screw = build.model({10, 10, 3}, {5, 5, 1.5}, 0.05)
    screw:box(4, 0, 1, 5, 9, 1, "chrome")
    screw:box(0, 4, 1, 9, 5, 1, "chrome")
    screw:box(3, 3, 0, 6, 6, 2, "dark")
    parts.add(v, "screw", screw, frame * Transform(Vec(0, 0.2, 3.2)), 0.3)
    parts.joint(v, "screw", "hinge", v.chassis, v.screw, frame, Vec(0, 0.2, 3.1), QuatEuler(0, 90, 0), {reach = 0.4})
    local rudder = build.model({2, 16, 8}, {1, 8, 0}, 0.05)
    rudder:box(0, 0, 1, 1, 12, 7, "wood")
    rudder:box(0, 12, 0, 1, 15, 3, "dark")
    parts.add(v, "rudder", rudder, frame * Transform(Vec(0, 0.4, 3.32)), 0.5)
    parts.joint(v, "rudder", "hinge", v.chassis, v.rudder, frame, Vec(0, 0.4, 3.3), kTurn,
        {min = -0.6, max = 0.6, reach = 0.6})
    for _, x in ipairs({-0.2, 0.2}) do parts.lamp(v, Vec(x, 1.95, -0.95)) end
    v.surface = frame.pos.y + 0.45
end

-- The screw pushes while it is under water; the rudder turns by the speed, and the keel holds against drift.
function boat.update(v, input)
    local frame = GetBodyTransform(v.chassis.body)
    local ahead, aside = frame.rot * Vec(0, 0, -1), frame.rot * Vec(1, 0, 0)
    local speed = VecDot(GetBodyVelocity(v.chassis.body), ahead)
    parts.spin(v.screw, 26 * input.throttle, 500)
    if IsHandleValid(v.rudder.joint) then SetJointMotorTarget(v.rudder.joint, 0.5 * input.steer, 2, 2000) end
    local stern = frame * Vec(0, 0.25, 3.1)
    if stern.y > v.surface then return end
    local mass = GetBodyMass(v.chassis.body)
    if IsHandleValid(v.screw.joint) and not v.isDead then
        local share = input.throttle > 0 and 1 or 0.5
        v.thrust = (v.thrust or 0) + 0.03 * (share * input.throttle - (v.thrust or 0))
        local push = VecScale(ahead, v.thrust * kThrust / 60)
        ApplyBodyImpulse(v.chassis.body, frame * Vec(0, 0.45, 3.1), push)
    end
    if IsHandleValid(v.rudder.joint) then
        local push = input.steer * (0.55 * speed + 0.9 * input.throttle) * 0.3 * mass
        ApplyBodyImpulse(v.chassis.body, frame * Vec(0, 0.45, 3.1), VecScale(aside, push / 60))
    end
    local center = frame * GetBodyCenterOfMass(v.chassis.body)
    local drift = VecDot(GetBodyVelocity(v.chassis.body), aside)
    ApplyBodyImpulse(v.chassis.body, center, VecScale(aside, -1.2 * drift * mass / 60))
    if input.brake > 0 then
        ApplyBodyImpulse(v.chassis.body, center, VecScale(ahead, -1.0 * speed * mass / 60))
    end
end

return boat
