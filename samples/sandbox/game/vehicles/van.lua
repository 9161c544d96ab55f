-- A delivery van with an empty cargo space.
local build = require("vehicles/build")
local parts = require("vehicles/parts")

local van = {name = "van", camera = {height = 2.0, distance = 8}, exit = Vec(-1.8, 0.3, -1.2), pitch = 0.85,
    engine = {Vec(-0.4, 0.5, -2.3), Vec(0.4, 0.85, -1.8)}}

local function model()
    local m = build.model({22, 25, 52}, {11, 0, 26})
    m:box(1, 3, 1, 20, 12, 50, "cream")
    m:box(1, 3, 0, 20, 5, 51, "black")
    m:clear(2, 5, 10, 19, 12, 50)
    m:clear(3, 5, 2, 18, 10, 8)
    m:box(6, 5, 3, 15, 8, 8, "dark")                        -- engine
    m:box(2, 4, 10, 19, 4, 49, "plank")                     -- floor
    m:cabin({x0 = 1, x1 = 20, low = 13, top = 22, z0 = 5, z1 = 50, front = 0.8, paint = "cream", posts = {12}})
    m:box(1, 13, 20, 20, 22, 50, "cream")                   -- the closed box
    m:clear(2, 13, 21, 19, 21, 49)
    m:box(1, 13, 19, 20, 22, 19, "cream")
    m:box(2, 5, 19, 19, 21, 19, "cream")                    -- bulkhead
    m:box(2, 23, 16, 19, 23, 49, "cream")
    m:pair(1, 9, 20, 1, 11, 49, "blue")                     -- a stripe
    m:pair(1, 9, 10, 1, 11, 18, "blue")
    m:pair(3, 5, 13, 9, 8, 17, "cloth")
    m:pair(3, 9, 17, 9, 14, 17, "cloth")
    m:box(2, 10, 9, 19, 12, 11, "black")
    m:box(4, 13, 12, 8, 14, 12, "black")
    m:pair(0, 13, 9, 0, 16, 9, "black")
    for _, z in ipairs({10, 40}) do
        m:pairDisc(1, 1, 4.5, z, 6.1, "black")
        m:pairDisc(1, 4, 4.5, z, 5.2)
        m:pair(5, 4, z - 1, 10, 5, z, "dark")
        m:pair(4, 4, z - 1, 4, 5, z, "dark")
    end
    m:pair(2, 8, 0, 5, 10, 1, "lamp")
    m:pair(2, 7, 0, 5, 7, 1, "amber")
    m:box(6, 6, 0, 15, 11, 1, "black")
    m:box(6, 9, 0, 15, 9, 0, "chrome")
    m:box(9, 4, 0, 12, 4, 0, "plate")
    m:pair(1, 7, 51, 2, 13, 51, "tail")
    m:box(3, 6, 51, 18, 21, 51, "cream")                    -- rear doors
    m:box(10, 6, 51, 11, 21, 51, "black")
    m:pair(4, 15, 51, 8, 19, 51, "glass")
    m:box(9, 11, 51, 9, 12, 51, "chrome")
    m:pair(1, 6, 19, 1, 21, 19, "black")                    -- seams of the doors
    m:pair(1, 6, 33, 1, 21, 33, "black")
    m:pair(1, 12, 17, 1, 12, 18, "chrome")
    m:pair(1, 12, 31, 1, 12, 32, "chrome")
    return m
end

function van.build(v, frame)
    parts.add(v, "chassis", model(), frame, 0.16)
    parts.axles(v, frame, 0.86, -1.6, 1.4, {radius = 0.45, width = 0.3, steer = 0.55, density = 0.35, drive = 3000,
        brake = 5500, maxSpin = 48, breakForce = 1.2e5, rim = "steel"})
    for _, x in ipairs({-0.75, 0.75}) do parts.lamp(v, Vec(x, 0.95, -2.65)) end
end

return van
