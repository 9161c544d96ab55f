-- Marks, undo and redo in random order between edits.
function build()
    for _, tag in ipairs{"tower", "extra"} do
        for _, body in ipairs(FindBodies(tag)) do Delete(body) end
    end
    for i = 0, 3 do Box("tower", {-6 + 3 * i, 0, 0}, {12, 40, 12}, 5 + i % 3) end
    wait(0.1)
end

function init()
    UndoLimit(8)
    Box("ground", {-10, -0.4, -10}, {200, 4, 200}, 6)
    for round = 0, math.huge do
        if round % 150 == 0 then build() end
        local choice = math.random(10)
        local pos = Vec(-6 + 12 * math.random(), 4 * math.random(), 1.2 * math.random())
        if choice <= 3 then
            UndoMark()
            MakeHole(pos, 0.8, 0.8, 0.5)
        elseif choice <= 5 then
            Explosion(pos, 1.5)
        elseif choice <= 8 then
            Undo()
        elseif choice == 9 then
            Redo()
        else
            PaintRGBA(pos, 0.6, math.random(), 0, 0, 1, 1)
            Box("extra", pos + Vec(0, 3, 0), {4, 4, 4}, 5, {dynamic = true})
        end
        wait(0.1 * math.random(0, 3))
    end
end
