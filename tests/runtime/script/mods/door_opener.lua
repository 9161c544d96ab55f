-- Opens a door by its motor, and closes it again.
function init()
	hinge = FindJoint("hinge", true)
	door = FindBody("door")
	open = false
	timer = 0
	shapes = GetJointShapes(hinge)
	SetTag(door, "interact", "Open")
end

function tick(dt)
	if IsJointBroken(hinge) then return end
	timer = timer + dt
	if timer > 1.5 then
		timer = 0
		open = not open
		if open then
			SetJointMotor(hinge, 1.5, 5000)
			SetTag(door, "interact", "Close")
		else
			SetJointMotor(hinge, -1.5, 5000)
			SetTag(door, "interact", "Open")
		end
		SetBool("level.door.open", open)
	end
	local angle = GetJointMovement(hinge)
	local min, max = GetJointLimits(hinge)
	if math.abs(angle) > math.abs(GetFloat("level.door.most")) then
		SetFloat("level.door.most", angle)
	end
end

function draw()
	local b = GetBodyTransform(door)
	local x, y, dist = UiWorldToPixel(TransformToParentPoint(b, Vec(0, 1, 0)))
	if dist > 0 then
		UiTranslate(x, y)
		UiAlign("center")
		UiFont("bold.ttf", 22)
		UiText(GetTagValue(door, "interact"))
	end
end
