-- Examples of the reference in docs/scripting: one for each function, in the yard of samples/lua/yard.h. A test runs each
-- of them in a yard of its own. "--- NAME" begins one.

--- Vec
local v = Vec(1, 2, 3)
assert(v[2] == 2 and v.y == 2)
assert(v + Vec(1, 1, 1) == Vec(2, 3, 4) and 2 * v == Vec(2, 4, 6))
--- VecCopy
local a = Vec(1, 2, 3)
local b = VecCopy(a)
b.x = 9
assert(a.x == 1)
--- VecLength
assert(VecLength({3, 4, 0}) == 5)
--- VecNormalize
assert(VecNormalize({0, 10, 0}) == Vec(0, 1, 0))
--- VecScale
assert(VecScale({1, 2, 3}, 2) == Vec(2, 4, 6))
--- VecAdd
assert(VecAdd({1, 2, 3}, {1, 1, 1}) == Vec(2, 3, 4))
--- VecSub
assert(VecSub({1, 2, 3}, {1, 1, 1}) == Vec(0, 1, 2))
--- VecDot
assert(VecDot({1, 2, 3}, {4, 5, 6}) == 32)
--- VecCross
assert(VecCross({1, 0, 0}, {0, 1, 0}) == Vec(0, 0, 1))
--- VecStr
assert(VecStr({1, 2.5, 3}) == "(1.0, 2.5, 3.0)")
--- VecLerp
assert(VecLerp({0, 0, 0}, {2, 4, 6}, 0.5) == Vec(1, 2, 3))
--- Quat
local none = Quat()
assert(none[4] == 1 and none * Vec(1, 2, 3) == Vec(1, 2, 3))
--- QuatCopy
local a = QuatEuler(0, 90, 0)
assert(QuatCopy(a) ~= a)
--- QuatAxisAngle
local q = QuatAxisAngle({0, 1, 0}, 90)
assert(VecLength(QuatRotateVec(q, {1, 0, 0}) - Vec(0, 0, -1)) < 1e-9)
--- QuatEuler
local q = QuatEuler(0, 90, 0)
assert(VecLength(q * Vec(1, 0, 0) - Vec(0, 0, -1)) < 1e-9)
--- GetQuatEuler
local x, y, z = GetQuatEuler(QuatEuler(10, 20, 30))
assert(VecLength(Vec(x, y, z) - Vec(10, 20, 30)) < 1e-9)
--- QuatLookAt
local q = QuatLookAt({0, 1, 0}, {5, 1, 0})
assert(VecLength(q * Vec(0, 0, -1) - Vec(1, 0, 0)) < 1e-9)
--- QuatSlerp
local half = QuatSlerp(Quat(), QuatEuler(0, 90, 0), 0.5)
local x, y, z = GetQuatEuler(half)
assert(math.abs(y - 45) < 1e-9)
--- QuatRotateQuat
local q = QuatRotateQuat(QuatEuler(0, 90, 0), QuatEuler(0, -90, 0))
assert(VecLength(q * Vec(1, 0, 0) - Vec(1, 0, 0)) < 1e-9)
--- QuatStr
assert(QuatStr(Quat()) == "(0.0, 0.0, 0.0, 1.0)")
--- QuatRotateVec
assert(VecLength(QuatRotateVec(QuatEuler(90, 0, 0), {0, 1, 0}) - Vec(0, 0, 1)) < 1e-9)
--- Transform
local t = Transform(Vec(1, 2, 3), QuatEuler(0, 90, 0))
assert(VecLength(t * Vec(1, 0, 0) - Vec(1, 2, 2)) < 1e-9)
--- TransformCopy
local t = Transform({1, 2, 3})
local copy = TransformCopy(t)
copy.pos.x = 5
assert(t.pos.x == 1)
--- TransformStr
assert(TransformStr(Transform({1, 2, 3})) == "(1.0, 2.0, 3.0) (0.0, 0.0, 0.0, 1.0)")
--- TransformToParentTransform
local t = TransformToParentTransform(Transform({1, 0, 0}), Transform({0, 2, 0}))
assert(t.pos == Vec(1, 2, 0))
--- TransformToLocalTransform
local t = TransformToLocalTransform(Transform({1, 0, 0}), Transform({1, 2, 0}))
assert(t.pos == Vec(0, 2, 0))
--- TransformToParentVec
local t = Transform({9, 9, 9}, QuatEuler(0, 90, 0))
assert(VecLength(TransformToParentVec(t, {1, 0, 0}) - Vec(0, 0, -1)) < 1e-9)
--- TransformToLocalVec
local t = Transform({9, 9, 9}, QuatEuler(0, 90, 0))
assert(VecLength(TransformToLocalVec(t, {1, 0, 0}) - Vec(0, 0, 1)) < 1e-9)
--- TransformToParentPoint
assert(TransformToParentPoint(Transform({1, 1, 1}), {1, 2, 3}) == Vec(2, 3, 4))
--- TransformToLocalPoint
assert(TransformToLocalPoint(Transform({1, 1, 1}), {1, 2, 3}) == Vec(0, 1, 2))

