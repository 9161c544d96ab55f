-- Plays for "options.bot.seconds" of game time (600): freely, a demolition and a heist in turn, a third of a round each,
-- with each tool, each row of each menu, saves, loads, undo and restarts. It says when each tenth begins; errors of
-- scripts end it. What it must remember over loads and restarts are options, as only these outlive both.
local bot = require("bots/hands")

local kTools = {"sledge", "axe", "pistol", "shotgun", "rocket", "timebomb", "remotebomb", "blowtorch", "extinguisher",
    "spray", "hands", "plank", "rope", "vacuum", "gravitygun", "laser", "drill"}
local kIds = {"", "demolition", "heist"}
local seconds = HasKey("options.bot.seconds") and GetFloat("options.bot.seconds") or 600
local total, part = math.floor(60 * seconds), math.max(240, math.floor(60 * seconds / 12))
local frame = GetInt("options.bot.frame")
local deed = GetInt("options.bot.deed")  -- how many things were done, which also says what comes next
local seed = 12345 + frame

local function random(count)
    seed = (seed * 1103515245 + 12345) & 0x7fffffff
    return seed // 65536 % count + 1
end

local function remember()
    SetInt("options.bot.frame", frame)
    SetInt("options.bot.deed", deed)
end

local function image(name)
    if GetBool("options.bot.seen." .. name) then return end
    SetBool("options.bot.seen." .. name, true)
    bot.image("long-" .. name)
end

local places = {{Vec(15.4, 0.1, 35.6), Vec(18.3, 1.5, 34.8)}, {Vec(40.5, 0.1, 40.5), Vec(41.2, 1.5, 36.4)},
    {Vec(19.0, 0.1, 47.0), Vec(19.4, 0.75, 44.2)}, {Vec(21.6, 0.1, 51.0), Vec(21.4, 0.6, 48.4)},
    {Vec(24.2, 0.3, 42.6), Vec(24.2, 1.5, 38)}, {Vec(50.8, 0.1, 28.2), Vec(50, 1.6, 25)},
    {Vec(28.2, 0.1, 40.6), Vec(28.2, 0.8, 38)}}

