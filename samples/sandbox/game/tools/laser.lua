-- Laser: a beam that cuts through all that breaks, thin and straight.
local feel = require("feel")
local sounds = require("sounds")
local belt = require("toolbelt")

return {
    name = "Laser",
    tip = "Cuts a thin line through everything",
    reach = 60,
    cooldown = 0.0,
    isAutomatic = true,
    marksUndo = false,
    turn = {2, 3, 0},
    hold = Vec(-0.005, 0.0, 0.02),
    model = {
        size = {7, 12, 34},
        origin = {3, 7, 20},
        palette = {{0.82, 0.83, 0.85, roughness = 0.35}, {0.16, 0.17, 0.19, roughness = 0.5},
            {1.0, 0.12, 0.08, emission = 5}, {0.35, 0.37, 0.40, roughness = 0.3, metallic = 0.6}},
        boxes = {{1, 6, 8, 5, 10, 30, 1}, {0, 7, 10, 6, 9, 26, 1}, {2, 7, 0, 4, 9, 8, 4}, {2, 7, 0, 4, 9, 0, 3},
            {0, 8, 12, 0, 8, 22, 3}, {6, 8, 12, 6, 8, 22, 3}, {2, 0, 22, 4, 6, 26, 2}, {2, 10, 12, 4, 11, 22, 2}},
        muzzle = Vec(0, 1, -21),
    },
    use = function(self, aim)
        local muzzle = belt.muzzle()
        local right, up = aim.rot * Vec(0.004, 0, 0), aim.rot * Vec(0, 0.004, 0)
        for _, offset in ipairs({right, -1 * right, up, -1 * up}) do
            DrawLine(muzzle + offset, aim.pos + 3 * offset, 1, 0.12, 0.06, 0.55)
        end
        DrawLine(muzzle, aim.pos, 1, 0.8, 0.7, 1)
        if not aim.hit then return end
        MakeHoleLine(aim.pos - 0.03 * aim.dir, aim.pos + 0.16 * aim.dir, 0.1, 0.1, 0.1)
        Paint(aim.pos, 0.16, "explosion", 0.2)
        PointLight(aim.pos + 0.12 * aim.normal, 0.9, 0.16, 0.08, 1)
        sounds.loop("motor", aim.pos, 0.4, 3)
        feel.burst(aim.pos, aim.normal, {type = "spark", count = 3, speed = 4, spread = 0.7, life = 0.5,
            color = {1, 0.45, 0.2}, radius = {0.012, 0.005}, gravity = -6, emissive = 0.3, stretch = 0.03})
    end,
    -- A hot spot where the beam ends.
    draw = function(self)
        if not InputDown("usetool") then return end
        UiTranslate(UiCenter(), UiMiddle())
        UiAlign("center middle")
        for i, size in ipairs({26, 15, 7}) do
            UiColor(1, 0.12 + 0.28 * (i - 1), 0.08 + 0.22 * (i - 1), 0.16 + 0.25 * (i - 1))
            UiCircle(size * (0.9 + 0.2 * math.random()))
        end
    end,
    tick = function(self)
        if InputPressed("usetool") then AddUndoMark() end
    end,
}
