-- Without gravity, plates that fly and spin are cut again and again; pieces go on as their bodies moved.
function init()
    Settings{min_piece_voxels = 1, debris_bodies = 4000, awake_debris_bodies = 4000, impact_threshold = 1e9}
    SetGravity({0, 0, 0})
    while true do
        FreeFlight(false)
        for i = 1, 6 do
            Box("plate", {30 * i - 100, 200, 0}, {40, 40, 2}, 6, {dynamic = true,
                velocity = {math.random() - 0.5, 4 * math.random(), math.random()}, spin = {0, 0, 2 * math.random() - 1}})
        end
        wait(0.1)
        FreeFlight(true)
        for cut = 1, 12 do
            for _, body in ipairs(FindBodies("plate")) do
                local frame = GetBodyTransform(body)
                MakeHole(frame * Vec(4 * math.random(), 4 * math.random(), 0.1), 0.6, 0.6, 0.6)
            end
            wait(0.1)
        end
        FreeFlight(false)
        LoadLevel("garden")
        wait(0.1)
        for _, shape in ipairs(FindShapes("plate")) do Delete(shape) end
        SetGravity({0, 0, 0})
    end
end
