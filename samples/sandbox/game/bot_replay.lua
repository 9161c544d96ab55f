-- A test: blows a wall up, sees it again from elsewhere, moves through time, and comes back to the game as it was.
local bot = require("bots/hands")
SetString("options.volume", "0")  -- nothing is computed for the ear

local function build()
    CreateModel({size = {80, 2, 80}, voxel = 0.5, origin = {40, 2, 40}, boxes = {{0, 0, 0, 79, 1, 79, 1}},
        palette = {{0.5, 0.5, 0.5, material = "concrete"}}}, Transform(Vec(50, 0, 50)), false)
    CreateModel({size = {60, 30, 4}, origin = {30, 0, 2}, boxes = {{0, 0, 0, 59, 29, 3, 1}},
        palette = {{0.65, 0.3, 0.22, material = "brick"}}}, Transform(Vec(50, 0, 42)), false)
    bot.stand(Vec(50, 0, 50), Vec(50, 1.5, 42))
end

local function ago()
    return tonumber(GetString("game.replay"))
end

local function destroy()
    bot.choose("rocket")
    bot.press("lmb")
    bot.frames(40)
    MakeHole(Vec(48, 0.8, 42), 0.5, 0.5, 0.5)
    Explosion(Vec(52, 1, 42.5), 1.2)
    bot.frames(110)
end

local function looksAgain()
    local first = ago()
    bot.expect(first > 3 and first < 30, "some seconds, found " .. first)
    bot.frames(60)
    bot.expect(math.abs(first - ago() - 1) < 0.1, "a second to pass in a second")
    local camera = GetCameraTransform().pos
    bot.hold("a", 60)
    bot.expect(VecLength(GetCameraTransform().pos - camera) > 3, "the camera to fly")
    bot.press("return")
    local still = ago()
    bot.frames(10)
    bot.expect(ago() == still, "time to stand still")
    bot.image("replay-paused")
    bot.press("rightarrow")
    bot.expect(math.abs(still - ago() - 0.5) < 1e-3, "half a second forth")
    bot.press("leftarrow")
    bot.press("leftarrow")
    bot.expect(math.abs(ago() - still - 0.5) < 1e-3, "half a second back")
    bot.press("return")
    bot.press("downarrow")
    bot.press("downarrow")
    local slow = ago()
    bot.frames(60)
    bot.expect(math.abs(slow - ago() - 0.25) < 0.05, "a quarter of the speed")
    bot.press("uparrow")
    bot.press("uparrow")
    AddInput("mousewheel", 5)
    bot.hold("rightarrow", 120)
    bot.expect(ago() == 0, "the end")
    bot.image("replay-end")
    bot.press("backspace")
    bot.expect(ago() > first - 0.3, "the beginning")
    bot.image("replay-begin")
end

-- Frames in which the world stands still: its hash is that of the pause, until the game goes on.
local function leave(hash)
    bot.expect(GetStateHash() == hash, "the world to stand still")
    SetInput("esc", true)
    bot.frames(2)
    bot.expect(GetStateHash() == hash, "the game as it was left")
    SetInput("esc", false)
    bot.frames(3)
    bot.expect(GetString("game.menu") == "" and GetStateHash() ~= hash, "the game to go on")
end

bot.play(function()
    bot.frames(3)
    bot.press("return")
    build()
    destroy()
    bot.press("esc")
    local hash, feet = GetStateHash(), GetPlayerTransform().pos
    for _ = 1, 6 do bot.press("downarrow") end
    bot.press("return")
    bot.expect(GetString("game.menu") == "replay", "the replay")
    looksAgain()
    leave(hash)
    bot.expect(VecLength(GetPlayerTransform().pos - feet) < 1e-6, "the player where he was")
    bot.image("replay-after")
    SetString("options.replay", "off")
    require("options").apply("replay")
    bot.press("b")
    bot.expect(GetString("game.menu") == "", "no replay where none is kept")
end)

function tick()
    bot.tick()
end
