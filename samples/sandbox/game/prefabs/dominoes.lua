-- A row of slabs: push the first one.
return {name = "Dominoes", pieces = function(model)
    local list = {}
    local paints = {"cream", "red", "cream", "blue"}
    for i = 0, 11 do
        local m = model(8, 16, 2)
        m:box(0, 0, 0, 7, 15, 1, paints[i % 4 + 1])
        m:box(0, 8, 0, 7, 8, 1, "black")
        list[#list + 1] = {model = m, at = Vec(0, 0, 0.9 * (i - 5.5)), density = 0.2}
    end
    return list
end}
