-- A test: saves each contract while things fly and the clock runs, goes on, loads, goes on again: the world, the goal and
-- the clock must be the same.
local bot = require("bots/hands")

local kLater = 100  -- steps after the save at which both are compared
local progress = saved("progress", {steps = 0, savedAt = 0})

-- A number that differs where any body, or how the contract stands, differs in a bit.
local function digest()
    local sum = 0
    local function add(...)
        local hash = 0xcbf29ce484222325
        for _, value in ipairs({...}) do hash = (hash ~ string.unpack("i8", string.pack("d", value))) * 1099511628211 end
        sum = sum + (hash ~ hash >> 29)
    end
    for _, body in ipairs(FindBodies()) do
        if not HasTag(body, "viewmodel") then
            local at, v, w = GetBodyTransform(body), GetBodyVelocity(body), GetBodyAngularVelocity(body)
            local count = 0
            for _, shape in ipairs(GetBodyShapes(body)) do count = count + GetShapeVoxelCount(shape) end
            add(at.pos.x, at.pos.y, at.pos.z, at.rot[1], at.rot[2], at.rot[3], at.rot[4], v.x, v.y, v.z, w.x, w.y, w.z,
                count)
        end
    end
    local feet = GetPlayerTransform().pos
    add(feet.x, feet.y, feet.z)
    local text = string.format("%x", sum)
    for _, key in ipairs({"left", "count", "height", "damage", "bombs", "time", "since", "resting"}) do
        text = text .. " " .. key .. "=" .. GetString("contract." .. key)
    end
    return text .. " " .. GetString("contract.phase")
end

local function await(phase)
    for _ = 1, 200 do
        if GetString("contract.phase") == phase then return end
        bot.frames(1)
    end
    error("expected the phase " .. phase)
end

local plays = {
    heist = function()
        await("planning")
        local heist = require("contracts/heist")
        local at = heist.center(heist.bodyOf(2))
        bot.stand(at + Vec(0, 0, 1.2), at)
        bot.press("e")
        bot.choose("timebomb")
        bot.stand(Vec(45.4, 0.1, 38), Vec(45.4, 0.4, 35))
        bot.press("lmb")
        bot.frames(100)
    end,
    demolition = function()
        await("running")
        bot.choose("remotebomb")
        bot.stand(Vec(28.2, 0.1, 40.2), Vec(28.2, 0.6, 38.2))
        bot.press("lmb")
        bot.choose("timebomb")
        bot.stand(Vec(31.2, 0.1, 37), Vec(29.4, 0.5, 37))
        bot.press("lmb")
        bot.choose("remotebomb")
        bot.press("rmb")
        bot.frames(6)
    end,
}

local function savesAndGoesOn(id)
    plays[id]()
    progress.savedAt = progress.steps
    SaveGame("middle")
    bot.frames(kLater + 10)
    bot.expect(LoadGame("middle"), "a saved game")
    bot.frames(3)
    error("expected the saved game to be loaded")
end

local next = {[""] = "heist", heist = "demolition"}

local function begin(id)
    SetString("game.contract", id)
    RestartLevel()
    bot.frames(3)
    error("expected the level to begin again")
end

-- The key outlives the load, as all options do.
function update()
    progress.steps = progress.steps + 1
    if progress.savedAt == 0 or progress.steps ~= progress.savedAt + kLater then return end
    local id = GetString("game.contract")
    local key = "options.digest." .. id
    local now, before = digest(), GetString(key)
    if before == "" then return SetString(key, now) end
    print("first  " .. before)
    print("loaded " .. now)
    bot.play(function()
        bot.expect(now == before, "the saved game to go on the same")
        if next[id] then begin(next[id]) end
    end)
end

function onLoad() end

bot.play(function()
    local id = GetString("game.contract")
    if progress.savedAt > 0 then return bot.frames(kLater + 60), error("expected a comparison") end
    if id == "" then begin("heist") end
    savesAndGoesOn(id)
end)

function tick()
    bot.tick()
end
