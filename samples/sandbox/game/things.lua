-- What can be placed. A thing is a list of pieces {model =, at =, turn =, density =, isFixed =, tag =, light =} in its own
-- frame, whose origin is the middle of its foot. Those of the folder "prefabs" are files that give one: {name =, pieces =}.
local build = require("vehicles/build")
local vehicles = require("vehicles/vehicles")

local things = {folders = {}}

-- A model whose origin is the middle of its foot.
local function model(x, y, z, voxel)
    return build.model({x, y, z}, {x / 2, 0, z / 2}, voxel)
end
things.model = model

-- All edges of a box in one surface.
local function frameEdges(m, name)
    local x, y, z = m.size[1] - 1, m.size[2] - 1, m.size[3] - 1
    for _, i in ipairs({0, 1}) do
        for _, k in ipairs({0, 1}) do
            m:box(0, i * y, k * z, x, i * y, k * z, name)
            m:box(i * x, 0, k * z, i * x, y, k * z, name)
            m:box(i * x, k * y, 0, i * x, k * y, z, name)
        end
    end
end

local function crate()
    local m = model(14, 14, 14, 0.05)
    m:box(0, 0, 0, 13, 13, 13, "plank")
    m:clear(1, 1, 1, 12, 12, 12)
    for i = 3, 10, 4 do
        m:box(0, i, 0, 13, i, 0, "wood")
        m:box(0, i, 13, 13, i, 13, "wood")
        m:box(0, i, 0, 0, i, 13, "wood")
        m:box(13, i, 0, 13, i, 13, "wood")
    end
    for _, at in ipairs({0, 12}) do
        for _, side in ipairs({0, 12}) do m:box(at, 0, side, at + 1, 13, side + 1, "wood") end
        m:box(at, 0, 0, at + 1, 1, 13, "wood")
        m:box(at, 12, 0, at + 1, 13, 13, "wood")
        m:box(0, 0, at, 13, 1, at + 1, "wood")
        m:box(0, 12, at, 13, 13, at + 1, "wood")
    end
    return m
end

-- A drum that stands, with hoops.
local function drum(paint, hoop)
    local m = model(12, 18, 12, 0.05)
    for y = 0, 17 do
        local isHoop = y == 0 or y == 6 or y == 11 or y == 17
        local radius = isHoop and 6 or 5.6
        for x = 0, 11 do
            local half = radius * radius - (x - 5.5) ^ 2
            if half >= 0 then
                half = math.floor(math.sqrt(half) + 0.5)
                m:box(x, y, 6 - half, x, y, 5 + half, isHoop and hoop or paint)
                if y > 0 and y < 17 and half > 1 and x > 1 and x < 10 then m:clear(x, y, 8 - half, x, y, 3 + half) end
            end
        end
    end
    m:box(7, 17, 5, 8, 17, 6, "black")
    return m
end

local function explosive()
    local m = drum("red", "dark")
    for x = 0, 11 do                                        -- a yellow band
        local half = math.floor(math.sqrt(math.max(0, 31.4 - (x - 5.5) ^ 2)) + 0.5)
        m:box(x, 8, 6 - half, x, 9, 6 - half, "yellow")
        m:box(x, 8, 5 + half, x, 9, 5 + half, "yellow")
    end
    for _, x in ipairs({0, 11}) do m:box(x, 8, 4, x, 9, 7, "yellow") end
    return m
end

local function plank()
    local m = model(3, 1, 30)
    m:box(0, 0, 0, 2, 0, 29, "plank")
    return m
end

local function table_()
    local m = model(14, 8, 8)
    m:box(0, 7, 0, 13, 7, 7, "wood")
    for _, x in ipairs({0, 13}) do
        for _, z in ipairs({0, 7}) do m:box(x, 0, z, x, 6, z, "wood") end
        m:box(x, 6, 0, x, 6, 7, "wood")
    end
    return m
end

local function chair()
    local m = model(5, 10, 5)
    for _, x in ipairs({0, 4}) do
        m:box(x, 0, 0, x, 3, 0, "wood")
        m:box(x, 0, 4, x, 9, 4, "wood")
    end
    m:box(0, 4, 0, 4, 4, 4, "plank")
    m:box(0, 7, 4, 4, 7, 4, "plank")
    m:box(0, 9, 4, 4, 9, 4, "plank")
    return m
end

local function lamp()
    local m = model(10, 40, 10, 0.05)
    m:box(2, 0, 2, 7, 0, 7, "dark")
    m:box(3, 1, 3, 6, 1, 6, "dark")
    m:box(4, 2, 4, 5, 31, 5, "chrome")
    m:box(3, 31, 3, 6, 31, 6, "chrome")
    m:box(3, 32, 3, 6, 36, 6, "bulb")
    for _, x in ipairs({3, 6}) do
        for _, z in ipairs({3, 6}) do m:box(x, 32, z, x, 36, z, "chrome") end
    end
    for i = 0, 2 do m:box(1 + i, 37 + i, 1 + i, 8 - i, 37 + i, 8 - i, "dark") end
    return m
end

