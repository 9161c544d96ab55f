-- Vehicles to drive: E enters and leaves. They stand at the places of the level that are called "vehicle KIND".
local camera = require("vehicles/camera")
local draw = require("draw")
local drive = require("vehicles/drive")
local keys = require("keys")
local parts = require("vehicles/parts")

local vehicles = {kinds = {}}
local kNames = {"car", "van", "truck", "forklift", "excavator", "boat", "crane"}
for _, name in ipairs(kNames) do vehicles.kinds[name] = require("vehicles/" .. name) end
local fleet = saved("vehicles", {all = {}, driven = 0})
local lightsOn = true

local function driven()
    return fleet.all[fleet.driven]
end

-- The one that is driven, and what kind it is.
function vehicles.driven()
    local v = driven()
    if v then return v, vehicles.kinds[v.kind] end
end

-- Makes one; its frame is on the ground, its front towards -z.
function vehicles.spawn(name, frame)
    local kind = vehicles.kinds[name] or error("no vehicle " .. tostring(name), 2)
    local v = {kind = name, bodies = {}, wheels = {}, lamps = {}, frame = frame}
    kind.build(v, frame)
    v.since = GetTime()
    fleet.all[#fleet.all + 1] = v
    return v
end

-- Its models and where they are, as parts.models() gives them.
function vehicles.models(name)
    return parts.models(name, vehicles.kinds[name])
end

function vehicles.spawnAll()
    fleet.all, fleet.driven = {}, 0
    for _, name in ipairs(kNames) do
        for _, place in ipairs(FindLocations("vehicle " .. name)) do
            vehicles.spawn(name, GetLocationTransform(place))
        end
    end
end

-- Other scripts may ask for one: "game.spawn" is "KIND x y z degrees".
local function spawnAsked()
    local name, x, y, z, turn = GetString("game.spawn"):match("^(%l+) (%S+) (%S+) (%S+) (%S+)$")
    ClearKey("game.spawn")
    if not name then return end
    vehicles.spawn(name, Transform(Vec(tonumber(x), tonumber(y), tonumber(z)), QuatEuler(0, tonumber(turn), 0)))
end

-- The vehicle that a body belongs to.
function vehicles.of(body)
    if not IsHandleValid(body) or not HasTag(body, "vehicle") then return nil end
    for i, v in ipairs(fleet.all) do
        for _, own in ipairs(v.bodies) do
            if own == body and IsHandleValid(v.chassis.body) then return v, vehicles.kinds[v.kind], i end
        end
    end
end

-- What E offers where the eyes look at a body: a text, and the deed.
function vehicles.offer(body)
    local v, kind, index = vehicles.of(body)
    if v then return "Drive the " .. kind.name, function() vehicles.enter(index) end end
end

-- After a load one sits where one sat.
function vehicles.resume()
    local v, kind = vehicles.driven()
    if not v then return end
    SetPlayerWalking(false)
    MovePlayer(Vec(0, 0, 0), false, false)
    camera.begin(GetBodyTransform(v.chassis.body), kind)
end

function vehicles.enter(index)
    fleet.driven = index
    vehicles.resume()
    drive.light(driven(), lightsOn)
end

-- Out at the side; on top where something is in the way.
function vehicles.leave()
    local v, kind = vehicles.driven()
    fleet.driven = 0
    drive.park(v, kind)
    if not IsHandleValid(v.chassis.body) then return SetPlayerWalking(true) end
    local frame = GetBodyTransform(v.chassis.body)
    local yaw = GetPlayerLook()
    local from = frame * Vec(0, 1.5, kind.exit[3])
    for _, side in ipairs({1, -1}) do
        local to = frame * Vec(side * kind.exit[1], kind.exit[2] + 0.3, kind.exit[3])
        local way = to - from
        QueryRejectBodies(parts.there(v))
        if not QueryRaycast(from, VecNormalize(way), VecLength(way), 0.3) then
            SetPlayerTransform(Transform(to, QuatEuler(0, math.deg(yaw), 0)))
            return SetPlayerWalking(true)
        end
    end
    SetPlayerTransform(Transform(frame.pos + Vec(0, 3, 0), QuatEuler(0, math.deg(yaw), 0)))
    SetPlayerWalking(true)
end

-- Each frame: what other scripts ask for, and what they may know.
function vehicles.publish()
    for _, v in ipairs(fleet.all) do
        if v.since and GetTime() > v.since then  -- its bodies are there
            v.since = nil
            drive.park(v, vehicles.kinds[v.kind])
        end
    end
    if HasKey("game.spawn") then spawnAsked() end
    local v = driven()
    SetString("game.vehicle", v and v.kind or "")
    SetBool("game.vehicle.dead", v ~= nil and v.isDead == true)
end

-- Each frame in which one drives and no menu is open.
function vehicles.tick(dt)
    local v, kind = vehicles.driven()
    if not IsHandleValid(v.chassis.body) then return vehicles.leave() end
    local yaw, pitch = camera.frame(v, kind, dt)
    SetPlayerLook(yaw, pitch)
    if InputPressed("headlights") then
        lightsOn = not lightsOn
        drive.light(v, lightsOn)
    end
end

-- Each step. `isHeld`: a menu is open.
function vehicles.update(isHeld)
    for _, each in ipairs(fleet.all) do drive.smoke(each) end
    local v, kind = vehicles.driven()
    if not v or not IsHandleValid(v.chassis.body) then return end
    camera.step()
    drive.update(v, kind, drive.input(isHeld))
    if v.age and v.age % 30 == 0 then drive.light(v, lightsOn) end
    local yaw, pitch = GetPlayerLook()
    local seat = GetBodyTransform(v.chassis.body).pos
    SetPlayerTransform(Transform(seat, QuatEuler(0, math.deg(yaw), 0) * QuatEuler(math.deg(pitch), 0, 0)))
end

-- Speed and keys, over the image.
function vehicles.draw()
    local v, kind = vehicles.driven()
    UiPush()
    UiTranslate(UiWidth() - 48, UiHeight() - 44)
    local speed = math.floor(3.6 * math.abs(drive.speed(v)) + 0.5)
    draw.text(v.isDead and "the engine is broken" or speed .. " km/h", 30, "right",
        v.isDead and {1, 0.45, 0.35} or draw.ink, 1, "bold.ttf")
    UiTranslate(0, -44)
    draw.text(kind.name, 22, "right")
    UiPop()
    local rows = {}
    local function add(actions, text) rows[#rows + 1] = {keys.labels(actions), text} end
    add("interact", "get out")
    add("gas left reverse right", "drive")
    add("handbrake", "brake")
    for _, row in ipairs(kind.keys or {}) do add(row[1], row[2]) end
    add("headlights", "lamps")
    draw.hints(rows)
end

return vehicles
