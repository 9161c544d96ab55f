-- Wrecking drone: the crate flies to points of the wall, one after the other, rams them, and comes back.
local home, drone, left = Vec(0, 1.5, -3), 0, 0

local function fly(to, speed)
    for _ = 1, 90 do
        if not IsHandleValid(drone) then return end
        local frame = GetBodyTransform(drone)
        local center = frame * GetBodyCenterOfMass(drone)
        if VecLength(to - center) < 0.3 then return end
        ConstrainPosition(drone, 0, center, to, speed, 4000)
        ConstrainOrientation(drone, 0, frame.rot, Quat(), 4, 500)
        wait(0)
    end
end

function init()
    drone = FindBody("crate")
    local targets = {Vec(-1.2, 1.8, 0.1), Vec(0.3, 1.2, 0.1), Vec(1.3, 2, 0.1)}
    left = #targets
    local before = GetShapeVoxelCount(FindShape("wall"))
    for _, target in ipairs(targets) do
        fly(home, 4)
        fly(target - Vec(0, 0, 0.6), 12)
        MakeHole(target, 0.5, 0.4, 0.1)
        Paint(target, 0.9, "explosion", 0.6)
        left = left - 1
    end
    fly(home, 4)
    SetInt("drone.removed", before - GetShapeVoxelCount(FindShape("wall")))
    print("done")
end

function draw()
    local x, y, depth = UiWorldToPixel(home + Vec(0, 0.8, 0))
    if depth < 0 then return end
    UiTranslate(x, y)
    UiAlign("center bottom")
    UiFont("mono.ttf", 26)
    UiText("drone: " .. left .. " targets")
end
