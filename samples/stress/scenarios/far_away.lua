-- The same small demolition at the origin and at 1, 10 and 100 km from it.
local places = {0, 1000, 10000, 100000}

function init()
    while true do
        for _, x in ipairs(places) do
            Box("ground", {x - 5, -0.4, -5}, {100, 4, 100}, 6)
            Box("wall", {x - 2, 0, 0}, {40, 25, 3}, 7)
            for k = 0, 4 do Box("crate", {x - 1 + 0.05 * k, 0.9 * k, -2}, {8, 8, 8}, 5, {dynamic = true}) end
        end
        wait(1)
        for i = 1, 10 do
            for _, x in ipairs(places) do
                MakeHole({x - 2 + 4 * math.random(), 2 * math.random(), 0.1}, 0.4, 0.4)
                if i == 5 then Explosion({x, 1, -0.5}, 2) end
            end
            wait(0.3)
        end
        wait(2)
        for _, tag in ipairs{"ground", "wall", "crate"} do
            for _, body in ipairs(FindBodies(tag)) do Delete(body) end
        end
        wait(0.2)
    end
end
