-- Files that were dropped on the window: models, levels, and prefabs as those of prefabs/. They are things to place until
-- the game ends, in a folder of their own.
local environment = require("environment")
local things = require("things")

local dropped = {}
local folder
local seen = 0

local function isList(value)
    if type(value) ~= "table" or #value ~= 3 then return false end
    for i = 1, 3 do
        if type(value[i]) ~= "number" then return false end
    end
    return true
end

-- What is wrong with a list of pieces; nil: nothing that is seen before they are made.
local function wrongPiece(pieces)
    if type(pieces) ~= "table" or #pieces == 0 then return "no pieces" end
    for i, piece in ipairs(pieces) do
        local m = type(piece) == "table" and piece.model
        if type(m) ~= "table" or not isList(m.size) or not isList(m.origin) or type(m.voxel) ~= "number"
            or type(m.palette) ~= "table" or type(m.boxes) ~= "table" then
            return "piece " .. i .. " without a model {size =, origin =, voxel =, palette =, boxes =}"
        end
    end
end

-- The prefab of a text; nil and what is wrong with it.
local function prefabOf(drop)
    local chunk, what = load(drop.script, "=" .. drop.path:match("[^/]+$"), "t", environment())
    local isGood, prefab = true, nil
    if chunk then isGood, prefab = pcall(chunk) end
    if not chunk or not isGood then return nil, tostring(what or prefab) end
    local function wrong(found) return nil, things.blame(drop.path, "expected {name =, pieces =}, found " .. found) end
    if type(prefab) ~= "table" then return wrong(type(prefab)) end
    if type(prefab.name) ~= "string" or type(prefab.pieces) ~= "function" then return wrong("a table without them") end
    local hasPieces, pieces = pcall(prefab.pieces, things.model)
    if not hasPieces then return nil, tostring(pieces) end
    local found = wrongPiece(pieces)
    if found then return wrong(found) end
    local hasPlaces, why = pcall(things.box, {list = pieces})
    if not hasPlaces then return nil, things.blame(drop.path, why) end
    return {name = prefab.name, list = pieces, isUpright = true}
end

-- The thing of a drop; nil and what is wrong with it.
local function thingOf(number)
    local drop = GetDrop(number)
    if drop.error then return nil, drop.error end
    local thing, what = {name = drop.name, list = drop.pieces, drop = number, isFree = drop.isFree}, nil
    if drop.script then thing, what = prefabOf(drop) end
    if thing then thing.path = drop.path end
    return thing, what
end

-- One that has come again, as a file that was changed, takes the place of the one before.
local function add(thing)
    if not folder then
        folder = {name = "Dropped", things = {}}
        table.insert(things.folders, folder)
    end
    for i, old in ipairs(folder.things) do
        if old.path == thing.path then
            folder.things[i] = thing
            return
        end
    end
    table.insert(folder.things, thing)
end

-- For other scripts: names of what can be placed, and of those the ones that have a small image.
function dropped.publish()
    local names, seen = {}, {}
    for _, thing in ipairs(folder and folder.things or {}) do
        names[#names + 1] = thing.name
        if thing.picture and #thing.picture > 0 then seen[#seen + 1] = thing.name end
    end
    SetString("game.dropped", table.concat(names, " "))
    SetString("game.pictured", table.concat(seen, " "))
end

-- The next one that has come: its thing, or nil and what is wrong with it; nil alone: there is none.
function dropped.take()
    if seen >= GetDropCount() then return nil end
    seen = seen + 1
    local thing, what = thingOf(seen)
    if thing then add(thing) end
    return thing, what
end

for number = 1, GetDropCount() do  -- of before a load or another beginning
    local thing = thingOf(number)
    if thing then add(thing) end
    seen = number
end

return dropped
