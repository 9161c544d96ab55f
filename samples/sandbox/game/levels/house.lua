-- The level of the heist: six things in the house and the shop of the town, each on a wire. Where there is no town they
-- lie on a lawn.
local yard = require("levels/yard")

local kCell = 0.05
local brass, dark, red, pale = {0.78, 0.60, 0.26, roughness = 0.35, metallic = 0.8, material = "metal"},
    {0.16, 0.15, 0.15, roughness = 0.5, material = "wood"}, {0.55, 0.16, 0.13, roughness = 0.5, material = "wood"},
    {0.88, 0.86, 0.80, roughness = 0.3, material = "plaster"}
local steel = {0.42, 0.45, 0.48, roughness = 0.4, metallic = 0.6, material = "metal"}
local blue = {0.17, 0.30, 0.52, roughness = 0.3, material = "plaster"}

-- Each: what it is called, from where it falls to what it stands on, and its boxes.
local things = {
    {name = "vase", from = Vec(20.5, 1.7, 36.8), size = {6, 9, 6}, palette = {pale, blue},
        boxes = {{1, 0, 1, 4, 0, 4, 1}, {0, 1, 0, 5, 4, 5, 1}, {0, 2, 0, 5, 2, 5, 2}, {1, 5, 1, 4, 5, 4, 1},
            {2, 6, 2, 3, 7, 3, 1}, {1, 8, 1, 4, 8, 4, 2}}},
    {name = "radio", from = Vec(20.5, 1.7, 32.4), size = {9, 6, 4}, palette = {red, dark, brass},
        boxes = {{0, 0, 0, 8, 5, 3, 1}, {1, 1, 3, 4, 4, 3, 2}, {6, 1, 3, 7, 2, 3, 3}, {6, 4, 3, 7, 4, 3, 3}}},
    {name = "clock", from = Vec(21.1, 4.6, 38.0), size = {6, 8, 4}, palette = {dark, pale, brass},
        boxes = {{0, 0, 0, 5, 1, 3, 1}, {0, 2, 0, 5, 6, 3, 1}, {1, 2, 3, 4, 5, 3, 2}, {2, 3, 3, 2, 4, 3, 1},
            {1, 7, 1, 4, 7, 2, 3}}},
    {name = "casket", from = Vec(25.7, 4.6, 37.6), size = {8, 5, 5}, palette = {red, brass},
        boxes = {{0, 0, 0, 7, 3, 4, 1}, {0, 4, 1, 7, 4, 3, 1}, {0, 2, 0, 7, 2, 4, 2}, {3, 1, 4, 4, 3, 4, 2}}},
    {name = "till", from = Vec(45.4, 1.9, 35.0), size = {8, 7, 7}, palette = {steel, brass, pale},
        boxes = {{0, 0, 0, 7, 2, 6, 1}, {0, 3, 0, 7, 4, 3, 1}, {1, 3, 4, 6, 3, 6, 3}, {1, 5, 1, 6, 6, 2, 2}}},
    {name = "safe", from = Vec(41.2, 1.2, 28.4), size = {9, 10, 8}, palette = {steel, dark, brass},
        boxes = {{0, 0, 0, 8, 9, 7, 1}, {1, 1, 7, 7, 8, 7, 2}, {3, 4, 7, 5, 5, 7, 3}}},
}

local function placeThing(thing)
    QueryRequire("physical")
    local isThere, dist = QueryRaycast(thing.from, {0, -1, 0}, 6)
    local at = thing.from - Vec(0, isThere and dist or 0, 0)
    local model = {voxel = kCell, size = thing.size, boxes = thing.boxes, palette = thing.palette,
        origin = {thing.size[1] / 2, 0, thing.size[3] / 2}}
    return CreateModel(model, Transform(at + Vec(0, 0.02, 0)), true)
end

-- A wire from a thing to the nearest wall or floor; 0 where there is none.
local function wire(shape)
    local low, high = GetShapeBounds(shape)
    local from = VecLerp(low, high, 0.5)
    local best, bestDist, bestWay = 0, 4, nil
    for _, way in ipairs({Vec(1, 0, 0), Vec(-1, 0, 0), Vec(0, 0, 1), Vec(0, 0, -1), Vec(0, -1, 0)}) do
        QueryRequire("static")
        local isThere, dist, _, other = QueryRaycast(from, way, bestDist)
        if isThere then best, bestDist, bestWay = other, dist, way end
    end
    return best ~= 0 and CreateRope(shape, from, best, from + bestDist * bestWay, 1.05 * bestDist, 0) or 0
end

return {
    place = "House and shop",
    things = things, placeThing = placeThing, wire = wire,
    exit = {Vec(37.6, -1.5, 46.8), Vec(41.4, 3, 50.2)}, ground = -0.16,
    alarm = Vec(23.5, 5.6, 39.8),
    start = {Vec(33.5, 0.3, 50.5), Vec(25.5, 2.8, 38)},  -- feet, and what the eyes look at
    build = function()
        if FindBody("house") == 0 then yard() end
    end,
}
