-- What all that is drawn over the image shares: sizes, colours, panels, texts, icons of tools.
local options = require("options")

local draw = {}

draw.ink = {0.96, 0.94, 0.90}
draw.accent = {1.0, 0.72, 0.30}
draw.ground = {0.055, 0.06, 0.07}

function draw.color(c, a)
    UiColor(c[1], c[2], c[3], a or 1)
end

-- A text in a size of the canvas, times the player's size of texts. `align`: as UiAlign().
function draw.text(text, size, align, color, alpha, font)
    UiPush()
    UiAlign(align or "left")
    UiFont(font or "regular.ttf", size * options.get("textsize"))
    draw.color(color or draw.ink, alpha or 1)
    UiTextShadow(0, 0, 0, 0.75 * (alpha or 1), 1.5, 0.2)
    local width, height = UiText(text)
    UiPop()
    return width, height
end

-- How wide such a text is.
function draw.width(text, size, font)
    UiPush()
    UiFont(font or "regular.ttf", size * options.get("textsize"))
    local width = UiGetTextSize(text)
    UiPop()
    return width
end

-- A panel of a width and height whose left upper corner is here.
function draw.panel(width, height, alpha)
    UiPush()
    UiAlign("left top")
    draw.color(draw.ground, alpha or 0.72)
    UiRoundedRect(width, height, 14)
    UiPop()
end

-- A tool's icon: its model from the side, its middle here, within a square of `size`.
function draw.icon(tool, size, alpha)
    local model = tool.model
    local wide, high = model.size[3], model.size[2]
    local unit = size / math.max(wide, high)
    local order = {}
    for i, box in ipairs(model.boxes) do order[i] = box end
    table.sort(order, function(a, b) return a[4] < b[4] end)
    UiPush()
    UiAlign("left top")
    UiRotate(tool.iconTurn or 0)
    for _, box in ipairs(order) do
        local c = model.palette[box[7]]
        local lift = 1.35 + 0.25 * box[4] / model.size[1]
        local function light(share) return math.min(1, share * lift + 0.13) end
        UiPush()
        UiColor(light(c[1]), light(c[2]), light(c[3]), alpha or 1)
        -- The muzzle, at the low end of z, points to the left.
        UiTranslate((box[3] - wide / 2) * unit, (high / 2 - box[5] - 1) * unit)
        UiRect((box[6] - box[3] + 1) * unit, (box[5] - box[2] + 1) * unit)
        UiPop()
    end
    UiPop()
end

-- What keys do, in the lower left corner: rows of a label and a text.
function draw.hints(rows)
    local wide = 0
    for _, row in ipairs(rows) do wide = math.max(wide, draw.width(row[1], 22, "bold.ttf")) end
    UiPush()
    UiTranslate(48, UiHeight() - 44 - 34 * (#rows - 1))
    for _, row in ipairs(rows) do
        draw.text(row[1], 22, "left", draw.accent, 0.95, "bold.ttf")
        UiPush()
        UiTranslate(wide + 28, 0)
        draw.text(row[2], 22)
        UiPop()
        UiTranslate(0, 34)
    end
    UiPop()
end

-- Whether the cursor is in a rectangle of the canvas.
function draw.isOver(x, y, width, height)
    local mx, my = InputValue("mousex"), InputValue("mousey")
    return mx >= x and mx < x + width and my >= y and my < y + height
end

return draw
