-- A tower of bricks loses its foot on one side, falls, and breaks; then the next one.
local BRICK, CONCRETE = 7, 6

function init()
    Box("ground", {-40, -0.4, -40}, {800, 4, 800}, CONCRETE)
    Settings{stress = true}
    while true do
        for tower = 0, 3 do
            local x = -12 + 8 * tower
            Box("tower", {x, 0, 0}, {16, 120, 16}, BRICK)
            wait(0.5)
            for i = 0, 5 do
                MakeHole({x + 0.2 + 0.25 * i, 0.4 + 0.6 * math.random(), 0.3 * i}, 0.5, 0.5)
                wait(0.3)
            end
            Explosion({x + 0.2, 0.6, 0.8}, 2 + math.random())
            wait(2)
        end
        for _, body in ipairs(FindBodies("tower")) do Delete(body) end
    end
end
