-- Looks, walks, runs, crouches, jumps and flies; carries a lamp.
local options = require("options")
local feel = require("feel")
local keys = require("keys")

local player = {isFlying = false, mayFly = true, hasLamp = false, speed = 0}
local kWalk, kRun, kCrouch, kFly, kFastFly = 4.0, 6.8, 2.0, 9.0, 26.0
local kRadiansPerPixel = 0.0022
local kFall = 30                -- metres below all there is from which one is put back
local jumps, fall = false, 0
local bottom = -math.huge

-- The box around all that stands, or around all where nothing does.
local function levelBounds(all)
    local low, high = Vec(math.huge, math.huge, math.huge), Vec(-math.huge, -math.huge, -math.huge)
    for _, shape in ipairs(FindShapes()) do
        if all or not IsBodyDynamic(GetShapeBody(shape)) then
            local from, to = GetShapeBounds(shape)
            for i = 1, 3 do low[i], high[i] = math.min(low[i], from[i]), math.max(high[i], to[i]) end
        end
    end
    if not all and low.y > high.y then return levelBounds(true) end
    return low, high
end

-- Where the town begins, on the pavement, with the house before one; in other levels on top of what is nearest to their
-- middle.
function player.spawn()
    local low, high = levelBounds()
    bottom = low.y - kFall
    local place = FindLocation("player")
    if place ~= 0 then return SetPlayerTransform(GetLocationTransform(place)) end
    local town = Vec(33.5, 0.3, 50.5)
    if QueryRaycast(town + Vec(0, 1, 0), {0, -1, 0}, 3) then
        return SetPlayerTransform(Transform(town, QuatLookAt(town + Vec(0, 1.3, 0), {25.5, 2.8, 38})))
    end
    for ring = 0, 8 do
        for turn = 0, 7 do
            local share, angle = ring / 16, turn * math.pi / 4
            local x = (0.5 + share * math.cos(angle)) * (high.x - low.x) + low.x
            local z = (0.5 + share * math.sin(angle)) * (high.z - low.z) + low.z
            local isThere, dist = QueryRaycast(Vec(x, high.y + 1, z), {0, -1, 0}, high.y - low.y + 2)
            if isThere then return SetPlayerTransform(Transform(Vec(x, high.y + 1.1 - dist, z))) end
        end
    end
    player.fly(true)  -- there is nothing to stand on
    if low.y <= high.y then SetPlayerTransform(Transform(VecLerp(low, high, 0.5) + Vec(0, high.y - low.y, 0))) end
end

-- Each frame, where no menu is open.
function player.tick(dt)
    local yaw, pitch = GetPlayerLook()
    local scale = kRadiansPerPixel * options.get("sensitivity") * options.get("fov") / 68
    local right, up = keys.look(dt * options.get("sensitivity"))
    SetPlayerLook(yaw - scale * InputValue("mousedx") - right, pitch - scale * InputValue("mousedy") + up)
    jumps = jumps or InputPressed("jump")
    if InputPressed("fly") and player.mayFly then player.fly(not player.isFlying) end
    if InputPressed("flashlight") then player.hasLamp = not player.hasLamp end
end

function player.fly(isFlying)
    player.isFlying = isFlying
    SetPlayerWalking(not isFlying)
end

-- Each step. `moves`: a menu may hold the player still.
function player.update(moves)
    local right, ahead, up = 0, 0, 0
    if moves then
        right, ahead, up = keys.axis("right", "left"), keys.axis("up", "down"), keys.axis("jump", "crouch")
    end
    local yaw, pitch = GetPlayerLook()
    local isFree = player.isFlying or IsPlayerSwimming()
    local heading = QuatEuler(0, math.deg(yaw), 0) * (isFree and QuatEuler(math.deg(pitch), 0, 0) or Quat())
    local wish = heading * Vec(right, 0, -ahead)
    if isFree then wish = wish + Vec(0, up, 0) end
    local length = VecLength(wish)
    if length > 1 then wish = VecScale(wish, 1 / length) end
    local crouches = not isFree and moves and InputDown("crouch")
    local runs = InputDown("sprint")
    local speed = player.isFlying and (runs and kFastFly or kFly) or crouches and kCrouch or runs and kRun or kWalk
    MovePlayer(VecScale(wish, speed), jumps and moves, crouches)
    jumps = false
    if player.hasLamp then
        local eye = GetPlayerCameraTransform()
        PointLight(eye.pos + eye.rot * Vec(0.2, -0.25, -0.5), 7, 6.2, 5, 1)
    end
    if GetPlayerTransform().pos.y < bottom and not player.isFlying then player.spawn() end
    local velocity = GetPlayerVelocity()
    if IsPlayerGrounded() and fall < -4 then
        feel.kick(0.7 * fall)
        feel.shake(-0.03 * fall)
    end
    fall = IsPlayerGrounded() and 0 or velocity.y
    player.speed = IsPlayerGrounded() and VecLength(Vec(velocity.x, 0, velocity.z)) or 0
    feel.walk(player.speed)
end

return player
