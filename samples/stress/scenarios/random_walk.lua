-- A random walk through all commands, each with random arguments, then in another level.
local walkers, waters = {}, {}

function place()
    return Vec(16 * math.random() - 8, 5 * math.random(), 16 * math.random() - 8)
end
function any(list)
    return #list > 0 and list[math.random(#list)] or 0
end

local commands = {
    function() Explosion(place(), 0.5 + 2 * math.random()) end,
    function() MakeHole(place(), math.random(), math.random(), math.random()) end,
    function() Shoot(place(), VecNormalize(place()), "rocket", 1, 30) end,
    function() PaintRGBA(place(), math.random(), math.random(), 0, 1, 1, 1) end,
    function() SpawnFire(place()) end,
    function() Pour(place(), 2) end,
    function() Box("thing", place(), {math.random(1, 12), math.random(1, 12), math.random(1, 12)}, math.random(2, 18),
        {dynamic = math.random() < 0.7, voxel = 0.1}) end,
    function() Ball("thing", place(), math.random(2, 10), math.random(5, 9), {dynamic = true, velocity = place()}) end,
    function() Delete(any(FindBodies("thing"))) end,
    function() Delete(any(FindShapes("thing"))) end,
    function() SetBodyVelocity(any(FindBodies("thing")), place()) end,
    function() SetBodyTransform(any(FindBodies("thing")), Transform(place(), QuatEuler(90 * math.random(), 0, 0))) end,
    function() SetBodyDynamic(any(FindBodies("thing")), math.random() < 0.5) end,
    function() SetBodyActive(any(FindBodies("thing")), math.random() < 0.5) end,
    function() TrimShape(any(FindShapes("thing"))) end,
    function() ResizeShape(any(FindShapes("thing")), 0, 0, 0, math.random(1, 12), 5, 5) end,
    function() start(SplitShape, any(FindShapes("thing"))) end,
    function() CopyShapeContent(any(FindShapes("thing")), any(FindShapes("thing"))) end,
    function() CopyShapePalette(any(FindShapes("thing")), any(FindShapes("thing"))) end,
    function()
        SetBrush("sphere", math.random(1, 5), math.random(0, 9))
        DrawShapeLine(any(FindShapes("thing")), 0, 0, 0, math.random(0, 9), math.random(0, 9), math.random(0, 9))
    end,
    function() Joint(math.random() < 0.5 and "ball" or "hinge", any(FindShapes("thing")), 0, place(), {anchor_radius = 20}) end,
    function() Delete(any(FindJoints("thing"))) end,
    function() Walk(any(walkers), 5 * place(), true) end,
    function() walkers[#walkers + 1] = Character(place() + Vec(0, 5, 0)) end,
    function() AddLight(place()) end,
    function() Glow(any(FindShapes("thing")), math.random(2, 18), 10 * math.random()) end,
    function() SetTag(any(FindShapes("thing")), "tag", "value") end,
    function() UndoMark() end,
    function() Undo() end,
    function() Redo() end,
    function() SaveAndLoad() end,
    function() SetGravity(Vec(4 * math.random() - 2, -12 * math.random(), 0)) end,
    function() Settings{stress = math.random() < 0.5, debris_bodies = math.random(10, 300)} end,
    function() if #waters < 3 then waters[#waters + 1] = Water({-4, -1, -4}, {4, 2 * math.random(), 4}) end end,
    function() RemoveWater(table.remove(waters) or 0) end,
}

function init()
    UndoLimit(5)
    while true do
        walkers, waters = {}, {}
        Box("ground", {-12, -0.4, -12}, {240, 4, 240}, 6)
        for i = 1, 6 do Box("thing", {-6 + 2 * i, 0, 0}, {12, 20, 6}, 5 + i % 4) end
        wait(0.1)
        for i = 1, 2000 do
            pcall(commands[math.random(#commands)])
            if math.random() < 0.4 then wait(0) end
        end
        LoadLevel("garden")
        wait(0.1)
    end
end
