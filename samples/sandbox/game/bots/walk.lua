-- Walks to a place by keys, until a second has brought the player no nearer. to: where the feet shall be; how: a key that
-- is held, too, as "shift" to run.
local bot = require("bots/hands")

local function farFrom(to)
    local d = to - GetPlayerTransform().pos
    return math.sqrt(d.x ^ 2 + d.z ^ 2), d
end

return function(to, what, how)
    local best, since = math.huge, 0
    SetInput("w", true)
    if how then SetInput(how, true) end
    while since < 60 do
        local far, d = farFrom(to)
        if far < 0.25 then break end
        since = far < best - 0.05 and 0 or since + 1
        best = math.min(best, far)
        SetPlayerLook(math.atan(-d.x, -d.z), -0.2)
        bot.frames(1)
    end
    SetInput("w", false)
    if how then SetInput(how, false) end
    bot.frames(10)
    local far, d = farFrom(to)
    local isThere = far < (how and 0.8 or 0.4) and math.abs(d.y) < 0.3
    bot.expect(isThere, string.format("%s to be reached, found %.2f %.2f %.2f short", what, d.x, d.y, d.z))
end
