-- Water rises through a room of crates, characters swim, walls break, and it goes again.
function furnish()
    for _, tag in ipairs{"wall", "crate"} do
        for _, body in ipairs(FindBodies(tag)) do Delete(body) end
    end
    Box("wall", {-6, 0, -6}, {120, 30, 4}, 7)
    Box("wall", {-6, 0, 5.6}, {120, 30, 4}, 7)
    for i = 1, 20 do
        Box("crate", {-5 + 10 * math.random(), 1 + 0.2 * i, -5 + 10 * math.random()}, {6, 6, 6}, math.random(5, 9),
            {dynamic = true})
    end
    wait(0.5)
end

function init()
    Box("ground", {-12, -0.4, -12}, {240, 4, 240}, 6)
    local swimmers = {Character({-3, 0, 0}), Character({3, 0, 1})}
    for round = 0, math.huge do
        if round % 5 == 0 then furnish() end
        local water
        for level = 1, 8 do
            if water then RemoveWater(water) end
            water = Water({-6, -0.5, -6}, {6, 0.35 * level, 6}, {flow = {math.random() - 0.5, 0, 2 * math.random() - 1}})
            for _, swimmer in ipairs(swimmers) do
                Walk(swimmer, {4 * math.random() - 2, 2 * math.random() - 1, 4 * math.random() - 2}, math.random() < 0.3)
            end
            MakeHole({-6 + 12 * math.random(), 3 * math.random(), -5.8}, 0.6, 0.5)
            wait(0.5)
        end
        Explosion({10 * math.random() - 5, 1, 10 * math.random() - 5}, 1.5)
        wait(1)
        RemoveWater(water)
        wait(0.5)
    end
end
