-- A lorry whose bed tips: R and F.
local build = require("vehicles/build")
local parts = require("vehicles/parts")

local truck = {name = "truck", camera = {height = 2.4, distance = 10}, exit = Vec(-2.0, 0.3, -2.2), pitch = 0.65,
    engine = {Vec(-0.4, 0.7, -2.2), Vec(0.4, 1.05, -1.7)}, keys = {{"liftup liftdown", "tip the bed"}}}

local function cabModel()
    local m = build.model({24, 27, 66}, {12, 0, 33})
    m:pair(7, 6, 8, 9, 8, 63, "dark")                        -- frame
    for _, z in ipairs({30, 46, 60}) do m:box(8, 6, z, 15, 8, z + 1, "dark") end
    m:box(1, 4, 2, 22, 6, 3, "black")
    m:box(1, 6, 2, 22, 14, 21, "green")
    m:clear(2, 9, 4, 21, 14, 20)
    m:box(8, 6, 8, 15, 10, 16, "dark")                       -- engine
    m:box(2, 8, 4, 21, 8, 20, "black")
    m:cabin({x0 = 1, x1 = 22, low = 15, top = 24, z0 = 2, z1 = 21, front = 0.2, paint = "green", posts = {14, 15}})
    m:box(1, 15, 21, 22, 24, 21, "green")
    m:pair(5, 16, 21, 9, 21, 21, "glass")
    m:pair(3, 9, 13, 9, 11, 18, "cloth")
    m:pair(3, 12, 18, 9, 17, 18, "cloth")
    m:box(2, 12, 3, 21, 14, 5, "black")
    m:box(4, 15, 6, 8, 16, 6, "black")
    m:pair(0, 16, 3, 0, 20, 4, "black")
    m:pair(2, 9, 1, 5, 11, 1, "lamp")
    m:pair(2, 8, 1, 5, 8, 1, "amber")
    m:box(6, 7, 1, 17, 12, 1, "black")
    for y = 8, 12, 2 do m:box(6, y, 1, 17, y, 1, "chrome") end
    m:box(1, 4, 1, 22, 6, 1, "chrome")
    m:box(10, 5, 0, 13, 5, 0, "plate")
    m:box(10, 5, 1, 13, 5, 1, "chrome")
    m:pair(1, 7, 20, 1, 14, 20, "black")
    m:pair(1, 12, 16, 1, 12, 18, "chrome")
    m:pair(1, 25, 8, 2, 25, 8, "amber")
    m:pair(20, 9, 22, 20, 26, 22, "chrome")                  -- exhausts
    for _, z in ipairs({12, 50}) do
        m:pairDisc(1, 5, 5, z, 6)
        m:pair(6, 5, z - 1, 11, 6, z, "dark")
        m:pair(5, 5, z - 1, 5, 6, z, "dark")
    end
    m:pair(1, 3, 26, 5, 8, 38, "steel")                      -- tanks
    m:pair(6, 6, 27, 6, 7, 37, "dark")
    m:pair(2, 6, 64, 6, 8, 64, "tail")
    m:box(1, 6, 63, 22, 8, 63, "dark")
    return m
end

local function bedModel()
    local m = build.model({24, 12, 42}, {12, 0, 41})
    m:box(0, 0, 0, 23, 1, 41, "plank")
    m:box(0, 1, 0, 23, 8, 41, "steel")
    m:clear(1, 1, 1, 22, 8, 40)
    m:box(0, 8, 0, 23, 11, 0, "steel")
    for z = 0, 41, 6 do m:pair(0, 0, z, 0, 8, z, "green") end
    m:box(0, 8, 0, 0, 8, 41, "green")
    m:box(23, 8, 0, 23, 8, 41, "green")
    m:box(0, 8, 41, 23, 8, 41, "green")
    m:pair(4, 2, 41, 4, 7, 41, "green")
    m:pair(10, 2, 41, 10, 7, 41, "green")
    m:pair(7, 0, 0, 9, 0, 41, "dark")
    return m
end

function truck.build(v, frame)
    parts.add(v, "chassis", cabModel(), frame, 0.22)
    parts.axles(v, frame, 0.95, -2.1, 1.7, {radius = 0.5, width = 0.4, steer = 0.5, density = 0.4, drive = 6000,
        brake = 9000, maxSpin = 32, breakForce = 2.5e5, rim = "steel"})
    parts.add(v, "bed", bedModel(), frame * Transform(Vec(0, 1.0, 3.1)), 0.12)
    if v.bed.shape ~= 0 then SetShapeCollisionFilter(v.bed.shape, 1, 255 - parts.wheelLayer) end
    parts.joint(v, "bed", "hinge", v.chassis, v.bed, frame, Vec(0, 1.0, 2.95), QuatEuler(0, 0, 0),
        {min = -0.02, max = 0.85, reach = 0.5})
    for _, x in ipairs({-0.85, 0.85}) do parts.lamp(v, Vec(x, 1.05, -3.3)) end
end

function truck.update(v, input)
    parts.move(v.bed, 0.5 * input.lift, 4e5)
end

return truck
