-- Nine bullets a step at a row of walls of different materials.
local materials = {5, 6, 7, 8, 9, 15}

function wall(i)
    return Box("wall", {-12 + 4 * i, 0, 0}, {36, 30, 3}, materials[i])
end

function init()
    Box("ground", {-20, -0.4, -20}, {400, 4, 400}, 6)
    for i = 1, #materials do wall(i) end
    while true do
        wait(10)
        for _, shape in ipairs(FindShapes("wall")) do Delete(shape) end
        wait(0.1)
        for i = 1, #materials do wall(i) end
    end
end

function update()
    for i = 1, 9 do
        local target = Vec(-8 + 24 * math.random(), 3 * math.random(), 0)
        local origin = target + Vec(math.random() - 0.5, math.random(), -8)
        Shoot(origin, VecNormalize(target - origin), "bullet", 1, 40)
    end
end
