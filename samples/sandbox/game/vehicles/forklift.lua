-- A forklift: steered behind, its fork goes up and down a mast.
local build = require("vehicles/build")
local parts = require("vehicles/parts")

local forklift = {name = "forklift", camera = {height = 1.7, distance = 6}, exit = Vec(-1.4, 0.3, 0.2), pitch = 1.15,
    isRearSteered = true, engine = {Vec(-0.3, 0.5, 0.5), Vec(0.3, 0.75, 0.8)}, keys = {{"liftup liftdown", "fork up, down"}}}
local kSpeed, kStrength = 0.7, 4e4

local function bodyModel()
    local m = build.model({16, 25, 28}, {8, 0, 14})
    m:box(2, 2, 5, 13, 6, 24, "orange")
    m:box(2, 2, 5, 13, 2, 24, "black")
    m:box(2, 5, 19, 13, 11, 26, "weight")                   -- counterweight
    m:box(3, 9, 19, 12, 11, 26, "orange")
    m:box(2, 7, 20, 13, 8, 26, "orange")
    m:clear(4, 3, 8, 11, 5, 13)
    m:box(4, 4, 18, 11, 8, 22, "dark")                      -- engine
    m:box(3, 7, 14, 12, 10, 18, "orange")
    m:box(4, 11, 14, 11, 11, 18, "black")                   -- seat
    m:box(4, 12, 18, 11, 16, 18, "black")
    m:box(3, 7, 5, 12, 10, 6, "orange")                     -- dashboard
    m:box(7, 10, 8, 8, 11, 8, "black")
    m:box(6, 11, 8, 9, 12, 9, "black")
    m:pair(2, 7, 6, 2, 24, 6, "dark")                       -- overhead guard
    m:pair(2, 12, 20, 2, 24, 20, "dark")
    m:box(2, 24, 6, 13, 24, 20, "dark")
    for z = 8, 18, 3 do m:clear(3, 24, z, 12, 24, z + 1) end
    m:box(7, 25, 19, 8, 25, 20, "amber")
    m:pair(3, 22, 5, 4, 23, 5, "lamp")
    m:pair(2, 7, 26, 3, 8, 26, "tail")
    m:pair(4, 1, 3, 5, 24, 4, "dark")                       -- mast
    m:box(4, 24, 3, 11, 24, 4, "dark")
    m:box(4, 2, 4, 11, 5, 5, "dark")
    m:box(4, 14, 4, 11, 14, 4, "dark")
    m:box(7, 3, 4, 8, 20, 4, "chrome")                      -- piston
    for _, z in ipairs({8, 22}) do
        m:pairDisc(0, 2, 3.5, z, 4.2)
        m:pair(3, 3, z - 1, 7, 4, z, "dark")
        m:pair(2, 3, z - 1, 2, 4, z, "dark")
    end
    m:pair(2, 4, 12, 2, 5, 16, "black")                     -- steps
    return m
end

-- In cells of half the size.
local function forkModel()
    local m = build.model({24, 18, 30}, {12, 0, 28}, 0.05)
    m:box(2, 1, 26, 21, 3, 27, "dark")
    m:box(2, 10, 26, 21, 12, 27, "dark")
    m:pair(2, 1, 26, 3, 17, 27, "dark")
    m:pair(7, 1, 26, 8, 17, 27, "dark")
    m:box(2, 16, 26, 21, 17, 27, "dark")
    m:pair(3, 0, 24, 6, 13, 25, "worn")
    m:pair(3, 0, 2, 6, 1, 25, "worn")
    m:pair(4, 0, 0, 5, 0, 1, "worn")
    m:pair(8, 0, 27, 10, 8, 29, "dark")                     -- rollers in the mast
    m:pair(4, 3, 28, 7, 8, 28, "dark")
    return m
end

function forklift.build(v, frame)
    parts.add(v, "chassis", bodyModel(), frame, 0.3)
    local wheel = {radius = 0.35, width = 0.2, density = 0.5, drive = 1800, brake = 3000, maxSpin = 18, steer = 0.9,
        breakForce = 1.5e5, rim = "orange", hertz = 14, isRearSteered = true}
    parts.axles(v, frame, 0.67, -0.6, 0.8, wheel)
    parts.add(v, "fork", forkModel(), frame * Transform(Vec(0, 0.08, -1.15)), 0.4)
    parts.joint(v, "fork", "prismatic", v.chassis, v.fork, frame, Vec(0, 0.5, -1.08), QuatEuler(0, 0, 90),
        {min = -0.03, max = 1.75, reach = 0.5})
    for _, x in ipairs({-0.45, 0.45}) do parts.lamp(v, Vec(x, 2.3, -0.95)) end
end

function forklift.update(v, input)
    parts.move(v.fork, kSpeed * input.lift, kStrength)
end

return forklift
