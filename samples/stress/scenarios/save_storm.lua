-- The game is saved and loaded every half second while bridges come down.
function init()
    for round = 0, math.huge do
        if round % 30 == 0 then
            LoadLevel("bridge")
            wait(0.1)
        end
        Explosion({-8 + 16 * math.random(), 4 * math.random(), 4 * math.random() - 2}, 1 + 2 * math.random())
        MakeHole({-8 + 16 * math.random(), 4 * math.random(), 4 * math.random() - 2}, 1, 0.8, 0.5)
        wait(0.2)
        SpawnFire({-8 + 16 * math.random(), 4 * math.random(), 0})
        wait(0.1)
        SaveAndLoad()
        wait(0.2)
    end
end
