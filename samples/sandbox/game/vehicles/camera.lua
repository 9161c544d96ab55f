-- The camera behind a vehicle: the mouse turns it, it comes back behind by itself, and it stays before walls.
local keys = require("keys")
local options = require("options")
local parts = require("vehicles/parts")

local camera = {}
local kStep, kRadius, kPitch = 1 / 60, 0.25, -0.22
local yaw, pitch, sinceTurned, reach, due = 0, kPitch, 10, 0, 0
local pivot

local function headingOf(frame)
    local ahead = frame.rot * Vec(0, 0, -1)
    return math.atan(-ahead.x, -ahead.z)
end

function camera.begin(frame, kind)
    yaw, pitch, sinceTurned = headingOf(frame), kPitch, 10
    reach, pivot, due = 0.4 * kind.camera.distance, nil, 0
end

-- Before each step: what is due of the time between two.
function camera.step()
    due = math.max(0, due - kStep)
end

-- Each frame. The world is drawn between its last two steps: so is what the camera follows.
function camera.frame(v, kind, dt)
    local body = v[kind.body or "chassis"].body
    local frame = GetBodyTransform(body)
    due = due + dt
    local steps = math.floor(due / kStep + 1e-6)
    local ahead = due - steps * kStep + (steps - 1) * kStep
    local goal = frame.pos + VecScale(GetBodyVelocity(body), ahead) + Vec(0, kind.camera.height, 0)
    pivot = goal
    local scale = 0.0022 * options.get("sensitivity")
    local dx, dy = InputValue("mousedx"), InputValue("mousedy")
    local right, up = keys.look(dt * options.get("sensitivity"))
    dx, dy = dx + right / scale, dy - up / scale
    sinceTurned = (dx ~= 0 or dy ~= 0) and 0 or sinceTurned + dt
    yaw = yaw - scale * dx
    pitch = math.max(-1.2, math.min(0.5, pitch - scale * dy))
    if sinceTurned > 1.5 and not kind.isTracked then
        local turn = (headingOf(frame) - yaw + math.pi) % (2 * math.pi) - math.pi
        local share = 1 - math.exp(-2.2 * dt)
        yaw, pitch = yaw + share * turn, pitch + share * (kPitch - pitch)
    end
    local rot = QuatEuler(0, math.deg(yaw), 0) * QuatEuler(math.deg(pitch), 0, 0)
    local back = rot * Vec(0, 0, 1)
    QueryRejectBodies(parts.there(v))
    local hit, dist = QueryRaycast(pivot, back, kind.camera.distance, kRadius)
    local free = hit and math.max(0.3, dist) or kind.camera.distance
    reach = free < reach and free or reach + (free - reach) * (1 - math.exp(-4 * dt))
    SetCameraTransform(Transform(pivot + VecScale(back, reach), rot), options.get("fov"))
    return yaw, pitch
end

return camera
