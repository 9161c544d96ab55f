-- Heist: six things hang on wires. The plan may take any time; the first wire that is cut starts an alarm, and within a
-- minute all six must be at the exit.
local draw = require("draw")
local level = require("levels/house")
local sounds = require("sounds")

local kSeconds = 60
local kReach = 3.2
local kWhole = 0.6  -- share of its voxels below which a thing is broken

local heist = {
    title = "Heist", place = level.place, firstPhase = "planning",
    brief = {"Take the six things that blink, with E, and bring them to the exit.",
        "Each is on a wire: the first one that is cut starts an alarm of " .. kSeconds .. " seconds.",
        "Make your ways first. Until then there is no clock."},
}

function heist.build(state)
    level.build()
    state.left, state.count, state.taken, state.voxels, state.isAtExit = kSeconds, 0, {}, {}, false
    for i, thing in ipairs(level.things) do
        local body, shape = level.placeThing(thing)
        SetTag(shape, "loot", tostring(i))
        SetTag(body, "loot", tostring(i))
        state.taken[i] = false
    end
    wait(0.1)
    for i = 1, #level.things do
        local shape = heist.shapeOf(i)
        state.voxels[i] = GetShapeVoxelCount(shape)
        local wire = level.wire(shape)
        if wire ~= 0 then SetTag(wire, "wire", tostring(i)) end
    end
    wait(0.1)
    state.wires = #FindJoints("wire")
    return level.start[1], level.start[2]
end

-- The shape of a thing, or 0.
function heist.shapeOf(i)
    for _, shape in ipairs(FindShapes("loot")) do
        if GetTagValue(shape, "loot") == tostring(i) then return shape end
    end
    return 0
end

local function alarm(state)
    if state.phase == "planning" then state.phase = "running" end
end

local function take(state, i, body)
    Delete(body)
    state.taken[i], state.count = true, state.count + 1
    state.wires = state.wires - 1
    sounds.play("click")
    alarm(state)
end

-- The thing that the eyes look at, or nearly.
local function seen(state, aim)
    local best, bestAngle = nil, math.cos(math.rad(9))
    for i in ipairs(level.things) do
        local body = not state.taken[i] and heist.bodyOf(i) or 0
        if body ~= 0 then
            local way = heist.center(body) - aim.eye
            local far = VecLength(way)
            local angle = far > 0 and VecDot(way, aim.dir) / far or 1
            local isHit = aim.body == body
            local isFree = isHit or aim.dist > far - 0.6
            if far < kReach and isFree and (isHit or angle > bestAngle) then best, bestAngle = i, isHit and 2 or angle end
        end
    end
    return best
end

function heist.bodyOf(i)
    local shape = heist.shapeOf(i)
    return shape ~= 0 and GetShapeBody(shape) or 0
end

function heist.center(body)
    return GetBodyTransform(body) * GetBodyCenterOfMass(body)
end

function heist.offer(state, aim)
    local i = seen(state, aim)
    if not i then return nil end
    local text = "Take the " .. level.things[i].name .. (state.phase == "planning" and ": the alarm starts" or "")
    return text, function() take(state, i, heist.bodyOf(i)) end
end

local function isAtExit()
    local at = GetPlayerTransform().pos
    local low, high = level.exit[1], level.exit[2]
    return at.x > low.x and at.x < high.x and at.z > low.z and at.z < high.z and at.y > low.y and at.y < high.y
end

local function warn(state)
    sounds.loop("alarm", level.alarm, 0.5)
    if state.left % 1 < 0.5 then PointLight(level.alarm, 30, 2, 1, 1) end
end

function heist.update(state, dt, contract)
    for i, thing in ipairs(level.things) do
        if not state.taken[i] then
            local shape = heist.shapeOf(i)
            if shape == 0 or GetShapeVoxelCount(shape) < kWhole * state.voxels[i] then
                return contract.finish(false, "The " .. thing.name .. " is broken")
            end
        end
    end
    if state.phase == "planning" and #FindJoints("wire") < state.wires then alarm(state) end
    state.isAtExit = isAtExit()
    if state.phase ~= "running" then return end
    state.left = math.max(0, state.left - dt)
    warn(state)
    if state.count == #level.things and state.isAtExit then
        contract.finish(true, "All six are out of the house")
    elseif state.left == 0 then
        contract.finish(false, "The time is over")
    end
