-- Paint rain: drops of paint fall on the yard and leave spots in all colours.
local drops = 0

local function colour(hue)
    local function part(shift) return 0.5 + 0.5 * math.cos(2 * math.pi * (hue + shift)) end
    return part(0), part(1 / 3), part(2 / 3)
end

function update()
    if drops >= GetIntParam("drops", 240) then return end
    local from = Vec(math.random() * 6 - 3, 6, math.random() * 5 - 3)
    local hit, dist, normal, shape = QueryRaycast(from, Vec(0.1, -1, 0.2), 12)
    if not hit then return end
    drops = drops + 1
    local at = from + dist * VecNormalize(Vec(0.1, -1, 0.2))
    local r, g, b = colour(drops / 60)
    PaintRGBA(at, 0.1 + 0.25 * math.random(), r, g, b, 1, 0.8)
    ParticleReset()
    ParticleType("plain")
    ParticleColor(r, g, b)
    ParticleRadius(0.04)
    ParticleGravity(-10)
    SpawnParticle(at, 2 * normal, 0.6)
    SetInt("paintrain.drops", drops)
end

function draw()
    UiTranslate(40, 60)
    UiFont("bold.ttf", 36)
    UiColor(colour(drops / 60))
    UiText(drops .. " drops")
end
