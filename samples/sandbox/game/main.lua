-- The game: a town to take apart. The shell (samples/sandbox/shell) gives input, a player, a camera and saves; all
-- else is here and in the files beside, over the functions of docs/scripting.
local belt = require("toolbelt")
local feel = require("feel")
local hud = require("hud")
local interact = require("interact")
local menus = require("menus/menus")
local options = require("options")
local player = require("player")
local radial = require("menus/radial")
local sounds = require("sounds")
local vehicles = require("vehicles/vehicles")

local titleTime = 0
local play = saved("play", {tool = 1, yaw = 0, pitch = 0, flies = false})

belt.load({"sledge", "axe", "pistol", "shotgun", "rocket", "timebomb", "remotebomb", "blowtorch", "extinguisher",
    "spray", "hands", "plank", "rope", "vacuum", "gravitygun", "laser", "drill"})

function init()
    player.spawn()
    vehicles.spawnAll()
    options.apply()
    if GetBool("game.restarted") then return ClearKey("game.restarted") end
    menus.open = "title"
end

function onLoad()
    belt.reset()
    belt.current = play.tool
    SetPlayerLook(play.yaw, play.pitch)
    player.fly(play.flies)
    vehicles.resume()
    options.apply()
    for _, tool in ipairs(belt.tools) do
        if tool.resume then tool.resume() end
    end
    hud.say("Loaded")
end

local function readKeys()
    if InputPressed("esc") then menus.open = "pause" end
    if InputPressed("tab") then radial.open() end
    if InputPressed("f5") then menus.save() end
    if InputPressed("f9") then menus.load() end
    if InputDown("ctrl") and InputPressed("z") and Undo() then hud.say("Taken back") end
    if vehicles.driven() then
        if InputPressed("e") then vehicles.leave() end
    elseif InputPressed("e") and belt.lastAim then
        local _, deed = interact.offer(belt.lastAim)
        if deed then deed() end
    end
end

-- For other scripts: what is open, and which tool is in the hand.
local function publish()
    SetString("game.menu", menus.open or radial.isOpen and "radial" or "")
    SetString("game.tool", belt.tool().id)
    vehicles.publish()
end

function tick(dt)
    publish()
    feel.tick(dt)
    hud.tick(dt)
    sounds.loop("wind", nil, 0.06 + 0.01 * math.min(VecLength(GetPlayerVelocity()), 30))
    SetTimeScale(menus.open and not menus.isTitle() and 0 or options.get("timescale"))
    if menus.open then
        titleTime = titleTime + dt
        if menus.isTitle() then menus.camera(titleTime) end
        return menus.tick()
    end
    if radial.isOpen then return radial.tick() end
    if vehicles.driven() then
        vehicles.tick(dt)
        return readKeys()
    end
    player.tick(dt)
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
    if vehicles.driven() then
        vehicles.update(menus.open)
        return belt.update(dt, false)
    end
    player.update(not menus.open)
    interact.update()
    belt.update(dt, not menus.open and interact.held == 0)
end

function draw()
    if menus.open then return menus.draw() end
    hud.draw(radial.isOpen)
    if radial.isOpen then radial.draw() end
end
