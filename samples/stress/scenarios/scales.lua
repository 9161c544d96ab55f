-- Towers of voxels from 2 cm to 2 m fall and break beside each other.
local sizes = {0.02, 0.05, 0.1, 0.3, 1, 2}

function init()
    local ground = Box("ground", {-100, -4, -100}, {100, 2, 100}, 6, {voxel = 2})
    while true do
        local x = -40
        for _, voxel in ipairs(sizes) do
            local height = math.random(20, 30)
            Box("tower", {x, 0, 0}, {8, height, 8}, 7, {voxel = voxel})
            Box("block", {x, (height + 1) * voxel, 0}, {8, 6, 8}, 6, {voxel = voxel, dynamic = true})
            wait(0.1)
            local radius = (4 + 2 * math.random()) * voxel
            MakeHole(Vec(x + 8 * voxel * math.random(), 3 * voxel, 4 * voxel), radius, radius, radius)
            x = x + 10 * voxel + 6
        end
        wait(3)
        for _, shape in ipairs(FindShapes()) do -- the pieces, too: giants that move are cells by the million
            if shape ~= ground then Delete(shape) end
        end
        wait(0.2)
    end
end
