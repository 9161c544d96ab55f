-- Actions and what they are bound to: keys and buttons of the mouse, and buttons of a gamepad. What a player has chosen
-- are options: "options.key.jump" = "space", "options.pad.jump" = "pada"; "-": nothing.
local keys = {usesPad = false}
local kTurn = 3.2  -- radians a second of a stick that is all the way out

-- Each action: its name as scripts ask for it, in menus, its key, its button. `on`: where it is used: "foot", "drive",
-- or without it everywhere; two that meet at one key are in conflict.
keys.groups = {
    {name = "Moving", rows = {
        {"up", "Forward", "w", "padlup", on = "foot"}, {"down", "Back", "s", "padldown", on = "foot"},
        {"left", "Left", "a", "padlleft"}, {"right", "Right", "d", "padlright"},
        {"jump", "Jump, fly up", "space", "pada", on = "foot"},
        {"crouch", "Crouch, fly down", "ctrl", "padrs", on = "foot"}, {"sprint", "Run", "shift", "padls", on = "foot"},
        {"fly", "Fly or walk", "v", "paddown", on = "foot"},
    }},
    {name = "Tools", rows = {
        {"usetool", "Use the tool", "lmb", "padrt", on = "foot"}, {"grab", "Its second use", "rmb", "padlt", on = "foot"},
        {"reload", "Reload, turn a thing", "r", "padx", on = "foot"},
        {"interact", "Doors, lamps, vehicles", "e", "pady"},
        {"nexttool", "Next tool", "-", "padrb", on = "foot"}, {"lasttool", "Tool before", "-", "padlb", on = "foot"},
        {"wheel", "Wheel of tools", "tab", "padright", on = "foot"}, {"spawn", "Things to place", "q", "padleft", on = "foot"},
        {"flashlight", "A lamp in the hand", "f", "padup", on = "foot"}, {"undo", "Take back", "ctrl+z", "padb", on = "foot"},
    }},
    {name = "Driving", rows = {
        {"gas", "Ahead", "w", "padrt", on = "drive"}, {"reverse", "Back", "s", "padlt", on = "drive"},
        {"handbrake", "Brake", "space", "pada", on = "drive"},
        {"headlights", "Headlights", "l", "padls", on = "drive"},
        {"liftup", "Lift", "r", "padup", on = "drive"}, {"liftdown", "Lower", "f", "paddown", on = "drive"},
        {"tiltup", "Bucket in", "t", "padrb", on = "drive"}, {"tiltdown", "Bucket out", "g", "padlb", on = "drive"},
        {"turnleft", "Turn left", "leftarrow", "padleft", on = "drive"},
        {"turnright", "Turn right", "rightarrow", "padright", on = "drive"},
        {"boomup", "Boom up", "uparrow", "padb", on = "drive"},
        {"boomdown", "Boom down", "downarrow", "padx", on = "drive"},
    }},
    {name = "Game", rows = {
        {"pause", "Menu", "esc", "padstart"}, {"photo", "Photo", "p", "padback"}, {"replay", "Replay", "b", "-"},
        {"quicksave", "Save", "f5", "-"},
        {"quickload", "Load", "f9", "-"}, {"hide", "Hide what is drawn over", "h", "-"}, {"help", "All keys", "f1", "-"},
    }},
}

-- What menus listen to. Nobody can lose these.
local fixed = {menuup = {"uparrow", "padup", "padlup"}, menudown = {"downarrow", "paddown", "padldown"},
    menuleft = {"leftarrow", "padleft", "padlleft"}, menuright = {"rightarrow", "padright", "padlright"},
    menuok = {"return", "pada"}, menuback = {"esc", "padb", "padstart"},
    listup = {"uparrow", "padup"}, listdown = {"downarrow", "paddown"}, listleft = {"leftarrow", "padleft"},
    listright = {"rightarrow", "padright"}, menuclear = {"backspace", "delete", "padx"}}

local kLabels = {lmb = "Left button", rmb = "Right button", mmb = "Wheel button", esc = "Esc", tab = "Tab",
    shift = "Shift", ctrl = "Ctrl", alt = "Alt", space = "Space", backspace = "Backspace", uparrow = "Up",
    downarrow = "Down", leftarrow = "Left", rightarrow = "Right", rshift = "Right Shift", rctrl = "Right Ctrl",
    ralt = "Right Alt", pgup = "Page up", pgdown = "Page down", capslock = "Caps lock", ["return"] = "Enter",
    insert = "Insert", delete = "Delete", home = "Home", ["end"] = "End",
    pada = "A", padb = "B", padx = "X", pady = "Y", padlb = "LB", padrb = "RB", padlt = "LT", padrt = "RT",
    padback = "Back", padstart = "Start", padguide = "Guide", padls = "Left stick in", padrs = "Right stick in",
    padup = "Cross up", paddown = "Cross down", padleft = "Cross left", padright = "Cross right",
    padlup = "Left stick up", padldown = "Left stick down", padlleft = "Left stick left",
    padlright = "Left stick right", padrup = "Right stick up", padrdown = "Right stick down",
    padrleft = "Right stick left", padrright = "Right stick right"}

