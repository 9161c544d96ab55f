-- A light at a place that fades. Color {r, g, b} of 1, watts per steradian.
return function(pos, color, intensity, seconds)
    start(function()
        local steps = math.max(1, math.floor(60 * seconds))
        for i = 0, steps - 1 do
            local share = intensity * (1 - i / steps) ^ 2
            PointLight(pos, color[1] * share, color[2] * share, color[3] * share, 1)
            wait(0)
        end
    end)
end
