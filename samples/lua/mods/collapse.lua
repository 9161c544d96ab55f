-- Structural collapse: cuts a wall's foot from left to right, shows how much still stands, and paints cracks above the
-- cut while the load grows.
local wall, whole, left = 0, 0, 1

function init()
    wall = FindShape("wall")
    whole = GetShapeVoxelCount(wall)
    for i = 0, GetIntParam("cuts", 9) do
        local x = -2 + i * 0.45
        MakeHole({x, 0.2, 0.15}, 0.35, 0.35)
        for crack = 1, 4 do
            PaintRGBA({x + 0.15 * crack * math.random(), 0.5 + 0.2 * crack, 0}, 0.06, 0.1, 0.1, 0.1, 1, 1)
        end
        wait(0.25)
    end
    wait(2)
    SetFloat("collapse.left", left)
    print(string.format("%d %% of the wall stands", math.floor(100 * left + 0.5)))
end

function update()
    if IsHandleValid(wall) then left = GetShapeVoxelCount(wall) / whole else left = 0 end
end

function onSplit(shape, pieces)
    if shape == wall then SetInt("collapse.pieces", GetInt("collapse.pieces") + #pieces) end
end

function draw()
    UiTranslate(60, 80)
    UiFont("bold.ttf", 32)
    UiTextOutline(0, 0, 0, 1, 0.1)
    UiText("Wall")
    UiTranslate(110, -24)
    UiColor(0, 0, 0, 0.6)
    UiRoundedRect(404, 30, 6)
    UiTranslate(2, 2)
    UiColor(1 - left, left, 0.1)
    UiRoundedRect(400 * left, 26, 5)
end
