-- What a contract shows over the image: its goal, how far it has come, its marks in the world.
local contract = require("contracts/contract")
local draw = require("draw")
local options = require("options")

local panel = {}
local kGood, kBad = {0.45, 0.92, 0.55}, {1.0, 0.42, 0.33}
local kCell, kGap = 250, 34

local function drawCell(cell, width, scale)
    local color = cell.isBad and kBad or cell.isGood and kGood or draw.ink
    draw.text(cell[1], 19, "left", draw.ink, 0.65)
    UiPush()
    UiTranslate(width, 0)
    draw.text(cell[2], 24, "right", color, 1, "bold.ttf")
    UiPop()
    UiPush()
    UiAlign("left top")
    UiTranslate(0, 12 * scale)
    UiColor(1, 1, 1, 0.16)
    UiRoundedRect(width, 6, 3)
    draw.color(cell.isBad and kBad or cell.isGood and kGood or draw.accent, 0.9)
    UiRoundedRect(math.max(6, width * cell[3]), 6, 3)
    UiPop()
end

-- The lower edge of what it covers.
function panel.height()
    return 24 + 118 * options.get("textsize")
end

function panel.draw()
    if not contract.isOpen() then return end
    local rules, state = contract.current(), contract.state
    UiPush()
    rules.draw(state)
    UiPop()
    local scale = options.get("textsize")
    local cells = rules.cells(state)
    local cell = math.min(kCell * scale, (UiWidth() - 140) / #cells - kGap)
    local width = #cells * (cell + kGap) - kGap
    UiPush()
    UiTranslate(UiCenter() - width / 2 - 30, 24)
    draw.panel(width + 60, 118 * scale, 0.62)
    UiTranslate(30, 42 * scale)
    UiPush()
    UiTranslate(width / 2, 0)
    draw.text(rules.goal(state), 27, "center", draw.accent, 1, "bold.ttf")
    UiPop()
    UiTranslate(0, 44 * scale)
    for _, row in ipairs(cells) do
        drawCell(row, cell, scale)
        UiTranslate(cell + kGap, 0)
    end
    UiPop()
end

return panel
