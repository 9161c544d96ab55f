-- What does not hold at the end of a run fails it.
function destroy()
    error("the end has failed")
end
