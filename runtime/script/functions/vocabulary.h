#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "runtime/script/binding/arguments.h"
#include "runtime/script/binding/script_context.h"

namespace rubble::script {

// The functions that scripts call, by subject: one file each.
/// Vec....
std::span<const ScriptFunction> vectorFunctions();
/// Quat....
std::span<const ScriptFunction> rotationFunctions();
/// Transform....
std::span<const ScriptFunction> transformFunctions();
/// MakeHole, Explosion, fires, Paint.
std::span<const ScriptFunction> breakFunctions();
/// Find..., tags, handles.
std::span<const ScriptFunction> findFunctions();
/// Bodies.
std::span<const ScriptFunction> bodyFunctions();
/// What holds bodies for a step.
std::span<const ScriptFunction> constrainFunctions();
/// What a shape is.
std::span<const ScriptFunction> shapeFunctions();
/// Making shapes and drawing in them.
std::span<const ScriptFunction> shapeEditFunctions();
/// Lights.
std::span<const ScriptFunction> lightFunctions();
/// Joints and ropes.
std::span<const ScriptFunction> jointFunctions();
/// Query....
std::span<const ScriptFunction> queryFunctions();
/// Particle....
std::span<const ScriptFunction> particleFunctions();
/// Gravity, time, Spawn, Debug..., waiting.
std::span<const ScriptFunction> worldFunctions();
/// What applies to all that is drawn after it.
std::span<const ScriptFunction> uiStateFunctions();
/// Texts, rectangles, images and lines over the image.
std::span<const ScriptFunction> uiDrawFunctions();
/// Other files of the scripts' folder, and tables that saves keep.
std::span<const ScriptFunction> fileFunctions();
/// What a game has in place of these: players, input, sound, tools.
std::span<const ScriptFunction> gameFunctions();
/// Keys that scripts share, and parameters.
std::span<const ScriptFunction> registryFunctions();

/// A chapter of the reference.
struct Subject {
    std::string_view name, title;
    std::span<const ScriptFunction> functions;
};

/// All of them, in the order of the reference.
const std::vector<Subject>& vocabulary();

/// Makes them globals of a state whose owner is a ScriptContext, and gives vectors, rotations and transforms their
/// operators.
void openVocabulary(lua_State* L);
/// Operators of the tables that Vec() gives.
void openVectorOperators(lua_State* L);
/// Those of Quat().
void openRotationOperators(lua_State* L);
/// Those of Transform().
void openTransformOperators(lua_State* L);

/// Gives the tables of a kind operators: rows whose names are those of metamethods.
void openOperators(lua_State* L, ValueKind kind, std::span<const ScriptFunction> operators);

/// Pushes a function of the vocabulary, or of operators: a closure that knows its row.
void pushFunction(lua_State* L, const ScriptFunction& function, lua_Integer index);

/// Waits until the next step is done, then goes on with `continuation`. Only callbacks and what start() began may wait.
int waitForStep(lua_State* L, lua_KContext context, lua_KFunction continuation);
/// Waits until a time in seconds of steps.
int waitUntil(lua_State* L, double time);
/// Whether the values that a callback has yielded with are those of a wait; then until when: seconds of steps, or a
/// negative number for the next step.
bool isWait(lua_State* L, int results, double& until);

}  // namespace rubble::script
