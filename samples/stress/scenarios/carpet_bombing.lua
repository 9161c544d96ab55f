-- Explosions in rows over a town, row by row, twice; then over the town as it was.
local row, column = 0, 0

function init()
    LoadLevel("town")
end

function update()
    if math.floor(GetTime() * 60) % 6 ~= 3 then return end
    local pos = Vec(4 + 5 * column + math.random(), 1 + 4 * math.random(), 4 + 5 * (row % 9) + math.random())
    Explosion(pos, 1 + 2 * math.random())
    column = column + 1
    if column > 10 then column, row = 0, row + 1 end
    if row > 17 then row = 0 LoadLevel("town") end
end
