-- The wheel of all tools: held Tab, the mouse points, letting go chooses.
local belt = require("toolbelt")
local draw = require("draw")

local radial = {isOpen = false}
local kRadius, kDead = 330, 60
local x, y = 0, 0

function radial.open()
    radial.isOpen, x, y = true, 0, 0
end

-- Which tool the mouse points at.
local function pointedAt()
    if x * x + y * y < kDead * kDead then return belt.current end
    local turn = math.atan(x, -y) / (2 * math.pi)
    local number = math.floor(turn * #belt.tools + 0.5) % #belt.tools + 1
    return belt.isAllowed(number) and number or belt.current
end

function radial.tick()
    x, y = x + InputValue("mousedx"), y + InputValue("mousedy")
    local stickX, stickY = InputValue("padrx"), InputValue("padry")
    if stickX * stickX + stickY * stickY > 0.2 then x, y = kRadius * stickX, -kRadius * stickY end
    local length = math.sqrt(x * x + y * y)
    if length > kRadius then x, y = x * kRadius / length, y * kRadius / length end
    if InputDown("wheel") then return end
    radial.isOpen = false
    belt.select(pointedAt())
end

function radial.draw()
    local chosen = pointedAt()
    UiPush()
    UiAlign("center middle")
    UiTranslate(UiCenter(), UiMiddle())
    UiColor(0.03, 0.035, 0.04, 0.62)
    UiCircle(kRadius + 105)
    UiColor(1, 1, 1, 0.06)
    UiCircleOutline(kRadius + 105, 2)
    UiColor(0.03, 0.035, 0.04, 0.55)
    UiCircle(180)
    for i, tool in ipairs(belt.tools) do
        local angle = 2 * math.pi * (i - 1) / #belt.tools
        local isChosen = i == chosen
        UiPush()
        UiTranslate(kRadius * math.sin(angle), -kRadius * math.cos(angle))
        UiPush()
        UiColor(1, 1, 1, 0.10)
        UiCircle(56)
        if isChosen then
            UiColor(1.0, 0.72, 0.30, 0.26)
            UiCircle(70)
            UiColor(1.0, 0.72, 0.30, 0.9)
            UiCircleOutline(70, 2.5)
        end
        UiPop()
        draw.icon(tool, isChosen and 112 or 98, isChosen and 1 or belt.isAllowed(i) and 0.88 or 0.14)
        UiPop()
    end
    local tool = belt.tools[chosen]
    UiTranslate(0, -8)
    draw.text(tool.name, 36, "center", draw.ink, 1, "bold.ttf")
    UiTranslate(0, 44)
    if tool.tip then draw.text(tool.tip, 22, "center", draw.ink, 0.75) end
    UiPop()
end

return radial
