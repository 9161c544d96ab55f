-- What can be placed, in folders, each with its picture.
local draw = require("draw")
local keys = require("keys")
local place = require("place")
local sounds = require("sounds")
local things = require("things")
local thumb = require("thumb")

local spawn = {isOpen = false}
local kTile, kLabel, kGap, kTabs = 200, 44, 16, 300
local folder, chosen, isInTabs = 1, 1, false
local mouseX, mouseY
local left, top, columns = 0, 0, 5

local function list()
    return things.folders[folder].things
end

function spawn.open()
    spawn.isOpen, isInTabs = true, false
end

-- For other scripts: which folder is open.
function spawn.publish()
    SetInt("game.folder", folder)
end

local function pick(thing)
    spawn.isOpen = false
    sounds.play("click")
    place.begin(thing)
end

local function change(number)
    folder, chosen = (number - 1) % #things.folders + 1, 1
end

-- By keys: up and down at the left choose a folder, right goes into it.
local function move()
    local dx = (InputPressed("menuright") and 1 or 0) - (InputPressed("menuleft") and 1 or 0)
    local dy = (InputPressed("menudown") and 1 or 0) - (InputPressed("menuup") and 1 or 0)
    if isInTabs then
        if dy ~= 0 then change(folder + dy) end
        if dx > 0 then isInTabs = false end
    else
        if dx < 0 and (chosen - 1) % columns == 0 then
            isInTabs = true
        else
            chosen = math.max(1, math.min(#list(), chosen + dx + columns * dy))
        end
    end
    local wheel = InputValue("mousewheel")
    if wheel ~= 0 then change(folder + (wheel < 0 and 1 or -1)) end
end

local function tileAt(i)
    local column, row = (i - 1) % columns, (i - 1) // columns
    return left + kTabs + column * (kTile + kGap), top + row * (kTile + kLabel + kGap)
end

-- What the mouse is over: "folder" or "thing".
local function point()
    local x, y = InputValue("mousex"), InputValue("mousey")
    local isNew = x ~= mouseX or y ~= mouseY
    mouseX, mouseY = x, y
    for i in ipairs(things.folders) do
        if draw.isOver(left, top + 64 * (i - 1), kTabs - 30, 60) then
            if InputPressed("lmb") then change(i) end
            return nil
        end
    end
    for i in ipairs(list()) do
        local tx, ty = tileAt(i)
        if draw.isOver(tx, ty, kTile, kTile + kLabel) then
            if isNew then chosen, isInTabs = i, false end
            return i == chosen
        end
    end
end

function spawn.tick()
    UiMakeInteractive()
    if InputPressed("menuback") or InputPressed("spawn") and not InputPressed("menuleft") then
        spawn.isOpen = false
        return
    end
    move()
    local isOver = point()
    if not isInTabs and InputPressed("menuok") or isOver and InputPressed("lmb") then pick(list()[chosen]) end
    if isInTabs and InputPressed("menuok") then isInTabs = false end
end

local function drawTabs()
    for i, entry in ipairs(things.folders) do
        UiPush()
        UiTranslate(left, top + 64 * (i - 1) + 30)
        if i == folder then
            UiAlign("left middle")
            UiColor(1.0, 0.72, 0.30, isInTabs and 0.3 or 0.16)
            UiRoundedRect(kTabs - 30, 56, 10)
            UiColor(1.0, 0.72, 0.30, 0.95)
            UiRoundedRect(5, 56, 2)
        end
        UiTranslate(24, 0)
        draw.text(entry.name, 30, "left middle", draw.ink, i == folder and 1 or 0.75)
        UiPop()
    end
end

local function drawTile(i, thing)
    local x, y = tileAt(i)
    local isChosen = i == chosen and not isInTabs
    UiPush()
    UiTranslate(x, y)
    UiAlign("left top")
    UiColor(1, 1, 1, isChosen and 0.14 or 0.07)
    UiRoundedRect(kTile, kTile + kLabel, 12)
    if isChosen then
        UiColor(1.0, 0.72, 0.30, 0.9)
        UiRect(kTile, 3)
    end
    UiTranslate(kTile / 2, kTile / 2 + 4)
    if thing.picture then thumb.draw(thing.picture, kTile - 30) end
    UiTranslate(0, kTile / 2 + kLabel / 2 - 8)
    local size = 22 * math.min(1, (kTile - 16) / draw.width(thing.name, 22))
    draw.text(thing.name, size, "center middle", draw.ink, isChosen and 1 or 0.85)
    UiPop()
end

-- A part of a picture a frame, so that the menu opens at once.
local function prepare()
    for _, thing in ipairs(list()) do
        if not thing.picture then
            local low, high = things.box(thing)
            local pieces = thing.drop and GetDropImage(thing.drop) or things.pieces(thing)
            thing.painter = thing.painter or coroutine.create(thumb.make)
            local isGood, picture = coroutine.resume(thing.painter, pieces, low, high)
            if not isGood and not thing.path then error(picture, 0) end
            if isGood then thing.picture = picture else thing.picture = {} end  -- of what was dropped there may be none
            return
        end
    end
end

function spawn.draw()
    prepare()
    columns = math.max(2, math.min(6, (UiWidth() - kTabs - 200) // (kTile + kGap)))
    local wide = kTabs + columns * (kTile + kGap) - kGap
    local lines = 0
    for _, entry in ipairs(things.folders) do lines = math.max(lines, -(-#entry.things // columns)) end
    local tall = math.max(lines * (kTile + kLabel + kGap) - kGap, 64 * #things.folders)
    left, top = UiCenter() - wide / 2, UiMiddle() - tall / 2 + 30
    UiPush()
    UiAlign("left top")
    UiColor(0.02, 0.025, 0.03, 0.45)
    UiRect(UiWidth(), UiHeight())
    UiTranslate(left - 40, top - 120)
    draw.panel(wide + 80, tall + 210, 0.78)
    UiTranslate(40, 72)
    draw.text("Things to place", 44, "left", draw.ink, 1, "bold.ttf")
    UiPop()
    drawTabs()
    for i, thing in ipairs(list()) do drawTile(i, thing) end
    UiPush()
    UiTranslate(left, top + tall + 58)
    draw.text(keys.labels("menuok") .. ": take    " .. keys.labels("menuback") .. ": back", 22, "left", draw.ink, 0.8)
    UiPop()
end

return spawn
