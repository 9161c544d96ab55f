-- A test: gets into each vehicle, drives, turns, brakes, uses what it has, gets out. Prints what they reach. Images of
-- the work are written where the option "images" is set.
local bot = require("bots/hands")

local lanes = {car = -50, van = -40, truck = -30, forklift = -20, excavator = -10, crane = 12, boat = 40}
local kStart, kLake = 30, 0.75
local view
local figures = {}
SetString("options.volume", "0")  -- nothing is computed for the ear

local function image(name, from, to)
    if not HasKey("options.images") then return end
    view = Transform(from, QuatLookAt(from, to))
    bot.frames(2)
    bot.image("action-" .. name)
    view = nil
end

local function block(size, material, color, place, isDynamic, boxes)
    return CreateModel({size = {size[1], size[2], size[3]}, origin = {size[1] / 2, 0, size[3] / 2},
        voxel = size.voxel or 0.1, palette = {{color[1], color[2], color[3], material = material, roughness = 0.9}},
        boxes = boxes or {{0, 0, 0, size[1] - 1, size[2] - 1, size[3] - 1, 1}}}, Transform(place), isDynamic)
end

local function build()
    block({120, 2, 120, voxel = 1}, "concrete", {0.42, 0.43, 0.44}, Vec(0, -2, 0), false)
    local x = lanes.boat
    CreateWater({Vec(x - 14, 0, -50), Vec(x + 14, 0, -50), Vec(x + 14, 0, 50), Vec(x - 14, 0, 50)}, kLake + 0.45, 3)
    for kind, at in pairs(lanes) do
        SetString("game.spawn", string.format("%s %g %g %g 0", kind, at, kind == "boat" and kLake or 0.02, kStart))
        bot.frames(2)
    end
    bot.frames(30)
end

-- A part of a vehicle: its chassis, unless another one is named.
local function part(kind, name)
    for _, body in ipairs(FindBodies("vehicle")) do
        local isOwn = GetTagValue(body, "vehicle") == kind
        if isOwn and GetTagValue(body, "part") == (name or "chassis") then return body end
    end
end

local function placeOf(body)
    return GetBodyTransform(body) * GetBodyCenterOfMass(body)
end

local function enter(kind)
    local body = part(kind)
    local target = GetBodyTransform(body) * Vec(0, 0.9, 0.3)
    SetPlayerWalking(kind ~= "boat")
    bot.stand(target + Vec(kind == "crane" and -3.4 or -2.9, -0.8, 0), target)
    bot.press("e")
    bot.expect(GetString("game.vehicle") == kind, "to sit in the " .. kind)
    return body
end

local function leave(kind)
    bot.press("e")
    bot.expect(GetString("game.vehicle") == "", "to have left the " .. kind)
    bot.frames(10)
    local far = VecLength(GetPlayerTransform().pos - GetBodyTransform(part(kind)).pos)
    bot.expect(far > 0.8 and far < 6, "to stand beside the " .. kind)
end

-- Forward for so many frames, a turn to the left, the brake.
local function drives(kind, frames, least)
    local body = part(kind)
    local from, best, total = placeOf(body), 0, 0
    SetInput("w", true)
    for _ = 1, frames do
        bot.frames(1)
        best = math.max(best, VecLength(GetBodyVelocity(body)))
        total = total + GetStepTime()
    end
    local way = placeOf(body) - from
    bot.expect(-way.z > least, string.format("the %s to drive %g m forward, not %.2f", kind, least, -way.z))
    bot.expect(math.abs(way.x) < 0.25 * -way.z, kind .. " to drive straight")
    SetInput("a", true)
    bot.frames(25)
    local spin, speed, radius = 0, 0, 0
    for _ = 1, 10 do
        bot.frames(1)
        spin, speed = spin + GetBodyAngularVelocity(body).y, speed + VecLength(GetBodyVelocity(body))
    end
    bot.expect(spin > 0.02, kind .. " to turn to the left")
    radius = speed / spin
    SetInput("a", false)
    SetInput("w", false)
    bot.hold("space", 90)
    bot.expect(VecLength(GetBodyVelocity(body)) < 0.25 * best, kind .. " to brake")
    local row = "| %s | %.0f kg | %.1f m in %.1f s | %.0f km/h | %.1f m | %.2f |"
    figures[#figures + 1] = string.format(row, kind, GetBodyMass(body), -way.z, frames / 60, 3.6 * best, radius,
        total / frames)
end

local function plain(kind)
    enter(kind)
    drives(kind, 90, 2)
    leave(kind)
end

local function lifts()
    -- Ahead of the forks, which are 0.9 m wide and fit between its sides.
    local crate = block({12, 9, 9}, "wood", {0.55, 0.4, 0.24}, Vec(lanes.forklift, 0.02, kStart - 3), true,
        {{0, 0, 0, 0, 8, 8, 1}, {11, 0, 0, 11, 8, 8, 1}, {0, 3, 0, 11, 8, 8, 1}})
    enter("forklift")
    bot.hold("w", 45)
    bot.hold("space", 20)
    bot.hold("r", 100)
    local high = placeOf(crate).y
    bot.expect(high > 1.2, string.format("the fork to lift a crate, not to %.2f m", high))
    image("forklift", Vec(lanes.forklift - 4, 2.4, kStart - 5), Vec(lanes.forklift, 1.2, kStart - 1.6))
    bot.hold("f", 110)
    bot.expect(placeOf(crate).y < 0.7, "the fork to put it down")
    bot.hold("s", 40)
    bot.hold("space", 30)
    Delete(crate)
    drives("forklift", 60, 1)
    leave("forklift")
