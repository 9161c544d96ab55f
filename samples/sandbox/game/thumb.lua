-- Small pictures of models: each pixel is a ray through the cells. Runs of one colour are kept, and drawn as rectangles.
local thumb = {}
local kWork = 9000                                       -- cells that are looked at in one go
local work = 0
local kPixels = 52
local kDir = VecNormalize(Vec(0.62, -0.42, 0.66))         -- from the front left, from above
local kRight = VecNormalize(VecCross(kDir, Vec(0, 1, 0)))
local kUp = VecCross(kRight, kDir)
local kShade = {0.72, 1.18, 0.95}                         -- of faces across x, y and z

-- Within a coroutine: enough for now after so many cells.
local function spend(cells)
    work = work + cells
    if work < kWork then return end
    work = 0
    coroutine.yield()
end

-- The cells of a model as a list of entries, x first, then y, then z.
local function cellsOf(model)
    local sx, sy, sz = model.size[1], model.size[2], model.size[3]
    local cells = {}
    for _, b in ipairs(model.boxes) do
        local shades, entry = b[8] or 1, b[7]
        for z = math.max(b[3], 0), math.min(b[6], sz - 1) do
            for y = math.max(b[2], 0), math.min(b[5], sy - 1) do
                local row = (z * sy + y) * sx
                spend(math.max(0, b[4] - b[1]) // 4 + 1)
                for x = math.max(b[1], 0), math.min(b[4], sx - 1) do
                    cells[row + x] = entry > 0 and entry + (x // 3 + y // 2 + z // 3) % shades or nil
                end
            end
        end
    end
    return cells
end

-- Where a ray enters the box from 0 to `size`, where it leaves it, and across which axis it came in; nil: it misses.
local function clip(o, d, size)
    local near, far, axis = -math.huge, math.huge, 1
    for k = 1, 3 do
        if math.abs(d[k]) < 1e-9 then
            if o[k] < 0 or o[k] > size[k] then return nil end
        else
            local a, b = -o[k] / d[k], (size[k] - o[k]) / d[k]
            if a > b then a, b = b, a end
            if a > near then near, axis = a, k end
            far = math.min(far, b)
        end
    end
    if near < far then return near, far, axis end
end

-- The first cell on a ray, in cells of the model: its entry, how far it is, and across which axis it is met.
local function march(cells, size, o, d)
    local t, far, axis = clip(o, d, size)
    if not t then return nil, nil, nil, 1 end
    local at, step, due, gap = {}, {}, {}, {}
    for k = 1, 3 do
        at[k] = math.max(0, math.min(size[k] - 1, math.floor(o[k] + (t + 1e-6) * d[k])))
        step[k] = d[k] < 0 and -1 or 1
        gap[k] = math.abs(d[k]) < 1e-9 and math.huge or 1 / math.abs(d[k])
        due[k] = gap[k] == math.huge and math.huge or (at[k] + (d[k] > 0 and 1 or 0) - o[k]) / d[k]
    end
    local steps = 0
    while true do
        steps = steps + 1
        local entry = cells[(at[3] * size[2] + at[2]) * size[1] + at[1]]
        if entry then return entry, t, axis, steps end
        axis = due[1] < due[2] and (due[1] < due[3] and 1 or 3) or (due[2] < due[3] and 2 or 3)
        t = due[axis]
        if t >= far then return nil, nil, nil, steps end
        at[axis], due[axis] = at[axis] + step[axis], due[axis] + gap[axis]
        if at[axis] < 0 or at[axis] >= size[axis] then return nil, nil, nil, steps end
    end
end

-- A vector as plain numbers, which cost less.
local function plain(v)
    return {v.x, v.y, v.z}
end

-- What rays need of a piece: its cells, where the picture's middle is in these, and how far a step to the right, upwards
-- and ahead goes.
local function prepare(piece, middle)
    local model, back = piece.model, QuatEuler(0, -(piece.turn or 0), 0)
    if piece.rot then back = TransformToLocalTransform(Transform(Vec(), piece.rot), Transform()).rot end
    local scale = 1 / (model.voxel or 0.1)
    local origin = Vec(model.origin[1], model.origin[2], model.origin[3])
    return {cells = cellsOf(model), model = model, dir = plain(VecScale(back * kDir, scale)),
        right = plain(VecScale(back * kRight, scale)), up = plain(VecScale(back * kUp, scale)),
        from = plain(VecScale(back * (middle - 60 * kDir - (piece.at or Vec())), scale) + origin)}
end

local function colorAt(pieces, u, v)
    local best, color, o = math.huge, nil, {}
    for _, p in ipairs(pieces) do
        for k = 1, 3 do o[k] = p.from[k] + u * p.right[k] + v * p.up[k] end
        local entry, t, axis, steps = march(p.cells, p.model.size, o, p.dir)
        spend(steps + 8)
        if entry and t < best then
            local c = p.model.palette[entry]
            local lift = kShade[axis] * (1 + 0.25 * math.min(1, c.emission or 0))
            best = t
            color = {}
            for k = 1, 3 do color[k] = math.min(1, c[k] * lift + 0.06) end
        end
    end
    return color
end

local function isSame(a, b)
    return a and b and a[1] == b[1] and a[2] == b[2] and a[3] == b[3]
end

-- Of pieces {model =, at =, turn =}, whose box is low to high: runs {x, y, length, color} of a square. Within a
-- coroutine, which it yields from.
function thumb.make(list, low, high)
    local pieces, middle = {}, VecLerp(low, high, 0.5)
    for i, piece in ipairs(list) do pieces[i] = prepare(piece, middle) end
    local wide, tall = 0, 0
    for k = 0, 7 do
        local corner = Vec(k & 1 > 0 and high.x or low.x, k & 2 > 0 and high.y or low.y, k & 4 > 0 and high.z or low.z)
        wide = math.max(wide, math.abs(VecDot(corner - middle, kRight)))
        tall = math.max(tall, math.abs(VecDot(corner - middle, kUp)))
    end
    local unit = 2 * math.max(wide, tall) / kPixels
    local runs = {}
    for y = 0, kPixels - 1 do
        local run
        for x = 0, kPixels - 1 do
            local u, v = (x + 0.5 - kPixels / 2) * unit, (kPixels / 2 - y - 0.5) * unit
            local color = colorAt(pieces, u, v)
            if run and isSame(run[4], color) then
                run[3] = run[3] + 1
            else
                run = color and {x, y, 1, color}
                runs[#runs + 1] = run
            end
        end
    end
    return runs
end

-- Its middle here, `size` wide.
function thumb.draw(runs, size, alpha)
    local unit = size / kPixels
    UiPush()
    UiAlign("left top")
    UiTranslate(-size / 2, -size / 2)
    for _, run in ipairs(runs) do
        local c = run[4]
        UiPush()
        UiColor(c[1], c[2], c[3], alpha or 1)
        UiTranslate(run[1] * unit, run[2] * unit)
        UiRect(run[3] * unit + 0.4, unit + 0.4)
        UiPop()
    end
    UiPop()
end

return thumb
