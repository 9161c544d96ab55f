-- What makes tools felt: the camera kicks and shakes, lights flash, matter sprays in its own colour.
local flash = require("flash")
local options = require("options")

local feel = {}
local shake, kick = 0, 0
local stride, pace = 0, 0  -- of walking: where in a stride, and how fast
local time = 0

-- Shakes the camera: 1 is a rocket close by.
function feel.shake(amount)
    shake = math.min(shake + amount, 1.5)
end

-- Shakes it as something at a place does.
function feel.shakeAt(pos, amount)
    local far = VecLength(pos - GetPlayerCameraTransform().pos)
    feel.shake(amount / (1 + 0.12 * far))
end

-- Throws the view up by so many degrees; it comes back.
function feel.kick(degrees)
    kick = kick + degrees
end

-- How fast the player walks, in m/s: the head goes up and down a little.
function feel.walk(speed)
    pace = pace + 0.2 * (math.min(speed / 6, 1) - pace)
    stride = stride + 0.03 * speed
end

-- The camera's offset from the eyes in this frame.
function feel.tick(dt)
    time = time + dt
    shake = shake * math.exp(-4 * dt)
    kick = kick * math.exp(-9 * dt)
    local motion = options.get("motion")
    local s = 2.2 * shake * shake * motion
    local turn = QuatEuler(kick * motion + s * math.sin(47 * time), s * math.sin(39 * time + 1),
        0.7 * s * math.sin(53 * time + 2))
    local bob = Vec(0.012 * math.sin(stride), 0.02 * math.abs(math.cos(stride)), 0)
    SetCameraOffsetTransform(Transform(VecScale(bob, pace * motion), turn))
end

-- A light for some steps that fades. Color {r, g, b}, intensity in W/sr.
function feel.flash(pos, color, intensity, seconds)
    local strength = options.get("flashes")
    if strength > 0 then flash(pos, color, strength * intensity, seconds or 0.05) end
end

local function spread(dir, amount)
    local v = Vec(math.random() - 0.5, math.random() - 0.5, math.random() - 0.5)
    return dir + (2 * amount) * v
end

-- Throws particles. Fields of `p`: type, count, speed, spread, life, color, radius {from, to}, alpha, gravity,
-- emissive, drag, stretch.
function feel.burst(pos, dir, p)
    ParticleReset()
    ParticleType(p.type or "dust")
    local c = p.color or {0.6, 0.6, 0.6}
    ParticleColor(c[1], c[2], c[3])
    local r = p.radius or {0.05, 0.1}
    ParticleRadius(r[1], r[2])
    ParticleAlpha(p.alpha or 0.7)
    ParticleGravity(p.gravity or 0)
    if p.emissive then ParticleEmissive(p.emissive) end
    if p.drag then ParticleDrag(p.drag) end
    if p.stretch then ParticleStretch(p.stretch) end
    for _ = 1, p.count or 8 do
        local speed = (p.speed or 2) * (0.4 + 0.6 * math.random())
        SpawnParticle(pos, VecScale(spread(dir, p.spread or 0.5), speed), (p.life or 1) * (0.6 + 0.4 * math.random()))
    end
end

local kinds = {
    wood = {type = "crumb", radius = {0.025, 0.02}, speed = 3.2, life = 0.9, gravity = -6},
    glass = {type = "glint", radius = {0.02, 0.015}, speed = 3.5, life = 1.0, gravity = -6, emissive = 0.05},
    metal = {type = "spark", radius = {0.012, 0.006}, speed = 6, life = 0.45, gravity = -6, stretch = 0.04,
        color = {1, 0.62, 0.22}, emissive = 0.3},
    stone = {type = "crumb", radius = {0.03, 0.025}, speed = 2.6, life = 0.9, gravity = -6},
}
local kindOf = {wood = "wood", glass = "glass", ice = "glass", metal = "metal", ["heavy metal"] = "metal",
    ["hard metal"] = "metal", wire = "metal"}

-- What the eyes look at is made of; "" of nothing.
function feel.material(aim)
    if not aim.hit or aim.shape == 0 then return "" end
    return (GetShapeMaterialAtPosition(aim.shape, aim.pos - 0.05 * aim.normal))
end

-- What a hit at a place throws: pieces and a little dust in the colour of what was hit. Returns the material.
function feel.debris(aim, amount)
    if not aim.hit then return "" end
    local material, r, g, b = "", 0.5, 0.5, 0.5
    if aim.shape ~= 0 then
        material, r, g, b = GetShapeMaterialAtPosition(aim.shape, aim.pos - 0.05 * aim.normal)
    end
    local color = {r * r, g * g, b * b}
    local kind = kindOf[material] or "stone"
    local base = kinds[kind]
    local p = {}
    for key, value in pairs(base) do p[key] = value end
    p.color = p.color or color
    p.count = math.floor(10 * amount) + 2
    p.spread = 0.7
    feel.burst(aim.pos, aim.normal, p)
    if kind ~= "metal" then
        feel.burst(aim.pos, aim.normal, {type = "dust", count = math.floor(4 * amount) + 1, speed = 1.1, life = 1.1,
            color = color, radius = {0.06, 0.3 * math.sqrt(amount)}, alpha = 0.35, drag = 2.5})
    end
    return material
end

return feel
