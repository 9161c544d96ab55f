-- Levels replace each other while things fall, burn and wait to be split.
local levels = {"town", "bridge", "garden"}

function init()
    local i = math.random(3)
    while true do
        LoadLevel(levels[1 + i % 3])
        i = i + 1
        wait(0.1)
        for k = 1, 5 do
            Explosion({30 * math.random(), 5 * math.random(), 30 * math.random()}, 2)
            SpawnFire({30 * math.random(), 2 * math.random(), 30 * math.random()})
            wait(0.05)
        end
        wait(0.8)
    end
end
