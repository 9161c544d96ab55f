-- Lifts: shapes with the tag "lift=STOREYS HEIGHT" that slide up from their lowest storey on a joint. Where the lights
-- over its doors have no power, a lift stays where it is.
local lift = {}
local kSpeed, kStrength, kNear, kCallReach = 1.6, 30000, 0.03, 3.2

-- {joint, storeys, height, shaft, lights} of a lift; nil where it is no more.
local function read(shape)
    local storeys, height = string.match(GetTagValue(shape, "lift"), "^(%d+) ([%d.]+)$")
    for _, joint in ipairs(GetShapeJoints(shape)) do
        if storeys and GetJointType(joint) == "prismatic" then
            local shaft = GetJointOtherShape(joint, shape)
            return {joint = joint, storeys = tonumber(storeys), height = tonumber(height),
                lights = GetShapeLights(shaft), shaft = shaft}
        end
    end
end

local function hasPower(it)
    for _, light in ipairs(it.lights) do
        if IsLightActive(light) then return true end
    end
    return #it.lights == 0
end

local function goTo(shape, storey)
    SetTag(shape, "storey", tostring(storey))
end

-- What E would do in a lift, or before its shaft: a text, and the deed.
function lift.offer(aim)
    if not aim.hit or aim.dist > kCallReach then return nil end
    for _, shape in ipairs(FindShapes("lift")) do
        local it = read(shape)
        if it and (aim.shape == shape or aim.shape == it.shaft) then
            local frame = GetBodyTransform(GetShapeBody(shape))
            local floor = math.floor(GetJointMovement(it.joint) / it.height + 0.5)
            if aim.shape == shape then
                if not hasPower(it) then return "The lift has no power", function() end end
                local goal = floor + 1 < it.storeys and floor + 1 or 0
                return "Go to storey " .. goal, function() goTo(shape, goal) end
            end
            local away = aim.pos - frame.pos
            local here = floor + math.floor(away.y / it.height)
            away.y = 0
            if here ~= floor and VecLength(away) < 2.2 and hasPower(it) then
                return "Call the lift", function() goTo(shape, math.max(0, math.min(it.storeys - 1, here))) end
            end
        end
    end
end

-- Each step: moves the lifts that are called. A motor of speed 0 holds them.
function lift.update()
    for _, shape in ipairs(FindShapes("storey")) do
        local it = read(shape)
        local goal = it and tonumber(GetTagValue(shape, "storey")) * it.height
        local way = it and goal - GetJointMovement(it.joint)
        if not it or math.abs(way) < kNear or not hasPower(it) then
            RemoveTag(shape, "storey")
            if it then SetJointMotor(it.joint, 0, kStrength) end
        else
            SetJointMotor(it.joint, math.max(-kSpeed, math.min(kSpeed, 4 * way)), kStrength)
        end
    end
end

return lift
