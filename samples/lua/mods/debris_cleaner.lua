-- Debris cleaner: deletes small pieces that lie still for a while, a few each second.
local pieces = {}

function onSplit(shape, list)
    for _, piece in ipairs(list) do pieces[#pieces + 1] = {shape = piece, since = GetTime()} end
end

function clean(patience, largest)
    local kept, deleted = {}, 0
    for _, piece in ipairs(pieces) do
        if IsHandleValid(piece.shape) then
            local body = GetShapeBody(piece.shape)
            if VecLength(GetBodyVelocity(body)) > 0.2 then piece.since = GetTime() end
            local isOld = GetTime() - piece.since > patience
            if isOld and GetShapeVoxelCount(piece.shape) <= largest and deleted < 20 then
                Delete(piece.shape)
                deleted = deleted + 1
            else
                kept[#kept + 1] = piece
            end
        end
    end
    pieces = kept
    SetInt("cleaner.deleted", GetInt("cleaner.deleted") + deleted)
end

function init()
    Explosion({0, 1, -0.3}, 2)
    while true do
        wait(1)
        clean(GetFloatParam("patience", 1), GetIntParam("largest", 200))
    end
end
