-- A test: plays by a gamepad, binds keys, places each thing and takes it back, and takes a photo. With the key
-- "options.images" it places all there is, and writes images.
local bot = require("bots/hands")
SetString("options.volume", "0")  -- nothing is computed for the ear

local isLong = HasKey("options.images")

local function image(name)
    if isLong then bot.image("menus-" .. name) end
end

local function build()
    CreateModel({size = {120, 2, 120}, voxel = 0.5, origin = {60, 2, 60}, boxes = {{0, 0, 0, 119, 1, 119, 1}},
        palette = {{0.5, 0.5, 0.5, material = "concrete"}}}, Transform(Vec(50, 0, 50)), false)
    bot.stand(Vec(50, 0, 50), Vec(50, 1.65, 40))
end

-- A button of the gamepad, as a thumb presses it.
local function tap(button)
    SetGamepad({[button] = true})
    bot.frames(3)
    SetGamepad({})
    bot.frames(3)
end

local function gamepad()
    bot.expect(GetString("game.menu") == "title", "a title")
    tap("a")
    bot.expect(GetString("game.menu") == "", "A to begin")
    build()
    local before = GetPlayerTransform().pos.z
    SetGamepad({ly = -1})
    bot.frames(60)
    local far = before - GetPlayerTransform().pos.z
    bot.expect(math.abs(far - 4) < 0.6, "a stick to walk four metres, found " .. far)
    SetGamepad({ly = -0.5})
    bot.frames(60)
    local slow = before - far - GetPlayerTransform().pos.z
    bot.expect(slow > 1 and slow < 2.4, "half a stick to walk half as far, found " .. slow)
    SetGamepad({ly = 0.1, rx = 0.1})
    bot.frames(5)
    local yaw, at = GetPlayerLook(), GetPlayerTransform().pos
    bot.frames(20)
    bot.expect(GetPlayerLook() == yaw and VecLength(GetPlayerTransform().pos - at) < 1e-3, "a stick at rest to rest")
    SetGamepad({rx = 1})
    bot.frames(10)
    SetGamepad({})
    bot.expect(GetPlayerLook() < yaw - 0.2, "the right stick to turn to the right")
    local tool = GetString("game.tool")
    tap("rb")
    bot.expect(GetString("game.tool") ~= tool, "RB to take the next tool")
    tap("lb")
    bot.expect(GetString("game.tool") == tool, "LB to take the one before")
    tap("start")
    bot.expect(GetString("game.menu") == "pause", "Start to open the menu")
    tap("b")
    bot.expect(GetString("game.menu") == "", "B to close it")
    image("pad")
end

local function toKeys()
    bot.press("esc")
    for _ = 1, 3 do bot.press("downarrow") end
    bot.press("return")
    for _ = 1, 10 do bot.press("downarrow") end
    bot.press("return")
    bot.expect(GetString("game.menu") == "keys", "the page of keys")
end

local function leaveMenus()
    for _ = 1, 4 do
        if GetString("game.menu") ~= "" then bot.press("esc") end
    end
end

