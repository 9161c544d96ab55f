-- Plays in the town with each tool and each menu, and writes an image of each.
local bot = require("bots/hands")

local wall = {Vec(19.0, 0.1, 47.0), Vec(19.4, 0.75, 44.2)}      -- low, of concrete
local house = {Vec(15.4, 0.1, 35.6), Vec(18.3, 1.5, 34.8)}      -- brick in the sun
local shop = {Vec(40.5, 0.1, 40.5), Vec(41.2, 1.5, 36.4)}       -- glass
local intact = {Vec(15.4, 0.1, 31.4), Vec(18.3, 1.5, 31.2)}     -- another place of that wall
local wood = {Vec(33.2, 0.1, 49.6), Vec(33.2, 0.45, 48)}        -- a crate
local close = {Vec(17.2, 0.1, 45.9), Vec(17.2, 0.75, 44.2)}     -- the low wall
local car = {Vec(21.6, 0.1, 51.0), Vec(21.4, 0.6, 48.4)}

-- Each tool: where, how long the button is held, and after how many frames the image of its use is taken.
local uses = {
    {"sledge", house, 60, 22}, {"axe", wood, 60, 20}, {"pistol", shop, 20, 6}, {"shotgun", shop, 20, 8},
    {"rocket", house, 4, 34}, {"vacuum", house, 90, 30}, {"timebomb", car, 4, 186},
    {"blowtorch", car, 80, 50}, {"extinguisher", car, 80, 50},
    {"laser", wall, 60, 40}, {"drill", close, 70, 50},
}

-- A crate to carry.
local function makeCrate(pos)
    local boxes = {{0, 0, 0, 5, 5, 5, 1}}
    for _, i in ipairs({0, 5}) do
        for _, k in ipairs({0, 5}) do
            boxes[#boxes + 1] = {0, i, k, 5, i, k, 2}
            boxes[#boxes + 1] = {i, 0, k, i, 5, k, 2}
            boxes[#boxes + 1] = {i, k, 0, i, k, 5, 2}
        end
    end
    return CreateModel({voxel = 0.1, size = {6, 6, 6}, boxes = boxes,
        palette = {{0.62, 0.45, 0.27, material = "wood"}, {0.42, 0.29, 0.17, material = "wood"}}},
        Transform(pos, QuatEuler(0, 20, 0)), true)
end

local function use(row)
    local tool, place, frames, at = row[1], row[2], row[3], row[4]
    bot.choose(tool)
    bot.stand(place[1], place[2])
    bot.image(tool .. "-1")
    SetInput("lmb", true)
    for i = 1, math.max(frames, at) + 1 do
        if i == frames then SetInput("lmb", false) end
        if i == at then Screenshot(tool .. "-2.png") end
        if tool == "laser" or tool == "drill" and i % 20 == 0 then AddInput("mousedx", 2) end
        bot.frames(1)
    end
    bot.frames(110)
    bot.image(tool .. "-3")
end

local function menus()
    bot.frames(30)
    bot.image("title")
    bot.press("return")
    bot.expect(GetString("game.menu") == "", "a game that has begun")
    bot.frames(40)
    bot.image("play")
    bot.press("f1")
    bot.image("keys")
    bot.press("f1")
    SetInput("tab", true)
    bot.frames(3)
    AddInput("mousedx", 200)
    AddInput("mousedy", 160)
    bot.frames(4)
    bot.image("radial")
    SetInput("tab", false)
    bot.frames(4)
    bot.press("esc")
    bot.expect(GetString("game.menu") == "pause", "the menu")
    bot.image("pause")
    for _ = 1, 3 do bot.press("downarrow") end
    bot.press("return")
    bot.expect(GetString("game.menu") == "settings", "the settings")
    bot.press("downarrow")
    bot.press("rightarrow")
    bot.image("settings")
    bot.press("esc")
    bot.press("esc")
    bot.expect(GetString("game.menu") == "", "to play again")
end

local function spray()
    bot.choose("spray")
    bot.stand(wall[1], wall[2])
    bot.press("rmb")
    bot.image("spray-1")
    SetInput("lmb", true)
    for i = 1, 60 do
        AddInput("mousedx", 10 * math.sin(i / 5))
        AddInput("mousedy", 8 * math.cos(i / 5))
        bot.frames(1)
    end
    bot.image("spray-2")
    SetInput("lmb", false)
end

local function bombs()
    bot.choose("remotebomb")
    bot.stand(intact[1], intact[2])
    for i = -1, 1 do
        bot.look(intact[2] + Vec(0, 0.2, 0.9 * i))
        bot.press("lmb")
    end
    bot.frames(10)
    bot.image("remotebomb-1")
    SetInput("rmb", true)
    bot.frames(14)
    bot.image("remotebomb-2")
    SetInput("rmb", false)
    bot.frames(150)
    bot.image("remotebomb-3")
    SetInput("ctrl", true)
    bot.press("z")
    SetInput("ctrl", false)
    bot.frames(10)
    bot.image("undo")
end

local function ties()
    for _, tool in ipairs({"plank", "rope"}) do
        bot.choose(tool)
        bot.stand(intact[1], intact[2])
        bot.look(intact[2] + Vec(0, 0.9, -0.8))
        bot.press("lmb")
        bot.look(intact[2] + Vec(0, -0.5, 0.8))
        bot.image(tool .. "-1")
        bot.press("lmb")
        bot.frames(30)
        bot.image(tool .. "-2")
    end
end

local function carry()
    for i, tool in ipairs({"hands", "gravitygun"}) do
        local at = Vec(30.5 - 2 * i, 0.6, 48.8)
        makeCrate(at)
        bot.choose(tool)
        bot.stand(at + Vec(0.4, -0.5, 2.3), at + Vec(0, -0.2, 0))
        bot.frames(40)
        bot.image(tool .. "-1")
        SetInput("lmb", true)
        bot.frames(20)
        bot.look(at + Vec(0.3, 1.2, 0))
        bot.frames(50)
        bot.image(tool .. "-2")
        if tool == "hands" then
            SetInput("lmb", false)
            bot.frames(3)
            bot.press("lmb")  -- throws
        else
            bot.press("rmb")
            SetInput("lmb", false)
        end
        bot.frames(12)
        bot.image(tool .. "-3")
    end
end

local function lamp()
    bot.stand(Vec(26.4, 0.3, 42.0), Vec(26.55, 2.45, 40.25))
    bot.image("lamp-1")
    bot.press("e")
    bot.frames(10)
    bot.image("lamp-2")
end

bot.play(function()
    menus()
    lamp()
    makeCrate(wood[2])
    for _, row in ipairs(uses) do use(row) end
    spray()
    bombs()
    ties()
    carry()
    bot.stand(Vec(30, 0.2, 54), Vec(24, 3, 36))
    bot.press("v")
    bot.hold("space", 60)
    bot.image("end")
end)

function tick()
    bot.tick()
end