-- A wall of bricks in courses: metres wide and high.
local function brickWall(wide, high)
    local m = model(wide * 10 // 1, high * 10 // 1, 2)
    m:box(0, 0, 0, m.size[1] - 1, m.size[2] - 1, 1, "brick")
    for y = 0, m.size[2] - 1 do
        for x = y % 2 * 2, m.size[1] - 1, 4 do m:box(x, y, 0, x, y, 1, "mortar") end
    end
    return m
end

local function concreteWall()
    local m = model(30, 25, 2)
    m:box(0, 0, 0, 29, 24, 1, "concrete")
    for _, x in ipairs({9, 19}) do m:box(x, 0, 0, x, 24, 0, "worn") end
    return m
end

local function woodWall()
    local m = model(30, 25, 2)
    for x = 0, 29 do m:box(x, 0, 0, x, 24, 0, x % 3 == 2 and "wood" or "plank") end
    for _, y in ipairs({1, 12, 23}) do m:box(0, y, 1, 29, y, 1, "wood") end
    for x = 0, 29, 29 do m:box(x, 0, 1, x, 24, 1, "wood") end
    return m
end

local function pane()
    local m = model(16, 20, 2)
    m:box(1, 1, 0, 14, 18, 0, "pane")
    m:box(0, 0, 0, 15, 0, 1, "dark")
    m:box(0, 19, 0, 15, 19, 0, "dark")
    for _, x in ipairs({0, 15}) do m:box(x, 0, 0, x, 19, 0, "dark") end
    return m
end

local function beam()
    local m = model(4, 5, 50)
    m:box(0, 0, 0, 3, 0, 49, "rust")
    m:box(0, 4, 0, 3, 4, 49, "rust")
    m:box(1, 1, 0, 2, 3, 49, "rust")
    return m
end

local function pillar()
    local m = model(8, 30, 8)
    m:box(0, 0, 0, 7, 1, 7, "concrete")
    m:box(1, 2, 1, 6, 27, 6, "concrete")
    m:box(0, 28, 0, 7, 29, 7, "concrete")
    for _, x in ipairs({2, 5}) do
        for _, z in ipairs({2, 5}) do m:box(x, 1, z, x, 28, z, "rust") end
    end
    return m
end

local function stairs()
    local m = model(12, 20, 30)
    for i = 0, 9 do m:box(0, 2 * i, 3 * i, 11, 2 * i + 1, 29, i % 2 == 0 and "concrete" or "concrete") end
    for i = 0, 6 do m:clear(2, 0, 3 * i + 9, 9, 2 * i + 1, 29) end
    return m
end

local function single(name, make, more)
    local thing = {name = name, make = function()
        local piece = {model = make()}
        for key, value in pairs(more or {}) do piece[key] = value end
        return {piece}
    end}
    return thing
end

local function folder(name, list)
    things.folders[#things.folders + 1] = {name = name, things = list}
end

folder("Things", {single("Crate", crate, {density = 0.35}), single("Barrel", function() return drum("blue", "steel") end,
        {density = 0.25}), single("Explosive", explosive, {density = 0.25, tag = "explosive"}),
    single("Lamp", lamp, {density = 0.5, light = Vec(0, 1.72, 0)}), single("Table", table_), single("Chair", chair),
    single("Plank", plank)})
folder("Building", {single("Brick wall", function() return brickWall(3, 2.4) end),
    single("Concrete wall", concreteWall), single("Wooden wall", woodWall), single("Glass pane", pane),
    single("Steel beam", beam), single("Pillar", pillar), single("Stairs", stairs)})
do
    local list = {}
    for _, kind in ipairs({"car", "van", "truck", "forklift", "excavator", "crane", "boat"}) do
        local name = vehicles.kinds[kind].name
        list[#list + 1] = {name = name:sub(1, 1):upper() .. name:sub(2), vehicle = kind, isUpright = true,
            make = function() return vehicles.models(kind) end}
    end
    folder("Vehicles", list)
    list = {}
    for _, file in ipairs(ListFiles("prefabs")) do
        local name = file:match("^(.+)%.lua$")
        if name then
            local prefab = require("prefabs/" .. name)
            list[#list + 1] = {name = prefab.name, make = function() return prefab.pieces(things.model) end,
                isUpright = true}
        end
    end
    folder("Prefabs", list)
end

-- What is wrong with a thing, under the name of the file that gave it and not of the script that noticed.
function things.blame(path, what)
    local text = tostring(what):gsub("^[^:]+:%d+: ", "")
    return path:match("[^/]+$") .. ": " .. text
end

-- Its pieces, made once.
function things.pieces(thing)
    thing.list = thing.list or thing.make()
    return thing.list
end

-- The box around a thing, in its frame.
function things.box(thing)
    if thing.low then return thing.low, thing.high end
    local low, high = Vec(math.huge, math.huge, math.huge), Vec(-math.huge, -math.huge, -math.huge)
    for _, piece in ipairs(things.pieces(thing)) do
        local m = piece.model
        local frame = Transform(piece.at or Vec(), piece.rot or QuatEuler(0, piece.turn or 0, 0))
        for k = 0, 7 do
            local cell = {k & 1 > 0 and m.size[1] or 0, k & 2 > 0 and m.size[2] or 0, k & 4 > 0 and m.size[3] or 0}
            local at = frame * VecScale(Vec(cell[1] - m.origin[1], cell[2] - m.origin[2], cell[3] - m.origin[3]), m.voxel)
            for i = 1, 3 do low[i], high[i] = math.min(low[i], at[i]), math.max(high[i], at[i]) end
        end
    end
    thing.low, thing.high = low, high
    return low, high
end

return things
