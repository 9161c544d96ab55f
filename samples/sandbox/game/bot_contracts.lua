-- A test: wins and loses each contract. Each stage begins the level anew; "bot.stage" says which one is played.
local bot = require("bots/hands")

-- Waits until a contract is in a phase, so many frames at most.
local function await(phase, frames)
    for _ = 1, frames do
        if GetString("contract.phase") == phase then return end
        bot.frames(1)
    end
    error("expected the phase " .. phase .. ", found " .. GetString("contract.phase") .. " "
        .. GetString("contract.reason"))
end

local function ended(phase, reason, frames)
    await(phase, frames)
    bot.frames(2)
    bot.expect(GetString("contract.reason"):find(reason, 1, true), reason .. ", found " .. GetString("contract.reason"))
    bot.expect(GetString("game.menu") == "result", "the screen that says so")
end

-- Puts remote bombs at places, each from where it is reached, and sets them off.
local function blow(places)
    bot.choose("remotebomb")
    for _, place in ipairs(places) do
        bot.stand(place[1], place[2])
        bot.press("lmb")
    end
    bot.press("rmb")
end

-- The foot of the chimney on three sides, so that it falls to the street.
local function chimneyFront()
    local places = {}
    for _, x in ipairs({27.2, 28.2, 29.2}) do places[#places + 1] = {Vec(x, 0.1, 40.2), Vec(x, 2, 38.2)} end
    for _, z in ipairs({37.5, 36.7}) do
        places[#places + 1] = {Vec(31.2, 0.1, z), Vec(29.4, 2, z)}
        places[#places + 1] = {Vec(26.3, 0.1, z), Vec(27.05, 2, z)}
    end
    return places
end

-- Where one can stand to reach a thing: on a floor, with nothing between the eyes and it.
local function footing(at)
    for _, far in ipairs({1.2, 1.6, 2.0}) do
        for turn = 0, 315, 45 do
            local out = QuatEuler(0, turn, 0) * Vec(0, 0, far)
            local isBlocked = QueryRaycast(at + Vec(0, 0.3, 0), VecNormalize(out), far + 0.35)
            local hit, down = QueryRaycast(at + out + Vec(0, 0.3, 0), {0, -1, 0}, 2.5, 0.3)
            if not isBlocked and hit then
                local feet = at + out + Vec(0, 0.02 - down, 0)
                bot.stand(feet, at)
                local eye = GetPlayerCameraTransform().pos
                local way = at - eye
                local isSeen = not QueryRaycast(eye, VecNormalize(way), VecLength(way) - 0.35)
                local drift = VecLength(GetPlayerTransform().pos - feet)
                if drift < 0.4 and isSeen then return bot.look(at) end
            end
        end
    end
    error("expected a place to take it from: " .. VecStr(at))
end

-- Takes things, each from where one can stand. Ways take as long as to run twice their straight line.
local function take(count)
    local last
    for i = 1, count do
        local heist = require("contracts/heist")
        footing(heist.center(heist.bodyOf(i)))
        local here = GetPlayerTransform().pos
        if last then bot.frames(math.floor(60 * 2 * VecLength(here - last) / 6.8)) end
        last = here
        bot.press("e")
        bot.expect(GetFloat("contract.count") == i, "to take thing " .. i)
    end
    return last
end

local function toExit()
    local exit = require("levels/house").exit
    SetPlayerTransform(Transform(VecLerp(exit[1], exit[2], 0.5)))
end

local stages = {
    {"demolition", function()
        local _, splinter = CreateModel({size = {3, 3, 3}, boxes = {{0, 0, 0, 2, 2, 2, 1}},
            palette = {{0.5, 0.3, 0.2, material = "brick"}}}, Transform(Vec(20, 11, 30)), false)
        SetTag(splinter, "target")  -- what hangs somewhere and is small does not count
        bot.frames(60)  -- until the stress in the chimney is known
        blow(chimneyFront())
        ended("won", "the shop stands", 1500)
    end},
    {"demolition", function()
        bot.choose("timebomb")
        bot.stand(Vec(20, 0.1, 50), Vec(20, 1.4, 60))  -- away from all
        for _ = 1, 8 do bot.hold("lmb", 34) end
        ended("lost", "No bombs", 900)
    end},
    {"demolition", function()
        blow({{Vec(37, 0.1, 41), Vec(37, 1.4, 39)}, {Vec(38, 0.1, 41), Vec(38, 1.4, 39)},
            {Vec(36, 0.1, 41), Vec(36, 1.4, 39)}})
        ended("lost", "damaged", 300)
    end},
    {"heist", function()
        local last = take(6)
        bot.expect(GetString("contract.phase") == "running", "an alarm")
        local exit = require("levels/house").exit
        bot.frames(math.floor(60 * 2 * VecLength(VecLerp(exit[1], exit[2], 0.5) - last) / 6.8))
        toExit()
        ended("won", "All six", 60)
    end},
    {"heist", function()
        take(2)
        ended("lost", "time is over", 3700)
    end},
    {"heist", function()
        Explosion(Vec(20.5, 0.3, 36.8), 1.5)
        ended("lost", "vase is broken", 60)
    end},
}

local function next(i)
    if not stages[i] then return end
    SetInt("bot.stage", i)
    SetString("game.contract", stages[i][1])
    RestartLevel()
    bot.frames(10)
    error("expected the level to begin again")
end

bot.play(function()
    local i = GetInt("bot.stage")
    if i > 0 then
        local id = stages[i][1]
        await(id == "heist" and "planning" or "running", 200)
        bot.frames(5)
        stages[i][2]()
        print("stage " .. i .. ": " .. GetString("contract.phase") .. ", " .. GetString("contract.reason"))
    end
    next(i + 1)
end)

function tick()
    bot.tick()
end
