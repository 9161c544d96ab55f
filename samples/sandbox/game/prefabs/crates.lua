-- A heap of boxes that falls nicely.
return {name = "Heap of boxes", pieces = function(model)
    local list = {}
    local paints = {"plank", "wood", "plank", "worn"}
    for layer = 0, 3 do
        for i = 0, 3 - layer do
            for k = 0, 1 do
                local m = model(6, 6, 6)
                m:box(0, 0, 0, 5, 5, 5, paints[(layer + i + k) % 4 + 1])
                for _, y in ipairs({0, 5}) do m:box(0, y, 0, 5, y, 5, "wood") end
                list[#list + 1] = {model = m, at = Vec(0.63 * (i - (3 - layer) / 2), 0.6 * layer, 0.63 * (k - 0.5)),
                    density = 0.3}
            end
        end
    end
    return list
end}
