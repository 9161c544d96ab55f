-- A test: rides the lift of the office tower, and finds it without power where its wire is cut.
local bot = require("bots/hands")
SetString("options.volume", "0")  -- nothing is computed for the ear

local function height()
    return GetBodyTransform(GetShapeBody(FindShape("lift"))).pos.y
end

bot.play(function()
    bot.frames(3)
    bot.press("return")
    bot.frames(10)
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
end)

function tick()
    bot.tick()
end
