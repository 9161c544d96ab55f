-- A test: the four things of the heist that are in the house, by keys alone: its door is pushed, all ways are walked.
local bot = require("bots/hands")
local walkTo = require("bots/walk")
local heist = require("contracts/heist")
local level = require("levels/house")
SetString("options.volume", "0")  -- nothing is computed for the ear

local corner = Vec(17.2, -0.3, 28.8)  -- of the house
local low, high = 5, 32               -- cells of its floors

local function cell(x, y, z)
    return corner + VecScale(Vec(x, y, z), 0.1)
end

local function along(what, places)
    for i, place in ipairs(places) do walkTo(place, what .. ", place " .. i, "shift") end
end

local function take(name)
    local count = GetFloat("contract.count")
    for i, thing in ipairs(level.things) do
        if thing.name == name then bot.look(heist.center(heist.bodyOf(i))) end
    end
    bot.press("e")
    bot.image("heist-" .. name)
    bot.expect(GetFloat("contract.count") == count + 1, "to take the " .. name)
end

local function robHouse()
    along("to the house", {Vec(31.5, 0, 46), Vec(31.5, 0, 42.8), Vec(26.6, 0, 42.8), cell(92, low, 112)})
    bot.look(cell(92, 17, 102))
    bot.press("e")
    bot.frames(60)
    along("living room", {cell(92, low, 92), cell(72, low, 89.5), cell(52, low, 88)})
    take("vase")
    along("kitchen", {cell(48, low, 82), cell(49.5, low, 66), cell(49.5, low, 44)})
    take("radio")
    along("study", {cell(49.5, low, 66), cell(48, low, 82), cell(58, low, 89.5), cell(71, low, 88), cell(69, low, 66),
        cell(70, low + 2, 57.5), cell(108, high, 57.5), cell(98, high, 72)})
    take("casket")
    along("bedroom", {cell(70, high, 67), cell(70, high, 89.5), cell(59, high, 89)})
    take("clock")
    along("out of the house", {cell(70, high, 89.5), cell(70, high, 67), cell(108, high, 66), cell(108, high, 57.5),
        cell(70, low + 2, 57.5), cell(69, low, 66), cell(92, low, 88), cell(92, low, 112)})
end

bot.play(function()
    if GetString("game.contract") == "" then
        bot.frames(3)
        SetString("game.contract", "heist")
        RestartLevel()
        bot.frames(10)
        error("expected the level to begin again")
    end
    while GetString("contract.phase") ~= "planning" do bot.frames(1) end
    bot.frames(10)
    robHouse()
    along("exit", {Vec(26.6, 0, 42.8), Vec(31.5, 0, 42.8), Vec(39.5, level.ground, 48.5)})
    bot.image("heist-end")
    bot.expect(GetFloat("contract.count") == 4 and GetString("contract.phase") == "running", "four things at the exit")
    bot.expect(GetFloat("contract.left") > 30, "half of the time for the shop, found " .. GetFloat("contract.left"))
end)

function tick()
    bot.tick()
end
