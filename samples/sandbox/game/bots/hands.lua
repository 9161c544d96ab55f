-- What a bot plays with: frames to wait for, keys to press, images to write. Its script runs before the game's in each
-- frame. A bot is a function; play() calls it and ends the game after it.
local bot = {}
local thread = nil

-- Lets frames pass.
function bot.frames(count)
    for _ = 1, count do coroutine.yield() end
end

-- A load ends what the bot does, and leaves the key down that asked for it.
function bot.press(key)
    if InputDown(key) then
        SetInput(key, false)
        bot.frames(1)
    end
    SetInput(key, true)
    bot.frames(3)
    SetInput(key, false)
    bot.frames(3)
end

function bot.hold(key, frames)
    SetInput(key, true)
    bot.frames(frames)
    SetInput(key, false)
    bot.frames(2)
end

function bot.image(name)
    Screenshot(name .. ".png")
    bot.frames(1)
end

-- Puts the player somewhere, with the eyes on a target.
function bot.stand(feet, target)
    SetPlayerTransform(Transform(feet, QuatLookAt(feet + Vec(0, 1.65, 0), target)))
    bot.frames(20)
end

-- Looks at another place.
function bot.look(target)
    local d = VecNormalize(target - GetPlayerCameraTransform().pos)
    SetPlayerLook(math.atan(-d.x, -d.z), math.asin(d.y))
    bot.frames(6)
end

-- Chooses a tool as a player does, by the wheel of the mouse.
function bot.choose(tool)
    for _ = 1, 40 do
        if GetString("game.tool") == tool then return bot.frames(25) end
        AddInput("mousewheel", -1)
        bot.frames(3)
    end
    error("expected a tool " .. tool)
end

function bot.expect(isGood, what)
    if not isGood then error("expected " .. what, 2) end
end

-- Of all shapes that do not move.
function bot.staticVoxels()
    local count = 0
    for _, shape in ipairs(FindShapes()) do
        if not IsBodyDynamic(GetShapeBody(shape)) then count = count + GetShapeVoxelCount(shape) end
    end
    return count
end

function bot.play(f)
    thread = coroutine.create(f)
end

-- From tick().
function bot.tick()
    if not thread then return end
    local isGood, what = coroutine.resume(thread)
    if isGood and coroutine.status(thread) ~= "dead" then return end
    thread = nil
    QuitGame()
    if not isGood then error(what, 0) end
end

return bot
