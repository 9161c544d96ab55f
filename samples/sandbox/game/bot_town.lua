-- A test of what works in the town: the lift of the office tower, while its wire is whole; the doors of the barn and of
-- the houses; the stairs, walked up and down by keys; the pumps of the petrol station, which go off.
local bot = require("bots/hands")
local walkTo = require("bots/walk")
SetString("options.volume", "0")  -- nothing is computed for the ear

local function height()
    return GetBodyTransform(GetShapeBody(FindShape("lift"))).pos.y
end

local function rideLift()
    local frame = GetBodyTransform(GetShapeBody(FindShape("lift")))
    bot.stand(frame * Vec(0.5, 0.12, 0.55), frame * Vec(0.5, 1.2, 0))
    local ground, feet = height(), GetPlayerTransform().pos.y
    bot.press("e")
    bot.frames(240)
    bot.expect(math.abs(height() - ground - 2.6) < 0.05, "the lift a storey higher, found " .. height() - ground)
    bot.expect(math.abs(GetPlayerTransform().pos.y - feet - 2.6) < 0.1, "the player with it")
    bot.image("lift")
    MakeHole(frame * Vec(-0.15, 0.5, 1.15), 0.3, 0.3, 0.3)
    bot.frames(30)
    bot.press("e")
    bot.frames(120)
    bot.expect(math.abs(height() - ground - 2.6) < 0.05, "a lift without power that stays, found " .. height() - ground)
end

local function openBarn()
    local hinge = GetShapeJoints(FindShape("barn door left"))[1]
    bot.stand(Vec(29.6, 0.1, 126.4), Vec(29.8, 1.3, 124.5))
    bot.press("e")
    bot.frames(60)
    bot.image("barn")
    bot.expect(math.abs(GetJointMovement(hinge)) > 0.3, "an open door, found " .. GetJointMovement(hinge))
end

-- In at the front door, up the stairs, through the rooms above, and all the way back.
local function visit(house)
    local corner = GetBodyTransform(FindBody(house)).pos
    local function cell(x, y, z) return corner + VecScale(Vec(x, y, z), 0.1) end
    local hinge = GetShapeJoints(FindShape(house .. " door"))[1]
    local ground, upper = 5, 32
    bot.stand(cell(93, ground, 121), cell(92, ground + 12, 102))
    bot.press("e")
    bot.frames(60)
    bot.image("door-" .. house:gsub(" ", "-"))
    bot.expect(math.abs(GetJointMovement(hinge)) > 1.2, house .. ": an open door, found " .. GetJointMovement(hinge))
    local way = {{"porch", 93, ground, 109}, {"hall", 92, ground, 76},
        {"door under the stairs", 105.5, ground, 68}, {"back room", 105.5, ground, 44},
        {"door under the stairs", 105.5, ground, 68}, {"stairs' foot", 69, ground, 66},
        {"first step", 70, ground + 2, 57.5}, {"landing", 108, upper, 57.5},
        {"back room above", 105.5, upper, 44}, {"landing", 108, upper, 57.5}, {"study", 110, upper, 66},
        {"study's end", 70, upper, 67}, {"bedroom's door", 70, upper, 89.5}, {"bedroom", 60, upper, 89.5}}
    local function walk(i) walkTo(cell(way[i][2], way[i][3], way[i][4]), house .. ": " .. way[i][1]) end
    for i = 1, #way do walk(i) end
    bot.image("above-" .. house:gsub(" ", "-"))
    for i = #way - 1, 1, -1 do walk(i) end
end

-- Up the stairs of the building site to its roof, and down again.
local function climbSite()
    local corner = GetBodyTransform(FindBody("shell of a building")).pos
    local way = {}
    for storey = 0, 2 do
        for _, at in ipairs({{82, 0, 30}, {82, 0, 17}, {117, 30, 17}, {117, 30, 30}}) do
            way[#way + 1] = corner + VecScale(Vec(at[1], 3 + 30 * storey + at[2], at[3]), 0.1)
        end
    end
    bot.stand(way[1], way[2])
    for i = 2, #way do walkTo(way[i], "building site, place " .. i) end
    bot.image("site")
    for i = #way - 1, 1, -1 do walkTo(way[i], "building site, back at place " .. i) end
end

local function setOffPump()
    local pump = FindShape("petrol pump 1")
    local low, high = GetShapeBounds(pump)
    local voxels = GetShapeVoxelCount(pump)
    MakeHole(VecLerp(low, high, 0.6), 0.25, 0.25, 0.25)
    bot.frames(60)
    bot.image("pump")
    bot.expect(not IsHandleValid(pump) or GetShapeVoxelCount(pump) < 0.5 * voxels, "a pump that has gone off")
    bot.expect(GetTagValue(FindShape("petrol pump 4"), "explosive") ~= "", "the others to be there")
end

bot.play(function()
    bot.frames(3)
    bot.press("return")
    bot.frames(10)
    rideLift()
    openBarn()
    for _, house in ipairs({"house", "quay house 4"}) do visit(house) end
    climbSite()
    setOffPump()
end)

function tick()
    bot.tick()
end
