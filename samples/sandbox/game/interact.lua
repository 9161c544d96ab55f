-- What E does: pushes and pulls doors, takes small things into the hand, switches lamps, drives vehicles, calls lifts.
local feel = require("feel")
local lift = require("lift")
local vehicles = require("vehicles/vehicles")

local interact = {held = 0, contract = nil}  -- contract: what offers a deed before all others
local kReach, kMaxMass, kLampReach, kRideReach = 2.6, 120, 1.0, 3.2
local localPoint, distance = Vec(0, 0, 0), 1.5
local kPush, kPushSteps = 1.5, 4  -- m/s that a push gives a door; steps after which one that stands still is pulled
local pushed = nil  -- the door of the last steps

local function hingeOf(shape)
    for _, joint in ipairs(GetShapeJoints(shape)) do
        if GetJointType(joint) == "hinge" then return joint end
    end
end

-- The light of a shape that is close to where the eyes look.
local function lampAt(aim)
    for _, light in ipairs(GetShapeLights(aim.shape)) do
        if VecLength(GetLightTransform(light).pos - aim.pos) < kLampReach then return light end
    end
end

-- Takes a thing into the hand where the eyes look at it.
function interact.take(aim)
    interact.held, distance = aim.body, math.max(1.2, aim.dist)
    localPoint = TransformToLocalPoint(GetBodyTransform(aim.body), aim.pos)
end

local function pushDoor(hinge, aim)
    pushed = {hinge = hinge, body = aim.body, at = TransformToLocalPoint(GetBodyTransform(aim.body), aim.pos),
        impulse = VecScale(Vec(aim.dir.x, 0, aim.dir.z), kPush * GetBodyMass(aim.body)),
        from = GetJointMovement(hinge), steps = 0}
    ApplyBodyImpulse(aim.body, aim.pos, pushed.impulse)
end

-- A door that does not give way, as one that is wide open, is pulled.
local function pullDoor()
    if not IsHandleValid(pushed.hinge) or not IsHandleValid(pushed.body) then
        pushed = nil
        return
    end
    pushed.steps = pushed.steps + 1
    if pushed.steps < kPushSteps then return end
    if math.abs(GetJointMovement(pushed.hinge) - pushed.from) < 0.02 then
        ApplyBodyImpulse(pushed.body, GetBodyTransform(pushed.body) * pushed.at, VecScale(pushed.impulse, -1))
    end
    pushed = nil
end

-- What E would do with what the eyes look at: a text, and the deed.
function interact.offer(aim)
    if interact.held ~= 0 then return "Let go", interact.drop end
    if interact.contract then
        local text, deed = interact.contract(aim)
        if text then return text, deed end
    end
    if aim.hit and aim.dist < kRideReach and vehicles.of(aim.body) then return vehicles.offer(aim.body) end
    if not aim.hit or aim.dist > kReach or not IsHandleValid(aim.shape) then return nil end
    local text, deed = lift.offer(aim)
    if text then return text, deed end
    local hinge = hingeOf(aim.shape)
    if hinge and IsBodyDynamic(aim.body) then
        return "Push the door", function() pushDoor(hinge, aim) end
    end
    local lamp = lampAt(aim)
    if lamp then
        local isOn = IsLightActive(lamp)
        return isOn and "Switch the lamp off" or "Switch the lamp on",
            function() SetLightEnabled(lamp, not isOn) end
    end
    if IsBodyDynamic(aim.body) and GetBodyMass(aim.body) < kMaxMass then
        return "Take", function() interact.take(aim) end
    end
end

function interact.drop()
    interact.held = 0
end

-- Throws what is held.
function interact.throw(dir)
    local body = interact.held
    interact.held = 0
    if not IsHandleValid(body) then return end
    local center = GetBodyTransform(body) * GetBodyCenterOfMass(body)
    ApplyBodyImpulse(body, center, VecScale(dir, 11 * GetBodyMass(body)))
    feel.kick(-0.8)
end

-- Each step: holds it before the eyes.
function interact.update()
    if pushed then pullDoor() end
    if interact.held == 0 then return end
    if not IsHandleValid(interact.held) or not IsBodyDynamic(interact.held) then return interact.drop() end
    local eye = GetPlayerCameraTransform()
    local point = GetBodyTransform(interact.held) * localPoint
    local goal = eye.pos + eye.rot * Vec(0, -0.1, -distance)
    if VecLength(goal - point) > 2.5 then return interact.drop() end
    ConstrainPosition(interact.held, 0, point, goal, 6, 12 * GetBodyMass(interact.held))
end

return interact
