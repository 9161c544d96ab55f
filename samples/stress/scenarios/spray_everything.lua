-- All surfaces are painted, with blending palettes and with the paint layer, while they break.
function init()
    Box("ground", {-10, -0.4, -10}, {200, 4, 200}, 6)
end

function build()
    for _, body in ipairs(FindBodies("wall")) do Delete(body) end
    for i = 0, 5 do Box("wall", {-8 + 3 * i, 0, 0}, {25, 25, 4}, 5 + i % 4) end
end

function update()
    local step = math.floor(GetTime() * 60 + 0.5)
    if step % 1800 == 1 then build() end
    if step % 300 == 0 then Settings{paint_layer = step % 600 == 0} end
    for i = 1, 3 do
        PaintRGBA({-8 + 18 * math.random(), 2.5 * math.random(), 0.4 * math.random(0, 1)}, 0.2 + 0.6 * math.random(),
            math.random(), math.random(), math.random(), math.random(), math.random())
    end
    if step % 10 == 0 then Paint({-8 + 18 * math.random(), 2 * math.random(), 0}, 0.5, "explosion", 0.8) end
    if step % 20 == 0 then MakeHole({-8 + 18 * math.random(), 2.5 * math.random(), 0.2}, 0.4, 0.3) end
end
