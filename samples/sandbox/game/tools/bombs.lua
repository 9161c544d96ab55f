-- What bombs of both kinds share: they are bodies with tags, so that saves keep them and blasts throw them. The tag
-- "fuse" says when one goes off, by a clock that is saved with them.
local feel = require("feel")
local sounds = require("sounds")
local belt = require("toolbelt")

local bombs = {}
local clock = saved("bombs", {time = 0, lit = 0})

-- Throws one before the player. `tag` names its kind.
function bombs.throw(model, aim, tag, speed)
    local frame = Transform(aim.eye + 0.5 * aim.dir, aim.rot)
    local body = CreateModel(model, frame, true)
    SetTag(body, tag)
    start(function()
        wait(0.02)
        SetBodyVelocity(body, VecScale(aim.dir, speed) + Vec(0, 2, 0) + GetPlayerVelocity())
        SetBodyAngularVelocity(body, Vec(3, 1, 2))
    end)
    return body
end

-- Puts one on what the eyes look at, where it stays.
function bombs.place(model, aim, tag)
    local up = math.abs(aim.normal.y) > 0.9 and Vec(0, 0, 1) or Vec(0, 1, 0)
    local frame = Transform(aim.pos + 0.1 * aim.normal, QuatLookAt(aim.pos, aim.pos - aim.normal))
    local body, shape = CreateModel(model, frame, true)
    SetTag(body, tag)
    CreateNail(shape, aim.shape, aim.pos, 0)
    return body
end

-- It goes off after so many seconds.
function bombs.light(body, seconds)
    SetTag(body, "fuse", string.format("%.6f", clock.time + seconds))
    clock.lit = clock.lit + 1
end

-- Seconds until it goes off; nil: nobody has lit it.
function bombs.left(body)
    local due = tonumber(GetTagValue(body, "fuse"))
    return due and due - clock.time
end

-- How many there are that have been lit.
function bombs.count()
    return clock.lit
end

-- Each step. `sizes`: of explosions, by kind, times `charge`.
function bombs.update(dt, sizes, charge)
    clock.time = clock.time + dt
    if clock.lit == 0 then return end
    local list = FindBodies("fuse")
    clock.lit = 0
    for _, body in ipairs(list) do
        local left = HasTag(body, "fuse") and bombs.left(body)
        if left and left > 0 then
            clock.lit = clock.lit + 1
        elseif left then
            for kind, size in pairs(sizes) do
                if HasTag(body, kind) then bombs.explode(body, charge * size) end
            end
        end
    end
end

function bombs.center(body)
    return GetBodyTransform(body) * GetBodyCenterOfMass(body)
end

function bombs.explode(body, size)
    local at = bombs.center(body)
    Delete(body)
    bombs.blast(at, size)
end

-- An explosion with its flash and its push on the camera.
function bombs.blast(at, size)
    Explosion(at, size)
    sounds.play("explosion", at, 0.6 * size)
    start(function()
        wait(0.05)
        belt.refresh()
    end)
    feel.flash(at + Vec(0, 0.3, 0), {1, 0.62, 0.28}, 600, 0.28)
    feel.shakeAt(at, 1.1)
end

return bombs
