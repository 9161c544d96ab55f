#include "tests/abi/refusals/argument_changes.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace rubble {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::pair<const char*, double> kWrongNumbers[] = {{"NaN", std::numeric_limits<double>::quiet_NaN()},
                                                        {"infinity", kInfinity},
                                                        {"-infinity", -kInfinity},
                                                        {"1e300", 1e300},
                                                        {"-1e300", -1e300}};

/// Collects the changes of a function.
class Changes {
public:
    Changes(const FunctionDescription& function, const WrongWorlds& wrong) : m_function(function), m_wrong(wrong) {}

    std::vector<ArgumentChange> all() {
        for (size_t i = 0; i < m_function.arguments.size(); ++i) addArgument(i);
        return std::move(m_out);
    }

private:
    /// Where a value is in a call.
    using Place = std::function<unsigned char*(HostCall&)>;

    template <class T>
    void add(const std::string& place, const std::string& what, rubble_result expected, const Place& at, T value) {
        m_out.push_back({place, what, expected, [=](HostCall& call) { std::memcpy(at(call), &value, sizeof value); }});
    }
    void addArgument(size_t i) {
        const ArgumentDescription& argument = m_function.arguments[i];
        const Place slot = [i](HostCall& call) { return call.bytesOf(i); };
        if (!isPointer(argument)) {
            // The length of an array is as the host says.
            const bool isLength = argument.name == "capacity" || argument.name == "count" || argument.name == "size" ||
                                  argument.name == "brick_count";
            if (!isLength) addValue(argument.name, argument.type, argument.name, slot);
            return;
        }
        add(argument.name, "null", RUBBLE_ERROR_NULL, slot, uint64_t(0));
        if (argument.rows > 0) {
            const Place last = [i, rows = argument.rows](HostCall& call) { return call.memoryOf(i) + 8 * (rows - 1); };
            if (argument.type == "const double") addNumber(argument.name, last);
        } else if (const StructDescription* type = structOf(argument.type)) {
            for (const FieldDescription& field : type->fields)
                if (argument.type.starts_with("const ") || field.name == "struct_size")
                    addField(i, field, 0, argument.name);
        }
    }
    /// base: bytes from where the argument points to the struct of the field; owner: the name of that.
    void addField(size_t i, const FieldDescription& field, size_t base, const std::string& owner) {
        if (const StructDescription* inner = structOf(field.type + "*")) {
            for (const FieldDescription& each : inner->fields)
                addField(i, each, base + field.offset, owner + "." + field.name);
            return;
        }
        const size_t rowSize = field.type == "int32_t" || field.type == "uint32_t" ? 4 : 8;
        const size_t offset = base + field.offset + (field.rows > 1 ? size_t(field.rows - 1) * rowSize : 0);
        const Place at = [i, offset](HostCall& call) { return call.memoryOf(i) + offset; };
        const std::string place = owner + "." + field.name;
        if (field.name == "struct_size") {
            add(place, "0", RUBBLE_ERROR_STRUCT_SIZE, at, 0u);
            add(place, "huge", RUBBLE_ERROR_STRUCT_SIZE, at, 1u << 30);
        } else if (field.name.starts_with("reserved")) {
            add(place, "1", RUBBLE_ERROR_ARGUMENT, at, 1u);
        } else if (field.type.ends_with("*")) {
            add(place, "null", RUBBLE_ERROR_NULL, at, uint64_t(0));
        } else {
            addValue(place, field.type, field.name, at);
        }
    }
    void addValue(const std::string& place, const std::string& type, const std::string& name, const Place& at) {
        if (isHandle(type) || name == "object" || name == "handle" || name == "owner")
            addHandle(place, type, at);
        else if (type == "double")
            addNumber(place, at);
        else if (type == "uint32_t")
            add(place, "huge", RUBBLE_ERROR_ARGUMENT, at, ~0u);
        else if (type == "uint64_t")
            add(place, "huge", RUBBLE_ERROR_ARGUMENT, at, ~uint64_t(0));
        else if (type == "int32_t")
            for (const int32_t value : {INT32_MIN, INT32_MAX})
                add(place, value < 0 ? "negative" : "huge", RUBBLE_ERROR_ARGUMENT, at, value);
    }
    void addNumber(const std::string& place, const Place& at) {
        for (const auto& [what, value] : kWrongNumbers) add(place, what, RUBBLE_ERROR_ARGUMENT, at, value);
    }
    void addHandle(const std::string& place, const std::string& type, const Place& at) {
        const std::string kind = type == "uint64_t" ? "rubble_body" : type;
        add(place, "0", RUBBLE_ERROR_STALE, at, uint64_t(0));
        add(place, "nonsense", RUBBLE_ERROR_STALE, at, 0x0123456789abcdefull);
        if (kind == "rubble_world") {
            add(place, "stale", RUBBLE_ERROR_STALE, at, m_wrong.gone);
        } else if (kind == "rubble_renderer") {
            add(place, "stale", RUBBLE_ERROR_STALE, at, m_wrong.goneRenderer);
        } else if (const auto found = m_wrong.other.live().find(kind); found != m_wrong.other.live().end()) {
            add(place, "of another world", RUBBLE_ERROR_STALE, at, found->second);
            if (!m_wrong.other.stale().contains(kind)) return addOtherKind(place, type, at);
            m_out.push_back({place, "stale", RUBBLE_ERROR_STALE, [=](HostCall& call) {
                                 const uint64_t value = call.world().stale().at(kind);
                                 std::memcpy(at(call), &value, sizeof value);
                             }});
        }
        addOtherKind(place, type, at);
    }
    void addOtherKind(const std::string& place, const std::string& type, const Place& at) {
        m_out.push_back({place, "of another kind", RUBBLE_ERROR_STALE, [=](HostCall& call) {
                             const bool isBody = type == "rubble_body";
                             const uint64_t value =
                                 type == "uint64_t" ? call.world().world()
                                                    : call.world().live().at(isBody ? "rubble_shape" : "rubble_body");
                             std::memcpy(at(call), &value, sizeof value);
                         }});
    }

    const FunctionDescription& m_function;
    const WrongWorlds m_wrong;
    std::vector<ArgumentChange> m_out;
};

}  // namespace

std::vector<ArgumentChange> changesOf(const FunctionDescription& function, const WrongWorlds& wrong) {
    return Changes(function, wrong).all();
}

}  // namespace rubble
