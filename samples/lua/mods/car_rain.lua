-- Rain of cars: each half second one falls out of the sky, turned at random, and counts what it breaks.
local cars, hits = {}, 0

function init()
    for i = 1, GetIntParam("cars", 8) do
        local pos = Vec(math.random() * 4 - 2, 6, math.random() * 2 - 1)
        local turn = QuatEuler(math.random() * 40 - 20, math.random() * 360, 0)
        local car = Spawn("car.vox", Transform(pos, turn))[1]  -- its body; a model without a level is static
        SetBodyDynamic(car, true)
        cars[car] = true
        wait(0.5)
    end
    wait(2)
    SetInt("carrain.hits", hits)
    print(hits .. " hits, " .. GetInt("carrain.broken") .. " voxels broken")
end

function onContact(a, b, pos, normal, impulse)
    if impulse < 500 or not (cars[a] or cars[b]) then return end
    hits = hits + 1
    if hits % 4 == 1 then
        local broken = MakeHole(pos, 0.4, 0.25)
        SetInt("carrain.broken", GetInt("carrain.broken") + broken)
    end
end

function draw()
    UiTranslate(UiCenter(), 60)
    UiAlign("center middle")
    UiFont("bold.ttf", 40)
    UiTextShadow(0, 0, 0, 0.8, 2, 0.3)
    UiText("Hits: " .. hits)
end
