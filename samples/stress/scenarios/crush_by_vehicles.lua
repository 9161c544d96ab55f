-- Cars drive through walls and over each other.
local cars = {}

function car(x, z, angle)
    local chassis, body = Box("car", {x - 0.8, 0.4, z - 1.5}, {16, 6, 30}, 9, {dynamic = true})
    for _, side in ipairs{-1, 1} do
        for _, axle in ipairs{-1, 1} do
            local center = Vec(x + side * 0.95, 0.35, z + axle * 1)
            local wheel = Ball("wheel", center, 7, 19, {dynamic = true})
            CollideAs(wheel, "sphere")
            Joint("wheel", chassis, wheel, center, {drive = 1500, brake = 3000, steer = axle > 0 and 0.5 or 0, hertz = 5,
                damping = 0.7, anchor_radius = 0.6})
        end
    end
    cars[#cars + 1] = body
end

-- Everything as at the beginning.
function park()
    for _, tag in ipairs{"car", "wheel", "wall", "crate"} do
        for _, body in ipairs(FindBodies(tag)) do Delete(body) end
    end
    cars = {}
    for i = -2, 2 do car(4 * i, -12) end
    for i = -3, 3 do Box("wall", {3 * i, 0, 0}, {25, 20, 2}, 7) end
    for i = -3, 3 do Box("crate", {3 * i, 0, 4}, {8, 8, 8}, 5, {dynamic = true}) end
    wait(0.5)
end

function init()
    Box("ground", {-30, -0.4, -30}, {600, 4, 600}, 6)
    for round = 0, math.huge do
        if round % 4 == 0 then park() end
        for _, body in ipairs(cars) do Drive(body, 1, 0.4 * math.random() - 0.2, 0) end
        wait(3)
        for _, body in ipairs(cars) do Drive(body, -1, 2 * math.random() - 1, 0) end
        wait(2)
        for _, body in ipairs(cars) do Drive(body, 0, 0, 1) end
        wait(1)
    end
end