--- MakeHole
local wall = FindShape("wall")
local before = GetShapeVoxelCount(wall)
local removed = MakeHole({0, 1.5, 0.15}, 0.5, 0.5) -- brick is of medium hardness
wait(0.1)
assert(removed > 0 and GetShapeVoxelCount(wall) <= before - removed)
--- MakeHoleLine
local wall = FindShape("wall")
local before = GetShapeVoxelCount(wall)
MakeHoleLine({-1, 1.5, 0.15}, {1, 1.5, 0.15}, 0.12, 0.12) -- a slit of two metres
wait(0.1)
assert(GetShapeVoxelCount(wall) <= before - 20 * 2 * 3)
--- Crack
local bodies = #FindBodies()
Crack({0, 1.5, 0.15}, 0.6, 0.6)
wait(0.1)
assert(#FindBodies() > bodies) -- bricks that came off
--- Explosion
Explosion({0, 0.4, -0.5}, 1.5)
wait(0.1)
assert(GetBodyVelocity(FindBody("crate")).z < 0) -- it flies away
--- Shoot
local before = GetShapeVoxelCount(FindShape("crate"))
Shoot({0, 0.4, -6}, {0, 0, 1}, "bullet", 1, 100)
wait(0.1)
assert(GetShapeVoxelCount(FindShape("crate")) < before)
--- AddHeat
AddHeat(FindShape("crate"), {0, 0.8, -1.6}, 5)
wait(1)
assert(GetFireCount() > 0)
--- SpawnFire
SpawnFire({0, 0.8, -1.6})
wait(0.1)
assert(GetFireCount() > 0)
--- Extinguish
SpawnFire({0, 0.8, -1.6})
wait(0.1)
assert(GetFireCount() > 0)
Extinguish({0, 0.8, -1.6}, 1, 20)
wait(0.1)
assert(GetFireCount() == 0)
--- GetFireCount
assert(GetFireCount() == 0)
--- QueryClosestFire
SpawnFire({0, 0.8, -1.6})
wait(0.1)
local hit, pos = QueryClosestFire({0, 2, -1.6}, 5)
assert(hit and VecLength(pos - Vec(0, 0.8, -1.6)) < 1)
--- QueryAabbFireCount
SpawnFire({0, 0.8, -1.6})
wait(0.1)
assert(QueryAabbFireCount({-1, 0, -3}, {1, 2, 0}) > 0 and QueryAabbFireCount({5, 0, 5}, {6, 1, 6}) == 0)
--- RemoveAabbFires
SpawnFire({0, 0.8, -1.6})
wait(0.1)
RemoveAabbFires({-1, 0, -3}, {1, 2, 0})
wait(0.1)
assert(GetFireCount() == 0)
--- Paint
local wall = FindShape("wall")
local _, r = GetShapeMaterialAtPosition(wall, {0, 1, 0.05})
Paint({0, 1, 0}, 0.5, "explosion")
wait(0.1)
local _, darker = GetShapeMaterialAtPosition(wall, {0, 1, 0.05})
assert(darker < r)
--- PaintRGBA
PaintRGBA({0, 1, 0}, 0.5, 1, 0, 0, 1, 1)
wait(0.1)
local _, r, g = GetShapeMaterialAtPosition(FindShape("wall"), {0, 1, 0.05})
assert(r == 1 and g == 0)

--- FindBody
local crate = FindBody("crate")
assert(IsBodyDynamic(crate) and FindBody("nothing") == 0)
--- FindBodies
assert(#FindBodies("crate") == 1 and #FindBodies() > 5)
--- FindShape
assert(GetShapeBody(FindShape("crate")) == FindBody("crate"))
--- FindShapes
for i, shape in ipairs(FindShapes()) do assert(GetShapeVoxelCount(shape) > 0) end
--- FindLight
assert(IsLightActive(FindLight("bulb")))
--- FindLights
assert(#FindLights() == 1)
--- FindJoint
assert(not IsJointBroken(FindJoint("hinge")))
--- FindJoints
assert(#FindJoints() == 2)
--- FindTrigger
assert(FindTrigger("gate") ~= 0)
--- FindTriggers
assert(#FindTriggers("gate") == 1)
--- IsBodyInTrigger
wait(0.1)
assert(IsBodyInTrigger(FindTrigger("gate"), FindBody("crate")))
--- FindLocation
local place = FindLocation("spawn")  -- 0: the level has no such place, as this yard
if place ~= 0 then SetBodyTransform(FindBody("crate"), GetLocationTransform(place)) end
--- FindLocations
for _, place in ipairs(FindLocations("bulb")) do PointLight(GetLocationTransform(place).pos, 1, 1, 1, 10) end
--- GetLocationTransform
assert(not pcall(GetLocationTransform, 5))  -- this yard has no places
--- SetTag
SetTag(FindBody("crate"), "owner", "me")
wait(0.1)
assert(GetTagValue(FindBody("crate"), "owner") == "me")
--- HasTag
assert(HasTag(FindBody("crate"), "crate"))
--- GetTagValue
assert(GetTagValue(FindBody("crate"), "crate") == "")
--- RemoveTag
local crate = FindBody("crate")
RemoveTag(crate, "crate")
wait(0.1)
assert(not HasTag(crate, "crate"))
--- IsHandleValid
assert(IsHandleValid(FindBody("crate")) and not IsHandleValid(0))
--- GetEntityType
assert(GetEntityType(FindBody("crate")) == "body" and GetEntityType(FindTrigger("gate")) == "trigger")
local made = Spawn("post.vox", Transform({5, 1, 5}))
assert(GetEntityType(made[1]) == "body" and GetEntityType(made[2]) == "shape" and GetEntityType(0) == "")
--- Delete
local crate = FindBody("crate")
Delete(crate)
wait(0.1)
assert(not IsHandleValid(crate))

--- GetBodyTransform
local t = GetBodyTransform(FindBody("crate"))
assert(VecLength(t.pos - Vec(-0.4, 0, -2)) < 0.1)
--- SetBodyTransform
local crate = FindBody("crate")
SetBodyTransform(crate, Transform({0, 5, -2}))
wait(0.05)
assert(GetBodyTransform(crate).pos.y > 4)
--- GetBodyVelocity
assert(VecLength(GetBodyVelocity(FindBody("crate"))) < 0.1)
--- SetBodyVelocity
local crate = FindBody("crate")
SetBodyVelocity(crate, {0, 5, 0})
wait(0.1)
assert(GetBodyVelocity(crate).y > 3)
--- GetBodyAngularVelocity
assert(VecLength(GetBodyAngularVelocity(FindBody("crate"))) < 0.1)
--- SetBodyAngularVelocity
local crate = FindBody("crate")
SetBodyVelocity(crate, {0, 5, 0})
wait(0.1)
SetBodyAngularVelocity(crate, {0, 3, 0})
wait(0.05)
assert(GetBodyAngularVelocity(crate).y > 2)
--- GetBodyVelocityAtPos
assert(VecLength(GetBodyVelocityAtPos(FindBody("crate"), {0, 1, -2})) < 0.1)
--- GetBodyMass
assert(GetBodyMass(FindBody("crate")) > 100 and GetBodyMass(FindBody("wall")) == 0)
--- GetBodyCenterOfMass
assert(VecLength(GetBodyCenterOfMass(FindBody("crate")) - Vec(0.4, 0.4, 0.4)) < 0.01)
--- GetBodyBounds
local min, max = GetBodyBounds(FindBody("crate"))
assert(VecLength(max - min - Vec(0.8, 0.8, 0.8)) < 0.05)
--- GetBodyShapes
assert(GetBodyShapes(FindBody("crate"))[1] == FindShape("crate"))
--- IsBodyActive
assert(not IsBodyActive(FindBody("wall")))
--- SetBodyActive
local crate = FindBody("crate")
SetBodyActive(crate, false)
wait(0.02)
assert(not IsBodyActive(crate))
--- IsBodyDynamic
assert(IsBodyDynamic(FindBody("crate")) and not IsBodyDynamic(FindBody("wall")))
--- SetBodyDynamic
local wall = FindBody("wall")
SetBodyDynamic(wall, true)
wait(0.1)
assert(IsBodyDynamic(wall))
--- IsBodyBroken
local crate = FindBody("crate")
assert(not IsBodyBroken(crate))
MakeHole({0, 0.4, -2}, 0.2)
wait(0.1)
assert(IsBodyBroken(crate))
--- ConstrainPosition
local crate = FindBody("crate")
local target = GetBodyTransform(crate).pos + Vec(0, 1, 0)
for i = 1, 60 do
    ConstrainPosition(crate, 0, GetBodyTransform(crate).pos, target, 3)
    wait(0)
end
assert(VecLength(GetBodyTransform(crate).pos - target) < 0.1)  -- it hangs in the air
--- ConstrainOrientation
local crate = FindBody("crate")
ApplyBodyImpulse(crate, GetBodyTransform(crate).pos, {0, 1000, 0})
for i = 1, 30 do
    ConstrainOrientation(crate, 0, GetBodyTransform(crate).rot, QuatEuler(0, 45, 0), 5)
    wait(0)
end
local x, y, z = GetQuatEuler(GetBodyTransform(crate).rot)
assert(math.abs(y - 45) < 5)
--- ConstrainVelocity
local crate = FindBody("crate")
for i = 1, 10 do
    ConstrainVelocity(crate, 0, GetBodyTransform(crate).pos, {0, 1, 0}, 2)
    wait(0)
end
assert(GetBodyTransform(crate).pos.y > 0.2)  -- raised at 2 m/s
--- ConstrainAngularVelocity
local crate = FindBody("crate")
for i = 1, 10 do
    ConstrainAngularVelocity(crate, 0, {0, 1, 0}, 3)
    wait(0)
end
assert(math.abs(GetBodyAngularVelocity(crate).y - 3) < 0.2)
--- ApplyBodyImpulse
local crate = FindBody("crate")
ApplyBodyImpulse(crate, {0, 0.4, -2}, {2000, 0, 0})
wait(0.05)
assert(GetBodyVelocity(crate).x > 1)

--- GetShapeBody
assert(GetShapeBody(FindShape("wall")) == FindBody("wall"))
--- GetShapeWorldTransform
assert(GetShapeWorldTransform(FindShape("wall")).pos == Vec(-2, 0, 0))
--- GetShapeLocalTransform
assert(GetShapeLocalTransform(FindShape("wall")).pos == Vec(0, 0, 0))
--- GetShapeBounds
local low, high = GetShapeBounds(FindShape("wall"))
assert(math.abs(high.y - low.y - 2.5) < 0.001)
--- GetShapeJoints
assert(GetShapeJoints(FindShape("door"))[1] == FindJoint("hinge"))
--- GetShapeLights
assert(#GetShapeLights(FindShape("wall")) == 0)
--- GetShapeSize
local x, y, z, scale = GetShapeSize(FindShape("wall"))
assert(x == 40 and y == 25 and z == 3 and math.abs(scale - 0.1) < 1e-6)
--- GetShapeVoxelCount
assert(GetShapeVoxelCount(FindShape("crate")) == 8 * 8 * 8)
--- GetShapeMaterialAtPosition
local type, r, g, b, a, entry = GetShapeMaterialAtPosition(FindShape("wall"), {0, 1, 0.15})
assert(type == "brick" and entry == 7 and a == 1)
--- GetShapeMaterialAtIndex
assert(GetShapeMaterialAtIndex(FindShape("crate"), 0, 0, 0) == "wood")
assert(GetShapeMaterialAtIndex(FindShape("crate"), 99, 0, 0) == "")
--- GetShapeMaterial
assert(GetShapeMaterial(FindShape("crate"), 5) == "wood")
--- SetShapeEmissiveScale
SetShapeEmissiveScale(FindShape("crate"), 0.5)
--- SetShapeDensity
local mass = GetBodyMass(FindBody("crate"))
SetShapeDensity(FindShape("crate"), 2)
wait(0.1)
assert(GetBodyMass(FindBody("crate")) > 1.9 * mass)
--- GetShapeCollisionFilter
local layer, mask = GetShapeCollisionFilter(FindShape("crate"))
assert(layer == 1 and mask == 255)
--- SetShapeCollisionFilter
local crate = FindShape("crate")
SetShapeCollisionFilter(crate, 2, 0) -- collides with nothing: it falls
wait(0.5)
assert(GetBodyTransform(FindBody("crate")).pos.y < -0.5)
--- IsShapeBroken
assert(not IsShapeBroken(FindShape("wall")))
MakeHole({0, 1.5, 0.15}, 0.5, 0.5)
wait(0.1)
assert(IsShapeBroken(FindShape("wall")))
--- IsShapeDisconnected
assert(IsShapeDisconnected(FindShape("crate")) and not IsShapeDisconnected(FindShape("wall")))
--- IsStaticShapeDetached
assert(not IsStaticShapeDetached(FindShape("wall")))
--- IsShapeTouching
wait(0.2)
assert(IsShapeTouching(FindShape("crate"), FindShape("floor")))
assert(not IsShapeTouching(FindShape("crate"), FindShape("wall")))
--- GetShapeClosestPoint
local hit, pos, normal = GetShapeClosestPoint(FindShape("wall"), {0, 1, -3})
assert(hit and VecLength(pos - Vec(0, 1, 0)) < 0.01)
--- CreateShape
local wall = FindShape("wall")
local shape = CreateShape(FindBody("wall"), Transform({0, 2.5, 0}), wall)
SetBrush("cube", 1, 7)
DrawShapeBox(shape, 0, 0, 0, 7, 7, 2)
wait(0.1)
assert(GetShapeVoxelCount(shape) == 8 * 8 * 3)
--- ClearShape
local crate = FindShape("crate")
ClearShape(crate)
SetBrush("cube", 1, 5)
DrawShapeBox(crate, 0, 0, 0, 3, 3, 3)
wait(0.1)
assert(GetShapeVoxelCount(crate) == 64)
--- ResizeShape
local crate = FindShape("crate")
ResizeShape(crate, 0, 0, 0, 3, 7, 7)
wait(0.1)
assert(GetShapeSize(crate) == 4)
--- TrimShape
local crate = FindShape("crate")
SetBrush("cube", 1, 0)
DrawShapeBox(crate, 4, 0, 0, 7, 7, 7)
TrimShape(crate)
wait(0.1)
assert(GetShapeSize(crate) < 8)
--- SplitShape
local crate = FindShape("crate")
SetBrush("cube", 1, 0)
DrawShapeBox(crate, 3, 0, 0, 4, 7, 7)
assert(#SplitShape(crate) == 1) -- the two halves do not touch
--- MergeShape
local wall = FindShape("wall")
local top = CreateShape(FindBody("wall"), Transform({0, 2.5, 0}), wall)
SetBrush("cube", 1, 7)
DrawShapeBox(top, 0, 0, 0, 7, 7, 2)
MergeShape(top, wall)
wait(0.1)
assert(GetShapeVoxelCount(wall) == 40 * 25 * 3 + 8 * 8 * 3)
--- CopyShapeContent
local crate, weight = FindShape("crate"), FindShape("weight")
CopyShapeContent(weight, crate)
wait(0.1)
assert(GetShapeVoxelCount(crate) == 4 * 4 * 4)
--- CopyShapePalette
CopyShapePalette(FindShape("wall"), FindShape("crate"))
--- SetBrush
local wall = FindShape("wall")
SetBrush("sphere", 6, 0) -- a ball of 6 cells that removes
DrawShapeLine(wall, 10, 10, 1, 20, 10, 1)
wait(0.1)
assert(GetShapeMaterialAtIndex(wall, 15, 10, 1) == "")
--- DrawShapeLine
local wall = FindShape("wall")
SetBrush("cube", 1, 5)
DrawShapeLine(wall, 0, 10, 0, 39, 10, 0)
wait(0.1)
assert(GetShapeMaterialAtIndex(wall, 20, 10, 0) == "wood")
--- DrawShapeBox
local wall = FindShape("wall")
SetBrush("cube", 1, 0)
DrawShapeBox(wall, 18, 8, 0, 22, 12, 2) -- a window
wait(0.1)
assert(GetShapeVoxelCount(wall) == 40 * 25 * 3 - 5 * 5 * 3)
--- ExtrudeShape
local crate = FindShape("crate")
SetBrush("cube", 1, 0)
ExtrudeShape(crate, 0, 7, 0, 1, 0, 0, 7)
wait(0.1)
assert(GetShapeVoxelCount(crate) == 8 * 8 * 8 - 7)

--- SetLightEnabled
local bulb = FindLight("bulb")
SetLightEnabled(bulb, false)
wait(0.05)
assert(not IsLightActive(bulb))
--- SetLightColor
SetLightColor(FindLight("bulb"), 1, 0.5, 0)
--- SetLightIntensity
SetLightIntensity(FindLight("bulb"), 100)
--- GetLightTransform
assert(GetLightTransform(FindLight("bulb")).pos == Vec(0, 3, -1.6))
--- GetLightShape
assert(GetLightShape(FindLight("bulb")) == 0)
--- IsLightActive
assert(IsLightActive(FindLight("bulb")))
--- IsPointAffectedByLight
local bulb = FindLight("bulb")
assert(IsPointAffectedByLight(bulb, {0, 1.5, -1.6}))
assert(not IsPointAffectedByLight(bulb, {0, 0.5, 1})) -- behind the wall
--- PointLight
PointLight({0, 2, 0}, 1, 0.8, 0.5, 10)

--- IsJointBroken
local rope = FindJoint("rope")
Delete(rope)
wait(0.1)
assert(IsJointBroken(rope))
--- GetJointShapes
local shapes = GetJointShapes(FindJoint("hinge"))
assert(shapes[1] == FindShape("post") and shapes[2] == FindShape("door"))
--- GetJointOtherShape
assert(GetJointOtherShape(FindJoint("hinge"), FindShape("door")) == FindShape("post"))
--- GetJointType
assert(GetJointType(FindJoint("hinge")) == "hinge")
--- IsBodyJointedToStatic
assert(IsBodyJointedToStatic(FindBody("weight")) and not IsBodyJointedToStatic(FindBody("crate")))
--- SetJointMotor
SetJointMotor(FindJoint("hinge"), 1, 1000)
wait(0.5)
assert(math.abs(GetBodyAngularVelocity(FindBody("door")).y) > 0.5)
--- SetJointMotorTarget
SetJointMotorTarget(FindJoint("hinge"), 0.5, 1, 5000)
wait(1)
local x, y = GetQuatEuler(GetBodyTransform(FindBody("door")).rot)
assert(math.abs(math.abs(y) - math.deg(0.5)) < 3)
--- GetJointLimits
local least, most = GetJointLimits(FindJoint("hinge"))
assert(least <= most)
--- GetJointMovement
assert(math.abs(GetJointMovement(FindJoint("hinge"))) < 0.1)  -- the door is as it was built
--- DetachJointFromShape
local weight = FindShape("weight")
DetachJointFromShape(FindJoint("rope"), weight)
wait(1)
assert(GetBodyTransform(FindBody("weight")).pos.y < 0.3) -- it lies on the floor
--- GetRopeNumberOfPoints
assert(GetRopeNumberOfPoints(FindJoint("rope")) >= 3 and GetRopeNumberOfPoints(FindJoint("hinge")) == 0)
--- GetRopePointPosition
assert(math.abs(GetRopePointPosition(FindJoint("rope"), 1).y - 3.9) < 0.1)
--- BreakRope
BreakRope(FindJoint("rope"), {-5, 2.5, -0.3})
wait(1)
assert(GetBodyTransform(FindBody("weight")).pos.y < 0.3)

--- QueryRequire
QueryRequire("dynamic")
local hit, dist, normal, shape = QueryRaycast({0, 1.5, -5}, {0, 0, 1}, 100)
assert(not hit) -- the wall is static
--- QueryInclude
QueryInclude(2)
assert(not QueryRaycast({0, 0.4, -5}, {0, 0, 1}, 100)) -- all is of layer 1
--- QueryRejectBody
QueryRejectBody(FindBody("crate"))
local hit, dist, normal, shape = QueryRaycast({0, 0.4, -5}, {0, 0, 1}, 100)
assert(shape == FindShape("wall"))
--- QueryRejectShape
QueryRejectShape(FindShape("crate"))
local hit, dist = QueryRaycast({0, 0.4, -5}, {0, 0, 1}, 100)
assert(math.abs(dist - 5) < 0.01)
--- QueryRejectBodies
QueryRejectBodies(FindBodies())
assert(not QueryRaycast({0, 0.4, -5}, {0, 0, 1}, 100))
--- QueryRejectShapes
QueryRejectShapes({FindShape("crate"), FindShape("wall")})
assert(not QueryRaycast({0, 0.4, -5}, {0, 0, 1}, 100))
--- QueryRaycast
local hit, dist, normal, shape = QueryRaycast({0, 1.5, -5}, {0, 0, 1}, 100)
assert(hit and math.abs(dist - 5) < 0.01 and normal == Vec(0, 0, -1) and shape == FindShape("wall"))
--- QueryRaycasts
local distances, shapes = QueryRaycasts({0, 1.5, -5, 0, 0, 1,  0, 50, 0, 0, 1, 0}, 100)
assert(math.abs(distances[1] - 5) < 0.01 and distances[2] == -1 and shapes[2] == 0)
--- QueryClosestPoint
local hit, pos, normal, shape = QueryClosestPoint({0, 1.5, -0.5}, 2)
assert(hit and shape == FindShape("wall") and math.abs(pos.z) < 0.01)
--- QueryAabbShapes
local shapes = QueryAabbShapes({-0.5, 1, -0.5}, {0.5, 2, 0.5})
assert(#shapes == 1 and shapes[1] == FindShape("wall"))
--- QueryAabbBodies
assert(QueryAabbBodies({-0.5, 0.2, -2.5}, {0.5, 0.5, -1.5})[1] == FindBody("crate"))

--- ParticleReset
ParticleReset()
ParticleType("smoke")
SpawnParticle({0, 2, 0}, {0, 1, 0}, 2)
--- ParticleType
ParticleType("spark")
--- ParticleColor
ParticleColor(1, 0.5, 0.2)
--- ParticleRadius
ParticleRadius(0.1, 0.5)
--- ParticleAlpha
ParticleAlpha(0.5)
--- ParticleEmissive
ParticleEmissive(5)
--- ParticleGravity
ParticleGravity(-10)  -- falls
--- ParticleDrag
ParticleDrag(2)
--- ParticleRotation
ParticleRotation(3)
--- ParticleStretch
ParticleStretch(0.1)
--- ParticleCollide
ParticleCollide(0)  -- goes through walls
--- ParticleTile
ParticleTile(5)
--- ParticleFlags
ParticleFlags(0)
--- ParticleSticky
ParticleSticky(0.5)
--- SpawnParticle
for i = 1, 10 do SpawnParticle({0, 2, 0}, {math.random(), 2, math.random()}, 1) end

--- SetTimeScale
SetTimeScale(0.5)
--- SetGravity
SetGravity({0, 0, 0})
SetBodyVelocity(FindBody("crate"), {0, 1, 0})
wait(1)
assert(GetBodyVelocity(FindBody("crate")).y > 0.9)
--- GetTime
local before = GetTime()
wait(0.5)
assert(math.abs(GetTime() - before - 0.5) < 0.02)
--- GetTimeStep
assert(math.abs(GetTimeStep() - 1 / 60) < 0.01)
--- Spawn
local things = Spawn("post.vox", Transform({5, 0, -5}))
wait(0.1)
assert(IsHandleValid(things[1]))
--- DebugLine
DebugLine({0, 0, 0}, {0, 5, 0}, 1, 0, 0)
--- DebugCross
DebugCross({0, 1, 0}, 0, 1, 0)
--- DrawLine
DrawLine({-2, 2.6, 0}, {2, 2.6, 0}, 1, 0.8, 0)  -- hidden where the wall is nearer
--- DebugPrint
DebugPrint("hello")
--- DebugWatch
DebugWatch("crates", #FindBodies("crate"))
--- DebugProfile
DebugProfile(true)
wait(0.1)
DebugProfile(false)
--- wait
local before = GetTime()
wait(0.25)
assert(GetTime() >= before + 0.25)
--- start
local done = false
start(function(seconds)
    wait(seconds)
    done = true
end, 0.2)
wait(0.5)
assert(done)

--- UiPush
UiPush()
UiTranslate(100, 100)
UiText("here")
UiPop()
UiText("where it was before")
--- UiPop
UiPush()
UiFont("bold.ttf", 60)
UiPop()
local width, height = UiGetTextSize("as before")
assert(height < 40)
--- UiTranslate
UiTranslate(UiCenter(), UiMiddle())
UiAlign("center middle")
UiText("in the middle")
--- UiRotate
UiTranslate(200, 200)
UiRotate(90)
UiText("upwards")
--- UiScale
UiScale(2)
UiText("twice as large")
--- UiWindow
UiTranslate(100, 100)
UiWindow(300, 200, true)
assert(UiWidth() == 300 and UiCenter() == 150)
UiRect(1000, 10)  -- 300 units of it are seen
--- UiAlign
UiTranslate(UiWidth(), 0)
UiAlign("right top")
UiText("in the right upper corner")
--- UiColor
UiColor(1, 0.5, 0)
UiRect(100, 20)
UiColor(1, 1, 1, 0.5)
UiRect(100, 20)
--- UiColorFilter
UiColorFilter(1, 1, 1, 0.5)  -- all at half opacity
UiColor(1, 0, 0)
UiRect(100, 20)
--- UiFont
UiFont("bold.ttf", 48)
local bold = UiGetTextSize("wide")
UiFont("regular.ttf", 48)
assert(bold > UiGetTextSize("wide"))
--- UiFontHeight
UiFont("regular.ttf", 50)
assert(UiFontHeight() > 50 and UiFontHeight() < 70)
--- UiTextOutline
UiTextOutline(0, 0, 0, 1, 0.1)
UiText("seen on any ground")
--- UiTextShadow
UiTextShadow(0, 0, 0, 0.8, 2, 0.2)
UiText("above the ground")
--- UiWordWrap
UiWordWrap(200)
local width, height = UiText("A long text, of which no line is wider than it should be.")
assert(width <= 200 and height > 2 * UiFontHeight())
--- UiWidth
assert(UiWidth() > UiHeight())
--- UiHeight
assert(UiHeight() == 1080)  -- of each screen
--- UiCenter
assert(UiCenter() == UiWidth() / 2)
--- UiMiddle
assert(UiMiddle() == 540)
--- UiWorld
UiPush()
UiWorld(Transform(Vec(-1, 3, 0), QuatEuler(0, 30, 0)), 0.01)
UiFont("bold.ttf", 40)
UiText("a sign, 40 cm high")
UiPop()
--- UiText
local width, height = UiText("Größe: 12 m", true)
UiText("a line below")
assert(width > height)
--- UiGetTextSize
local width, height = UiGetTextSize("text")
UiRect(width, height)
--- UiRect
UiTranslate(10, 10)
UiRect(200, 30)
--- UiRectOutline
UiRectOutline(200, 30, 2)
--- UiRoundedRect
UiRoundedRect(200, 30, 8)
--- UiCircle
UiTranslate(UiCenter(), UiMiddle())
UiAlign("center middle")
UiCircle(3)
--- UiCircleOutline
UiAlign("center middle")
UiCircleOutline(20, 2)
--- UiLine
UiLine(100, 50, 3)
--- UiImage
local width, height = UiImage("image.png")
assert(width == 16 and height == 8)
UiImage("image.png", 0, 0, 8, 8)  -- its left half
--- UiGetImageSize
assert(UiGetImageSize("image.png") == 16)
--- UiImageBox
UiImageBox("image.png", 300, 100, 4, 4)
--- UiWorldToPixel
local x, y, depth = UiWorldToPixel(GetCameraTransform() * Vec(0, 0, -5))
assert(math.abs(depth - 5) < 1e-6 and math.abs(x - UiCenter()) < 1e-3)
--- GetCameraTransform
local eye = GetCameraTransform()
local hit, dist = QueryRaycast(eye.pos, eye.rot * Vec(0, 0, -1), 100)
--- require
local tools = require("tools")  -- tools.lua, which returns a table
assert(tools.double(4) == 8 and require("tools") == tools)
--- saved
local progress = saved("progress", {broken = 0, spawn = Vec(0, 1, 0)})
progress.broken = progress.broken + 1  -- a save keeps it
--- SetInt
SetInt("game.score", 5)
assert(GetInt("game.score") == 5)
--- GetInt
assert(GetInt("not.there") == 0)
--- SetFloat
SetFloat("game.speed", 0.1)
assert(GetFloat("game.speed") == 0.1)
--- GetFloat
assert(GetFloat("not.there") == 0)
--- SetBool
SetBool("game.over", true)
assert(GetBool("game.over"))
--- GetBool
assert(GetBool("not.there") == false)
--- SetString
SetString("game.name", "rubble")
assert(GetString("game.name") == "rubble")
--- GetString
assert(GetString("not.there") == "")
--- HasKey
SetInt("game.score", 5)
assert(HasKey("game") and HasKey("game.score") and not HasKey("gam"))
--- ClearKey
SetInt("game.score", 5)
ClearKey("game")
assert(not HasKey("game.score"))
--- ListKeys
SetInt("game.b", 1)
SetInt("game.a.x", 2)
local keys = ListKeys("game")
assert(#keys == 2 and keys[1] == "a" and keys[2] == "b")
--- GetIntParam
assert(GetIntParam("floors", 3) == 3)
--- GetFloatParam
assert(GetFloatParam("speed", 0.5) == 0.5)
--- GetBoolParam
assert(GetBoolParam("alarm", true) == true)
--- GetStringParam
assert(GetStringParam("title", "none") == "none")
--- GetPlayerTransform
local ahead = TransformToParentVec(GetPlayerTransform(), {0, 0, -1})
assert(VecLength(ahead) > 0.99)
--- GetPlayerPos
assert(GetPlayerPos() == GetPlayerTransform().pos)
--- DriveVehicle
DriveVehicle(FindVehicle("car"), 1, 0, false)
--- GetPlayerCameraTransform
local eye = GetPlayerCameraTransform().pos
--- SetPlayerTransform
SetPlayerTransform(Transform({0, 1, -5}))
--- GetPlayerVelocity
assert(VecLength(GetPlayerVelocity()) == 0)
--- SetPlayerVelocity
SetPlayerVelocity({0, 5, 0})
--- GetPlayerHealth
assert(GetPlayerHealth() == 1)
--- SetPlayerHealth
SetPlayerHealth(0.5)
--- GetPlayerVehicle
assert(GetPlayerVehicle() == 0)
--- GetPlayerGrabBody
assert(GetPlayerGrabBody() == 0)
--- GetPlayerPickBody
assert(GetPlayerPickBody() == 0)
--- GetPlayerInteractBody
assert(GetPlayerInteractBody() == 0)
--- GetPlayerInteractShape
assert(GetPlayerInteractShape() == 0)
--- FindVehicle
assert(FindVehicle("car") == 0)
--- InputPressed
if InputPressed("usetool") then MakeHole({0, 1, 0}, 0.5) end
--- InputDown
assert(not InputDown("up"))
--- InputReleased
assert(not InputReleased("jump"))
--- InputValue
assert(InputValue("mousewheel") == 0)
--- RegisterTool
RegisterTool("laser", "Laser", "laser.vox")
--- SetToolTransform
SetToolTransform(Transform({0, -0.2, 0}))
--- GetToolBody
assert(GetToolBody() == 0)
--- LoadSound
local sound = LoadSound("warning-beep.ogg")
--- PlaySound
PlaySound(LoadSound("warning-beep.ogg"), {0, 1, 0}, 0.5)
--- LoadLoop
local loop = LoadLoop("engine.ogg")
--- PlayLoop
PlayLoop(LoadLoop("engine.ogg"), {0, 1, 0})
--- PlayMusic
PlayMusic("calm.ogg")
--- StopMusic
StopMusic()
--- UiMakeInteractive
UiMakeInteractive()
--- UiSound
UiSound("click.ogg")
--- ShakeCamera
ShakeCamera(0.3)
