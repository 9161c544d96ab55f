-- What goes off when it is damaged or stands in fire: shapes with the tag "explosive", whose value tells them apart.
local bombs = require("tools/bombs")

local explosives = {}
local kLook, kSize, kVoxels, kHot = 6, 1.7, 6, 90  -- steps; size; voxels that may be lost; steps in a fire
local count = saved("explosives", {made = 0})
local newest = 0                -- when the last one was made: it is there from the step after on
local known, steps = {}, 0      -- shape -> where it is, what it has lost, and for how long it has been in a fire

function explosives.add(shape)
    count.made, newest = count.made + 1, GetTime()
    SetTag(shape, "explosive", tostring(count.made))
end

-- Those of a level have no number yet.
function explosives.begin()
    for _, shape in ipairs(FindShapes("explosive")) do
        if GetTagValue(shape, "explosive") == "" then explosives.add(shape) end
    end
end

-- Pieces of one that has gone off are no more than that.
local function disarm(number)
    for _, shape in ipairs(FindShapes("explosive")) do
        if GetTagValue(shape, "explosive") == number then RemoveTag(shape, "explosive") end
    end
end

local function explode(shape, record)
    known[shape] = nil
    disarm(record.number)
    bombs.blast(record.at, kSize)
end

local function look()
    local now = {}
    for _, shape in ipairs(FindShapes("explosive")) do
        local low, high = GetShapeBounds(shape)
        local record = known[shape] or {lost = 0, hot = 0, number = GetTagValue(shape, "explosive")}
        record.at = VecLerp(low, high, 0.5)
        local isHot = QueryAabbFireCount(low - Vec(0.3, 0.3, 0.3), high + Vec(0.3, 0.3, 0.3)) > 0
        record.hot = isHot and record.hot + kLook or 0
        now[shape] = record
    end
    known = now
end

-- Voxels of a shape are gone.
function explosives.broken(shape, voxels)
    local record = known[shape]
    if record then record.lost = record.lost + voxels end
end

-- Each step.
function explosives.update()
    if count.made == 0 then return end
    steps = steps + 1
    if steps % kLook == 0 and GetTime() > newest then look() end
    for shape, record in pairs(known) do
        if record.lost > kVoxels or record.hot > kHot then explode(shape, record) end
    end
end

return explosives
