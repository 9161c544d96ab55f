-- Photo: the world stands still, the camera flies, light and air can be changed, and what is seen becomes a PNG. What was
-- changed ends with it.
local camera = require("freecamera")
local draw = require("draw")
local keys = require("keys")
local options = require("options")
local stills = require("menus/stills")

local photo = {isOpen = false, isStill = false}
local kRow, kWidth, kRepeat = 50, 470, 1 / 14
local kFrames = 6  -- for which the panel stays away around an image
local air          -- as it was
local chosen, sinceStep, hidden, isBare = 1, 0, 0, false
local value, changed

local function sunAngles(dir)
    return math.deg(math.asin(math.max(-1, math.min(1, dir.y)))), math.deg(math.atan(dir.x, -dir.z)) % 360
end

-- Each row: what it is, its range and step, how it is written. What `apply` gives goes to SetEnvironment().
local rows = {
    {id = "fov", name = "Field of view", low = 12, high = 110, step = 2, format = "%d°"},
    {id = "roll", name = "Tilt", low = -45, high = 45, step = 1, format = "%d°"},
    {id = "exposure", name = "Exposure", low = -3, high = 3, step = 0.25, format = "%+.2f EV",
        apply = function(v) return {exposure = air.exposure * 2 ^ v} end},
    {id = "sunHeight", name = "Height of the sun", low = -8, high = 80, step = 2, format = "%d°"},
    {id = "sunTurn", name = "Direction of the sun", low = 0, high = 360, step = 5, format = "%d°", wraps = true},
    {id = "haze", name = "Shafts of light", low = 0, high = 0.03, step = 0.002, format = "%.3f / m",
        apply = function(v) return {fogDensity = v} end},
    {id = "clouds", name = "Clouds", low = 0, high = 1, step = 0.1, format = "%.1f",
        apply = function(v) return {clouds = v} end},
    {id = "wetness", name = "Wetness", low = 0, high = 1, step = 0.1, format = "%.1f",
        apply = function(v) return {wetness = v} end},
    {id = "grid", name = "Lines of thirds", low = 0, high = 1, step = 1, format = "%d"},
    {id = "size", name = "Size of stills", low = 1, high = #stills.sizes, step = 1, format = "%d"},
}

-- Light and air as the rows say; those that nobody has changed as they were.
local function light()
    SetEnvironment(air)
    if changed.sunHeight or changed.sunTurn then
        local up, turn = math.rad(value.sunHeight), math.rad(value.sunTurn)
        SetEnvironment({sun = Vec(math.cos(up) * math.sin(turn), math.sin(up), -math.cos(up) * math.cos(turn))})
    end
    for _, row in ipairs(rows) do
        if row.apply and changed[row.id] then SetEnvironment(row.apply(value[row.id])) end
    end
    ApplyEdits()
end

local function reset()
    local up, turn = sunAngles(VecNormalize(air.sunDirection))
    value = {fov = options.get("fov"), roll = 0, exposure = 0, sunHeight = up, sunTurn = turn, haze = air.fogDensity,
        clouds = air.clouds, wetness = air.wetness, grid = 0, size = stills.chosen()}
    changed = {}
end

function photo.open()
    photo.isOpen, photo.isStill, isBare, hidden, chosen = true, false, false, 0, 1
    air = GetEnvironment()
    reset()
    camera.begin()
end

function photo.close()
    if next(changed) then
        changed = {}
        light()
    end
    photo.isOpen = false
    options.apply("fov")
end

-- Each step while it is open: after the first one the world stands still, without a tool before the eyes.
function photo.update()
    photo.isStill = photo.isOpen
end

local function change(direction)
    local row = rows[chosen]
    local now = math.floor(value[row.id] / row.step + 0.5) * row.step + direction * row.step
    if row.wraps then now = now % row.high else now = math.max(row.low, math.min(row.high, now)) end
    value[row.id], changed[row.id] = now, row.apply or row.id:find("^sun") and true or nil
    if row.id == "size" then stills.choose(now) end
    if changed[row.id] then light() end
end

-- Left and right change what is chosen, and go on while they are held.
local function adjust(dt)
    if InputPressed("listdown") then chosen = chosen % #rows + 1 end
    if InputPressed("listup") then chosen = (chosen - 2) % #rows + 1 end
    local wheel = InputValue("mousewheel")
    if wheel ~= 0 then change(wheel > 0 and 1 or -1) end
    local direction = (InputDown("listright") and 1 or 0) - (InputDown("listleft") and 1 or 0)
    local isNew = InputPressed("listright") or InputPressed("listleft")
    sinceStep = isNew and -0.3 or sinceStep + dt
    if direction ~= 0 and (isNew or sinceStep > kRepeat) then
        if not isNew then sinceStep = 0 end
        change(direction)
    end
    if InputPressed("menuclear") then
        local wasLit = next(changed)
        reset()
        if wasLit then light() end
    end
end

-- Each frame while it is open.
function photo.tick(dt)
    hidden = math.max(0, hidden - 1)
    if stills.isBusy() then return camera.stay(value.fov, value.roll) end
    camera.fly(dt, value.fov, value.roll)
    if InputPressed("menuback") or InputPressed("photo") then return photo.close() end
    if InputPressed("hide") then isBare = not isBare end
    adjust(dt)
    if InputPressed("usetool") or InputPressed("menuok") then
        stills.take()
        hidden = kFrames
    end
end

local function drawRow(row, isChosen)
    UiPush()
    if isChosen then
        UiAlign("left middle")
        UiColor(1.0, 0.72, 0.30, 0.16)
        UiRoundedRect(kWidth * options.get("textsize") - 40, kRow * options.get("textsize") - 8, 8)
    end
    UiTranslate(16, 0)
    draw.text(row.name, 24, "left middle", draw.ink, isChosen and 1 or 0.82)
    UiTranslate(kWidth * options.get("textsize") - 72, 0)
    local now = value[row.id]
    if row.format:find("%%d") then now = math.floor(now + 0.5) end
    local text = row.id == "grid" and (now == 1 and "on" or "off") or row.id == "size" and stills.sizes[now][1]
        or string.format(row.format, now)
    draw.text(text, 24, "right middle", changed[row.id] and draw.accent or draw.ink, isChosen and 1 or 0.82)
    UiPop()
end

local function drawThirds()
    UiPush()
    UiAlign("left top")
    UiColor(1, 1, 1, 0.35)
    for i = 1, 2 do
        UiPush()
        UiTranslate(UiWidth() * i / 3, 0)
        UiRect(1.5, UiHeight())
        UiPop()
        UiPush()
        UiTranslate(0, UiHeight() * i / 3)
        UiRect(UiWidth(), 1.5)
        UiPop()
    end
    UiPop()
end

function photo.draw()
    if stills.isBusy() and stills.sizes[value.size][2] then return stills.draw() end
    if hidden > 0 then return end
    if value.grid == 1 then drawThirds() end
    if isBare then return end
    local scale = options.get("textsize")
    UiPush()
    UiTranslate(40, 40)
    draw.panel(kWidth * scale, (#rows * kRow + 100) * scale, 0.62)
    UiTranslate(20, 56 * scale)
    draw.text("Photo", 36, "left", draw.ink, 1, "bold.ttf")
    UiTranslate(0, 44 * scale)
    for i, row in ipairs(rows) do
        drawRow(row, i == chosen)
        UiTranslate(0, kRow * scale)
    end
    UiPop()
    UiPush()
    UiTranslate(UiCenter(), UiHeight() - 44)
    draw.text(string.format("%s: take it    %s: as it was    %s: hide this    %s: back", keys.labels("menuok"),
        keys.labels("menuclear"), keys.labels("hide"), keys.labels("menuback")), 24, "center")
    if stills.last ~= "" then
        UiTranslate(0, -40 * scale)
        draw.text("Saved as " .. stills.last, 24, "center", draw.accent)
    end
    UiPop()
end

return photo