end

local function tips()
    enter("truck")
    local bed = part("truck", "bed")
    local before = placeOf(bed).y
    bot.hold("r", 90)
    bot.expect(placeOf(bed).y > before + 0.6, string.format("the bed to tip, not %.2f m", placeOf(bed).y - before))
    image("truck", Vec(lanes.truck - 6, 3, kStart + 6), Vec(lanes.truck, 1.3, kStart))
    bot.hold("f", 95)
    drives("truck", 90, 2)
    leave("truck")
end

local function digs()
    local at = Vec(lanes.excavator, 0, kStart - 4.4)
    local _, mound = block({30, 8, 30}, "dirt", {0.42, 0.32, 0.22}, at, false)
    enter("excavator")
    local before = GetShapeVoxelCount(mound)
    bot.hold("downarrow", 60)
    bot.hold("f", 40)
    image("excavator", at + Vec(-5, 2.6, -2.4), at + Vec(0, 0.8, 1.6))
    bot.hold("uparrow", 75)
    local dug = before - (IsHandleValid(mound) and GetShapeVoxelCount(mound) or 0)
    bot.expect(dug > 500, "the bucket to dig, not " .. dug .. " voxels")
    local house = part("excavator", "house")
    local ahead = GetBodyTransform(house).rot * Vec(0, 0, -1)
    bot.hold("leftarrow", 70)
    bot.expect(VecDot(ahead, GetBodyTransform(house).rot * Vec(0, 0, -1)) < 0.8, "the excavator's house to turn")
    Delete(GetShapeBody(mound))
    drives("excavator", 60, 0.7)
    leave("excavator")
    return dug
end

local function wrecks()
    local x = lanes.crane
    local _, wall = block({3, 30, 40}, "brick", {0.55, 0.3, 0.24}, Vec(x - 5.5, 0, kStart - 7.5), false)
    enter("crane")
    bot.hold("f", 100)
    local before = GetShapeVoxelCount(wall)
    SetInput("leftarrow", true)
    bot.frames(100)
    image("crane", Vec(x - 13, 4, kStart - 16), Vec(x - 3, 3, kStart - 5))
    bot.frames(60)
    SetInput("leftarrow", false)
    local broken = before - (IsHandleValid(wall) and GetShapeVoxelCount(wall) or 0)
    bot.expect(broken > 50, "the ball to break a wall, not " .. broken .. " voxels")
    bot.hold("r", 40)
    drives("crane", 60, 0.5)
    leave("crane")
end

local function sails()
    enter("boat")
    SetInput("w", true)
    bot.frames(60)
    image("boat", placeOf(part("boat")) + Vec(-6, 2.5, -6), placeOf(part("boat")))
    SetInput("w", false)
    drives("boat", 60, 2)
    bot.expect(math.abs(placeOf(part("boat")).y - kLake - 0.5) < 0.6, "the boat to float")
    leave("boat")
end

-- A shot through the engine stops a car, and a wheel that is hit hard comes off.
local function breaks()
    local body = enter("car")
    MakeHole(GetBodyTransform(body) * Vec(0, 0.5, -1.4), 0.5, 0.5, 0.5)
    bot.frames(40)
    bot.expect(GetBool("game.vehicle.dead"), "an engine that is gone to stop")
    local from = placeOf(body)
    bot.hold("w", 60)
    bot.expect(VecLength(placeOf(body) - from) < 0.5, "a dead car to stand")
    local wheel, van = part("van", "wheel"), part("van")
    local shape = GetBodyShapes(wheel)[1]
    bot.expect(#GetShapeJoints(shape) == 1, "a wheel on its joint")
    local hub = TransformToLocalPoint(GetBodyTransform(van), placeOf(wheel))
    local outward = GetBodyTransform(van).rot * Vec(hub.x > 0 and 5000 or -5000, 500, 0)
    ApplyBodyImpulse(wheel, placeOf(wheel), outward)
    bot.frames(4)
    bot.expect(#GetShapeJoints(shape) == 0, "a wheel that is hit hard to come off")
    Delete(van)  -- whose side still covers the wheel
    local place = placeOf(wheel)
    ApplyBodyImpulse(wheel, place, VecScale(outward, 0.2))
    bot.frames(30)
    local way = VecLength(placeOf(wheel) - place)
    bot.expect(way > 0.3, string.format("a wheel that came off to go its way, not %.2f m", way))
    bot.press("e")
end

bot.play(function()
    bot.frames(3)
    bot.press("return")
    build()
    plain("car")
    plain("van")
    tips()
    lifts()
    digs()
    wrecks()
    sails()
    breaks()
    print("| vehicle | chassis | way | fastest | turn radius | ms a step |\n" .. table.concat(figures, "\n"))
    print("vehicles: " .. GetStateHash())
    ClearKey("options.volume")
end)

function tick()
    bot.tick()
    if view then SetCameraTransform(view, 55) end
end
