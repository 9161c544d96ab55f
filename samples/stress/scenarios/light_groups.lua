-- Glowing signs and their lights are switched, cut and destroyed.
function sign(x, y)
    local group = LightGroup(0.3 + 0.4 * math.random())
    local shape = Box("sign", {x, y, 0}, {12, 6, 2}, 8, {dynamic = math.random() < 0.3})
    Glow(shape, 8, 20, group)
    AddLight({0.6, 0.3, 0.3}, shape, group)
    return group
end

function init()
    Box("ground", {-12, -0.4, -12}, {240, 4, 240}, 6)
    while true do
        local groups = {}
        for i = 0, 7 do groups[#groups + 1] = sign(-8 + 2 * i, 0.5 + i % 3) end
        wait(0.2)
        for i = 1, 25 do
            SwitchLightGroup(groups[math.random(#groups)], math.random() < 0.5)
            MakeHole({-8 + 16 * math.random(), 3 * math.random(), 0.1}, 0.3, 0.3, 0.3)
            if i % 6 == 0 then Explosion({-8 + 16 * math.random(), 1, 0}, 1) end
            wait(0.1)
        end
        for _, body in ipairs(FindBodies("sign")) do Delete(body) end
        wait(0.2)
    end
end
