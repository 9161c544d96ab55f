-- The tool in the hand: which one it is, its model before the eyes, how it swings and recoils, when it works again.
local feel = require("feel")
local player = require("player")

local belt = {tools = {}, current = 1, ammo = saved("ammo", {}), cooldown = 0, raise = 0}
-- What a contract allows: `tools` by name, and a `budget` of tools that share what is left in left[key], of `all`.
belt.limits = nil
local kVoxel = 0.008       -- metres of a model's cell: small and near, so that it does not reach into walls
local kHold = Vec(0.105, -0.10, -0.27)
local body, bodyOf = 0, 0
local swing, swingSeconds, recoil, phase = 1, 0.35, 0, 0
local sway = Vec(0, 0, 0)
local lastYaw, lastPitch = 0, 0

function belt.load(names)
    for i, name in ipairs(names) do
        local tool = require("tools/" .. name)
        tool.id, tool.number = name, i
        belt.tools[i] = tool
        if tool.ammo then belt.ammo[name] = belt.ammo[name] or tool.ammo end
    end
end

function belt.tool()
    return belt.tools[belt.current]
end

function belt.isAllowed(number)
    return not belt.limits or belt.limits.tools[belt.tools[number].id] == true
end

-- Takes the tool of a name.
function belt.choose(id)
    for i, tool in ipairs(belt.tools) do
        if tool.id == id then belt.select(i) end
    end
end

-- How often a tool can be used, and of how many; nil: without end.
function belt.left(tool)
    local limits = belt.limits
    if limits and limits.budget[tool.id] then return limits.left[limits.key], limits.all end
    if tool.ammo then return belt.ammo[tool.id], tool.ammo end
end

local function spend(tool)
    local limits = belt.limits
    if limits and limits.budget[tool.id] then
        limits.left[limits.key] = limits.left[limits.key] - 1
    elseif tool.ammo then
        belt.ammo[tool.id] = belt.ammo[tool.id] - 1
    end
end

-- Takes a tool in the hand, or with a `direction` the next one from there on that is allowed.
function belt.select(number, direction)
    number = (number - 1) % #belt.tools + 1
    while direction and not belt.isAllowed(number) do number = (number + direction - 1) % #belt.tools + 1 end
    if number == belt.current or not belt.isAllowed(number) then return end
    local old = belt.tool()
    if old.release then old:release() end
    belt.current, belt.raise, belt.cooldown = number, 1, 0.15
    swing, recoil = 1, 0
end

-- A stroke of so many seconds; a shot throws the tool back by `amount`.
function belt.swing(seconds)
    swing, swingSeconds = 0, seconds
end

function belt.recoil(amount)
    recoil = recoil + amount
end

-- Where a model's point is in the world, in cells from its frame: a muzzle.
function belt.muzzle()
    local model = belt.tool().model
    local m = model.muzzle or Vec(0, 0, -10)
    return belt.frame() * VecScale(m, kVoxel)
end

-- The next query does not find the model before the eyes.
function belt.rejectModel()
    if body ~= 0 and IsHandleValid(body) then QueryRejectBody(body) end
end

-- What the eyes look at.
function belt.aim(maxDist)
    local eye = GetPlayerCameraTransform()
    local dir = eye.rot * Vec(0, 0, -1)
    belt.rejectModel()
    local hit, dist, normal, shape = QueryRaycast(eye.pos, dir, maxDist or 120)
    local aim = {eye = eye.pos, rot = eye.rot, dir = dir, hit = hit, dist = dist, normal = normal, shape = shape or 0}
    aim.pos = hit and eye.pos + dist * dir or eye.pos + (maxDist or 120) * dir
    aim.body = hit and aim.shape ~= 0 and GetShapeBody(aim.shape) or 0
    return aim
end

-- How far a stroke has come: quickly down, slowly back.
local function strokeAt(share)
    if share < 0.26 then return (share / 0.26) ^ 2 end
    local back = (share - 0.26) / 0.74
    return 1 - back * back * (3 - 2 * back)
end

