-- Gravity gun: holds the body that the player looks at before the eye, and throws it after two seconds. The eye
-- stands at a fixed place here, since a script without a window has no player.
local eye = Vec(0, 0.4, -6)
local ahead = Vec(0, 0, 1)
local held = 0

function init()
    local hit, dist, normal, shape = QueryRaycast(eye, ahead, 20)
    local body = hit and GetShapeBody(shape) or 0
    if not IsBodyDynamic(body) then return print("nothing to hold") end
    held = body
    wait(2)
    held = 0
    ApplyBodyImpulse(body, TransformToParentPoint(GetBodyTransform(body), GetBodyCenterOfMass(body)),
        GetBodyMass(body) * 12 * ahead)
    print("thrown")
    wait(0.1)
    SetInt("gravitygun.speed", math.floor(VecLength(GetBodyVelocity(body))))
end

function update(dt)
    if held == 0 or not IsHandleValid(held) then return end
    local frame = GetBodyTransform(held)
    local center = frame * GetBodyCenterOfMass(held)
    local goal = eye + Vec(0, 1, 0) + 2.5 * ahead
    SetBodyVelocity(held, VecScale(goal - center, 5))
end
