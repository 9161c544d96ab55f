-- What holds a vehicle together: its record, wheels on their joints, arms on hinges, lamps.
local build = require("vehicles/build")

local parts = {wheelLayer = 2}
local kLeft = QuatEuler(0, 180, 0)  -- a wheel's frame: x to the left, z forward

-- Adds a body to a vehicle, under a name.
function parts.add(v, name, model, transform, density)
    local body, shape = build.body(model, transform, density)
    v.bodies[#v.bodies + 1] = body
    v[name] = {body = body, shape = shape, corner = VecScale(Vec(table.unpack(model.origin)), model.voxel)}
    if body == 0 then return v[name] end
    SetTag(body, "vehicle", v.kind)
    SetTag(body, "part", name)
    return v[name]
end

-- A wheel at a place of the chassis. `w`: radius, width, rim, and the options of its joint.
function parts.wheel(v, frame, place, w)
    local transform = Transform(frame * place, frame.rot)
    local body, shape = build.body(build.wheelModel(w.radius, w.width, w.rim, w.tyre), transform, w.density)
    if body == 0 then return end
    SetCollisionShape(shape, "cylinder x")
    SetShapeCollisionFilter(shape, parts.wheelLayer, 255)
    SetTag(body, "vehicle", v.kind)
    SetTag(body, "part", "wheel")
    v.bodies[#v.bodies + 1] = body
    local joint = CreateJoint("wheel", v.chassis.shape, shape, Transform(transform.pos, frame.rot * kLeft), {
        reach = 0.6, min = -0.12, max = 0.12, hertz = w.hertz or 8, damping = 0.7, drive = w.drive or 0,
        brake = w.brake or 0, maxSpin = w.maxSpin or 40, steer = w.steer or 0, steerRate = 1.6,
        breakForce = w.breakForce or 0})
    v.wheels[#v.wheels + 1] = {joint = joint, body = body, side = place[1] < 0 and -1 or 1}
end

-- Four wheels: half the track, the places of both axles along z.
function parts.axles(v, frame, track, front, back, w)
    for _, z in ipairs({front, back}) do
        for _, side in ipairs({-1, 1}) do
            local own = {}
            for key, value in pairs(w) do own[key] = value end
            own.steer = (z == front) == not w.isRearSteered and w.steer or 0
            parts.wheel(v, frame, Vec(side * track, w.height or w.radius, z), own)
        end
    end
end

-- Connects a part to another one. `rot`: turns x to the axis, in the vehicle's frame.
function parts.joint(v, name, kind, a, b, frame, place, rot, options)
    if a.shape == 0 then return end
    v[name].joint = CreateJoint(kind, a.shape, b.shape, Transform(frame * place, frame.rot * rot), options)
end

-- A headlamp on the chassis, at a place of the vehicle's frame; it is dark while nobody drives.
function parts.lamp(v, place, color, angle)
    if v.chassis.shape == 0 then return end
    local at = Transform(place + v.chassis.corner, QuatEuler(-6, 0, 0))
    v.lamps[#v.lamps + 1] = {light = CreateLight(v.chassis.shape, at, color or Vec(95, 84, 62),
        {angle = angle or 0.5, reach = 34, radius = 0.12, off = true}), place = place + Vec(0, 0, 0.06)}
end

-- The models of a kind and where they are, without a body: for pictures of it.
function parts.models(name, kind)
    build.record = {}
    local isGood, what = pcall(kind.build, {kind = name, bodies = {}, wheels = {}, lamps = {}}, Transform())
    local list = build.record
    build.record = nil
    if not isGood then error(what, 0) end
    return list
end

-- Its bodies that are still there.
function parts.there(v)
    local list = {}
    for _, body in ipairs(v.bodies) do
        if IsHandleValid(body) then list[#list + 1] = body end
    end
    return list
end

-- Turns or slides at a speed for as long as it is called, as a winch or a screw does.
function parts.spin(part, speed, strength)
    if part and part.speed ~= speed and IsHandleValid(part.joint) then
        SetJointMotor(part.joint, speed, strength)
        part.speed = speed
    end
end

local kLead = 0.15  -- radians or metres by which a goal is ahead of what is held up by something

-- Moves a hinge or a slide at a speed while a key says so, and holds it where it is otherwise.
function parts.move(part, speed, strength)
    if not part or not IsHandleValid(part.joint) or speed == 0 and part.goal then return end
    local now = GetJointMovement(part.joint)
    local lead = ((part.goal or now) - now + math.pi) % (2 * math.pi) - math.pi
    local goal = now + math.max(-kLead, math.min(kLead, lead + speed / 60))
    local least, most = GetJointLimits(part.joint)
    if least < most then
        goal = math.max(least, math.min(most, goal))
    else
        goal = (goal + math.pi) % (2 * math.pi) - math.pi
    end
    part.goal = goal
    SetJointMotorTarget(part.joint, goal, math.max(0.3, 1.5 * math.abs(speed)), strength)
end

return parts
