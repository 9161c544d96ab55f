-- Plates are cut in two in flight, and their pieces again and again; what is left falls, and splits once more on the ground.
local columns = {Vec(0.05, 9, 9), Vec(9, 0.05, 9)} -- one of the middle, as the plates have 63: 31, 15, 7 and 3 are left

function halve(generation)
    for _, shape in ipairs(FindShapes("plate")) do
        if math.random() < 0.95 then
            local body = GetShapeBody(shape)
            local frame = GetBodyTransform(body)
            Cut(shape, frame * GetBodyCenterOfMass(body), columns[generation % 2 + 1], frame.rot)
        end
    end
end

function init()
    local ground = Box("ground", {-30, -0.4, -20}, {600, 4, 400}, 6)
    for round = 0, math.huge do
        Settings{min_piece_voxels = 1, debris_bodies = 1800, awake_debris_bodies = 1500, impact_threshold = 1e9}
        SetGravity({0, 0, 0})
        for i = 0, round // 3 % 6 do
            -- in two rows: pieces of neighbours would meet in flight
            Box("plate", {10 * i - 29, 6, i % 2 * 8}, {63, 63, 3}, 5 + i % 3, {dynamic = true,
                velocity = {0, math.random(), math.random()}, spin = {0, 0, 0.5 + math.random()}})
        end
        wait(0.1)
        FreeFlight(true)
        for generation = 1, 8 do
            halve(generation)
            wait(0.1)
        end
        FreeFlight(false)
        Settings{impact_threshold = 1}
        SetGravity({0, -30, 0})
        wait(1.1)
        for i = 1, 2 do -- what is deleted may split in the same step
            for _, shape in ipairs(FindShapes()) do
                if shape ~= ground then Delete(shape) end
            end
            wait(0.1)
        end
    end
end
