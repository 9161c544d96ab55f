-- Title screen, pause, settings, and the screens of contracts.
local bindings = require("menus/bindings")
local contract = require("contracts/contract")
local contracts = require("menus/contracts")
local draw = require("draw")
local hud = require("hud")
local list = require("menus/list")
local options = require("options")

local menus = {open = nil}  -- "title", "pause", "settings", "keys", "brief" or "result"
local before = nil          -- what settings return to
local lists
menus.photo = nil           -- what the photo of the menu does
menus.replay = nil          -- what its replay does
local isFirst = true

local function close()
    menus.open = nil
    isFirst = false
end

-- Opens one, at its first row.
function menus.show(name)
    menus.open = name
    lists[name].chosen = 1
end

local function settings()
    before = menus.open
    menus.show("settings")
end

function menus.save()
    SaveGame("quick")
    hud.say("Saved")
end

function menus.load()
    if LoadGame("quick") then return close() end
    hud.say(HasSave("quick") and "The saved game is damaged" or "There is no saved game yet")
end

local more = contracts.lists(menus.show, close, function() menus.open = "title" end)
local function hasNoSave() return not HasSave("quick") end

lists = {
    title = list("Rubble", {{name = "Play freely", run = close},
        contracts.rows[1], contracts.rows[2],
        {name = "Continue the saved game", run = menus.load, isOff = hasNoSave},
        {name = "Settings", run = settings}, {name = "Leave", run = QuitGame}}),
    pause = list("Paused", {{name = "Go on", run = close}, {name = "Save", run = menus.save},
        {name = "Load", run = menus.load, isOff = hasNoSave}, {name = "Settings", run = settings},
        {name = function() return contract.current() and "Try again" or "Build the town again" end, run = RestartLevel},
        {name = "Photo", run = function() menus.photo() end}, {name = "Replay", run = function() menus.replay() end},
        {name = "Back to the title", run = contracts.toTitle}, {name = "Leave", run = QuitGame}}),
    settings = list("Settings", {}), keys = bindings, brief = more.brief, result = more.result,
}
do
    local rows = lists.settings.rows
    for _, row in ipairs(options.rows) do table.insert(rows, {name = row.name, option = row.id}) end
    for _, row in ipairs(options.world) do table.insert(rows, {name = row.name, option = row.id}) end
    table.insert(rows, {name = "Keys and gamepad", run = function() menus.show("keys") end})
    table.insert(rows, {name = "Back", run = function() menus.open = before or "pause" end})
    lists.settings.width = 760
end

bindings.back = function() menus.open = "settings" end

function menus.tick()
    UiMakeInteractive()
    if menus.open == "keys" then return bindings:tick() end
    if InputPressed("menuback") then
        if menus.open == "settings" then
            menus.open = before or "pause"
        elseif menus.open == "brief" then
            menus.open = "title"
        elseif menus.open ~= "title" then
            close()
        end
        return
    end
    lists[menus.open]:tick()
end

-- The camera of the title: slowly around the corner, while the town lives.
function menus.camera(time)
    local angle = 0.35 * math.sin(0.05 * time) + 0.62
    local target = Vec(31, 3.2, 40)
    local eye = target + Vec(21 * math.sin(angle), 4.6 + 0.8 * math.sin(0.07 * time), 21 * math.cos(angle))
    SetCameraTransform(Transform(eye, QuatLookAt(eye, target)))
end

local function drawTitle()
    UiPush()
    UiTranslate(120, 250)
    draw.text("Rubble", 150, "left", draw.ink, 1, "bold.ttf")
    UiTranslate(6, 56)
    draw.text("A town to take apart", 34, "left", draw.accent)
    UiPop()
    lists.title:draw(110, 390)
end

local function drawPanel(menu)
    local height = menu:height()
    local x, y = UiCenter() - menu.width / 2, UiMiddle() - height / 2
    UiPush()
    UiColor(0.02, 0.025, 0.03, 0.45)
    UiAlign("left top")
    UiRect(UiWidth(), UiHeight())
    UiTranslate(x - 40, y - 110)
    draw.panel(menu.width + 80, height + 150, 0.78)
    UiTranslate(40, 72)
    draw.text(menu.title, 48, "left", draw.ink, 1, "bold.ttf")
    UiPop()
    menu:draw(x, y)
end

function menus.draw()
    if menus.open == "title" then
        UiPush()
        UiAlign("left top")
        for i = 0, 47 do  -- darker to the left, so that letters are read on any sky
            UiColor(0.02, 0.025, 0.03, 0.019)
            UiRect(980 - 20 * i, UiHeight())
        end
        UiPop()
        drawTitle()
    elseif menus.open == "brief" then
        contracts.drawBrief(lists.brief)
    elseif menus.open == "result" then
        contracts.drawResult(lists.result)
    else
        drawPanel(lists[menus.open])
    end
end

function menus.isTitle()
    return menus.open == "title" or menus.open == "brief"
        or (menus.open == "settings" or menus.open == "keys") and before == "title"
end

-- Whether the world stands still behind it.
function menus.stopsTime()
    return menus.open ~= nil and not menus.isTitle() and menus.open ~= "result"
end

return menus
