-- Over the image while one plays: crosshair, tool, what E does. It stays out of the way.
local belt = require("toolbelt")
local draw = require("draw")
local interact = require("interact")
local keys = require("keys")
local options = require("options")
local place = require("place")
local player = require("player")
local vehicles = require("vehicles/vehicles")

local hud = {isHidden = false, showsKeys = false, messageAt = 110}
local message, messageTime = "", 0
local sinceStart, nameTime, lastTool = 0, 0, 0

local kMoves = "up left down right"
-- What a player needs to know first: pairs of actions and what they do.
local kFirst = {{{kMoves, "walk"}, {"look", "look"}}, {{"usetool", "use the tool"}},
    {{"wheel", "all tools"}, {"change", "change"}}, {{"spawn", "things to place"}, {"fly", "fly"}},
    {{"undo", "take back"}, {"help", "all keys"}}}
local kFirstOfContract = {kFirst[1], kFirst[2], kFirst[3], {{"interact", "take, open"}, {"help", "all keys"}}}
local kKeys = {{kMoves, "walk"}, {"sprint", "run"}, {"jump", "jump"}, {"crouch", "crouch"}, {"fly", "fly or walk"},
    {"usetool", "use the tool"}, {"grab", "its second use"}, {"reload", "reload"},
    {"interact", "doors, lamps, things, vehicles"}, {"flashlight", "a lamp"},
    {"wheel", "wheel of tools"}, {"change", "change the tool"}, {"spawn", "things to place"}, {"undo", "take back"},
    {"photo", "photo"}, {"replay", "replay"}, {"quicksave quickload", "save, load"}, {"hide", "hide all this"}, {"pause", "menu"}}

-- What to press for it.
local function labelOf(actions)
    if actions == "look" then return keys.usesPad and "Right stick" or "Mouse" end
    if actions == "change" then
        return keys.usesPad and keys.label("lasttool") .. "  " .. keys.label("nexttool") or "1 to 9, wheel"
    end
    return keys.labels(actions)
end

-- A line that is shown for some seconds.
function hud.say(text, seconds)
    message, messageTime = text, seconds or 2
end

-- The line that is shown, or "".
function hud.message()
    return messageTime > 0 and message or ""
end

function hud.tick(dt)
    messageTime = math.max(0, messageTime - dt)
    nameTime = math.max(0, nameTime - dt)
    sinceStart = sinceStart + dt
    if lastTool ~= belt.current then lastTool, nameTime = belt.current, 2.2 end
    if InputPressed("hide") then hud.isHidden = not hud.isHidden end
    if InputPressed("help") then hud.showsKeys = not hud.showsKeys end
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
    local label = keys.label("interact")
    local height = 34 * options.get("textsize")
    local width = math.max(height, draw.width(label, 24, "bold.ttf") + 18)
    UiTranslate(-10, 0)
    UiPush()
    UiAlign("right middle")
    UiColor(0, 0, 0, 0.5)
    UiRoundedRect(width, height, 7)
    UiPop()
    UiPush()
    UiTranslate(-width / 2, 0)
    draw.text(label, 24, "center middle", draw.accent, 1, "bold.ttf")
    UiPop()
    UiTranslate(12, 0)
    draw.text(text, 24, "left middle", draw.ink, 0.95)
    UiPop()
end

local function drawKeys()
    UiPush()
    local first, second, line = 0, 0, 41 * options.get("textsize")
    for _, row in ipairs(kKeys) do
        first = math.max(first, draw.width(labelOf(row[1]), 24, "bold.ttf"))
        second = math.max(second, draw.width(row[2], 24))
    end
    local columns = line * #kKeys + 110 > UiHeight() and 2 or 1  -- large texts need two
    local each, wide = -(-#kKeys // columns), first + second + 62
    UiTranslate(48, math.max(20, math.min(150, UiHeight() - line * each - 90)))
    draw.panel(columns * wide + 20, line * each + 36, 0.62)
    UiTranslate(30, 18 + 0.75 * line)
    for i, row in ipairs(kKeys) do
        if i > 1 and i % each == 1 then UiTranslate(wide, -line * each) end
        draw.text(labelOf(row[1]), 24, "left", draw.accent, 1, "bold.ttf")
        UiPush()
        UiTranslate(first + 36, 0)
        draw.text(row[2], 24)
        UiPop()
        UiTranslate(0, line)
    end
    UiPop()
end

-- One line after the other in the first half minute.
local function drawFirstSteps()
    local i, steps = math.floor(sinceStart / 6) + 1, player.mayFly and kFirst or kFirstOfContract
    if i > #steps or hud.showsKeys then return end
    local within = sinceStart - 6 * (i - 1)
    local fade = math.min(1, within / 0.6, (6 - within) / 0.6)
    UiPush()
    local width, gap = -70, 14
    for _, pair in ipairs(steps[i]) do
        width = width + draw.width(labelOf(pair[1]), 28, "bold.ttf") + gap + draw.width(pair[2], 28) + 70
    end
    UiTranslate(UiCenter() - width / 2, UiHeight() - 120)
    for _, pair in ipairs(steps[i]) do
        UiTranslate(draw.text(labelOf(pair[1]), 28, "left", draw.accent, fade, "bold.ttf") + gap, 0)
        UiTranslate(draw.text(pair[2], 28, "left", draw.ink, fade) + 70, 0)
    end
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

-- The line of hud.say().
function hud.drawMessage()
    if messageTime <= 0 then return end
    UiPush()
    UiTranslate(UiCenter(), hud.messageAt)
    local size = 28 * math.min(1, (UiWidth() - 120) / draw.width(message, 28))  -- errors of files are long
    draw.text(message, size, "center", draw.ink, math.min(1, messageTime / 0.4))
    UiPop()
end

-- `isBehind`: a menu is before it.
function hud.draw(isBehind)
    if hud.isHidden or isBehind then return end
    if vehicles.driven() then
        vehicles.draw()
    elseif place.isActive() then
        drawCrosshair(belt.tool())
        place.draw()
    else
        drawToolbelt(belt.tool())
        drawFirstSteps()
    end
    if hud.showsKeys then drawKeys() end
    hud.drawMessage()
end

return hud