local function bindings()
    local keys = require("keys")
    toKeys()
    image("keys")
    for _ = 1, 4 do bot.press("downarrow") end  -- to jumping
    bot.press("return")
    image("keys-waits")
    bot.press("j")
    bot.expect(GetString("options.key.jump") == "j", "J to jump")
    bot.press("return")
    bot.press("e")
    bot.expect(GetString("options.key.jump") == "e", "E to jump")
    image("keys-conflict")
    bot.expect(keys.conflict("jump", "key") and keys.conflict("interact", "key"), "a conflict to be shown at both")
    bot.press("return")
    SetInput("ctrl", true)
    bot.frames(3)
    bot.press("k")
    SetInput("ctrl", false)
    bot.frames(3)
    bot.expect(GetString("options.key.jump") == "ctrl+k", "two keys at a time")
    bot.press("backspace")
    bot.expect(not HasKey("options.key.jump"), "the key of before")
    bot.press("return")
    bot.press("j")
    bot.press("rightarrow")
    bot.press("return")
    tap("y")
    bot.expect(GetString("options.pad.jump") == "pady", "Y to jump")
    bot.press("return")
    bot.press("esc")
    bot.expect(GetString("game.menu") == "keys" and GetString("options.pad.jump") == "pady", "Esc to leave it")
    leaveMenus()
    bot.stand(Vec(50, 0, 50), Vec(50, 1.65, 40))
    bot.press("space")
    bot.frames(8)
    bot.expect(GetPlayerTransform().pos.y < 0.1, "Space to do nothing")
    bot.press("j")
    bot.frames(6)
    bot.expect(GetPlayerTransform().pos.y > 0.3, "J to jump")
    bot.frames(60)
    for _, wrong in ipairs({"nonsense", "", "pada", "ctrl+", "+"}) do
        SetString("options.key.jump", wrong)
        keys.apply()
        bot.expect(keys.of("jump", "key") == "space", wrong .. " to count as not chosen")
    end
    keys.resetAll()
    bot.press("space")
    bot.frames(6)
    bot.expect(GetPlayerTransform().pos.y > 0.3, "Space to jump again")
    bot.frames(60)
end

local function pick(folder, thing)
    bot.press("q")
    bot.expect(GetString("game.menu") == "spawn", "the menu of things")
    bot.press("leftarrow")
    bot.frames(2)
    for _ = 1, 4 do bot.press("leftarrow") end
    local things = require("things")
    for _ = 1, #things.folders do
        if GetInt("game.folder") == folder then break end
        bot.press("downarrow")
    end
    bot.press("rightarrow")
    for _ = 2, thing do bot.press("rightarrow") end
    bot.frames(3)
end

local function bodies()
    local count = 0
    for _, body in ipairs(FindBodies()) do
        if not HasTag(body, "ghost") and not HasTag(body, "viewmodel") then count = count + 1 end
    end
    return count
end

local function undo()
    SetInput("ctrl", true)
    bot.press("z")
    SetInput("ctrl", false)
    bot.frames(4)
end

