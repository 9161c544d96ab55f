-- An arch of stones that hold each other.
return {name = "Arch", pieces = function(model)
    local m = model(44, 30, 8)
    for x = 0, 43 do
        for y = 0, 29 do
            local r = math.sqrt((x - 21.5) ^ 2 + (y - 6) ^ 2)
            local isLeg = y < 6 and (x < 7 or x > 36)
            if isLeg or y >= 6 and r > 15 and r < 22.2 then
                local stone = isLeg and y // 3 + x // 40 or math.floor(math.atan(y - 6, x - 21.5) * 22 / math.pi)
                m:box(x, y, 0, x, y, 7, stone % 2 == 0 and "concrete" or "mortar")
            end
        end
    end
    return {{model = m}}
end}
