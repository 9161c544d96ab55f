-- Over the image while one plays: crosshair, tool, what E does. It stays out of the way.
local belt = require("toolbelt")
local draw = require("draw")
local interact = require("interact")
local options = require("options")
local player = require("player")
local vehicles = require("vehicles/vehicles")

local hud = {isHidden = false, showsKeys = false, messageAt = 110}
local message, messageTime = "", 0
local sinceStart, nameTime, lastTool = 0, 0, 0

local kFirst = {"Walk: W A S D    Look: mouse", "Left button: use the tool", "Tab: all tools    1 to 9, wheel: change",
    "V: fly    Ctrl+Z: take back    F1: all keys"}
local kLastOfContract = "E: take, open    F5: save    F1: all keys"
local kKeys = {{"W A S D", "walk"}, {"Shift", "run"}, {"Space", "jump"}, {"Ctrl", "crouch"}, {"V", "fly or walk"},
    {"Left button", "use the tool"}, {"Right button", "its second use"}, {"R", "reload"},
    {"E", "doors, lamps, things, vehicles"}, {"F", "a lamp"},
    {"Tab", "wheel of tools"}, {"1 to 9, wheel", "change the tool"}, {"Ctrl+Z", "take back"},
    {"F5, F9", "save, load"}, {"H", "hide all this"}, {"Esc", "menu"}}

-- A line that is shown for some seconds.
function hud.say(text, seconds)
    message, messageTime = text, seconds or 2
end

function hud.tick(dt)
    messageTime = math.max(0, messageTime - dt)
    nameTime = math.max(0, nameTime - dt)
    sinceStart = sinceStart + dt
    if lastTool ~= belt.current then lastTool, nameTime = belt.current, 2.2 end
    if InputPressed("h") then hud.isHidden = not hud.isHidden end
    if InputPressed("f1") then hud.showsKeys = not hud.showsKeys end
end

local function drawCrosshair(tool)
    UiPush()
    UiTranslate(UiCenter(), UiMiddle())
    UiAlign("center middle")
    local isNear = belt.lastAim and belt.lastAim.hit and belt.lastAim.dist < (tool.reach or 120)
    UiColor(0, 0, 0, 0.4)
    UiCircle(6)
    UiColor(1, 1, 1, isNear and 0.95 or 0.55)
    UiCircle(3.8)
    if belt.cooldown > 0.2 then
        UiColor(1, 1, 1, 0.25)
        UiCircleOutline(13 + 20 * belt.cooldown, 1.5)
    end
    UiPop()
end

local function drawTool(tool)
    local fade = 0.55 + 0.45 * math.min(1, nameTime)
    UiPush()
    UiTranslate(UiWidth() - 48, UiHeight() - 44)
    draw.text(tool.name, 30, "right", draw.ink, fade, "bold.ttf")
    local left, all = belt.left(tool)
    if left then
        UiPush()
        UiTranslate(0, -40 * options.get("textsize"))
        draw.text(left .. " / " .. all, 26, "right", left == 0 and {1, 0.45, 0.35} or draw.ink, fade)
        UiPop()
    elseif tool.tip and nameTime > 0 then
        UiPush()
        UiTranslate(0, -40 * options.get("textsize"))
        draw.text(tool.tip, 22, "right", draw.ink, math.min(1, nameTime))
        UiPop()
    end
    UiPop()
end

local function drawHint()
    local text = belt.lastAim and interact.offer(belt.lastAim)
    if not text then return end
    UiPush()
    UiTranslate(UiCenter(), UiMiddle() + 70)
    local key = 34
    UiTranslate(-10, 0)
    UiPush()
    UiAlign("right middle")
    UiColor(0, 0, 0, 0.5)
    UiRoundedRect(key, key, 7)
    UiPop()
    UiPush()
    UiTranslate(-key / 2, 0)
    draw.text("E", 24, "center middle", draw.accent, 1, "bold.ttf")
    UiPop()
    UiTranslate(12, 0)
    draw.text(text, 24, "left middle", draw.ink, 0.95)
    UiPop()
end

local function drawKeys()
    UiPush()
    UiTranslate(48, 150)
    draw.panel(600, 44 * #kKeys + 40, 0.62)
    UiTranslate(30, 54)
    for _, row in ipairs(kKeys) do
        draw.text(row[1], 25, "left", draw.accent, 1, "bold.ttf")
        UiPush()
        UiTranslate(230, 0)
        draw.text(row[2], 25)
        UiPop()
        UiTranslate(0, 44)
    end
    UiPop()
end

-- One line after the other in the first half minute.
local function drawFirstSteps()
    local i = math.floor(sinceStart / 6) + 1
    if i > #kFirst or hud.showsKeys then return end
    local within = sinceStart - 6 * (i - 1)
    local fade = math.min(1, within / 0.6, (6 - within) / 0.6)
    UiPush()
    UiTranslate(UiCenter(), UiHeight() - 120)
    local text = i == #kFirst and not player.mayFly and kLastOfContract or kFirst[i]
    draw.text(text, 28, "center", draw.ink, fade)
    UiPop()
end

local function drawToolbelt(tool)
    drawCrosshair(tool)
    if tool.draw then
        UiPush()
        tool:draw()
        UiPop()
    end
    drawTool(tool)
    drawHint()
end

-- `isBehind`: a menu is before it.
function hud.draw(isBehind)
    if hud.isHidden or isBehind then return end
    if vehicles.driven() then
        vehicles.draw()
    else
        drawToolbelt(belt.tool())
        drawFirstSteps()
    end
    if hud.showsKeys then drawKeys() end
    if messageTime > 0 then
        UiPush()
        UiTranslate(UiCenter(), hud.messageAt)
        draw.text(message, 28, "center", draw.ink, math.min(1, messageTime / 0.4))
        UiPop()
    end
end

return hud
