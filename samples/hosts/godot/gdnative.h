#pragma once
#include <cstddef>
#include <cstdint>

/// What Rubble uses of GDNative 1.0, the C interface of Godot 3 (seen in 3.2.3 and 3.5.3, x86-64), written down here so
/// that no header of Godot is needed. Godot's values are opaque bytes; its functions are slots of two tables.
namespace gd {

// ---- values: arrays of bytes, as Godot declares them, for they are passed and returned as such ----

template <size_t size>
struct Bytes {
    uint8_t bytes[size];
};
using VariantBytes = Bytes<24>;
using StringBytes = Bytes<8>;
using CharStringBytes = Bytes<8>;
using ArrayBytes = Bytes<8>;
using PoolBytes = Bytes<8>;  ///< a pool array of any type
using Vector2Bytes = Bytes<8>;
using Vector3Bytes = Bytes<12>;
using ColorBytes = Bytes<16>;
using TransformBytes = Bytes<48>;
struct Object;      ///< godot_object
struct MethodBind;  ///< godot_method_bind
struct PoolReadAccess;
struct PoolWriteAccess;
static_assert(sizeof(VariantBytes) == 24 && alignof(VariantBytes) == 1);

/// Variant::Type, for properties and arguments of signals.
enum class Type : int32_t { Nil = 0, Bool = 1, Int = 2, Real = 3, String = 4, Vector3 = 7, Color = 14 };

// ---- what Godot hands to the library ----

struct ApiHeader {
    uint32_t type;
    uint32_t version[2];
    const ApiHeader* next;
};
/// The table of the core: its functions are 8-byte slots from offset 40 on, and slot n is at offset 8 n.
struct CoreApi {
    ApiHeader header;
    uint32_t extensionCount;
    const ApiHeader* const* extensions;
};
static_assert(offsetof(CoreApi, extensionCount) == 24 && offsetof(CoreApi, extensions) == 32 && sizeof(CoreApi) == 40);

struct InitOptions {
    bool inEditor;
    uint64_t coreApiHash, editorApiHash, noApiHash;
    void (*reportVersionMismatch)(const Object*, const char*, Bytes<8>, Bytes<8>);  ///< not called
    void (*reportLoadingError)(const Object*, const char*);                         ///< not called
    Object* library;
    const CoreApi* api;
    const StringBytes* libraryPath;
};
static_assert(offsetof(InitOptions, coreApiHash) == 8 && offsetof(InitOptions, reportVersionMismatch) == 32 &&
              offsetof(InitOptions, api) == 56 && sizeof(InitOptions) == 72);

inline constexpr uint32_t kNativeScriptType = 1;  ///< of ApiHeader::type

// ---- what the library hands to Godot for a class ----

/// A function, what it is called with, and what frees that; null here.
template <class Signature>
struct Callback {
    Signature* function;
    void* data = nullptr;
    void (*freeData)(void*) = nullptr;  ///< not called, for there are no data
};
using CreateFunction = Callback<void*(Object* node, void* data)>;
using DestroyFunction = Callback<void(Object* node, void* data, void* self)>;
using MethodFunction =
    Callback<VariantBytes(Object* node, void* data, void* self, int32_t count, const VariantBytes* const* arguments)>;
using SetFunction = Callback<void(Object* node, void* data, void* self, const VariantBytes* value)>;
using GetFunction = Callback<VariantBytes(Object* node, void* data, void* self)>;
struct MethodAttributes {
    int32_t rpc;
};
struct PropertyAttributes {
    int32_t rset;
    Type type;
    int32_t hint;
    StringBytes hintText;
    int32_t usage;
    VariantBytes value;
};
struct SignalArgument {
    StringBytes name;
    Type type;
    int32_t hint;
    StringBytes hintText;
    int32_t usage;
    VariantBytes value;
};
struct Signal {
    StringBytes name;
    int32_t argumentCount;
    const SignalArgument* arguments;
    int32_t defaultCount;
    const VariantBytes* defaults;
};
static_assert(sizeof(CreateFunction) == 24 && sizeof(MethodFunction) == 24 && sizeof(MethodAttributes) == 4);
static_assert(sizeof(PropertyAttributes) == 48 && offsetof(PropertyAttributes, hintText) == 12 &&
              offsetof(PropertyAttributes, value) == 24);
static_assert(sizeof(SignalArgument) == 52 && sizeof(Signal) == 40 && offsetof(Signal, arguments) == 16);

inline constexpr int32_t kUsageDefault = 7;  ///< stored, in the inspector, over the network
inline constexpr int32_t kHintRange = 1, kHintEnum = 3, kHintFile = 13;

// ---- the tables ----

inline void* const* core = nullptr;          ///< set by godot_gdnative_init()
inline void* const* nativeScript = nullptr;  ///< the same

/// A function in a slot of a table.
template <void* const*& table, size_t slot, class Signature>
struct Function;
template <void* const*& table, size_t slot, class R, class... A>
struct Function<table, slot, R(A...)> {
    /// Calls it.
    R operator()(A... arguments) const { return reinterpret_cast<R (*)(A...)>(table[slot])(arguments...); }
};
template <size_t slot, class Signature>
using Core = Function<core, slot, Signature>;
template <size_t slot, class Signature>
using NativeScript = Function<nativeScript, slot, Signature>;

inline constexpr Core<513, void(VariantBytes*, const VariantBytes*)> variantCopy;
inline constexpr Core<514, void(VariantBytes*)> variantNil;
inline constexpr Core<515, void(VariantBytes*, bool)> variantBool;
inline constexpr Core<517, void(VariantBytes*, int64_t)> variantInt;
inline constexpr Core<518, void(VariantBytes*, double)> variantReal;
inline constexpr Core<519, void(VariantBytes*, const StringBytes*)> variantString;
inline constexpr Core<522, void(VariantBytes*, const Vector3Bytes*)> variantVector3;
inline constexpr Core<528, void(VariantBytes*, const TransformBytes*)> variantTransform;
inline constexpr Core<529, void(VariantBytes*, const ColorBytes*)> variantColor;
inline constexpr Core<532, void(VariantBytes*, const Object*)> variantObject;
inline constexpr Core<534, void(VariantBytes*, const ArrayBytes*)> variantArray;
inline constexpr Core<536, void(VariantBytes*, const PoolBytes*)> variantPoolInt;
inline constexpr Core<540, void(VariantBytes*, const PoolBytes*)> variantPoolVector3;
inline constexpr Core<541, void(VariantBytes*, const PoolBytes*)> variantPoolColor;
inline constexpr Core<542, bool(const VariantBytes*)> asBool;
inline constexpr Core<544, int64_t(const VariantBytes*)> asInt;
inline constexpr Core<545, double(const VariantBytes*)> asReal;
inline constexpr Core<546, StringBytes(const VariantBytes*)> asString;
inline constexpr Core<547, Vector2Bytes(const VariantBytes*)> asVector2;
inline constexpr Core<549, Vector3Bytes(const VariantBytes*)> asVector3;
inline constexpr Core<555, TransformBytes(const VariantBytes*)> asTransform;
inline constexpr Core<556, ColorBytes(const VariantBytes*)> asColor;
inline constexpr Core<559, Object*(const VariantBytes*)> asObject;
inline constexpr Core<562, PoolBytes(const VariantBytes*)> asPoolByte;
inline constexpr Core<575, void(VariantBytes*)> variantDestroy;

inline constexpr Core<579, void(StringBytes*)> stringNew;
inline constexpr Core<683, CharStringBytes(const StringBytes*)> stringUtf8;
inline constexpr Core<684, bool(StringBytes*, const char*)> stringParseUtf8;
inline constexpr Core<726, void(StringBytes*)> stringDestroy;
inline constexpr Core<577, const char*(const CharStringBytes*)> charStringData;
inline constexpr Core<578, void(CharStringBytes*)> charStringDestroy;

inline constexpr Core<328, void(ArrayBytes*)> arrayNew;
inline constexpr Core<356, void(ArrayBytes*, const VariantBytes*)> arrayPushBack;
inline constexpr Core<366, void(ArrayBytes*)> arrayDestroy;

// Pool arrays: 16 functions for each type from slot 160 on, then 4 of its read access from 272 on, and 4 of its write
// access from 300 on, in the order of bytes, ints, reals, strings, vectors of two, vectors of three, colours.
enum class Pool : size_t { Byte = 0, Int = 1, Vector3 = 5, Color = 6 };
template <Pool pool>
inline constexpr Core<160 + 16 * size_t(pool), void(PoolBytes*)> poolNew;
template <Pool pool>
inline constexpr Core<169 + 16 * size_t(pool), void(PoolBytes*, int32_t)> poolResize;
template <Pool pool>
inline constexpr Core<170 + 16 * size_t(pool), PoolReadAccess*(const PoolBytes*)> poolRead;
template <Pool pool>
inline constexpr Core<171 + 16 * size_t(pool), PoolWriteAccess*(PoolBytes*)> poolWrite;
template <Pool pool>
inline constexpr Core<174 + 16 * size_t(pool), int32_t(const PoolBytes*)> poolSize;
template <Pool pool>
inline constexpr Core<175 + 16 * size_t(pool), void(PoolBytes*)> poolDestroy;
template <Pool pool>
inline constexpr Core<273 + 4 * size_t(pool), const void*(const PoolReadAccess*)> poolReadPointer;
template <Pool pool>
inline constexpr Core<275 + 4 * size_t(pool), void(PoolReadAccess*)> poolReadDestroy;
template <Pool pool>
inline constexpr Core<301 + 4 * size_t(pool), void*(const PoolWriteAccess*)> poolWritePointer;
template <Pool pool>
inline constexpr Core<303 + 4 * size_t(pool), void(PoolWriteAccess*)> poolWriteDestroy;

inline constexpr Core<736, Object*(const char*)> globalSingleton;
inline constexpr Core<737, MethodBind*(const char*, const char*)> methodBind;
inline constexpr Core<739, VariantBytes(MethodBind*, Object*, const VariantBytes* const*, int32_t, void*)> methodCall;
inline constexpr Core<740, Object* (*(const char*))()> classConstructor;
inline constexpr Core<746, void(const char*, const char*, const char*, int32_t)> printError;
inline constexpr Core<747, void(const char*, const char*, const char*, int32_t)> printWarning;
inline constexpr Core<748, void(const StringBytes*)> print;

inline constexpr NativeScript<3, void(void*, const char*, const char*, CreateFunction, DestroyFunction)> registerClass;
inline constexpr NativeScript<5, void(void*, const char*, const char*, MethodAttributes, MethodFunction)>
    registerMethod;
inline constexpr NativeScript<6, void(void*, const char*, const char*, PropertyAttributes*, SetFunction, GetFunction)>
    registerProperty;
inline constexpr NativeScript<7, void(void*, const char*, const Signal*)> registerSignal;

}  // namespace gd
