-- An undercarriage on tracks: rollers in two rows, each driven for itself.
local build = require("vehicles/build")
local parts = require("vehicles/parts")

local tracks = {}

-- `length` and `width` in cells, even; a track is 6 wide and 9 high.
function tracks.model(length, width, paint)
    local m = build.model({width, 13, length}, {width / 2, 0, length / 2})
    m:pairDisc(0, 5, 5, 5, 4.3, "tread")
    m:pairDisc(0, 5, 5, length - 5, 4.3, "tread")
    m:pair(0, 1, 5, 5, 9, length - 6, "tread")
    m:pair(0, 2, 5, 5, 8, length - 6, "black")
    for z = 2, length - 3, 3 do                             -- shoes
        m:pair(0, 9, z, 5, 9, z, "rubber")
    end
    m:pair(0, 3, 6, 0, 7, length - 7, "dark")
    for z = 8, length - 9, 6 do m:pairDisc(0, 0, 4, z + 0.5, 1.6, "steel") end
    m:pairDisc(0, 0, 5, 5, 2.4, paint)
    m:pairDisc(0, 0, 5, length - 5, 2.4, paint)
    m:box(6, 4, length // 2 - 8, width - 7, 8, length // 2 + 7, paint)
    m:box(6, 4, 6, width - 7, 5, length - 7, "dark")
    m:box(width // 2 - 5, 9, length // 2 - 5, width // 2 + 4, 12, length // 2 + 4, "dark")  -- the ring
    return m
end

function tracks.build(v, frame, length, width, paint, density, w)
    parts.add(v, "chassis", tracks.model(length, width, paint), frame * Transform(Vec(0, 0.06, 0)), density)
    local reach = 0.05 * length - 0.55
    for _, z in ipairs({-reach, 0, reach}) do
        for _, side in ipairs({-1, 1}) do
            parts.wheel(v, frame, Vec(side * (0.05 * width - 0.3), 0.4, z), {radius = 0.4, width = 0.4, density = 0.5,
                hertz = 14, rim = "dark", tyre = "steel", breakForce = w.breakForce})
        end
    end
    v.track = {spin = w.speed / 0.4, torque = w.torque, turn = w.turn, left = 0, right = 0}
end

-- Both tracks at their speeds: -1 to 1.
function tracks.drive(v, throttle, steer, isBraked)
    local t = v.track
    for side, goal in pairs({left = throttle - 0.8 * steer, right = throttle + 0.8 * steer}) do
        goal = isBraked and 0 or math.max(-1, math.min(1, goal))
        t[side] = t[side] + math.max(-0.05, math.min(0.05, goal - t[side]))
    end
    if steer ~= 0 and not isBraked then                     -- shoes slide where rollers would hold
        local up = GetBodyTransform(v.chassis.body).rot * Vec(0, 1, 0)
        ConstrainAngularVelocity(v.chassis.body, 0, up, 0.55 * steer, -t.turn / 60, t.turn / 60)
    end
    for _, wheel in ipairs(v.wheels) do
        if IsHandleValid(wheel.joint) then
            SetJointMotor(wheel.joint, t.spin * (wheel.side < 0 and t.left or t.right), t.torque)
        end
    end
end

return tracks
