-- Boulders and planks slide down a slope into a wall, without anything that gives energy.
function init()
    Box("ground", {-20, -0.4, -20}, {400, 4, 400}, 6)
    Box("slope", {-6, 0, -8}, {120, 4, 140}, 6, {turned = {0.6, 0, 0}})
    Settings{debris_bodies = 400, awake_debris_bodies = 400}
    while true do
        Box("wall", {-6, 0, 5}, {120, 20, 4}, 7)
        ClosedSystem(false)
        for i = 1, 60 do
            local size = math.random(2, 7)
            Box("boulder", {-5 + 10 * math.random(), 2 + 0.4 * i % 7, -7 + 3 * math.random()},
                {size, math.random(2, 7), size}, math.random(5, 7), {dynamic = true, turned = {math.random(), math.random(), 0}})
            if i % 10 == 0 then wait(0.2) end
        end
        wait(0)
        wait(0)
        ClosedSystem(true)
        wait(7)
        ClosedSystem(false)
        for _, tag in ipairs{"boulder", "wall"} do
            for _, body in ipairs(FindBodies(tag)) do Delete(body) end
        end
        wait(0.2)
    end
end
