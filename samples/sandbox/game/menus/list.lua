-- A column of rows that the mouse or the arrow keys choose from: buttons, and options that left and right change.
local draw = require("draw")
local options = require("options")
local sounds = require("sounds")

local kRow = 62

local List = {}
List.__index = List

-- Rows: {name =, run =} or {name =, option = id}.
local function make(title, rows)
    return setmetatable({title = title, rows = rows, chosen = 1, x = 0, y = 0, width = 560}, List)
end

function List:change(row, direction)
    if row.option then options.change(row.option, direction) end
end

function List:tick()
    local count = #self.rows
    if InputPressed("menudown") then self.chosen = self.chosen % count + 1 end
    if InputPressed("menuup") then self.chosen = (self.chosen - 2) % count + 1 end
    local isOver = false
    for i = 1, count do
        if draw.isOver(self.x, self.y + kRow * (i - 1), self.width, kRow) then
            isOver = true
            if InputValue("mousex") ~= self.mouseX or InputValue("mousey") ~= self.mouseY then self.chosen = i end
        end
    end
    self.mouseX, self.mouseY = InputValue("mousex"), InputValue("mousey")
    local row = self.rows[self.chosen]
    if InputPressed("menuright") then self:change(row, 1) end
    if InputPressed("menuleft") then self:change(row, -1) end
    if row.option then
        if isOver and InputPressed("lmb") then
            self:change(row, InputValue("mousex") > self.x + self.width - 190 and 1 or -1)
        end
    elseif InputPressed("menuok") or isOver and InputPressed("lmb") then
        sounds.play("click")
        row.run()
    end
end

function List:drawRow(row, isChosen)
    if isChosen then
        UiPush()
        UiAlign("left middle")
        UiColor(1.0, 0.72, 0.30, 0.16)
        UiRoundedRect(self.width, kRow - 8, 10)
        UiColor(1.0, 0.72, 0.30, 0.95)
        UiRoundedRect(5, kRow - 8, 2)
        UiPop()
    end
    UiPush()
    UiTranslate(28, 0)
    draw.text(type(row.name) == "function" and row.name() or row.name, 31, "left middle", draw.ink, row.isOff and row.isOff() and 0.4 or isChosen and 1 or 0.82)
    UiPop()
    if not row.option then return end
    UiPush()
    UiTranslate(self.width - 340, 0)
    UiAlign("left middle")
    UiColor(1, 1, 1, 0.16)
    UiRoundedRect(150, 6, 3)
    draw.color(draw.accent, isChosen and 0.95 or 0.7)
    UiRoundedRect(math.max(6, 150 * options.share(row.option)), 6, 3)
    UiPop()
    UiPush()
    UiTranslate(self.width - 95, 0)
    draw.text(options.text(row.option), 27, "center middle", draw.ink, isChosen and 1 or 0.8)
    if isChosen then
        UiTranslate(-78, 0)
        draw.text("‹", 34, "center middle", draw.accent)
        UiTranslate(156, 0)
        draw.text("›", 34, "center middle", draw.accent)
    end
    UiPop()
end

-- Its left upper corner at x, y of the canvas.
function List:draw(x, y)
    self.x, self.y = x, y
    for i, row in ipairs(self.rows) do
        UiPush()
        UiTranslate(x, y + kRow * (i - 0.5))
        self:drawRow(row, i == self.chosen)
        UiPop()
    end
end

function List:height()
    return kRow * #self.rows
end

return make
