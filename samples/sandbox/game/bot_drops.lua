-- A test: files of the folder "options.drops" are dropped on the window. "options.models" names those that can be placed.
local bot = require("bots/hands")
SetString("options.volume", "0")  -- nothing is computed for the ear

local folder = GetString("options.drops") .. "/"
local feet = Vec(50, 0, 60)

local function build()
    CreateModel({size = {120, 2, 120}, voxel = 0.5, origin = {60, 2, 60}, boxes = {{0, 0, 0, 119, 1, 119, 1}},
        palette = {{0.5, 0.5, 0.5, material = "concrete"}}}, Transform(Vec(50, 0, 50)), false)
    bot.stand(feet, feet + Vec(0, 0, -9))
end

local function placed()
    return #FindBodies("placed")
end

local function drop(file)
    DropFile(folder .. file)
    bot.frames(3)
end

-- It stands before the eyes at once, is put down, and taken back.
local function places(file)
    drop(file)
    local name = GetString("game.placing")
    bot.expect(name ~= "", file .. " to be placed, found " .. GetString("game.message"))
    bot.look(feet + Vec(0, 0, -9))
    bot.frames(4)
    bot.expect(#FindBodies("ghost") > 0, "an image of " .. file)
    bot.image("drop-" .. file:gsub("%W", "-"))
    local before = placed()
    bot.press("lmb")
    bot.press("rmb")
    bot.frames(10)
    bot.expect(placed() > before, file .. " to stand there, found " .. GetString("game.message"))
    bot.image("dropped-" .. file:gsub("%W", "-"))
    SetInput("ctrl", true)
    bot.press("z")
    SetInput("ctrl", false)
    bot.frames(4)
    bot.expect(placed() == before, file .. " to be gone again")
end

-- Says why, and nothing else changes.
local function refuses(file, why)
    local before = GetDropCount()
    drop(file)
    local message = GetString("game.message")
    bot.expect(GetDropCount() == before + 1 and message:find(why), file .. ": " .. why .. ", found " .. message)
    bot.expect(GetString("game.placing") == "" and GetString("game.dropped") == "", "nothing to place")
end

bot.play(function()
    bot.frames(3)
    bot.press("return")
    build()
    refuses("nothing.vox", "nothing.vox: expected a file, found none")
    refuses("folder.vox", "folder.vox: expected a file, found another thing")
    refuses("text.txt", "text.txt: expected a .vox, .vdb, .rubble or .lua file")
    refuses("broken.vox", "^broken.vox: ")
    refuses("broken.rubble", "^broken.rubble: ")
    refuses("syntax.lua", "syntax.lua:1: ")
    refuses("empty.lua", "expected a text that can be read, found nothing")
    refuses("number.lua", "number.lua: expected {name =, pieces =}, found number")
    refuses("fails.lua", "attempt to")
    refuses("acts.lua", "global 'QuitGame'")
    refuses("loops.lua", "loops.lua:1: the script wanted more")
    refuses("grows.lua", "the script wanted more")
    refuses("model.lua", "model.lua: expected {name =, pieces =}, found piece 1 without a model")
    drop("large.lua")
    bot.frames(10)
    local message = GetString("game.message")
    bot.expect(message:find("^large.lua: CreateModel: size: expected") and GetString("game.placing") == "",
        "no image of it, found " .. message)
    drop("odd.lua")
    bot.look(feet + Vec(0, 0, -9))
    bot.frames(4)
    bot.press("lmb")
    message = GetString("game.message")
    bot.expect(message:find("^odd.lua: CreateModel: expected a material"), "a name of its file, found " .. message)
    bot.expect(placed() == 0, "no piece of it")
    bot.press("rmb")
    for file in GetString("options.models"):gmatch("%S+") do places(file) end
    bot.press("q")
    bot.press("uparrow")
    for _ = 1, 8 do
        if GetInt("game.folder") ~= 5 then
            AddInput("mousewheel", -1)
            bot.frames(3)
        end
    end
    bot.expect(GetInt("game.folder") == 5, "a folder of what was dropped")
    local names = GetString("game.dropped")
    for _ = 1, 1000 do
        if "Large " .. GetString("game.pictured") ~= names then bot.frames(1) end
    end
    bot.image("drop-menu")
    bot.expect("Large " .. GetString("game.pictured") == names, "small images of all but one")
    bot.press("rightarrow")
    bot.press("return")
    bot.expect(GetString("game.placing") == names:match("%S+ (%S+)"), "the second one to be placed")
    local first = GetString("options.models"):match("%S+")
    drop(first)
    bot.expect(GetString("game.dropped") == names, "one that comes again to take its own place")
    for key, menu in pairs({p = "photo", b = "replay", esc = "pause"}) do
        bot.press("rmb")
        bot.press(key)
        bot.expect(GetString("game.menu") == menu, menu .. ", found " .. GetString("game.menu"))
        drop(first)
        bot.expect(GetString("game.placing") == "" and GetString("game.menu") == menu, menu .. " to stay open")
        bot.press("esc")
        bot.expect(GetString("game.menu") == "" and GetString("game.placing") ~= "", "a thing to place after " .. menu)
    end
end)

function tick()
    bot.tick()
end
