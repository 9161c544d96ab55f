-- A hut of boards with a window, and a roof on rafters.
return {name = "Hut", pieces = function(model)
    local m = model(36, 32, 30)
    local function boards(x0, z0, x1, z1)
        for i = 0, math.max(x1 - x0, z1 - z0) do
            local x, z = x0 + (x1 > x0 and i or 0), z0 + (z1 > z0 and i or 0)
            m:box(x, 1, z, x, 22, z, i % 3 == 2 and "wood" or "plank")
        end
    end
    m:box(1, 0, 1, 34, 0, 28, "wood")
    boards(2, 2, 33, 2)
    boards(2, 27, 33, 27)
    boards(2, 2, 2, 27)
    boards(33, 2, 33, 27)
    for _, x in ipairs({2, 33}) do
        for _, z in ipairs({2, 27}) do m:box(x, 0, z, x, 22, z, "wood") end
    end
    m:clear(13, 1, 2, 21, 18, 2)                              -- a door
    m:box(12, 1, 2, 12, 19, 2, "wood")
    m:box(22, 1, 2, 22, 19, 2, "wood")
    m:box(12, 19, 2, 22, 19, 2, "wood")
    m:box(33, 9, 10, 33, 16, 19, "wood")                      -- a window
    m:box(33, 10, 11, 33, 15, 18, "pane")
    m:box(33, 10, 14, 33, 15, 14, "wood")
    for i = 0, 16 do                                          -- a roof
        local y = 23 + i // 2
        m:box(0, y, i - 1, 35, y, i, "tile")
        m:box(0, y, 30 - i, 35, y, 31 - i, "tile")
        if i > 1 then
            for _, x in ipairs({2, 33}) do m:box(x, 22, i, x, y - 1, 29 - i, "plank") end
        end
    end
    return {{model = m, density = 0.8}}
end}
