-- The menus of contracts: what is asked for before one begins, and how it has ended.
local contract = require("contracts/contract")
local draw = require("draw")
local list = require("menus/list")
local options = require("options")

local screens = {chosen = nil}
local kGood, kBad = {0.45, 0.92, 0.55}, {1.0, 0.42, 0.33}

-- Begins a contract, or with nil what may be done freely; either with the level anew.
function screens.begin(id)
    if id then SetString("game.contract", id) else ClearKey("game.contract") end
    RestartLevel()
end

function screens.toTitle()
    SetBool("game.title", true)
    screens.begin(nil)
end

-- Lists of `open(name)`, `close()` and `back()`, to the title, of the menus.
function screens.lists(open, close, back)
    local function choose(id)
        return function()
            screens.chosen = id
            open("brief")
        end
    end
    screens.rows = {{name = "Demolition contract", run = choose("demolition")}, {name = "Heist", run = choose("heist")}}
    return {
        brief = list("", {{name = "Begin", run = function() screens.begin(screens.chosen) end},
            {name = "Back", run = back}}),
        result = list("", {{name = "Try again", run = function() screens.begin(contract.state.id) end},
            {name = "Look around", run = close}, {name = "Back to the title", run = screens.toTitle}}),
    }
end

local function drawFrame(menu, above, width)
    local height = menu:height() + above
    local x, y = UiCenter() - width / 2, UiMiddle() - height / 2
    UiPush()
    UiColor(0.02, 0.025, 0.03, 0.45)
    UiAlign("left top")
    UiRect(UiWidth(), UiHeight())
    UiPop()
    UiTranslate(x, y)
    UiPush()
    UiTranslate(-40, -40)
    draw.panel(width + 80, height + 80, 0.78)
    UiPop()
    menu.width = width
    return x, y + above
end

function screens.drawBrief(menu)
    local scale = options.get("textsize")
    local rules = contract.rules[screens.chosen]
    UiPush()
    local x, y = drawFrame(menu, (130 + 46 * #rules.brief) * scale + 20, math.min(940 * scale, UiWidth() - 120))
    UiTranslate(0, 44 * scale)
    draw.text(rules.title, 48, "left", draw.ink, 1, "bold.ttf")
    UiTranslate(2, 44 * scale)
    draw.text(rules.place, 27, "left", draw.accent)
    UiTranslate(0, 56 * scale)
    for _, line in ipairs(rules.brief) do
        draw.text(line, 26, "left", draw.ink, 0.92)
        UiTranslate(0, 42 * scale)
    end
    UiPop()
    menu:draw(x, y)
end

function screens.drawResult(menu)
    local scale = options.get("textsize")
    local rules, state = contract.current(), contract.state
    local figures = rules.figures(state)
    local hasWon = state.phase == "won"
    UiPush()
    local x, y = drawFrame(menu, (120 + 42 * #figures) * scale + 30, math.min(820 * scale, UiWidth() - 120))
    UiTranslate(0, 44 * scale)
    draw.text(hasWon and "Done" or "Failed", 54, "left", hasWon and kGood or kBad, 1, "bold.ttf")
    UiTranslate(2, 46 * scale)
    draw.text(state.reason, 30, "left", draw.ink)
    UiTranslate(0, 52 * scale)
    for _, row in ipairs(figures) do
        draw.text(row[1], 25, "left", draw.ink, 0.7)
        UiPush()
        UiTranslate(300 * scale, 0)
        draw.text(row[2], 25, "left", draw.ink)
        UiPop()
        UiTranslate(0, 42 * scale)
    end
    UiPop()
    menu:draw(x, y)
end

return screens
