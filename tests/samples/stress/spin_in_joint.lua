-- A fixed joint takes the spin from the body that a check has turned, within the step: both worlds are equal again.
function init()
    local wall = Box("wall", {-6, 0, 0}, {30, 25, 3}, 5)
    local arm = Box("arm", {-6, 3, 1}, {4, 4, 4}, 5, {dynamic = true})
    Joint("fixed", wall, arm, {-5.8, 2.5, 0.5}, {anchor_radius = 2, break_force = 500})
    WaitForStep(19)
    Explosion({-4.48, 0.52, 0.06}, 0.6)
end
