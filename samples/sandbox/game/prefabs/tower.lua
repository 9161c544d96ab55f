-- A lookout on four legs with braces, a floor, a rail and a roof.
return {name = "Lookout", pieces = function(model)
    local m = model(24, 70, 24)
    for _, x in ipairs({2, 20}) do
        for _, z in ipairs({2, 20}) do m:box(x, 0, z, x + 1, 58, z + 1, "wood") end
    end
    for _, z in ipairs({2, 21}) do
        for y = 2, 22, 20 do
            m:bar({3, y, z}, {20, y + 18, z}, 1, "plank")
            m:bar({20, y, z}, {3, y + 18, z}, 1, "plank")
            m:bar({z, y, 3}, {z, y + 18, 20}, 1, "plank")
            m:bar({z, y, 20}, {z, y + 18, 3}, 1, "plank")
        end
    end
    for x = 0, 23 do m:box(x, 42, 0, x, 42, 23, x % 3 == 2 and "wood" or "plank") end
    m:box(2, 41, 2, 21, 41, 2, "wood")
    m:box(2, 41, 21, 21, 41, 21, "wood")
    for _, at in ipairs({0, 23}) do
        for y = 46, 50, 4 do
            m:box(at, y, 0, at, y, 23, "plank")
            m:box(0, y, at, 23, y, at, "plank")
        end
        for i = 0, 23, 23 do m:box(at, 43, i, at, 50, i, "wood") end
    end
    m:box(2, 58, 2, 21, 58, 2, "wood")
    m:box(2, 58, 21, 21, 58, 21, "wood")
    for i = 0, 11 do m:box(i, 59 + i * 5 // 6, i, 23 - i, 59 + i * 5 // 6, 23 - i, "tile") end
    return {{model = m, density = 0.8}}
end}