-- The model's frame in the world.
function belt.frame()
    local tool = belt.tool()
    local t = strokeAt(swing)
    local bob = math.min(player.speed / 6, 1)
    local pos = kHold + (tool.hold or Vec(0, 0, 0)) + sway
        + Vec(0.006 * bob * math.sin(phase), 0.006 * bob * math.abs(math.cos(phase)) - 0.09 * belt.raise, 0.03 * recoil)
    local rot = QuatEuler(14 * recoil - 30 * belt.raise, 0, 0)
    if tool.turn then rot = rot * QuatEuler(tool.turn[1], tool.turn[2], tool.turn[3]) end
    if t > 0 and tool.stroke then
        pos = pos + VecScale(tool.stroke.pos, t)
        rot = QuatEuler(t * tool.stroke.turn[1], t * tool.stroke.turn[2], t * tool.stroke.turn[3]) * rot
    end
    local eye = GetPlayerCameraTransform()
    local ahead = VecScale(GetPlayerVelocity(), 1 / 60)
    return Transform(eye.pos + ahead, eye.rot) * Transform(pos, rot)
end

local function removeModels()
    for _, old in ipairs(FindBodies("viewmodel")) do Delete(old) end
    body, bodyOf = 0, 0
end

function belt.hide()
    if body ~= 0 then removeModels() end
end

local function showModel()
    local tool = belt.tool()
    if bodyOf == belt.current and body ~= 0 and IsHandleValid(body) then
        return SetBodyTransform(body, belt.frame())
    end
    removeModels()
    tool.model.voxel = kVoxel
    body = CreateModel(tool.model, belt.frame(), false)
    SetTag(body, "viewmodel", tool.id)
    bodyOf = belt.current
end

-- Makes the model anew, without the soot of a blast.
function belt.refresh()
    bodyOf = 0
end

-- After a load, with the tool that was in the hand. Its model stays the one that was saved: the world goes on with the
-- same bits.
function belt.resume(number)
    belt.current, body, bodyOf = number, 0, 0
    for _, old in ipairs(FindBodies("viewmodel")) do
        if body == 0 and GetTagValue(old, "viewmodel") == belt.tool().id then
            body, bodyOf = old, number
        else
            Delete(old)
        end
    end
end

-- Each frame, where no menu is open.
function belt.tick(dt)
    local tool = belt.tool()
    belt.cooldown = belt.cooldown - dt
    for i = 1, math.min(9, #belt.tools) do
        if InputPressed(tostring(i)) then belt.select(i) end
    end
    local wheel = InputValue("mousewheel")
    if wheel ~= 0 then
        local direction = wheel < 0 and 1 or -1
        belt.select(belt.current + direction, direction)
    end
    local turns = (InputPressed("nexttool") and 1 or 0) - (InputPressed("lasttool") and 1 or 0)
    if turns ~= 0 then belt.select(belt.current + turns, turns) end
    tool = belt.tool()
    local aim = belt.aim(tool.reach)
    belt.lastAim = aim
    if tool.tick then tool:tick(aim, dt) end
    local wants = tool.isAutomatic and InputDown("usetool") or InputPressed("usetool")
    local left, all = belt.left(tool)
    local isEmpty = left and left <= 0
    if wants and belt.cooldown <= 0 then
        if isEmpty then
            belt.cooldown = 0.25
        else
            belt.cooldown = tool.cooldown or 0.3
            if tool.marksUndo ~= false then AddUndoMark() end
            if tool:use(aim) ~= false then spend(tool) end
        end
    end
    if tool.alt and InputPressed("grab") then tool:alt(aim) end
    if InputPressed("reload") and left and left < all and not belt.limits then
        belt.ammo[tool.id], belt.raise, belt.cooldown = tool.ammo, 1, 0.5
    end
end

-- Each step.
function belt.update(dt, isShown)
    swing = math.min(1, swing + dt / swingSeconds)
    recoil = recoil * math.exp(-11 * dt)
    belt.raise = belt.raise * math.exp(-9 * dt)
    phase = phase + dt * 1.9 * player.speed
    local yaw, pitch = GetPlayerLook()
    local goal = Vec(0.05 * (yaw - lastYaw), -0.05 * (pitch - lastPitch), 0)
    sway = VecLerp(sway, VecScale(goal, math.min(1, 0.02 / (VecLength(goal) + 1e-6))), 0.25)
    lastYaw, lastPitch = yaw, pitch
    local tool = belt.tool()
    if isShown then showModel() else belt.hide() end
    if isShown and tool.update then tool:update(dt) end
end

return belt
