-- The level of the demolition contract: an old mill with a chimney, in place of the house of the town. Where there is no
-- town around it, it stands on a lawn of its own, beside a shed.
local blueprint = require("levels/blueprint")
local yard = require("levels/yard")

local kCorner = Vec(17.6, -0.4, 29.2)  -- of its model; the ground is four cells higher
local kGround, kEaves, kRoof = 4, 40, 54
local kHall = {2, 40, 80, 108}         -- x, z, x1, z1 of its walls
local kChimney = {94, 66, 117, 89}     -- of its foot
local kTop = 127

local function drawHall(b)
    local x, z, x1, z1 = table.unpack(kHall)
    b:shaft("brick", x, kGround, z, x1, kEaves, z1, 3)
    b:block("timber", x + 3, kGround - 1, z + 3, x1 - 3, kGround - 1, z1 - 3, 5)
    b:bricks("ochre", x, kEaves - 5, z1 - 2, x1, kEaves - 4, z1)
    b:block("concrete", x - 1, kGround, z1, x1 + 1, kGround + 1, z1 + 1, 6)
    for _, at in ipairs({7, 21, 51, 65}) do
        b:window(x + at, kGround + 9, z1 - 2, 9, 17)
        b:window(x + at, kGround + 9, z, 9, 17)
    end
    b:block("door", x + 34, kGround, z1 - 1, x + 44, kGround + 23, z1 - 1, 2)
    b:clear(x + 34, kGround, z1 - 2, x + 44, kGround + 23, z1 - 2)
    b:clear(x + 34, kGround, z1, x + 44, kGround + 23, z1)
    b:block("ochre", x + 32, kGround + 24, z1 - 2, x + 46, kGround + 26, z1, 3)
    for _, at in ipairs({20, 40, 60}) do  -- columns and benches within
        for _, row in ipairs({18, 46}) do b:block("steel", x + at, kGround, z + row, x + at + 1, kEaves, z + row + 1, 8) end
        b:block("timber", x + at - 12, kGround + 8, z + 28, x + at + 4, kGround + 8, z + 36, 3)
        for _, leg in ipairs({-11, 3}) do
            b:block("timber", x + at + leg, kGround, z + 32, x + at + leg, kGround + 7, z + 32, 3)
        end
    end
end

-- Three roofs as the teeth of a saw, whose steep sides are of glass.
local function drawRoof(b)
    local x, z, x1, z1 = table.unpack(kHall)
    local tooth = (x1 - x + 1) // 3
    for i = 0, 2 do
        local from = x + i * tooth
        local to = i == 2 and x1 or from + tooth - 1
        for at = from, to do
            local y = kEaves + (kRoof - kEaves) * (to - at) // (to - from)
            for _, wall in ipairs({z, z1 - 2}) do
                if y > kEaves then b:block("brick", at, kEaves + 1, wall, at, y - 1, wall + 2, 2) end
            end
            for along = z - 2, z1 + 2, 5 do
                b:fill(at, y, along, at, y + 1, math.min(along + 4, z1 + 2), b:pick("slate", at // 2, i, along))
            end
        end
        local steel = b:entries("steel")[1]
        b:window(from, kEaves + 1, z + 3, 1, 1)  -- makes the entry of the glass
        b:fill(from, kEaves + 1, z + 3, from, kRoof - 1, z1 - 3, b.glass)
        for at = z + 3, z1 - 3, 8 do b:fill(from, kEaves + 1, at, from, kRoof - 1, at, steel) end
        b:block("steel", from, kEaves, z + 3, from, kEaves, z1 - 3, 9)
    end
end

local function drawChimney(b)
    local x, z, x1, z1 = table.unpack(kChimney)
    b:shaft("brick", x, kGround, z, x1, kGround + 16, z1, 4)
    b:block("concrete", x - 1, kGround + 17, z - 1, x1 + 1, kGround + 18, z1 + 1, 6)
    for tier, thick in ipairs({4, 3, 3}) do
        local inset, low = tier, kGround + 19 + (tier - 1) * 30
        b:shaft("brick", x + inset, low, z + inset, x1 - inset, tier == 3 and kTop - 12 or low + 29, z1 - inset, thick)
        b:shaft("ochre", x + inset, low + 26, z + inset, x1 - inset, low + 27, z1 - inset, thick)
    end
    b:shaft("ochre", x + 2, kTop - 11, z + 2, x1 - 2, kTop - 8, z1 - 2, 5)
    b:shaft("brick", x + 1, kTop - 7, z + 1, x1 - 1, kTop - 3, z1 - 1, 6)
    b:shaft("soot", x + 2, kTop - 2, z + 2, x1 - 2, kTop, z1 - 2, 4)
end

-- The hall on its floor, and the chimney: shapes of their own, of which the first is the first whose stress is found.
local function buildMill()
    local hall = blueprint({120, 60, 126})
    hall:block("concrete", 0, 0, 0, 119, kGround - 1, 125, 12)
    hall:block("earth", 0, kGround - 1, 0, 119, kGround - 1, 38, 3)
    hall:block("earth", 0, kGround - 1, 111, 119, kGround - 1, 125, 3)
    local x, z, x1, z1 = table.unpack(kChimney)
    hall:clear(x - 1, 0, z - 1, x1 + 1, kGround - 1, z1 + 1)
    drawHall(hall)
    wait(0)
    drawRoof(hall)
    wait(0)
    local chimney = blueprint({x1 - x + 3, 128, z1 - z + 3})
    chimney.from = {x - 1, 0, z - 1}
    chimney:block("concrete", x - 1, 0, z - 1, x1 + 1, kGround - 1, z1 + 1, 6)
    drawChimney(chimney)
    local _, first = chimney:build(kCorner)
    wait(0)
    local _, second = hall:build(kCorner)
    return {first, second}
end

-- Removes the house and what is in it.
local function clearPlot()
    local low, high = GetBodyBounds(FindBody("house"))
    for _, body in ipairs(FindBodies()) do
        local at = GetBodyTransform(body) * GetBodyCenterOfMass(body)
        local isIn = at.x > low.x and at.x < high.x and at.z > low.z and at.z < high.z and at.y < high.y
        if isIn and (IsBodyDynamic(body) or body == FindBody("house")) then Delete(body) end
    end
end

-- What stands beside it where there is no shop.
local function buildShed()
    local shed = blueprint({50, 34, 60})
    shed:shaft("brick", 0, 0, 0, 49, 29, 59, 3)
    shed:block("timber", 0, 30, 0, 49, 31, 59, 6)
    local _, shape = shed:build(Vec(34.6, 0, 33))
    return shape
end

return {
    place = "The old mill",
    neighbourName = "Shop",
    chimney = {Vec(kCorner.x + 9.4, 0, kCorner.z + 6.6), Vec(kCorner.x + 11.8, 0, kCorner.z + 9.0)},
    height = 12.4, strength = 0.03,
    start = {Vec(25.5, 0.2, 51.5), Vec(27, 5, 36)},  -- feet, and what the eyes look at
    -- Gives the shapes of the building and of its neighbour.
    build = function()
        local shop = FindShape("shop")
        if shop ~= 0 and FindBody("house") ~= 0 then
            clearPlot()
        else
            yard()
            shop = 0
        end
        local mill = buildMill()
        return mill, shop ~= 0 and shop or buildShed()
    end,
}
