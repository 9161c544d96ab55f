-- A look at all vehicles: each from before and behind.
local bot = require("bots/hands")
local kinds = {"car", "van", "truck", "forklift", "excavator", "crane", "boat"}
local kBig = {truck = 1.25, excavator = 1.7, crane = 2.6, boat = 1.15}
local eye

local function look()
    bot.frames(3)
    bot.press("return")
    CreateModel({size = {120, 2, 120}, voxel = 1, origin = {60, 2, 60}, boxes = {{0, 0, 0, 119, 1, 119, 1}},
        palette = {{0.42, 0.43, 0.44, material = "concrete", roughness = 0.9}}}, Transform(Vec(0, 0, 0)), false)
    bot.frames(2)
    for i, kind in ipairs(kinds) do
        SetString("game.spawn", kind .. " " .. (i * 12 - 48) .. " 0.02 0 0")
        bot.frames(2)
    end
    bot.frames(60)
    bot.press("h")
    for i, kind in ipairs(kinds) do
        local x, big = i * 12 - 48, kBig[kind] or 1
        local mid = Vec(x, 0.9 * big, kind == "crane" and -2.5 or kind == "excavator" and -1 or 0)
        for _, from in ipairs({Vec(-3.6, 2.2, -4.4), Vec(3.9, 2.4, 4.4)}) do
            eye = Transform(mid + VecScale(from, big), QuatLookAt(mid + VecScale(from, big), mid))
            bot.frames(2)
            bot.image(kind .. (from.z < 0 and "-front" or "-back"))
        end
    end
end

bot.play(look)
function tick()
    bot.tick()
    if eye then SetCameraTransform(eye, 50) end
end
