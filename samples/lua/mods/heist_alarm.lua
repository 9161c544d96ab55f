-- Timed heist alarm: when the crate leaves the gate, the lamp blinks and a clock runs down. The level must be left by
-- then. saved() keeps the clock, so that a save does not stop the alarm.
local alarm = saved("alarm", {isOn = false, left = 0})

function init()
    if GetBoolParam("steal", true) then
        wait(0.5)
        local crate = FindBody("crate")
        SetBodyVelocity(crate, Vec(-2, 6, -9))
    end
end

function onTrigger(trigger, body, entered)
    if entered or alarm.isOn or trigger ~= FindTrigger("gate") then return end
    alarm.isOn, alarm.left = true, GetFloatParam("seconds", 4)
    SetBool("alarm.on", true)
end

function update(dt)
    if not alarm.isOn then return end
    alarm.left = math.max(0, alarm.left - dt)
    local lamp = FindLight("bulb")
    if lamp ~= 0 then
        SetLightColor(lamp, 1, 0.05, 0.02)
        SetLightEnabled(lamp, alarm.left % 0.5 < 0.25)
    end
    if alarm.left == 0 then
        alarm.isOn = false
        SetBool("alarm.over", true)
        print("caught")
    end
end

function draw()
    if not alarm.isOn then return end
    UiAlign("center middle")
    UiTranslate(UiCenter(), 90)
    UiColor(0.8, 0, 0, 0.7)
    UiRoundedRect(260, 90, 14)
    UiColor(1, 1, 1)
    UiFont("mono.ttf", 64)
    UiText(string.format("%.1f", alarm.left))
end