local function useTool(id)
    local place = places[random(#places)]
    bot.stand(place[1], place[2])
    for _ = 1, 20 do
        if GetString("game.tool") == id then break end
        AddInput("mousewheel", -1)
        bot.frames(2)
    end
    bot.frames(15)
    SetInput("lmb", true)
    for i = 1, 40 do
        AddInput("mousedx", 8 * math.sin(i / 4))
        AddInput("mousedy", 5 * math.cos(i / 5))
        if i == 12 then image("tool-" .. id) end
        bot.frames(1)
    end
    SetInput("lmb", false)
    bot.press("rmb")
    bot.press("e")
    if random(3) == 1 then bot.press("r") end
    bot.hold(({"w", "a", "s", "d", "space", "ctrl"})[random(6)], 10 + random(20))
end

local function undo()
    SetInput("ctrl", true)
    bot.press("z")
    SetInput("ctrl", false)
end

local function looks()
    bot.press("f1")
    image("keys")
    bot.press("f1")
    bot.press("b")
    bot.frames(20)
    image("replay")
    bot.press("esc")
    bot.press("h")
    bot.press("h")
    bot.press("flashlight")
    bot.press("v")
    bot.hold("space", 20)
    bot.press("v")
    SetInput("tab", true)
    bot.frames(3)
    AddInput("mousedx", 60 * random(9) - 300)
    AddInput("mousedy", 60 * random(9) - 300)
    bot.frames(3)
    image("wheel-" .. (GetString("game.contract") == "demolition" and "limited" or "all"))
    SetInput("tab", false)
    bot.frames(3)
end

-- Each option up and down again, by keys, and one by the mouse.
local function settings()
    bot.press("esc")
    image("pause")
    for _ = 1, 3 do bot.press("downarrow") end
    bot.press("return")
    image("settings")
    for row = 1, 10 do
        if row ~= 7 or random(4) == 1 then  -- the picture's renderer is made anew: not each time
            bot.press("rightarrow")
            bot.press("leftarrow")
        end
        bot.press("downarrow")
    end
    SetCursor(UiCenter() + 340, UiMiddle())
    bot.press("lmb")
    bot.press("esc")
    bot.press("esc")
    for _ = 1, 4 do
        if GetString("game.menu") ~= "" then bot.press("esc") end
    end
    bot.expect(GetString("game.menu") == "", "to play again, not " .. GetString("game.menu"))
end

local function large()
    SetFloat("options.textsize", 1.8)
    bot.frames(2)
    image("large-" .. (GetString("game.contract") == "" and "free" or GetString("game.contract")))
    bot.press("esc")
    image("large-pause")
    bot.press("esc")
    SetFloat("options.textsize", 1)
end

-- What is played of a contract itself.
local function playContract(id)
    if id == "demolition" then
        bot.stand(Vec(28.2, 0.1, 40.2), Vec(28.2, 0.6, 38.2))
        for _ = 1, 3 do
            bot.press("lmb")
            AddInput("mousedx", 120)
            bot.frames(3)
        end
        image("demolition")
        bot.press("rmb")
        bot.frames(20)
        image("demolition-blast")
    elseif id == "heist" then
        local heist = require("contracts/heist")
        for i = 1, 6 do
            local body = heist.bodyOf(i)
            if body ~= 0 then
                local at = heist.center(body)
                bot.stand(at + Vec(0, -0.6, 1.3), at)
                image("heist-" .. i)
                bot.press("e")
            end
        end
        local exit = require("levels/house").exit
        SetPlayerTransform(Transform(VecLerp(exit[1], exit[2], 0.5)))
        bot.frames(30)
    end
end

local function result()
    if GetString("game.menu") ~= "result" then return end
    image("result-" .. GetString("game.contract") .. "-" .. GetString("contract.phase"))
    bot.press("downarrow")
    bot.press("return")
    bot.expect(GetString("game.menu") == "", "to look around")
end

-- Where a contract ends meanwhile its screen takes the keys; else a load begins the bot again.
local function saveAndLoad()
    result()
    bot.press("f5")
    bot.frames(30)
    result()
    remember()
    bot.press("f9")
    bot.frames(5)
    bot.expect(GetString("game.menu") == "result", "the saved game to be loaded")
end

local function title()
    bot.frames(10)
    image("title")
    bot.press("downarrow")
    bot.press("return")
    image("brief-demolition")
    bot.press("downarrow")
    bot.press("return")
    bot.press("downarrow")
    bot.press("return")
    image("brief-heist")
    bot.press("esc")
    bot.press("downarrow")
    bot.press("downarrow")
    bot.press("return")
    bot.expect(GetString("game.menu") == "settings", "the settings of the title")
    bot.press("esc")
    for _ = 1, 4 do bot.press("uparrow") end
    bot.press("return")
    bot.expect(GetString("game.menu") == "", "a game that has begun")
end

local function restart(id)
    remember()
    if id == "" then ClearKey("game.contract") else SetString("game.contract", id) end
    SetInt("options.bot.end", frame + part)
    RestartLevel()
    bot.frames(5)
    bot.expect(false, "the level to begin again")
end

local function play()
    bot.frames(3)
    if GetString("game.menu") == "title" then title() end
    local id = GetString("game.contract")
    for _ = 1, 200 do
        local phase = GetString("contract.phase")
        if id == "" or phase ~= "" and phase ~= "building" then break end
        bot.frames(1)
    end
    local last = GetInt("options.bot.end")
    if last == 0 then last = part end
    while frame < last and frame < total do
        deed = deed + 1
        result()
        local kind = deed % 24
        if kind == 5 then looks()
        elseif kind == 9 then settings()
        elseif kind == 12 then undo()
        elseif kind == 14 then playContract(id)
        elseif kind == 18 then large()
        elseif kind == 21 then saveAndLoad()
        else useTool(kTools[deed % #kTools + 1]) end
    end
    result()
    if frame >= total then return image("end") end
    restart(kIds[(frame // part) % #kIds + 1])
end

function onLoad() end

bot.play(play)

function tick()
    frame = frame + 1
    if frame % (total // 10) == 0 then
        local voxels = #FindShapes()
        print(string.format("tenth %d: %s, %d bodies, %d shapes", frame // (total // 10), GetString("game.contract"),
            #FindBodies(), voxels))
    end
    remember()
    bot.tick()
end
