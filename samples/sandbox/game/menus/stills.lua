-- Images that a photo or the replay writes, in a size that the player has chosen.
local draw = require("draw")
local options = require("options")
local sounds = require("sounds")

local stills = {last = ""}
stills.sizes = {{"window"}, {"1920 x 1080", 1920, 1080}, {"3840 x 2160", 3840, 2160}}

-- The number of the size that is chosen.
function stills.chosen()
    return math.max(1, math.min(#stills.sizes, GetInt("options.stills")))
end

function stills.choose(number)
    SetInt("options.stills", number)
end

-- Begins one. Until stills.isBusy() ends all must stay as it is.
function stills.take()
    local number, size = GetInt("options.photos") + 1, stills.sizes[stills.chosen()]
    SetInt("options.photos", number)
    stills.last = string.format("photo-%03d.png", number)
    Screenshot(stills.last, size[2], size[3])
    sounds.play("click")
end

function stills.isBusy()
    return GetScreenshotProgress() < 1
end

-- How far one is, in the middle of the lower edge.
function stills.draw()
    local share = GetScreenshotProgress()
    local scale = options.get("textsize")
    UiPush()
    UiTranslate(UiCenter() - 220 * scale, UiHeight() - 130 * scale)
    draw.panel(440 * scale, 90 * scale, 0.72)
    UiTranslate(220 * scale, 40 * scale)
    draw.text(string.format("%s, %s: %d %%", stills.last, stills.sizes[stills.chosen()][1], math.floor(100 * share)), 24,
        "center")
    UiTranslate(-190 * scale, 24 * scale)
    UiAlign("left middle")
    UiColor(1, 1, 1, 0.16)
    UiRoundedRect(380 * scale, 8, 4)
    draw.color(draw.accent, 0.95)
    UiRoundedRect(math.max(8, 380 * scale * share), 8, 4)
    UiPop()
end

return stills
