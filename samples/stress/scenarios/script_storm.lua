-- A thousand coroutines read, draw, wait and edit.
local walls = {}

function worker(i)
    math.random()
    while true do
        local shape = walls[1 + i % #walls]
        if IsHandleValid(shape) then
            local hit, dist = QueryRaycast({-6 + 12 * math.random(), 2 * math.random(), -5}, {0, 0, 1}, 10)
            if i % 50 == 0 then
                SetBrush(i % 100 == 0 and "cube" or "sphere", math.random(1, 4), math.random(0, 1) * 7)
                DrawShapeBox(shape, 1, math.random(0, 19), 0, math.random(1, 29), math.random(0, 19), 2)
            elseif i % 51 == 0 and hit then
                MakeHole({-6 + 12 * math.random(), 2 * math.random(), 0.1}, 0.2, 0.2)
            elseif i % 53 == 0 then
                SetTag(shape, "tag" .. i, tostring(math.random(5)))
            end
        end
        wait(0.2 + 0.6 * math.random())
    end
end

function build()
    for _, body in ipairs(FindBodies("wall")) do Delete(body) end
    for i = 1, 4 do walls[i] = Box("wall", {-9 + 3 * i, 0, 0}, {30, 20, 3}, 7) end
    wait(0.1)
end

function init()
    Box("ground", {-12, -0.4, -12}, {240, 4, 240}, 6)
    build()
    for i = 1, 900 do start(worker, i) end
    while true do
        wait(20)
        build()
    end
end