local rowOf = {}
for _, group in ipairs(keys.groups) do
    for _, row in ipairs(group.rows) do rowOf[row[1]] = row end
end

-- The place of a kind of device in a row.
local kColumn = {key = 3, pad = 4}

-- What a file says may be anything: only what could be bound counts.
local function isInput(device, text)
    local last = text:match("^%l+%+(.+)$") or text
    return text == "-" or (last:sub(1, 3) == "pad" and kLabels[last] ~= nil) == (device == "pad")
        and (kLabels[last] ~= nil or last:match("^f?%d+$") or #last == 1 and last ~= "+") and true or false
end

-- What an action is bound to: of the keyboard and the mouse, "key", or of a gamepad, "pad"; "-" where there is nothing.
function keys.of(action, device)
    local chosen = GetString("options." .. device .. "." .. action)
    return chosen ~= "" and isInput(device, chosen) and chosen or rowOf[action][kColumn[device]]
end

function keys.isChanged(action, device)
    return keys.of(action, device) ~= rowOf[action][kColumn[device]]
end

-- Binds all as the options say.
function keys.apply()
    for action in pairs(rowOf) do
        local list = {}
        for _, device in ipairs({"key", "pad"}) do
            local input = keys.of(action, device)
            if input ~= "-" then list[#list + 1] = input end
        end
        BindInput(action, table.unpack(list))
    end
    for action, list in pairs(fixed) do BindInput(action, table.unpack(list)) end
end

-- Binds one anew; without an input as it was at first.
function keys.bind(action, device, input)
    local key = "options." .. device .. "." .. action
    if not input or input == rowOf[action][kColumn[device]] then ClearKey(key) else SetString(key, input) end
    keys.apply()
end

function keys.resetAll()
    ClearKey("options.key")
    ClearKey("options.pad")
    keys.apply()
end

-- Another action that the same input would do in the same place; nil: there is none.
function keys.conflict(action, device)
    local input, row = keys.of(action, device), rowOf[action]
    if input == "-" then return nil end
    for _, group in ipairs(keys.groups) do
        for _, its in ipairs(group.rows) do
            local meets = its ~= row and (not row.on or not its.on or row.on == its.on)
            if meets and keys.of(its[1], device) == input then return its[2] end
        end
    end
end

-- An input as a player reads it.
function keys.name(input)
    if input == "-" then return "" end
    local held, last = input:match("^(%l+)%+(.+)$")
    if held then return keys.name(held) .. "+" .. keys.name(last) end
    return kLabels[input] or input:upper()
end

-- What to press for an action, on what is in use.
function keys.label(action)
    for _, input in ipairs(fixed[action] or {}) do
        if (input:sub(1, 3) == "pad") == keys.usesPad then return keys.name(input) end
    end
    local pad = keys.of(action, "pad")
    return keys.name(keys.usesPad and pad ~= "-" and pad or keys.of(action, "key"))
end

local kSticks = {padlup = "Left stick", padldown = "Left stick", padlleft = "Left stick", padlright = "Left stick"}

-- The same of several, by their names with spaces between.
function keys.labels(actions)
    local parts, seen = {}, {}
    for action in actions:gmatch("%S+") do
        local stick = keys.usesPad and rowOf[action] and kSticks[keys.of(action, "pad")]
        local text = stick or keys.label(action)
        if not seen[text] then parts[#parts + 1] = text end
        seen[text] = true
    end
    return table.concat(parts, "  ")
end

-- -1 to 1, of two actions; a stick gives what lies between.
function keys.axis(more, less)
    return InputValue(more) - InputValue(less)
end

-- How far a gamepad turns the view in this frame: radians to the right, and upwards.
function keys.look(dt)
    local x, y = InputValue("padrx"), InputValue("padry")
    local turn = kTurn * math.sqrt(x * x + y * y) * dt
    return turn * x, turn * y
end

-- Each frame: whether one plays by a gamepad, which the labels follow.
function keys.tick()
    local last = InputLastPressed()
    if last ~= "" then keys.usesPad = last:sub(1, 3) == "pad" end
end

return keys
