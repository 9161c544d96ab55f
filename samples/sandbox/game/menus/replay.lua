-- Replay: the last seconds again, seen by a camera that flies. The world of the game stands still meanwhile.
local camera = require("freecamera")
local draw = require("draw")
local hud = require("hud")
local keys = require("keys")
local options = require("options")
local stills = require("menus/stills")

local replay = {isOpen = false}
local kJump, kRepeat = 0.5, 1 / 10  -- seconds that an arrow key moves by, and after which it does again
local kWidth, kFrames = 900, 6      -- frames for which nothing is drawn over an image
local kSpeeds = {{0.1, "1/10"}, {0.25, "1/4"}, {0.5, "1/2"}, {1, "1"}, {2, "2"}}
local length, ago, speed, isPaused, fov = 0, 0, 4, false, 68
local sinceJump, hidden, isBare = 0, 0, false

function replay.open()
    length = GetReplayLength()
    if length < 0.1 then
        return hud.say(options.get("replay") == "on" and "Nothing has happened yet" or "The settings keep no replay", 3)
    end
    replay.isOpen, isPaused, isBare, hidden = true, false, false, 0
    ago, speed, fov = length, 4, options.get("fov")
    camera.begin()
end

function replay.close()
    replay.isOpen = false
    options.apply("fov")
end

-- Left and right move through time, and go on while they are held.
local function scrub(dt)
    local direction = (InputDown("listright") and 1 or 0) - (InputDown("listleft") and 1 or 0)
    local isNew = InputPressed("listright") or InputPressed("listleft")
    sinceJump = isNew and -0.3 or sinceJump + dt
    if direction == 0 or not isNew and sinceJump < kRepeat then return end
    if not isNew then sinceJump = 0 end
    ago = math.max(0, math.min(length, ago - direction * kJump))
end

local function readKeys(dt)
    if InputPressed("hide") then isBare = not isBare end
    if InputPressed("listup") then speed = math.min(#kSpeeds, speed + 1) end
    if InputPressed("listdown") then speed = math.max(1, speed - 1) end
    fov = math.max(12, math.min(110, fov - 2 * InputValue("mousewheel")))
    if InputPressed("menuclear") then ago, isPaused = length, false end
    if InputPressed("menuok") then
        if not isPaused and ago == 0 then ago = length else isPaused = not isPaused end
    end
    if InputPressed("usetool") then
        stills.take()
        hidden = kFrames
    end
    scrub(dt)
end

-- Each frame while it is open.
function replay.tick(dt)
    hidden = math.max(0, hidden - 1)
    local isBusy = stills.isBusy()
    if not isBusy and (InputPressed("menuback") or InputPressed("replay")) then return replay.close() end
    if isBusy then
        camera.stay(fov)
    else
        readKeys(dt)
        if not isPaused then ago = math.max(0, ago - dt * kSpeeds[speed][1]) end
        camera.fly(dt, fov)
    end
    local isShown, why = ShowReplay(ago, "viewmodel")
    if isShown then return end
    replay.close()
    hud.say(why, 6)
end

-- For other scripts: seconds before the game, while it is open.
function replay.publish()
    SetString("game.replay", replay.isOpen and string.format("%.4f", ago) or "")
end

local function drawBar(width, scale)
    UiPush()
    UiAlign("left middle")
    UiColor(1, 1, 1, 0.16)
    UiRoundedRect(width, 8, 4)
    draw.color(draw.accent, 0.95)
    UiRoundedRect(math.max(8, width * (1 - ago / length)), 8, 4)
    UiPop()
    UiPush()
    UiTranslate(0, 44 * scale)
    draw.text(ago < 0.005 and "now" or string.format("%.1f s ago", ago), 24)
    UiTranslate(width, 0)
    draw.text(isPaused and "paused" or kSpeeds[speed][2] .. "x", 24, "right", isPaused and draw.accent or draw.ink)
    UiPop()
end

function replay.draw()
    if stills.isBusy() and stills.sizes[stills.chosen()][2] then return stills.draw() end
    if hidden > 0 or isBare then return end
    local scale = options.get("textsize")
    local width = math.min(kWidth * scale, UiWidth() - 160)
    UiPush()
    UiTranslate(UiCenter() - width / 2 - 30, UiHeight() - 130 - 90 * scale)
    draw.panel(width + 60, 90 * scale, 0.62)
    UiTranslate(30, 30 * scale)
    drawBar(width, scale)
    UiPop()
    UiPush()
    UiTranslate(UiCenter(), UiHeight() - 84)
    draw.text(string.format("%s: pause    %s: back and forth    %s: speed    %s: take it", keys.labels("menuok"),
        keys.labels("listleft listright"), keys.labels("listdown listup"), keys.labels("usetool")), 24, "center")
    UiTranslate(0, 40)
    draw.text(string.format("%s: from the beginning    %s: hide this    %s: back to the game", keys.labels("menuclear"),
        keys.labels("hide"), keys.labels("menuback")), 24, "center")
    UiPop()
end

return replay
