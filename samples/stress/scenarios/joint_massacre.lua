-- Chains, ropes, hinges and motors are made, loaded, cut and broken.
function init()
    Box("ground", {-20, -0.4, -20}, {400, 4, 400}, 6)
    while true do
        local beam = Box("beam", {-10, 6, 0}, {200, 4, 4}, 9)
        wait(0.1)
        for i = 0, 7 do
            local x = -9 + 2.4 * i
            local weight = Box("weight", {x, 2, 0}, {5, 5, 5}, math.random(5, 9), {dynamic = true})
            local center = Vec(x + 0.2, 2.4, 0.2)
            if i % 4 == 0 then
                Joint("rope", beam, weight, {x + 0.2, 6.05, 0.2}, {rope_end = center, strength = 20000})
            elseif i % 4 == 1 then
                local last = beam
                for k = 0, 4 do
                    local y = 5.2 - 0.6 * k
                    local link = Box("link", {x, y, 0.1}, {2, 6, 2}, 9, {dynamic = true})
                    Joint("ball", last, link, {x + 0.1, y + 0.6, 0.2}, {break_force = 30000})
                    last = link
                end
            elseif i % 4 == 2 then
                local arm = Box("arm", {x, 5.4, 0.1}, {15, 2, 2}, 5, {dynamic = true})
                Joint("hinge", beam, arm, {x + 0.1, 6, 0.2}, {axis = {0, 0, 1}, speed = 3, force = 2000})
            else
                local post = Box("post", {x, 0, 1}, {3, 20, 3}, 6)
                Joint("fixed", post, weight, {x + 0.15, 2, 1}, {break_force = 5000, anchor_radius = 1})
            end
        end
        wait(1.5)
        for i = 1, 12 do
            MakeHole({-10 + 20 * math.random(), 2 + 4 * math.random(), 0.2}, 0.3, 0.3, 0.3)
            for _, body in ipairs(FindBodies("weight")) do
                if math.random() < 0.2 then
                    ApplyBodyImpulse(body, GetBodyTransform(body).pos, {0, 0, 8 * GetBodyMass(body)})
                end
            end
            wait(0.2)
        end
        for _, tag in ipairs{"beam", "weight", "link", "arm", "post"} do
            for _, body in ipairs(FindBodies(tag)) do Delete(body) end
        end
        wait(0.3)
    end
end
