-- A test of what works in the town: the lift of the office tower, while its wire is whole; the doors of the barn; the
-- pumps of the petrol station, which go off.
local bot = require("bots/hands")
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
    setOffPump()
end)

function tick()
    bot.tick()
end
