-- Shapes fall apart in each of many steps, those of checks among them: their script gets the pieces of each.
function init()
    local done = 0
    for step = 3, 30 do
        local bar = Box("bar", {-2, step, 0}, {40, 4, 4}, 6)
        start(function()
            WaitForStep(step)
            MakeHole({0, step + 0.2, 0.2}, 0.5, 0.5, 0.5)
            local pieces = SplitShape(bar)
            Expect(#pieces == 1, "one piece beside the bar of step " .. step .. ", found " .. #pieces)
            done = done + 1
        end)
    end
    WaitForStep(33)
    Expect(done == 28, "28 bars that have come apart, found " .. done)
end
