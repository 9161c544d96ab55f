-- The page of keys: each action with its key and its button of a gamepad. One is chosen, then the next input is its own.
local draw = require("draw")
local keys = require("keys")
local options = require("options")
local sounds = require("sounds")

local kRow, kWidth, kKeyColumn, kPadColumn, kCell = 46, 990, 520, 760, 210  -- at the usual size of texts
local kDevices = {"key", "pad"}
local kHeld = {ctrl = true, alt = true, shift = true}
local kBad = {1.0, 0.42, 0.33}

local page = {title = "Keys and gamepad", width = kWidth, chosen = 1, x = 0, y = 0}
local rows, column, first = {}, 1, 1
local capture, held, mouseX, mouseY  -- what waits for an input; a key that may become "ctrl+z"

for _, group in ipairs(keys.groups) do
    rows[#rows + 1] = {header = group.name}
    for _, row in ipairs(group.rows) do rows[#rows + 1] = {action = row[1], name = row[2]} end
end
rows[#rows + 1] = {name = "All as at first", run = keys.resetAll}
rows[#rows + 1] = {name = "Back", run = function() page.back() end}

local function rowHeight()
    return kRow * options.get("textsize")
end

-- How much wider all is with larger texts.
local function stretch()
    return math.min(options.get("textsize"), (UiWidth() - 120) / kWidth)
end

local function columnAt(i)
    return stretch() * (i == 1 and kKeyColumn or kPadColumn)
end

local function visible()
    return math.max(3, math.min(#rows, math.floor((UiHeight() - 300) / rowHeight())))
end

local function choose(step)
    repeat
        page.chosen = (page.chosen - 1 + step) % #rows + 1
    until not rows[page.chosen].header
end

-- Keeps what is chosen in sight.
local function scroll()
    local count = visible()
    local low = page.chosen == 2 and 1 or page.chosen
    first = math.max(1, math.min(first, low, #rows - count + 1))
    if page.chosen >= first + count then first = page.chosen - count + 1 end
end

local function finish(input)
    keys.bind(capture.action, capture.device, input)
    sounds.play("click")
    capture, held = nil, nil
end

local function tickCapture()
    local last = InputLastPressed()
    local isPad = last:sub(1, 3) == "pad"
    if last == "esc" then
        capture, held = nil, nil
    elseif last ~= "" and isPad == (capture.device == "pad") then
        if kHeld[last] then
            held = last
        else
            finish(held and InputDown(held) and held .. "+" .. last or last)
        end
    elseif held and not InputDown(held) then
        finish(held)
    end
end

-- The mouse chooses a row and a column; whether it is over a row.
local function point()
    local x, y = InputValue("mousex"), InputValue("mousey")
    local isNew = x ~= mouseX or y ~= mouseY
    mouseX, mouseY = x, y
    local i = first + math.floor((y - page.y) / rowHeight())
    local isOver = x >= page.x and x < page.x + page.width and i >= first and i < first + visible() and rows[i]
        and not rows[i].header
    if isOver and isNew then
        page.chosen = i
        if rows[i].action then column = x > page.x + (columnAt(1) + columnAt(2)) / 2 and 2 or 1 end
    end
    return isOver
end

function page:tick()
    if rows[self.chosen].header then choose(1) end
    if capture then return tickCapture() end
    if InputPressed("menuback") then return self.back() end
    if InputPressed("menudown") then choose(1) end
    if InputPressed("menuup") then choose(-1) end
    local wheel = InputValue("mousewheel")
    if wheel ~= 0 then choose(wheel < 0 and 1 or -1) end
    if InputPressed("menuright") then column = 2 end
    if InputPressed("menuleft") then column = 1 end
    local isOver = point()
    scroll()
    local row = rows[self.chosen]
    if row.action and InputPressed("menuclear") then keys.bind(row.action, kDevices[column]) end
    if not InputPressed("menuok") and not (isOver and InputPressed("lmb")) then return end
    sounds.play("click")
    if row.run then return row.run() end
    capture = {action = row.action, device = kDevices[column]}
end

-- For other scripts: whether the page waits for an input.
function page:waits()
    return capture ~= nil
end

local function drawCell(row, i, isChosen)
    local device = kDevices[i]
    local waits = capture and isChosen and column == i
    local other = keys.conflict(row.action, device)
    UiPush()
    UiTranslate(columnAt(i), 0)
    UiAlign("center middle")
    if isChosen and column == i then
        UiColor(1.0, 0.72, 0.30, waits and 0.5 or 0.25)
        UiRoundedRect(kCell * stretch(), rowHeight() - 8, 8)
    else
        UiColor(1, 1, 1, 0.06)
        UiRoundedRect(kCell * stretch(), rowHeight() - 8, 8)
    end
    local text = waits and "..." or keys.name(keys.of(row.action, device))
    local color = other and kBad or keys.isChanged(row.action, device) and draw.accent or draw.ink
    draw.text(text == "" and "–" or text, 23, "center middle", color, text == "" and 0.35 or 0.95, "bold.ttf")
    UiPop()
end

local function drawRow(row, isChosen)
    UiPush()
    UiTranslate(28, 0)
    if row.header then
        draw.text(row.header, 23, "left middle", draw.accent, 0.9, "bold.ttf")
    else
        draw.text(row.name, 26, "left middle", draw.ink, isChosen and 1 or 0.82)
    end
    UiPop()
    if row.action then
        drawCell(row, 1, isChosen)
        drawCell(row, 2, isChosen)
    elseif row.header then
        for i, name in ipairs({"Key, mouse", "Gamepad"}) do
            UiPush()
            UiTranslate(columnAt(i), 0)
            draw.text(name, 20, "center middle", draw.ink, 0.5)
            UiPop()
        end
    end
end

-- What can be done, or what is wrong, with the one that is chosen.
local function note(row)
    if capture then
        return capture.device == "pad" and "Press a button of the gamepad. Esc: leave it" or
            "Press a key or a button of the mouse. Esc: leave it", draw.accent
    end
    if not row.action then return "", draw.ink end
    local device = kDevices[column]
    local other = keys.conflict(row.action, device)
    if other then return keys.name(keys.of(row.action, device)) .. " is also: " .. other, kBad end
    return keys.labels("menuok") .. ": bind anew    " .. keys.labels("menuclear") .. ": as at first", draw.ink
end

local function drawBar(count)
    if count >= #rows then return end
    local height = rowHeight() * count
    UiPush()
    UiTranslate(page.width + 6, 0)
    UiAlign("left top")
    UiColor(1, 1, 1, 0.12)
    UiRoundedRect(6, height, 3)
    UiTranslate(0, height * (first - 1) / #rows)
    draw.color(draw.accent, 0.8)
    UiRoundedRect(6, height * count / #rows, 3)
    UiPop()
end

function page:draw(x, y)
    self.x, self.y = x, y
    local count = visible()
    UiPush()
    UiTranslate(x, y)
    drawBar(count)
    for i = first, first + count - 1 do
        local row = rows[i]
        UiPush()
        UiTranslate(0, rowHeight() * (i - first + 0.5))
        if i == self.chosen and not row.header then
            UiPush()
            UiAlign("left middle")
            UiColor(1.0, 0.72, 0.30, 0.10)
            UiRoundedRect(self.width - 20, rowHeight() - 4, 10)
            UiPop()
        end
        drawRow(row, i == self.chosen)
        UiPop()
    end
    UiTranslate(28, rowHeight() * count + 30)
    local text, color = note(rows[self.chosen])
    draw.text(text, 22, "left middle", color, 0.85)
    UiPop()
end

function page:height()
    self.width = kWidth * stretch()
    return rowHeight() * visible() + 40
end

return page
