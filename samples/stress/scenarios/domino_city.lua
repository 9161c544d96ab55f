-- Rows of dominoes knock each other over; energy only falls. All rows are alike: the losses of one hide no gain of another.
function row(z, count, height)
    for i = 0, count - 1 do
        Box("domino", {-10 + 0.5 * i, 0, z + 0.1 * math.random()}, {1, height, 5}, 5, {dynamic = true})
    end
end

function init()
    Box("ground", {-15, -0.4, -15}, {300, 4, 300}, 6)
    while true do
        local height, speed = math.random(10, 12), 0.7 + 0.2 * math.random()
        for z = -4, 4 do row(1.5 * z, 30, height) end
        wait(1)
        ClosedSystem(false)
        for _, body in ipairs(FindBodies("domino")) do
            local pos = GetBodyTransform(body).pos
            if pos.x < -9.9 then ApplyBodyImpulse(body, pos + Vec(0, 0.9, 0.25), {speed * GetBodyMass(body), 0, 0}) end
        end
        wait(0)
        wait(0)
        ClosedSystem(true)
        wait(8)
        ClosedSystem(false)
        for _, body in ipairs(FindBodies("domino")) do Delete(body) end
        wait(0.1)
        Expect(#FindBodies("domino") == 0, "a domino is there after all were deleted")
    end
end
