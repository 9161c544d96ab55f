-- Laser cutter: a beam goes along a path on the wall, cuts what it meets, and throws sparks.
local eye = Vec(0, 1.2, -5)
local target, removed = nil, 0

-- The corners of a door in the wall.
local path = {Vec(-0.5, 0.2, 0), Vec(-0.5, 1.9, 0), Vec(0.5, 1.9, 0), Vec(0.5, 0.2, 0), Vec(-0.5, 0.2, 0)}

local function cut(at)
    QueryRejectBody(FindBody("crate"))  -- which stands in the way
    local hit, dist = QueryRaycast(eye, VecNormalize(at - eye), 20)
    if not hit then return end
    target = eye + dist * VecNormalize(at - eye)
    removed = removed + MakeHole(target + 0.15 * VecNormalize(at - eye), 0.16, 0.16)
    ParticleReset()
    ParticleType("spark")
    ParticleColor(1, 0.6, 0.2)
    ParticleGravity(-10)
    for _ = 1, 4 do SpawnParticle(target, {math.random() - 0.5, 2 * math.random(), -1}, 0.5) end
end

function init()
    for corner = 1, #path - 1 do
        for i = 0, 20 do
            cut(VecLerp(path[corner], path[corner + 1], i / 20))
            wait(0.03)
        end
    end
    target = nil
    wait(0.5)
    SetInt("laser.removed", removed)
    print(removed .. " voxels cut")
end

function onSplit(shape, pieces)
    for _, piece in ipairs(pieces) do
        if GetShapeVoxelCount(piece) > 100 then SetBool("laser.door", true) end
    end
end

function draw()
    if target then DrawLine(eye + Vec(0.3, -0.3, 0), target, 1, 0.1, 0.1) end
end
