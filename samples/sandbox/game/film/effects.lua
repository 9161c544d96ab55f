-- What is seen of blasts, dust and rain, beside what the world makes by itself.
local flash = require("flash")
local sounds = require("sounds")

local effects = {}

local function random(low, high) return low + (high - low) * math.random() end

-- Any direction; `up`: of its upper half.
local function direction(up)
    local v = VecNormalize(Vec(random(-1, 1), random(-1, 1), random(-1, 1)))
    return up and Vec(v.x, math.abs(v.y), v.z) or v
end

-- Throws one particle. Fields of p: type, color, radius {from, to}, life; alpha, drag, gravity, emissive, ...
function effects.particle(pos, velocity, p)
    ParticleReset()
    ParticleType(p.type)
    ParticleColor(p.color[1], p.color[2], p.color[3])
    ParticleRadius(p.radius[1], p.radius[2])
    ParticleAlpha(p.alpha or 0.5)
    if p.drag then ParticleDrag(p.drag) end
    if p.gravity then ParticleGravity(p.gravity) end
    if p.emissive then ParticleEmissive(p.emissive) end
    if p.stretch then ParticleStretch(p.stretch) end
    if p.spin then ParticleRotation(random(-p.spin, p.spin)) end
    if p.passes then ParticleCollide(0) end
    SpawnParticle(pos, velocity, p.life)
end
local particle = effects.particle

-- Fire that rolls up and turns to smoke, which it lights from within at first.
local function fireball(pos, size)
    for _ = 1, math.floor(14 * size) do
        local v = direction()
        particle(pos + (0.25 * size * random(0.2, 1)) * v, (random(1.5, 4.5) * size) * v + Vec(0, 1.2, 0),
            {type = "flame", color = {1, 1, 1}, radius = {0.22 * size, 0.62 * size}, alpha = 0.9, drag = 4,
                emissive = 3, life = random(0.25, 0.6), spin = 2})
    end
    start(function()
        for i = 1, 7 do
            for _ = 1, math.floor(2 * size) + 1 do
                local v = direction()
                local shade = random(0.03, 0.10)
                particle(pos + (0.5 * size * random(0.3, 1)) * v + Vec(0, 0.12 * i, 0),
                    (random(0.8, 2.4) * size) * v + Vec(0, 1.6, 0),
                    {type = "smoke", color = {shade * 1.1, shade, shade * 0.92}, radius = {0.2 * size, 0.75 * size},
                        alpha = random(0.35, 0.6), drag = 2.2, life = random(1.6, 4.2), spin = 0.6})
            end
            wait(0.03)
        end
    end)
end

-- A ring of dust that runs over the ground and slows down.
function effects.ring(pos, size, color)
    for i = 1, math.floor(34 * size) do
        local angle = 2 * math.pi * (i + random(0, 0.8)) / (34 * size)
        local out = Vec(math.cos(angle), 0, math.sin(angle))
        particle(pos + 0.4 * size * out, (random(6, 9) * size) * out + Vec(0, random(0.1, 0.7), 0),
            {type = "dust", color = color, radius = {0.1, random(0.35, 0.7)}, alpha = random(0.10, 0.26), drag = 2.6,
                life = random(0.9, 2.0), spin = 1})
    end
end

-- Pieces too small for bodies, which fly and leave a thread of smoke.
local function trails(pos, size, way)
    for i = 1, math.floor(6 * size) do
        start(function()
            local v = direction(true)
            if way then v = VecNormalize(v + way) end
            local p, speed = pos, random(6, 11) * math.sqrt(size)
            v = VecScale(v + Vec(0, 0.35, 0), speed)
            local isHot = i % 3 == 0
            for step = 1, math.floor(random(30, 58)) do
                v = v + Vec(0, -9.8 / 60, 0)
                p = p + VecScale(v, 1 / 60)
                if isHot and step < 26 then
                    particle(p, VecScale(v, 0.2), {type = "flame", color = {1, 1, 1}, radius = {0.07, 0.02},
                        alpha = 0.8, emissive = 0.2, life = 0.14})
                end
                particle(p, VecScale(v, 0.35), {type = "smoke", color = {0.24, 0.21, 0.18},
                    radius = {0.06, random(0.1, 0.2)}, alpha = 0.16 * (1 - step / 70), drag = 7, stretch = 0.08,
                    life = random(0.6, 1.3)})
                wait(0)
            end
        end)
    end
end

-- Dust that hangs where something broke, rolls outward and sinks.
function effects.haze(pos, spread, count, color, speed)
    for _ = 1, count do
        local v = direction(true)
        local shade = random(0.8, 1.15)
        local aside = Vec(v.x * spread.x * math.random(), v.y * spread.y * math.random(),
            v.z * spread.z * math.random())
        particle(pos + aside, VecScale(Vec(v.x, 0.3 * v.y, v.z), (speed or 0.6) * math.random()),
            {type = "dust", color = {color[1] * shade, color[2] * shade, color[3] * shade},
                radius = {random(0.12, 0.3), random(0.7, 1.4)}, alpha = random(0.06, 0.2), drag = 0.8, gravity = -0.12,
                life = random(2.5, 7), spin = 0.4})
    end
end

-- A blast: breaks, flashes, burns, smokes, and raises dust. `ground`: where the ring runs, nil: none; `way`: where
-- most of it goes.
function effects.blast(pos, size, o)
    o = o or {}
    Explosion(pos, size)
    sounds.play("explosion", pos, size)
    flash(pos + Vec(0, 0.2, 0), {1, 0.72, 0.42}, (o.light or 700) * size, 0.32)
    fireball(pos, (o.fire or 1) * size)
    trails(pos, (o.trails or 1) * size, o.way)
    if o.ground then effects.ring(Vec(pos.x, o.ground + 0.15, pos.z), 0.8 * size, o.dust or {0.36, 0.32, 0.27}) end
    effects.haze(pos, Vec(1.2, 0.9, 1.2), math.floor((o.haze or 9) * size), o.dust or {0.36, 0.32, 0.27}, 1.6)
end

return effects
