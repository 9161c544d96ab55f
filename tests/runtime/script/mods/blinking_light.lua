-- Old bulb: blinks, follows a swinging weight, breaks the circuit when its door opens
function rndVec(s)
	return Vec((math.random()*2-1)*s, (math.random()*2-1)*s, (math.random()*2-1)*s)
end

function init()
	bulb = FindLight("bulb")
	hinge = FindJoint("hinge")
	door = FindShape("door")
	gate = FindTrigger("gate")
	on = true
	blink = 0
	SetTag(door, "interact", "Open")
	SetTag(door, "unbreakable")
	shapes = FindShapes("", true)
	count = 0
	for i=1,#shapes do
		if HasTag(shapes[i], "unbreakable") then count = count + 1 end
	end
	SetInt("level.light.tagged", count)
	local mi, ma = GetJointLimits(hinge)
	SetBool("level.light.limits", mi <= ma)
	assert(GetJointType(hinge) == "hinge")
	local other = GetJointOtherShape(hinge, door)
	SetBool("level.light.other", other ~= 0 and other ~= door)
end

function tick(dt)
	blink = blink + dt
	if blink > 0.2 then
		blink = 0
		on = not on
		SetLightEnabled(bulb, on)
	end
	SetLightColor(bulb, 1, 0.8, 0.6)
	SetLightIntensity(bulb, 0.5 + math.random())
	if GetPlayerInteractShape() == door and InputPressed("interact") then
		RemoveTag(door, "interact")
	end
	if GetTime() > 1 and not opened then
		opened = true
		SetJointMotor(hinge, 1.5, 60)
	end
	if GetTime() > 2 and opened ~= "done" then
		opened = "done"
		SetJointMotorTarget(hinge, 0, 2, 60)
		RemoveTag(door, "unbreakable")
	end
	SetFloat("level.light.angle", math.max(GetFloat("level.light.angle"), math.abs(GetJointMovement(hinge))))
	if IsPointAffectedByLight(bulb, Vec(0, 1, -1.6)) then
		SetBool("level.light.lit", true)
	end
	if GetTagValue(door, "interact") == "Open" then
		DebugCross(GetLightTransform(bulb).pos, 1, 1, 0)
	end
	if IsBodyInTrigger(gate, FindBody("crate")) then
		SetBool("level.light.crate", true)
	end
	if on then
		PointLight(VecAdd(GetLightTransform(bulb).pos, rndVec(0.1)), 1, 0.6, 0.3, 2)
	end
	DebugWatch("door", TransformStr(GetShapeWorldTransform(door)))
	DebugWatch("size", VecStr(Vec(GetShapeSize(door))))
end
