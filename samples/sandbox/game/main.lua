-- The game: a town to take apart. The shell (samples/sandbox/shell) gives input, a player, a camera and saves; all
-- else is here and in the files beside, over the functions of docs/scripting.
local belt = require("toolbelt")
local bombs = require("tools/bombs")
local contract = require("contracts/contract")
local dropped = require("dropped")
local explosives = require("explosives")
local feel = require("feel")
local hud = require("hud")
local interact = require("interact")
local keys = require("keys")
local lift = require("lift")
local menus = require("menus/menus")
local options = require("options")
local photo = require("menus/photo")
local panel = require("contracts/panel")
local place = require("place")
local player = require("player")
local radial = require("menus/radial")
local replay = require("menus/replay")
local sounds = require("sounds")
local spawn = require("menus/spawn")
local vehicles = require("vehicles/vehicles")

local titleTime = 0
local hasSeenEnd = false
local lastDropped = nil  -- what waits to be placed
local blasts = {timebomb = 1.5, remotebomb = 1.6}  -- sizes of explosions
local play = saved("play", {tool = 1, yaw = 0, pitch = 0, flies = false})

belt.load({"sledge", "axe", "pistol", "shotgun", "rocket", "timebomb", "remotebomb", "blowtorch", "extinguisher",
    "spray", "hands", "plank", "rope", "vacuum", "gravitygun", "laser", "drill"})

contract.add("demolition")
contract.add("heist")
interact.contract = contract.offer
place.say = hud.say

function init()
    keys.apply()
    player.spawn()
    vehicles.spawnAll()
    explosives.begin()
    options.apply()
    contract.begin()
    local isAgain = GetBool("game.restarted") and not GetBool("game.title")
    ClearKey("game.restarted")
    ClearKey("game.title")
    if not isAgain then menus.open = "title" end
end

function onLoad()
    keys.apply()
    belt.resume(play.tool)
    SetPlayerLook(play.yaw, play.pitch)
    player.fly(play.flies)
    vehicles.resume()
    place.resume()
    options.apply()
    contract.resume()
    for _, tool in ipairs(belt.tools) do
        if tool.resume then tool.resume() end
    end
    hud.say("Loaded")
end

menus.photo = function()
    menus.open = nil
    photo.open()
end

menus.replay = function()
    menus.open = nil
    replay.open()
end

local function readKeys()
    if InputPressed("photo") then return photo.open() end
    if InputPressed("replay") then return replay.open() end
    if InputPressed("pause") then menus.show("pause") end
    if InputPressed("wheel") and not vehicles.driven() then
        place.finish()
        radial.open()
    end
    if InputPressed("spawn") and not vehicles.driven() then
        if contract.current() then hud.say("Nothing is placed in a contract") else spawn.open() end
    end
    if InputPressed("quicksave") then menus.save() end
    if InputPressed("quickload") then menus.load() end
    if InputPressed("undo") then
        if contract.current() then
            hud.say("Nothing is taken back in a contract")
        elseif Undo() then
            hud.say("Taken back")
        end
    end
    if vehicles.driven() then
        if InputPressed("interact") then vehicles.leave() end
    elseif InputPressed("interact") and belt.lastAim then
        local _, deed = interact.offer(belt.lastAim)
        if deed then deed() end
    end
end

-- What is dropped on the window stands before the eyes at once, or when what is open is left. In a contract nothing is
-- placed.
local function takeDrops()
    local thing, what = dropped.take()
    if what then hud.say(what, 8) end
    if thing then
        hud.say(string.format("%s is in the menu of things (%s)", thing.name, keys.label("spawn")), 4)
        lastDropped = thing
    end
    if contract.current() then lastDropped = nil end
    if not lastDropped or menus.open or photo.isOpen or replay.isOpen or vehicles.driven() then return end
    spawn.isOpen, radial.isOpen = false, false
    place.begin(lastDropped)
    lastDropped = nil
end

-- For other scripts: what is open, and which tool is in the hand.
local function publish()
    local other = photo.isOpen and "photo" or replay.isOpen and "replay" or spawn.isOpen and "spawn" or radial.isOpen and "radial"
    SetString("game.menu", menus.open or other or "")
    SetString("game.tool", belt.tool().id)
    spawn.publish()
    SetString("game.placing", place.thing and place.thing.name or "")
    contract.publish()
    replay.publish()
    dropped.publish()
    SetString("game.message", hud.message())
    vehicles.publish()
end

function tick(dt)
    publish()
    keys.tick()
    takeDrops()
    feel.tick(dt)
    hud.tick(dt)
    sounds.loop("wind", nil, 0.06 + 0.01 * math.min(VecLength(GetPlayerVelocity()), 30))
    hud.messageAt = contract.isOpen() and panel.height() + 60 or 110
    if contract.isOver() and not hasSeenEnd and not menus.open then
        hasSeenEnd = true
        menus.show("result")
    end
    SetTimeScale((menus.stopsTime() or photo.isStill or spawn.isOpen or replay.isOpen) and 0 or options.get("timescale"))
    if menus.open then
        titleTime = titleTime + dt
        if menus.isTitle() then menus.camera(titleTime) end
        return menus.tick()
    end
    if photo.isOpen then return photo.tick(dt) end
    photo.isStill = false
    if replay.isOpen then return replay.tick(dt) end
    if spawn.isOpen then return spawn.tick() end
    if radial.isOpen then return radial.tick() end
    if vehicles.driven() then
        vehicles.tick(dt)
        return readKeys()
    end
    player.tick(dt)
    if place.isActive() then
        place.tick()
        return readKeys()
    end
    if interact.held ~= 0 and InputPressed("usetool") then
        interact.throw(GetPlayerCameraTransform().rot * Vec(0, 0, -1))
        belt.cooldown = 0.3
    end
    belt.tick(dt)
    readKeys()
    play.tool, play.flies = belt.current, player.isFlying
    play.yaw, play.pitch = GetPlayerLook()
end

function update(dt)
    vehicles.update(menus.open or photo.isOpen)
    if not vehicles.driven() then
        player.update(not menus.open and not photo.isOpen)
        interact.update()
    end
    local isPlaying = not menus.open and not photo.isOpen and not spawn.isOpen
    place.update(isPlaying)
    lift.update()
    explosives.update()
    bombs.update(dt, blasts, contract.charge())
    contract.update(dt)
    belt.update(dt, not vehicles.driven() and isPlaying and not place.isActive() and interact.held == 0)
    photo.update()
end

function onBreak(shape, voxels)
    explosives.broken(shape, voxels)
end

function draw()
    if menus.open then
        menus.draw()
        return hud.drawMessage()
    end
    if photo.isOpen then return photo.draw() end
    if replay.isOpen then return replay.draw() end
    if spawn.isOpen then
        spawn.draw()
        return hud.drawMessage()
    end
    if not hud.isHidden and not radial.isOpen then panel.draw() end
    hud.draw(radial.isOpen)
    if radial.isOpen then radial.draw() end
end
