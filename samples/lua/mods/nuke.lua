-- Nuke: a flash, a ring of explosions that grows from the middle, smoke, and the count of what it removed.
local center = Vec(0, 0.5, 0)
local removed, pieces = 0, 0

function init()
    for ring = 0, GetIntParam("rings", 3) do
        local count = ring == 0 and 1 or 6 * ring
        for i = 1, count do
            local angle = 2 * math.pi * i / count
            local pos = center + ring * 1.5 * Vec(math.cos(angle), 0, math.sin(angle))
            Explosion(pos, 4 - ring)
            PointLight(pos, 1, 0.8, 0.5, 500)
        end
        wait(0.15)
    end
    ParticleReset()
    ParticleType("smoke")
    ParticleRadius(0.5, 3)
    for i = 1, 40 do SpawnParticle(center, {math.random() - 0.5, 2 + 3 * math.random(), math.random() - 0.5}, 8) end
    wait(1)
    SetInt("nuke.removed", removed)
    print(removed .. " voxels and " .. pieces .. " pieces")
end

function onBreak(shape, voxels) removed = removed + voxels end

function onSplit(shape, list) pieces = pieces + #list end
