-- A test: builds a small yard and plays in it with each tool and each menu. Each use must do what the tool is for.
local bot = require("bots/hands")

local kEye = Vec(50, 0, 48)
local brick, wood, crate

local function build()
    local function model(size, material, color)
        return {size = size, voxel = 0.1, origin = {size[1] // 2, 0, size[3] // 2},
            palette = {{color[1], color[2], color[3], material = material}},
            boxes = {{0, 0, 0, size[1] - 1, size[2] - 1, size[3] - 1, 1}}}
    end
    local gray, red, brown = {0.5, 0.5, 0.5}, {0.5, 0.25, 0.2}, {0.5, 0.35, 0.2}
    CreateModel(model({120, 3, 120}, "concrete", gray), Transform(Vec(50, -0.3, 50)), false)
    _, brick = CreateModel(model({60, 30, 3}, "brick", red), Transform(Vec(52, 0, 45)), false)
    _, wood = CreateModel(model({20, 30, 3}, "wood", brown), Transform(Vec(47.5, 0, 45)), false)
    crate = CreateModel(model({5, 5, 5}, "wood", brown), Transform(Vec(50, 0, 46.4)), true)
    bot.stand(kEye, Vec(51.5, 1.4, 45))
end

local function moves()
    bot.stand(Vec(50, 0, 54), Vec(50, 1.65, 40))
    local function feet() return GetPlayerTransform().pos end
    bot.hold("w", 60)
    bot.expect(math.abs(54 - feet().z - 4) < 0.6, "a walk of four metres in a second")
    SetInput("shift", true)
    bot.hold("s", 30)
    SetInput("shift", false)
    bot.expect(feet().z > 52.6, "to run back")
    bot.press("space")
    bot.frames(6)
    bot.expect(feet().y > 0.3, "a jump")
    bot.frames(60)
    bot.expect(feet().y < 0.1, "to land")
    local before = GetPlayerCameraTransform().pos.y
    SetInput("ctrl", true)
    bot.frames(30)
    bot.expect(before - GetPlayerCameraTransform().pos.y > 0.4, "to crouch")
    SetInput("ctrl", false)
    local yaw = GetPlayerLook()
    AddInput("mousedx", 100)
    bot.frames(2)
    bot.expect(math.abs(yaw - GetPlayerLook() - 0.22) < 0.01, "to turn to the right")
    bot.press("v")
    bot.hold("space", 60)
    bot.expect(feet().y > 7, "to fly")
    bot.press("v")
    bot.frames(10)
end

-- Holds the left button at a place with a tool for some frames, and lets some pass.
local function use(tool, target, held, after)
    bot.choose(tool)
    bot.look(target)
    bot.hold("lmb", held)
    bot.frames(after or 10)
end

local function breaks(tool, shape, target, held, after)
    local before = GetShapeVoxelCount(shape)
    bot.stand(kEye, target)
    use(tool, target, held, after)
    local left = IsHandleValid(shape) and GetShapeVoxelCount(shape) or 0
    bot.expect(left < before, tool .. " to remove voxels")
    return before - left
end

local function tools()
    local near = Vec(51.0, 1.4, 45.1)
    kEye = Vec(51, 0, 46.8)
    breaks("sledge", brick, near, 4, 30)
    breaks("drill", brick, Vec(51.6, 1.2, 45.1), 40)
    breaks("laser", brick, Vec(50.6, 2.2, 45.1), 6)
    breaks("pistol", brick, Vec(51.6, 2.2, 45.1), 3)
    breaks("shotgun", brick, Vec(52.2, 1.8, 45.1), 3)
    kEye = Vec(47.5, 0, 46.8)
    breaks("axe", wood, Vec(47.3, 1.6, 45.1), 4, 30)
    bot.stand(kEye, Vec(47.9, 1.2, 45.1))
    use("blowtorch", Vec(47.9, 1.2, 45.1), 90)
    bot.expect(GetFireCount() > 0, "the blowtorch to light a fire")
    use("extinguisher", Vec(47.9, 1.2, 45.1), 60)
    bot.expect(GetFireCount() == 0, "the extinguisher to put it out")
    kEye = Vec(53.5, 0, 47)
    bot.stand(kEye, Vec(53.5, 1.4, 45.15))
    local before = GetShapeVoxelCount(brick)
    use("spray", Vec(53.5, 1.4, 45.15), 12)  -- no script can read paint, which is a layer over the voxels
    bot.expect(GetShapeVoxelCount(brick) == before, "the spray can to remove nothing")
end

local function carriers()
    for _, tool in ipairs({"hands", "gravitygun"}) do
        kEye = Vec(50, 0, 48)
        SetBodyTransform(crate, Transform(Vec(50, 0.05, 46.4)))
        SetBodyVelocity(crate, Vec(0, 0, 0))
        SetBodyAngularVelocity(crate, Vec(0, 0, 0))
        bot.stand(kEye, Vec(50, 0.3, 46.4))
        bot.choose(tool)
        bot.look(Vec(50, 0.3, 46.4))
        SetInput("lmb", true)
        bot.frames(4)
        bot.look(Vec(50, 1.9, 46))
        bot.frames(60)
        bot.expect(GetBodyTransform(crate).pos.y > 0.5, tool .. " to lift a crate")
        bot.press("rmb")
        SetInput("lmb", false)
        bot.frames(40)
        if tool == "hands" then bot.press("e") end
    end
    SetBodyTransform(crate, Transform(Vec(50, 0.05, 46.4)))
end

local function ties()
    kEye = Vec(52, 0, 47.5)
    for _, tool in ipairs({"plank", "rope"}) do
        local before = #FindJoints()
        bot.stand(kEye, Vec(53, 1.2, 45.1))
        use(tool, Vec(53.0, 1.0, 45.1), 3)
        use(tool, Vec(54.0, 1.6, 45.1), 3, 20)
        bot.expect(#FindJoints() > before, tool .. " to hold things together")
    end
end

local function blasts()
    kEye = Vec(54, 0, 51)
    breaks("rocket", brick, Vec(54, 1.4, 45.1), 3, 60)
    local after = GetShapeVoxelCount(brick)
    SetInput("ctrl", true)
    bot.press("z")
    SetInput("ctrl", false)
    bot.frames(5)
    bot.expect(GetShapeVoxelCount(brick) > after, "Ctrl+Z to take back an explosion")
    kEye = Vec(50.5, 0, 47)
    bot.stand(kEye, Vec(50.5, 1.3, 45.1))
    use("remotebomb", Vec(50.5, 1.3, 45.1), 3)
    local before = GetShapeVoxelCount(brick)
    bot.press("rmb")
    bot.frames(20)
    bot.expect(GetShapeVoxelCount(brick) < before, "a remote bomb to go off")
    breaks("timebomb", brick, Vec(53, 0.5, 45.1), 3, 220)
    local bodies = #FindBodies()
    use("vacuum", Vec(50.5, 0.2, 45.6), 60)
    bot.expect(#FindBodies() < bodies, "the vacuum to swallow pieces")
end

local function menus()
    bot.expect(GetString("game.menu") == "title", "a title")
    bot.press("return")
    bot.expect(GetString("game.menu") == "", "a game that has begun")
    SetInput("tab", true)
    bot.frames(3)
    AddInput("mousedx", 300)
    bot.frames(3)
    bot.expect(GetString("game.menu") == "radial", "the wheel of tools")
    local tool = GetString("game.tool")
    SetInput("tab", false)
    bot.frames(4)
    bot.expect(GetString("game.tool") ~= tool, "another tool")
    bot.press("esc")
    bot.expect(GetString("game.menu") == "pause", "the menu")
    bot.image("pause")
    for _ = 1, 3 do bot.press("downarrow") end
    bot.press("return")
    bot.expect(GetString("game.menu") == "settings", "the settings")
    for _ = 1, 5 do bot.press("downarrow") end
    for _ = 1, 9 do bot.press("leftarrow") end
    bot.expect(GetFloat("options.volume") == 0, "no sound")
    bot.frames(10)
    for _ = 1, 8 do bot.press("rightarrow") end
    bot.expect(math.abs(GetFloat("options.volume") - 0.8) < 1e-6, "sound again")
    for _ = 1, 3 do bot.press("downarrow") end
    bot.press("leftarrow")
    bot.expect(GetFloat("world.gravity") == 9, "less gravity")
    bot.press("rightarrow")
    bot.press("esc")
    bot.press("esc")
    bot.expect(GetString("game.menu") == "", "to play again")
end

-- Each undo takes back one deed more.
local function undoes()
    local counts = {GetShapeVoxelCount(brick)}
    for i = 1, 3 do
        AddUndoMark()
        MakeHole(Vec(50 + i, 2.5, 45.1), 0.3, 0.3)
        bot.frames(20)
        counts[i + 1] = GetShapeVoxelCount(brick)
        bot.expect(counts[i + 1] < counts[i], "a hole")
    end
    for i = 3, 1, -1 do
        bot.expect(Undo(), "an undo")
        bot.frames(20)
        bot.expect(GetShapeVoxelCount(brick) == counts[i], "the wall before hole " .. i)
    end
end

-- Names that would be files elsewhere, or of others, are refused.
local function names()
    for _, name in ipairs({"", "../a", "a/b", "a b", "\u{4e00}"}) do
        bot.expect(not pcall(SaveGame, name) and not pcall(HasSave, name), "no save called " .. name)
        bot.expect(not pcall(Screenshot, name .. ".png"), "no image called " .. name)
    end
    bot.expect(not pcall(Screenshot, "options.txt"), "images alone")
end

-- What nobody can have chosen counts as not chosen; who falls out of the level comes back.
local function mishaps()
    local options = require("options")
    for id, default in pairs({fov = 68, volume = 0.8, textsize = 1}) do
        local was = GetString("options." .. id)
        for _, wrong in ipairs({"nan", "inf", "-1e30", "text"}) do
            SetString("options." .. id, wrong)
            local value = options.get(id)
            bot.expect(value == value and value >= 0 and value <= 100, id .. " of a damaged file")
            bot.expect(wrong == "-1e30" or value == default, "the first " .. id)
        end
        if was == "" then ClearKey("options." .. id) else SetString("options." .. id, was) end
    end
    SetPlayerTransform(Transform(Vec(45, -500, 55)))
    bot.frames(10)
    bot.expect(GetPlayerTransform().pos.y > -1, "to be back in the level")
end

-- After a load the scripts begin again, this one too: onLoad() goes on.
local progress = saved("progress", {isSaved = false})

local function saves()
    progress.isSaved = true
    bot.press("f5")
    bot.expect(HasSave("quick"), "a saved game")
    bot.stand(Vec(45, 0, 55), Vec(50, 1, 45))
    bot.press("f9")
    bot.frames(3)
    error("expected the saved game to be loaded")
end

local function checkLoad()
    bot.frames(3)
    bot.expect(GetString("game.menu") == "", "to play on")
    bot.expect(GetPlayerTransform().pos.z < 54, "the player where the game was saved")
    bot.expect(GetString("game.tool") == "vacuum", "the tool that was in the hand")
    bot.expect(#FindBodies("viewmodel") <= 1, "one model before the eyes")
    bot.press("esc")
    SetFloat("options.volume", 0.5)  -- the file of options has another one since the load
    for _ = 1, 4 do bot.press("downarrow") end
    bot.press("return")
    bot.frames(3)
    error("expected the level to begin again")
end

local function checkRestart()
    bot.frames(5)
    bot.expect(GetString("game.menu") == "", "no title again")
    bot.expect(GetFloat("options.volume") == 0.5, "the options that were chosen before")
    bot.expect(#FindBodies() == 2, "the level as it was, and the model of a tool")
end

function onLoad()
    bot.play(checkLoad)
end

if GetBool("game.restarted") then
    bot.play(checkRestart)
elseif not progress.isSaved then bot.play(function()
    bot.frames(3)
    menus()
    build()
    undoes()
    moves()
    tools()
    carriers()
    ties()
    blasts()
    bot.image("end")
    names()
    mishaps()
    saves()
end) end

function tick()
    bot.tick()
end
