-- Gravity gun: the left button draws a thing near and holds it, the right one hurls it.
local feel = require("feel")
local belt = require("toolbelt")

local held, point, far = 0, Vec(0, 0, 0), 3

local gun = {
    name = "Gravity gun",
    tip = "Right button: hurl",
    reach = 30,
    cooldown = 0.0,
    isAutomatic = true,
    marksUndo = false,
    turn = {2, 4, 0},
    hold = Vec(-0.005, -0.005, 0.02),
    model = {
        size = {13, 14, 34},
        origin = {6, 8, 20},
        palette = {{0.20, 0.21, 0.23, roughness = 0.4, metallic = 0.4}, {0.85, 0.48, 0.10, roughness = 0.5},
            {0.35, 0.75, 1.0, emission = 4}, {0.10, 0.10, 0.11, roughness = 0.6}},
        boxes = {{3, 5, 10, 9, 11, 28, 1}, {4, 6, 6, 8, 10, 10, 4}, {5, 7, 4, 7, 9, 6, 3}, {0, 7, 0, 2, 9, 12, 2},
            {10, 7, 0, 12, 9, 12, 2}, {5, 12, 0, 7, 13, 12, 2}, {3, 8, 14, 3, 8, 24, 3}, {9, 8, 14, 9, 8, 24, 3},
            {5, 0, 22, 7, 5, 26, 4}},
        muzzle = Vec(0, 0.5, -17),
    },
}

function gun:use(aim)
    if held ~= 0 or aim.body == 0 or not IsBodyDynamic(aim.body) or GetBodyMass(aim.body) > 4000 then return end
    AddUndoMark()
    held, far = aim.body, math.max(2.2, math.min(aim.dist, 3.2))
    point = TransformToLocalPoint(GetBodyTransform(aim.body), aim.pos)
end

function gun:alt(aim)
    local body = held ~= 0 and held or aim.body
    held = 0
    belt.cooldown = 0.4
    if body == 0 or not IsHandleValid(body) or not IsBodyDynamic(body) then return end
    local mass = GetBodyMass(body)
    local center = GetBodyTransform(body) * GetBodyCenterOfMass(body)
    ApplyBodyImpulse(body, center, VecScale(aim.dir, math.min(22, 20000 / mass) * mass))
    feel.flash(belt.muzzle() + 0.4 * aim.dir, {0.4, 0.8, 1}, 8, 0.1)
    feel.burst(belt.muzzle(), aim.dir, {type = "spark", count = 12, speed = 6, spread = 0.3, life = 0.3,
        color = {0.5, 0.8, 1}, radius = {0.012, 0.004}, emissive = 0.3, stretch = 0.03})
    belt.recoil(1.3)
    feel.kick(1.2)
end

function gun:release()
    held = 0
end

function gun:tick(aim)
    if held == 0 then return end
    if not InputDown("usetool") or not IsHandleValid(held) then held = 0 return end
    local at, muzzle = GetBodyTransform(held) * point, belt.muzzle()
    local last = muzzle
    for i = 1, 9 do  -- a beam that trembles
        local share = i / 9
        local sag = 0.06 * math.sin(math.pi * share)
        local now = VecLerp(muzzle, at, share)
            + sag * Vec(math.random() - 0.5, math.random() - 0.5, math.random() - 0.5)
        DrawLine(last, now, 0.5, 0.85, 1, 0.9)
        last = now
    end
    PointLight(VecLerp(muzzle, at, 0.8), 0.8, 1.6, 2.4, 1)
end

function gun:update()
    if held == 0 or not IsHandleValid(held) then return end
    local eye = GetPlayerCameraTransform()
    local at = GetBodyTransform(held) * point
    ConstrainPosition(held, 0, at, eye.pos + eye.rot * Vec(0, 0, -far), 14, 40 * GetBodyMass(held))
end

return gun
