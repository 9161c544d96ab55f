-- Spray can: paints in one of twelve colours. The right button turns the wheel of colours.
local feel = require("feel")
local belt = require("toolbelt")

local colors = {{0.86, 0.14, 0.16}, {0.95, 0.45, 0.10}, {0.98, 0.80, 0.12}, {0.55, 0.78, 0.18}, {0.13, 0.60, 0.30},
    {0.10, 0.65, 0.66}, {0.14, 0.46, 0.84}, {0.22, 0.24, 0.66}, {0.52, 0.24, 0.66}, {0.90, 0.30, 0.58},
    {0.94, 0.94, 0.92}, {0.09, 0.09, 0.10}}
local state = saved("spray", {color = 1})
local shown = 0

return {
    name = "Spray can",
    tip = "Right button: next colour",
    reach = 5,
    cooldown = 0.03,
    isAutomatic = true,
    marksUndo = false,
    turn = {10, -6, 4},
    hold = Vec(0.0, -0.01, 0.04),
    model = {
        size = {7, 20, 7},
        origin = {3, 10, 3},
        palette = {{0.75, 0.76, 0.78, roughness = 0.25, metallic = 0.7}, {0.86, 0.14, 0.16, roughness = 0.4},
            {0.92, 0.92, 0.90, roughness = 0.5}, {0.12, 0.12, 0.13, roughness = 0.5}},
        boxes = {{1, 0, 0, 5, 13, 6, 1}, {0, 0, 1, 6, 13, 5, 1}, {1, 2, 0, 5, 10, 6, 2}, {0, 2, 1, 6, 10, 5, 2},
            {1, 14, 1, 5, 15, 5, 4}, {2, 16, 2, 4, 18, 4, 3}, {3, 17, 1, 3, 17, 1, 4}},
        muzzle = Vec(0, 7, -2),
    },
    use = function(self, aim)
        local c = colors[state.color]
        if aim.hit then PaintRGBA(aim.pos, 0.16 + 0.035 * aim.dist, c[1], c[2], c[3], 0.8, 0.5) end
        feel.burst(belt.muzzle(), aim.dir, {type = "plain", count = 3, speed = 5, spread = 0.09, life = 0.22,
            color = {c[1] * c[1], c[2] * c[2], c[3] * c[3]}, radius = {0.006, 0.05}, alpha = 0.16, drag = 2})
        belt.recoil(0.02)
    end,
    alt = function(self)
        state.color = state.color % #colors + 1
        shown = 2.5
    end,
    tick = function(self, aim, dt)
        shown = math.max(0, shown - dt)
        if InputPressed("usetool") then AddUndoMark() end
    end,
    -- The wheel of colours around the crosshair, while it is turned.
    draw = function(self)
        UiTranslate(UiCenter(), UiMiddle())
        UiAlign("center middle")
        local fade = math.min(1, shown / 0.5)
        for i, c in ipairs(colors) do
            local angle = 2 * math.pi * (i - 1) / #colors
            local isChosen = i == state.color
            if fade > 0 then
                UiPush()
                UiTranslate(92 * math.sin(angle), -92 * math.cos(angle))
                UiColor(0, 0, 0, 0.35 * fade)
                UiCircle(isChosen and 24 or 17)
                UiColor(c[1], c[2], c[3], fade)
                UiCircle(isChosen and 21 or 14)
                UiPop()
            end
        end
        local c = colors[state.color]
        UiColor(c[1], c[2], c[3], 0.9)
        UiCircleOutline(13, 3)
    end,
    color = function() return colors[state.color] end,
}
