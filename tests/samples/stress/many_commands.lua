-- 120,000 commands: what their list itself takes is no leak of the library.
function update()
    for i = 1, 100 do SetGravity(Vec(0, -9.81 - 0.001 * i, 0)) end
end
