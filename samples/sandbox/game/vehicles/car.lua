-- A saloon: four wheels, all driven.
local build = require("vehicles/build")
local parts = require("vehicles/parts")

local car = {name = "car", camera = {height = 1.5, distance = 6.5}, exit = Vec(-1.7, 0.3, 0), lift = 0.0,
    engine = {Vec(-0.35, 0.4, -1.7), Vec(0.35, 0.65, -1.1)}, pitch = 1}

local function model()
    local m = build.model({20, 16, 42}, {10, 0, 21})
    m:box(1, 3, 1, 18, 8, 40, "red")
    m:box(2, 4, 0, 17, 7, 41, "red")
    m:box(1, 3, 1, 18, 3, 40, "black")
    m:box(2, 9, 3, 17, 9, 13, "red")                       -- bonnet and boot
    m:box(2, 9, 33, 17, 9, 39, "red")
    m:clear(3, 4, 3, 16, 7, 12)
    m:clear(2, 4, 15, 17, 8, 32)
    m:clear(3, 4, 34, 16, 7, 38)
    m:box(6, 4, 4, 13, 6, 10, "dark")                      -- engine, radiator
    m:box(5, 4, 2, 14, 7, 2, "steel")
    m:box(1, 9, 13, 18, 9, 33, "red")
    m:clear(2, 9, 14, 17, 9, 32)
    m:cabin({x0 = 2, x1 = 17, low = 10, top = 15, z0 = 13, z1 = 33, front = 1.0, back = 0.7, paint = "red",
        posts = {23}})
    for _, z in ipairs({17, 26}) do                        -- seats
        m:pair(3, 4, z, 8, 6, z + 5, "cloth")
        m:pair(3, 7, z + 5, 8, 11, z + 5, "cloth")
    end
    m:box(2, 7, 14, 17, 8, 15, "black")
    m:box(4, 9, 16, 7, 10, 16, "black")
    m:pair(0, 9, 16, 0, 10, 16, "red")                     -- mirrors
    m:pair(1, 9, 16, 1, 9, 16, "black")
    for _, z in ipairs({8, 33}) do                         -- arches and axles
        m:pairDisc(1, 1, 4, z, 5.4, "black")
        m:pairDisc(1, 4, 4, z, 4.6)
        m:box(5, 3, z - 1, 14, 4, z, "dark")
        m:pair(4, 3, z - 1, 4, 4, z, "dark")
    end
    m:pair(2, 6, 0, 5, 7, 0, "lamp")
    m:pair(6, 6, 0, 6, 7, 0, "amber")
    m:pair(2, 6, 41, 5, 7, 41, "tail")
    m:box(7, 5, 0, 12, 7, 0, "black")
    m:box(7, 7, 0, 12, 7, 0, "chrome")
    m:box(2, 3, 0, 17, 4, 0, "chrome")                     -- bumpers
    m:box(2, 3, 41, 17, 4, 41, "chrome")
    m:box(8, 4, 0, 11, 4, 0, "plate")
    m:box(8, 5, 41, 11, 5, 41, "plate")
    for _, z in ipairs({14, 23, 31}) do m:pair(1, 5, z, 1, 9, z, "black") end
    for _, z in ipairs({20, 28}) do m:pair(1, 8, z, 1, 8, z + 1, "chrome") end
    return m
end

function car.build(v, frame)
    parts.add(v, "chassis", model(), frame, 0.18)
    parts.axles(v, frame, 0.77, -1.3, 1.2, {radius = 0.4, width = 0.2, steer = 0.55, density = 0.35, drive = 2000,
        brake = 3200, maxSpin = 62, breakForce = 9e4, height = 0.4})
    for _, x in ipairs({-0.62, 0.62}) do parts.lamp(v, Vec(x, 0.68, -2.15)) end
end

return car
