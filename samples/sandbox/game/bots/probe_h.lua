local bot = require("bots/hands")
if GetString("bot.stage") == "" then
bot.play(function()
    bot.frames(3)
    SetString("bot.stage", "run")
    SetString("game.contract", "heist")
    RestartLevel()
    bot.frames(20)
end)
else
bot.play(function()
    for i = 1, 100 do if GetString("contract.phase") == "planning" then break end bot.frames(1) end
    bot.frames(60)
    bot.image("h-1")
    local heist = require("contracts/heist")
    for i, eye in ipairs({Vec(19.2,0.3,37.6), Vec(22.2,0.3,32.6), Vec(22.4,3,37.6), Vec(25.6,3,36), Vec(44.4,0.3,36.5), Vec(41.2,0.3,30.5)}) do
        local at = heist.center(heist.bodyOf(i))
        print(i, VecStr(at), #FindJoints("wire"))
        bot.stand(eye, at)
        bot.image("h-thing" .. i)
    end
    bot.press("e")
    bot.frames(10)
    bot.image("h-alarm")
    SetPlayerTransform(Transform(Vec(39.5,0.2,53), QuatLookAt(Vec(39.5,1.6,53), Vec(39.5, 0.5, 47))))
    bot.frames(400)
    bot.image("h-exit")
    bot.frames(3300)
    bot.image("h-lost")
    print(GetString("contract.phase"), GetString("contract.reason"))
end)
end
function tick() bot.tick() end
