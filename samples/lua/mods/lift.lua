-- Lift: carries the crate up and down between floors. It stops at each, and a number over it says where it is.
local cabin, floor, height = 0, 1, 0.4

function init()
    cabin = FindBody("crate")
    local x, z = GetBodyTransform(cabin).pos.x, GetBodyTransform(cabin).pos.z
    for _, next in ipairs({1, 2, 3, 2, 1}) do
        local goal = Vec(x, 0.05 + (next - 1) * 1.2, z)
        for _ = 1, 240 do
            if not IsHandleValid(cabin) then return end
            local frame = GetBodyTransform(cabin)
            ConstrainPosition(cabin, 0, frame.pos, goal, 1.5)
            ConstrainOrientation(cabin, 0, frame.rot, Quat(), 2)
            if math.abs(frame.pos.y - goal.y) < 0.02 then break end
            wait(0)
        end
        floor = next
        height = GetBodyTransform(cabin).pos.y
        SetFloat("lift.highest", math.max(GetFloat("lift.highest"), height))
    end
    SetInt("lift.floor", floor)
    print("at floor " .. floor)
end

function draw()
    if not IsHandleValid(cabin) then return end
    UiWorld(Transform(GetBodyTransform(cabin).pos + Vec(0.8, 1.1, -0.1), QuatEuler(0, 180, 0)), 0.01, false)
    UiFont("bold.ttf", 40)
    UiTextOutline(0, 0, 0, 1, 0.1)
    UiText("floor " .. floor)
end
