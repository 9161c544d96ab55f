-- A look at all vehicles: each from before and behind.
local bot = require("bots/hands")
local kinds = {"car", "van", "truck", "forklift", "excavator", "crane", "boat"}
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
    local only = GetString("gallery.only")
    for i, kind in ipairs(kinds) do
        local x, big = i * 12 - 48, (kind == "crane" or kind == "excavator") and 1.9 or kind == "truck" and 1.25 or 1
        if kind == "crane" then big = 2.6 end
        local mid = Vec(x, 0.9 * big, kind == "crane" and -2.5 or 0)
        for name, from in pairs({front = Vec(-3.6, 2.2, -4.4), back = Vec(3.9, 2.4, 4.4)}) do
            local eye = mid + VecScale(from, big)
            for _ = 1, 1 do
                SetCameraTransform(Transform(eye, QuatLookAt(eye, mid)), 50)
                SetString("gallery.camera", "x")
            end
            SetPlayerWalking(false)
            SetPlayerTransform(Transform(eye - Vec(0, 1.65, 0), QuatLookAt(eye, mid)))
            bot.frames(3)
            bot.image(kind .. "-" .. name)
        end
    end
end
bot.play(look)
function tick() bot.tick() end
