-- Wooden sheds burn from all sides, and are put out, and burn again; then others are built.
function shed(x, z)
    local walls = Box("shed", {x, 0, z}, {20, 16, 2}, 5)
    Box("shed", {x, 0, z + 1.8}, {20, 16, 2}, 5)
    Box("shed", {x, 0, z + 0.2}, {2, 16, 16}, 5)
    Box("shed", {x + 1.8, 0, z + 0.2}, {2, 16, 16}, 5)
    Box("shed", {x, 1.6, z}, {20, 2, 20}, 5)
end

function init()
    Box("ground", {-20, -0.4, -20}, {400, 4, 400}, 6)
    Settings{fire = true, fire_spread = 3, max_fires = 400}
    for round = 0, math.huge do
        if round % 5 == 0 then
            for _, body in ipairs(FindBodies("shed")) do Delete(body) end
            for x = -2, 1 do
                for z = -2, 1 do shed(4 * x, 4 * z) end
            end
        end
        for i = 1, 12 do
            SpawnFire({-8 + 14 * math.random(), 1.8 * math.random(), -8 + 14 * math.random()})
            local shapes = FindShapes("shed")
            if #shapes > 0 then
                local shape = shapes[math.random(#shapes)]
                AddHeat(shape, GetShapeWorldTransform(shape).pos, 4)
            end
            wait(0.2)
        end
        for i = 1, 6 do
            Pour({-8 + 14 * math.random(), 1.5, -8 + 14 * math.random()}, 1 + 2 * math.random())
            wait(0.3)
        end
        RemoveAabbFires({-8, 0, -8}, {0, 3, 0})
        wait(0.5)
    end
end
