-- What breaks and paints, for the image of docs/scripting:
-- ./rubble lua samples/lua/breaking.lua --steps 60 --camera 0.9 1.9 -6 0.6 1.2 0 --image FILE
local shown = {
    {"MakeHole", -1.6, function(p) MakeHole(p, 0.35, 0.35) end},
    {"Shoot", -0.8, function(p) Shoot(VecAdd(p, {0, 0, -3}), {0, 0, 1}, "shotgun") end},
    {"Paint: spraycan", 0, function(p) Paint(p, 0.3, "spraycan") end},
    {"Paint: explosion", 0.8, function(p) Paint(p, 0.35, "explosion") end},
    {"PaintRGBA", 1.6, function(p) PaintRGBA(p, 0.3, 1, 0.1, 0.1) end},
}

function init()
    for _, row in ipairs(shown) do row[3](Vec(row[2], 1.7, 0)) end
    SetBodyTransform(FindBody("crate"), Transform(Vec(2.6, 0, -0.8)))  -- beside the wall: its smoke hides nothing
    wait(0)
    SpawnFire(Vec(3, 0.8, -0.8))
end

local function label(name, place)
    local x, y = UiWorldToPixel(place)
    UiPush()
    UiTranslate(x, y)
    UiAlign("center bottom")
    UiFont("bold.ttf", 22)
    UiTextOutline(0, 0, 0, 0.8, 0.15)
    UiText(name)
    UiPop()
end

function draw()
    for i, row in ipairs(shown) do label(row[1], Vec(row[2], 2.55 + 0.15 * (i % 2), 0)) end
    label("SpawnFire", Vec(3, 1.3, -0.8))
end
