-- Common driving: what keys ask for, wheels, engine, lamps, smoke.
local build = require("vehicles/build")
local feel = require("feel")
local keys = require("keys")
local sounds = require("sounds")
local tracks = require("vehicles/tracks")

local drive = {}
local kEngineCells = 3          -- places along each side at which the engine is looked for
local kSmoke = 60 * 60          -- steps for which it smokes
local kCheck = 15               -- steps between two looks

-- What the keys ask for; nothing where the driver cannot.
function drive.input(isHeld)
    if isHeld then return {throttle = 0, steer = 0, brake = 1, lift = 0, turn = 0, boom = 0, tilt = 0} end
    local axis = keys.axis
    return {throttle = axis("gas", "reverse"), steer = axis("left", "right"), brake = InputValue("handbrake"),
        lift = axis("liftup", "liftdown"), tilt = axis("tiltup", "tiltdown"), turn = axis("turnleft", "turnright"),
        boom = axis("boomup", "boomdown")}
end

-- Metres a second, ahead.
function drive.speed(v)
    if not IsHandleValid(v.chassis.body) then return 0 end
    local frame = GetBodyTransform(v.chassis.body)
    return VecDot(GetBodyVelocity(v.chassis.body), frame.rot * Vec(0, 0, -1))
end

-- The share of the engine that is there.
local function engineShare(v, kind)
    local part = v[kind.engineIn or "chassis"]
    if not IsHandleValid(part.shape) then return 0 end
    local low, high = kind.engine[1], kind.engine[2]
    local frame = GetBodyTransform(part.body)
    if kind.engineIn then frame = frame * Transform(Vec(0, -1.4, 0)) end
    local found, n = 0, kEngineCells
    for i = 0, n - 1 do
        for k = 0, n - 1 do
            local at = Vec(low[1] + (high[1] - low[1]) * (i + 0.5) / n, 0.5 * (low[2] + high[2]),
                low[3] + (high[3] - low[3]) * (k + 0.5) / n)
            local material = GetShapeMaterialAtPosition(part.shape, frame * at)
            if material ~= "" then found = found + 1 end
        end
    end
    return found / (n * n), frame * VecLerp(low, high, 0.5)
end

-- An engine that has lost a part of itself stops for good.
local function checkEngine(v, kind)
    v.age = (v.age or 0) + 1
    if v.age % kCheck ~= 1 then return end
    local share, at = engineShare(v, kind)
    v.whole = v.whole or share
    if v.isDead or share >= 0.7 * v.whole then return end
    v.isDead, v.smoke = true, 0
    v.smokeAt = TransformToLocalPoint(GetBodyTransform(v.chassis.body), at)
    feel.burst(at, Vec(0, 1, 0), {type = "spark", count = 24, speed = 5, life = 0.6, color = {1, 0.62, 0.22},
        radius = {0.015, 0.006}, gravity = -6, emissive = 0.4, stretch = 0.04, spread = 0.8})
end

-- Each step of each vehicle: an engine that has broken smokes, less and less, also where nobody drives.
function drive.smoke(v)
    if not v.smoke or v.smoke > kSmoke or not IsHandleValid(v.chassis.body) then return end
    v.smoke = v.smoke + 1
    if v.smoke % 4 ~= 0 then return end
    local left = 1 - v.smoke / kSmoke
    local frame = GetBodyTransform(v.chassis.body)
    local at = frame * v.smokeAt + Vec(0, 0.35, 0) + frame.rot * Vec(0.5 * math.random() - 0.25, 0, 0)
    feel.burst(at, Vec(0.15, 1, 0.05), {type = "smoke", count = 1, speed = 1.3, life = 3.2, drag = 0.5,
        color = {0.045, 0.043, 0.042}, radius = {0.18, 0.9}, alpha = 0.35 + 0.4 * left, spread = 0.12})
end

-- A lamp whose glass is gone is dark.
function drive.light(v, isOn)
    for _, lamp in ipairs(v.lamps) do
        if IsHandleValid(lamp.light) then
            local at = GetBodyTransform(v.chassis.body) * lamp.place
            QueryRequire("physical")
            local hasGlass = QueryClosestPoint(at, 0.3)
            SetLightEnabled(lamp.light, isOn and hasGlass)
        end
    end
end

local function rollWheels(v, kind, input, speed)
    local isAgainst = input.throttle * speed < -0.8
    local steer = input.steer / (1 + (speed / 15) ^ 2)
    local throttle = isAgainst and 0 or input.throttle * math.min(1, 0.7 + 0.1 * math.abs(speed))
    DriveWheels(v.chassis.body, throttle, kind.isRearSteered and -steer or steer,
        math.max(input.brake, isAgainst and 0.7 or 0))
end

-- Each step of one that is driven.
function drive.update(v, kind, input)
    if not IsHandleValid(v.chassis.body) then return end
    if not IsBodyActive(v.chassis.body) then SetBodyActive(v.chassis.body, true) end
    checkEngine(v, kind)
    if v.isDead then
        input.throttle, input.lift, input.turn, input.boom, input.tilt = 0, 0, 0, 0, 0
    end
    local speed = drive.speed(v)
    if kind.isTracked then
        tracks.drive(v, input.throttle, v.isDead and 0 or input.steer, input.brake > 0)
    elseif not kind.isBoat then
        rollWheels(v, kind, input, speed)
    end
    if kind.update then kind.update(v, input) end
    if not v.isDead then
        local work = math.max(math.abs(input.lift), math.abs(input.turn), math.abs(input.boom), math.abs(input.tilt))
        local load = math.max(math.abs(input.throttle), 0.6 * work)
        v.rev = (v.rev or 0) + 0.06 * (load - (v.rev or 0))
        sounds.loop("engine", GetBodyTransform(v.chassis.body).pos, 0.35 + 0.4 * v.rev,
            kind.pitch * (0.7 + 0.5 * v.rev + 0.02 * math.abs(speed)))
    end
end

-- Nobody drives it any more: it stands.
function drive.park(v, kind)
    if not IsHandleValid(v.chassis.body) then return end
    if kind.isTracked then tracks.drive(v, 0, 0, true)
    elseif not kind.isBoat then DriveWheels(v.chassis.body, 0, 0, 1) end
    if kind.isTracked then
        v.track.left, v.track.right = 0, 0
        tracks.drive(v, 0, 0, true)
    end
    if kind.update then kind.update(v, drive.input(true)) end
    drive.light(v, false)
end

return drive