end

function heist.goal(state)
    if state.phase == "planning" then return "Plan your way, then take the six things" end
    return state.count < #level.things and "Take what is left, then to the exit" or "To the exit"
end

function heist.cells(state)
    local cells = {{"Things", string.format("%d of %d", state.count, #level.things), state.count / #level.things,
        isGood = state.count == #level.things}}
    if state.phase == "planning" then
        cells[2] = {"Alarm", "not yet", 1}
    else
        cells[2] = {"Time", string.format("%.1f s", state.left), state.left / kSeconds, isBad = state.left < 15}
    end
    local way = VecLength(GetPlayerTransform().pos - VecLerp(level.exit[1], level.exit[2], 0.5))
    cells[3] = {"Exit", state.isAtExit and "here" or string.format("%.0f m", way), math.max(0, 1 - way / 40),
        isGood = state.isAtExit}
    return cells
end

function heist.figures(state)
    return {{"Things taken", string.format("%d of %d", state.count, #level.things)},
        {"Time of the alarm", string.format("%.1f of %d s", kSeconds - state.left, kSeconds)}}
end

-- A ring around a thing that blinks, and what it is where it is near or looked at.
local function drawMark(at, text, isLoud)
    local x, y, depth = UiWorldToPixel(at)
    if depth < 2.5 then return end  -- close by the box is enough
    local beat = 0.5 + 0.5 * math.sin(5 * GetTime())
    local size = math.max(12, math.min(60, 160 / depth))
    UiPush()
    UiTranslate(x, y)
    UiAlign("center middle")
    UiColor(0, 0, 0, 0.35)
    UiCircleOutline(size + 1.5, 5)
    UiColor(1.0, 0.72, 0.30, isLoud and 1 or 0.35 + 0.6 * beat)
    UiCircleOutline(size, 2.5)
    UiTranslate(0, size + 20)
    local isAimedAt = math.abs(x - UiCenter()) < 130 and math.abs(y - UiMiddle()) < 130
    if isLoud or isAimedAt or depth < 8 then
        draw.text(string.format("%s  %.0f m", text, depth), 19, "center middle", nil, 0.95)
    end
    UiPop()
end

-- The edges of a body's box, which voxels hide.
local function drawBox(body, alpha)
    local low, high = GetBodyBounds(body)
    local corner = {low - Vec(0.03, 0.03, 0.03), high + Vec(0.03, 0.03, 0.03)}
    local function at(x, y, z) return Vec(corner[x].x, corner[y].y, corner[z].z) end
    for a = 1, 2 do
        for b = 1, 2 do
            DrawLine(at(1, a, b), at(2, a, b), 1, 0.72, 0.3, alpha)
            DrawLine(at(a, 1, b), at(a, 2, b), 1, 0.72, 0.3, alpha)
            DrawLine(at(a, b, 1), at(a, b, 2), 1, 0.72, 0.3, alpha)
        end
    end
end

local function drawExit()
    local low, high = level.exit[1], level.exit[2]
    local width, depth = 100 * (high.x - low.x), 100 * (high.z - low.z)
    UiPush()
    UiWorld(Transform(Vec(low.x, level.ground, low.z), QuatEuler(-90, 0, 0)), 0.01)
    UiAlign("left top")
    UiColor(0.35, 0.9, 0.5, 0.16)
    UiRect(width, depth)
    UiColor(0.35, 0.9, 0.5, 0.85)
    UiRectOutline(width, depth, 10)
    UiPop()
end

function heist.draw(state)
    local beat = 0.5 + 0.5 * math.sin(5 * GetTime())
    for i, thing in ipairs(level.things) do
        local body = not state.taken[i] and heist.bodyOf(i) or 0
        if body ~= 0 then
            drawBox(body, 0.3 + 0.7 * beat)
            drawMark(heist.center(body), thing.name, false)
        end
    end
    drawExit()
    drawMark(VecLerp(level.exit[1], level.exit[2], 0.5), "Exit", true)
end

return heist
