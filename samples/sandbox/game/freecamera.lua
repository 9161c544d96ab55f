-- A camera that flies, as of photos and of the replay.
local keys = require("keys")
local options = require("options")

local camera = {pos = Vec(), yaw = 0, pitch = 0}
local kSlow, kFast = 4, 14  -- m/s

-- Begins where the player's eyes, or another camera, are.
function camera.begin()
    local frame = GetCameraTransform()
    camera.pos = frame.pos
    local ahead = frame.rot * Vec(0, 0, -1)
    camera.yaw, camera.pitch = math.atan(-ahead.x, -ahead.z), math.asin(math.max(-1, math.min(1, ahead.y)))
end

-- Each frame in which it stays where it is. `fov`, `roll`: degrees.
function camera.stay(fov, roll)
    local rot = QuatEuler(0, math.deg(camera.yaw), 0) * QuatEuler(math.deg(camera.pitch), 0, 0)
    SetCameraTransform(Transform(camera.pos, rot * QuatEuler(0, 0, roll or 0)), fov)
    return rot
end

-- Each frame: flies as the keys say. `fov`, `roll`: degrees.
function camera.fly(dt, fov, roll)
    local scale = 0.0022 * options.get("sensitivity") * fov / 68
    local right, up = keys.look(dt * options.get("sensitivity"))
    camera.yaw = camera.yaw - scale * InputValue("mousedx") - right * fov / 68
    camera.pitch = math.max(-1.55, math.min(1.55, camera.pitch - scale * InputValue("mousedy") + up * fov / 68))
    local rot = camera.stay(fov, roll)
    local wish = rot * Vec(keys.axis("right", "left"), 0, keys.axis("down", "up")) + Vec(0, keys.axis("jump", "crouch"), 0)
    camera.pos = camera.pos + VecScale(wish, dt * (InputDown("sprint") and kFast or kSlow))
    camera.stay(fov, roll)
end

return camera
