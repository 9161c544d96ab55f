-- A look at the yard and at all vehicles in it, each from before on its left and from behind on its right.
local bot = require("bots/hands")
local kBig = {truck = 1.25, excavator = 1.6, crane = 2.5, boat = 1.15}
local eye

local function lookAt(name, from, to)
    eye = Transform(from, QuatLookAt(from, to))
    bot.frames(2)
    bot.image(name)
end

bot.play(function()
    bot.frames(3)
    bot.press("return")
    bot.frames(60)
    bot.image("spawn")
    bot.press("h")
    lookAt("yard", Vec(12, 11, 50), Vec(26, 0, 24))
    lookAt("harbour", Vec(34, 5, 42), Vec(50, 0, 28))
    for _, body in ipairs(FindBodies("vehicle")) do
        local kind = GetTagValue(body, "vehicle")
        if GetTagValue(body, "part") == "chassis" then
            local frame, big = GetBodyTransform(body), kBig[kind] or 1
            local mid = Vec(0, 0.9 * big, kind == "crane" and -2.5 or kind == "excavator" and -1 or 0)
            for side, from in pairs({front = Vec(-3.6, 2.2, -4.4), back = Vec(3.9, 2.4, 4.4)}) do
                lookAt(kind .. "-" .. side, frame * (mid + VecScale(from, big)), frame * mid)
            end
        end
    end
end)

function tick()
    bot.tick()
    if eye then SetCameraTransform(eye, 50) end
end
