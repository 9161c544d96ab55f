-- Moves of the film's camera.
local camera = {}

-- From 0 to 1 while t goes from t0 to t1, with a slow beginning and end.
function camera.ease(t, t0, t1)
    local s = math.min(math.max((t - t0) / (t1 - t0), 0), 1)
    return s * s * s * (s * (6 * s - 15) + 10)
end

-- A point of a Catmull-Rom curve through values of keys, between keys i and i + 1.
local function curve(a, b, c, d, s)
    return VecScale(2 * b + s * (c - a) + (s * s) * (2 * a - 5 * b + 4 * c - d)
        + (s * s * s) * (3 * b - a - 3 * c + d), 0.5)
end

-- The camera on a path of keys {t, eye, target, fov} at a time. It eases in and out, but never quite stands still.
function camera.path(keys, t)
    local first, last = keys[1][1], keys[#keys][1]
    local share = (t - first) / (last - first)
    local eased = first + (last - first) * (0.35 * share + 0.65 * camera.ease(share, 0, 1))
    local i = 1
    while i < #keys - 1 and eased > keys[i + 1][1] do i = i + 1 end
    local a, b, c, d = keys[math.max(i - 1, 1)], keys[i], keys[i + 1], keys[math.min(i + 2, #keys)]
    local s = (eased - b[1]) / (c[1] - b[1])
    local eye, target = curve(a[2], b[2], c[2], d[2], s), curve(a[3], b[3], c[3], d[3], s)
    return eye, target, b[4] + (c[4] - b[4]) * s
end

-- The same as a transform, held by a hand that shakes by some amount: 1 is at rest.
function camera.held(keys, t, shake)
    local eye, target, fov = camera.path(keys, t)
    local s = 0.12 * (shake or 1)
    local turn = QuatEuler(s * (math.sin(2.1 * t + 1) + 0.6 * math.sin(5.3 * t)),
        s * (math.sin(1.7 * t) + 0.6 * math.sin(4.6 * t + 2)), 0.7 * s * math.sin(2.9 * t + 4))
    return Transform(eye, QuatLookAt(eye, target) * turn), fov
end

-- A jolt that dies away: degrees of a blast at t0, as `shake` of camera.held().
function camera.jolt(t, t0, amount)
    if t < t0 then return 0 end
    return amount * math.exp(-3.2 * (t - t0)) * (1 + 0.5 * math.sin(61 * t))
end

return camera
