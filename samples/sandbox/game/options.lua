-- What the player has chosen. Options outlive the game: the shell keeps the keys "options.*" in a file.
local options = {}
local kReplay = 30  -- seconds that are kept

-- Each option: its name in menus, what it is at first, and its range and step, or its choices.
options.rows = {
    {id = "sensitivity", name = "Mouse sensitivity", default = 1.0, low = 0.2, high = 3.0, step = 0.1, format = "%.1f"},
    {id = "fov", name = "Field of view", default = 68, low = 45, high = 100, step = 1, format = "%d°"},
    {id = "textsize", name = "Text size", default = 1.0, low = 0.8, high = 1.8, step = 0.1, format = "%.1fx"},
    {id = "motion", name = "Camera motion", default = 1.0, low = 0.0, high = 1.0, step = 0.1, format = "%.1f"},
    {id = "flashes", name = "Flashes of light", default = 1.0, low = 0.0, high = 1.0, step = 0.1, format = "%.1f"},
    {id = "volume", name = "Sound", default = 0.8, low = 0.0, high = 1.0, step = 0.1, format = "%.1f", zero = "off"},
    {id = "preset", name = "Picture", default = "balanced", choices = {"draft", "fast", "balanced", "accurate"}},
    {id = "replay", name = "Replay", default = "on", choices = {"off", "on"}},
}
-- Rules of this world, which are saved with the game and not with the options.
options.world = {
    {id = "gravity", name = "Gravity", default = 10, low = 0, high = 20, step = 1, format = "%d m/s²"},
    {id = "timescale", name = "Time", default = 1.0, low = 0.1, high = 2.0, step = 0.1, format = "%.1fx"},
}

local rowOf = {}
for _, row in ipairs(options.rows) do rowOf[row.id], row.key = row, "options." .. row.id end
for _, row in ipairs(options.world) do rowOf[row.id], row.key = row, "world." .. row.id end

local function isChoice(row, value)
    for _, choice in ipairs(row.choices) do
        if choice == value then return true end
    end
end

-- What a file or a script has made of an option may be anything: what it cannot be counts as not chosen.
function options.get(id)
    local row = rowOf[id]
    local default = id == "preset" and GetPreset() or row.default
    if not HasKey(row.key) then return default end
    local text = GetString(row.key)
    if row.choices then return isChoice(row, text) and text or default end
    local value = tonumber(text)
    return value and value == value and math.max(row.low, math.min(row.high, value)) or default
end

function options.set(id, value)
    local row = rowOf[id]
    if row.choices then
        SetString(row.key, value)
    else
        SetFloat(row.key, math.max(row.low, math.min(row.high, value)))
    end
    options.apply(id)
end

-- One step up or down, or to the next choice.
function options.change(id, direction)
    local row, value = rowOf[id], options.get(id)
    if not row.choices then
        local steps = math.floor(value / row.step + 0.5) + direction
        return options.set(id, steps * row.step)
    end
    local place = 1
    for i, choice in ipairs(row.choices) do
        if choice == value then place = i end
    end
    options.set(id, row.choices[math.max(1, math.min(#row.choices, place + direction))])
end

function options.text(id)
    local row, value = rowOf[id], options.get(id)
    if row.choices then return value end
    if row.zero and value < row.step / 2 then return row.zero end
    if row.format:find("%%d") then value = math.floor(value + 0.5) end
    return string.format(row.format, value)
end

-- Where a value lies in its range, 0 to 1.
function options.share(id)
    local row, value = rowOf[id], options.get(id)
    if not row.choices then return (value - row.low) / (row.high - row.low) end
    for i, choice in ipairs(row.choices) do
        if choice == value then return (i - 1) / (#row.choices - 1) end
    end
    return 0
end

-- Makes one take effect, or all.
function options.apply(id)
    if not id or id == "fov" then SetCameraFov(options.get("fov")) end
    if id == "gravity" or not id and HasKey("world.gravity") then SetGravity({0, -options.get("gravity"), 0}) end
    if not id or id == "timescale" then SetTimeScale(options.get("timescale")) end
    if not id or id == "volume" then SetSoundVolume(options.get("volume")) end
    if not id or id == "replay" then KeepReplay(options.get("replay") == "on" and kReplay or 0) end
    if id == "preset" or not id and HasKey("options.preset") then SetPreset(options.get("preset")) end
end

return options
