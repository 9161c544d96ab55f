#include "samples/hosts/godot/variant.h"

#include <cmath>
#include <cstring>

namespace rubble_godot {
namespace {

/// A pool array of values; makeVariant: the function of its type.
template <gd::Pool pool, class T, class Make>
gd::VariantBytes makePool(const std::vector<T>& values, Make makeVariant) {
    gd::PoolBytes array;
    gd::poolNew<pool>(&array);
    gd::poolResize<pool>(&array, int32_t(values.size()));
    gd::PoolWriteAccess* access = gd::poolWrite<pool>(&array);
    if (!values.empty()) std::memcpy(gd::poolWritePointer<pool>(access), values.data(), values.size() * sizeof(T));
    gd::poolWriteDestroy<pool>(access);
    gd::VariantBytes bytes;
    makeVariant(&bytes, &array);
    gd::poolDestroy<pool>(&array);
    return bytes;
}

}  // namespace

Variant::Variant(const char* text) {
    gd::StringBytes string;
    gd::stringNew(&string);
    gd::stringParseUtf8(&string, text);
    gd::variantString(&m_bytes, &string);
    gd::stringDestroy(&string);
}

Variant::Variant(const Vec3& value) {
    const auto bytes = std::bit_cast<gd::Vector3Bytes>(value);
    gd::variantVector3(&m_bytes, &bytes);
}

Variant::Variant(const Color& value) {
    const auto bytes = std::bit_cast<gd::ColorBytes>(value);
    gd::variantColor(&m_bytes, &bytes);
}

Variant::Variant(const Transform& value) {
    const auto bytes = std::bit_cast<gd::TransformBytes>(value);
    gd::variantTransform(&m_bytes, &bytes);
}

Variant Variant::take(const gd::VariantBytes& bytes) {
    Variant value;
    value.m_bytes = bytes;
    return value;
}

Variant Variant::array(const std::vector<Variant>& values) {
    gd::ArrayBytes array;
    gd::arrayNew(&array);
    for (const Variant& value : values) gd::arrayPushBack(&array, &value.m_bytes);
    gd::VariantBytes bytes;
    gd::variantArray(&bytes, &array);
    gd::arrayDestroy(&array);
    return take(bytes);
}

Variant Variant::pool(const std::vector<int32_t>& values) {
    return take(makePool<gd::Pool::Int>(values, gd::variantPoolInt));
}

Variant Variant::pool(const std::vector<Vec3>& values) {
    return take(makePool<gd::Pool::Vector3>(values, gd::variantPoolVector3));
}

Variant Variant::pool(const std::vector<Color>& values) {
    return take(makePool<gd::Pool::Color>(values, gd::variantPoolColor));
}

std::string Variant::asString() const {
    gd::StringBytes string = gd::asString(&m_bytes);
    gd::CharStringBytes utf8 = gd::stringUtf8(&string);
    std::string text = gd::charStringData(&utf8);
    gd::charStringDestroy(&utf8);
    gd::stringDestroy(&string);
    return text;
}

std::array<int32_t, 2> Variant::asSize() const {
    const auto size = std::bit_cast<std::array<float, 2>>(gd::asVector2(&m_bytes));
    return {int32_t(std::lround(size[0])), int32_t(std::lround(size[1]))};
}

std::vector<uint8_t> Variant::asBytes() const {
    constexpr gd::Pool pool = gd::Pool::Byte;
    gd::PoolBytes array = gd::asPoolByte(&m_bytes);
    std::vector<uint8_t> bytes(size_t(gd::poolSize<pool>(&array)));
    gd::PoolReadAccess* access = gd::poolRead<pool>(&array);
    if (!bytes.empty()) std::memcpy(bytes.data(), gd::poolReadPointer<pool>(access), bytes.size());
    gd::poolReadDestroy<pool>(access);
    gd::poolDestroy<pool>(&array);
    return bytes;
}

uint64_t Variant::ridKey() const {
    uint64_t key;
    std::memcpy(&key, m_bytes.bytes + 8, sizeof key);
    return key;
}

gd::VariantBytes Variant::release() {
    const gd::VariantBytes bytes = m_bytes;
    gd::variantNil(&m_bytes);
    return bytes;
}

Variant Method::call(gd::Object* object, const gd::VariantBytes* const* arguments, int32_t count) const {
    if (!m_bind) m_bind = gd::methodBind(m_owner, m_name);
    if (!m_bind || !object) {
        printError(std::string(m_owner) + "." + m_name + (m_bind ? " of no object" : " is not in this Godot"));
        return {};
    }
    int32_t error[4] = {};  // kind, argument, expected type
    Variant result = Variant::take(gd::methodCall(m_bind, object, arguments, count, error));
    if (error[0] != 0)
        printError(std::string(m_owner) + "." + m_name + ": error " + std::to_string(error[0]) + " of argument " +
                   std::to_string(error[1]));
    return result;
}

gd::Object* singleton(const char* name) {
    return gd::globalSingleton(name);
}

void printError(std::string_view text) {
    gd::printError(std::string(text).c_str(), "rubble", "rubble", 0);
}

void printWarning(std::string_view text) {
    gd::printWarning(std::string(text).c_str(), "rubble", "rubble", 0);
}

bool readFile(const std::string& path, std::vector<uint8_t>& out) {
    static constexpr Method open{"_File", "open"}, length{"_File", "get_len"}, read{"_File", "get_buffer"};
    static const auto construct = gd::classConstructor("_File");
    const Variant file(construct());  // a reference: it goes with its last value
    gd::Object* object = file.as<gd::Object*>();
    constexpr int32_t kRead = 1;
    if (open(object, path, kRead).as<int64_t>() != 0) return false;
    out = read(object, length(object)).asBytes();
    return true;
}

}  // namespace rubble_godot