-- A thing of each folder, or all: each is placed, stands there, and is gone after an undo.
local function placeAll()
    local things = require("things")
    local feet = Vec(50, 0, 60)
    for f, folder in ipairs(things.folders) do
        for t, thing in ipairs(folder.things) do
            if not isLong and t ~= f then goto next end
            pick(f, t)
            if t == #folder.things then
                bot.frames(#folder.things)
                image("things-" .. f)
            end
            bot.press("return")
            bot.expect(GetString("game.placing") == thing.name, thing.name .. " to be placed")
            bot.stand(feet, feet + Vec(0, -0.2, -7))
            local before = bodies()
            bot.expect(#FindBodies("ghost") == #things.pieces(thing), "an image of " .. thing.name)
            AddInput("mousewheel", 1)
            bot.frames(4)
            if t == 1 then image("place-" .. f) end
            bot.press("lmb")
            bot.press("rmb")
            bot.frames(12)
            bot.expect(#FindBodies("ghost") == 0, "no image any more")
            bot.expect(bodies() == before + #things.pieces(thing), thing.name .. " to stand there")
            if t % 3 == 2 then image("placed-" .. f .. "-" .. t) end
            undo()
            bot.expect(bodies() == before, thing.name .. " to be gone again")
            ::next::
        end
    end
end

-- What is in the way is not built over; what is explosive goes off when it is hit, and sets off its neighbour.
local function explosive()
    local feet = Vec(40, 0, 60)
    pick(1, 3)
    bot.press("return")
    bot.stand(feet, feet + Vec(0, 0, -4.5))
    bot.press("lmb")
    bot.frames(5)
    local before = bodies()
    bot.look(feet + Vec(0.4, 0, -4.5))
    bot.press("lmb")
    bot.expect(bodies() == before, "no second one in the same place")
    bot.look(feet + Vec(0.9, 0, -4.5))
    bot.press("lmb")
    bot.expect(bodies() == before + 1, "another one beside it")
    bot.press("rmb")
    bot.frames(30)
    bot.expect(#FindShapes("explosive") == 2, "two of them")
    MakeHole(feet + Vec(0, 0.5, -4.4), 0.3, 0.3, 0.3)
    bot.frames(40)
    bot.expect(#FindShapes("explosive") == 0, "both to have gone off, found " .. #FindShapes("explosive"))
end

local function photo()
    bot.stand(Vec(50, 0, 50), Vec(50, 1.2, 40))
    local body = CreateModel({size = {5, 5, 5}, boxes = {{0, 0, 0, 4, 4, 4, 1}},
        palette = {{0.6, 0.4, 0.2, material = "wood"}}}, Transform(Vec(50, 4, 46)), true)
    bot.frames(4)
    local air = GetEnvironment()
    bot.press("p")
    bot.expect(GetString("game.menu") == "photo", "the photo")
    bot.frames(4)
    local at, hash = GetBodyTransform(body).pos, GetStateHash()
    bot.hold("w", 20)
    image("photo")
    bot.expect(VecLength(GetBodyTransform(body).pos - at) == 0 and GetStateHash() == hash, "the world to stand still")
    bot.expect(#FindBodies("viewmodel") == 0, "no tool before the eyes")
    local camera = GetCameraTransform().pos
    bot.expect(VecLength(camera - Vec(50, 1.65, 50)) > 0.8, "the camera to fly")
    for _ = 1, 3 do bot.press("downarrow") end
    for _ = 1, 4 do bot.press("rightarrow") end
    bot.expect(GetEnvironment().sunDirection.y ~= air.sunDirection.y, "another sun")
    bot.expect(VecLength(GetBodyTransform(body).pos - at) == 0, "light without time")
    image("photo-sun")
    bot.press("return")
    bot.expect(GetInt("options.photos") == 1, "an image")
    bot.press("esc")
    bot.frames(5)
    local now = GetEnvironment()
    for key, value in pairs(air) do
        bot.expect(type(value) == "table" and VecLength(value - now[key]) < 1e-9 or value == now[key], key .. " as before")
    end
    bot.expect(GetBodyTransform(body).pos.y < at.y, "time to go on")
end

-- An image of another size than the window's: all stays as it is meanwhile, and memory is free after it.
local function still()
    local function drawSome()
        for _ = 1, 8 do bot.image("small") end
    end
    drawSome()
    local memory = GetDrawMemory()
    bot.press("p")
    bot.frames(4)
    bot.press("uparrow")
    bot.press("rightarrow")
    bot.expect(GetInt("options.stills") == 2, "another size")
    local hash, camera = GetStateHash(), GetCameraTransform().pos
    bot.press("return")
    SetInput("w", true)
    AddInput("mousedx", 100)
    local frames, seen = 0, 0
    while GetScreenshotProgress() < 1 do
        frames, seen = frames + 1, math.max(seen, GetDrawMemory())
        bot.frames(1)
    end
    SetInput("w", false)
    bot.expect(frames > 8 and frames < 20, "some frames, found " .. frames)
    bot.expect(VecLength(GetCameraTransform().pos - camera) < 0.2, "the camera to stay")
    bot.expect(GetStateHash() == hash, "the world to stand still")
    bot.expect(seen > 2 * memory, "larger targets meanwhile, found " .. seen .. " after " .. memory)
    bot.press("esc")
    drawSome()
    bot.expect(GetDrawMemory() <= 1.02 * memory, "no more memory than before, found " .. GetDrawMemory() .. " after "
        .. memory)
    SetInt("options.stills", 1)
end

bot.play(function()
    bot.frames(3)
    gamepad()
    bindings()
    placeAll()
    explosive()
    photo()
    still()
end)

function tick()
    bot.tick()
end
