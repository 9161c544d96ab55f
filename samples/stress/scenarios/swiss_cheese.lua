-- A block is drilled with exact holes until its last voxel is gone.
local cells = 40

function init()
    -- Nothing but the holes may remove voxels: no piece is too small or too many, and no impact breaks.
    Settings{min_piece_voxels = 1, debris_bodies = 2000, debris_voxels = 1000000,
        impact_threshold = 1e12}
    Box("ground", {-10, -0.4, -10}, {200, 4, 200}, 6)
    while true do
        local block = Box("block", {-2, 0, -2}, {cells, cells, cells}, 7)
        wait(0.1)
        for i = 1, 30 do
            ExactHole(block, {math.random() * cells, math.random() * cells, math.random() * cells}, 1.2 + 4 * math.random())
            wait(0)
        end
        for pass = 1, 40 do
            if not IsHandleValid(block) then break end
            MakeHole({4 * math.random() - 2, 4 * math.random(), 4 * math.random() - 2}, 1.5, 1.5)
            wait(0.05)
        end
        if IsHandleValid(block) then Delete(block) end
        wait(0.1)
    end
end
