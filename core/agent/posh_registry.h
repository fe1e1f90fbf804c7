// The senses and acts that a robot offers to plans. It needs no robot, so editors and checks can use it, too.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/agent/posh/posh_body.h"
#include "core/agent/posh/posh_primitive.h"
#include "core/base/result.h"

namespace usar::agent {

/// Converts `value` to the type of the parameter: accepts whole numbers for reals, and for symbols also texts and the
/// last part of enumeration constants. The error is a phrase: "takes $x as …, not …".
Result<posh::Value, std::string> convertArgument(const PoshParameter& parameter, const posh::Value& value);

/// The parameter to which an argument of a call belongs: the one called `name`, or, if that is empty, the one at
/// `position` (from 0). nullptr if there is none.
const PoshParameter* parameterFor(const PrimitiveDescription& primitive, std::size_t position, const std::string& name);

/// A value for each parameter of a sense or act.
class PoshArguments {
public:
    /// The defaults, overridden by the arguments of the call. The error is a phrase that begins with the primitive's
    /// name.
    static Result<PoshArguments, std::string> make(const PrimitiveDescription& primitive,
                                                   const std::vector<posh::CallArgument>& arguments);

    /// The parameter must be declared (assertion) with the requested type.
    double real(std::string_view name) const { return std::get<double>(find(name)); }
    std::int64_t whole(std::string_view name) const { return std::get<std::int64_t>(find(name)); }
    bool flag(std::string_view name) const { return std::get<bool>(find(name)); }
    /// The value of a parameter that is a text or a symbol.
    const std::string& text(std::string_view name) const;

private:
    const posh::Value& find(std::string_view name) const;

    std::vector<std::pair<std::string, posh::Value>> values_;
};

/// A running act; there is one object for each call in a plan. `init` comes first, `run` once per cycle, `done` last.
class PoshAct {
public:
    virtual ~PoshAct() = default;
    virtual void init(PoshBody&, const PoshArguments&) {}
    virtual posh::ActResult run(PoshBody& body, const PoshArguments& arguments) = 0;
    virtual void done(PoshBody&, const PoshArguments&, posh::DoneReason) {}
};

/// A sense or act: its description and its code.
struct PoshPrimitive {
    PrimitiveDescription description;
    std::function<void(const PoshBody&, const PoshArguments&, posh::Value&)> sense; ///< empty for an act
    std::function<std::unique_ptr<PoshAct>()> make_act;                             ///< empty for a sense
};

/// Senses and acts by name; adding one under an existing name replaces the earlier one.
class PoshRegistry {
public:
    /// Completes the description of the primitive that was just added; valid until the next change of the registry.
    class Entry {
    public:
        explicit Entry(PrimitiveDescription& description) : description_(description) {}
        Entry& describe(std::string help) { return description_.help = std::move(help), *this; }
        Entry& takes(PoshParameter parameter) { return description_.parameters.push_back(std::move(parameter)), *this; }
        Entry& unit(std::string unit) { return description_.unit = std::move(unit), *this; }
        /// The range of a sense's number, inclusive.
        Entry& within(double minimum, double maximum) {
            description_.minimum = minimum;
            description_.maximum = maximum;
            return *this;
        }
        /// The symbols that a sense may answer.
        Entry& oneOf(std::vector<std::string> choices) { return description_.choices = std::move(choices), *this; }
        Entry& needs(std::string sensor_or_command) {
            return description_.needs.push_back(std::move(sensor_or_command)), *this;
        }

    private:
        PrimitiveDescription& description_;
    };

    Entry add(PoshPrimitive primitive);
    const PoshPrimitive* find(std::string_view name) const;
    const std::map<std::string, PoshPrimitive, std::less<>>& all() const { return primitives_; }
    /// Descriptions sorted by name.
    std::vector<PrimitiveDescription> descriptions() const;

private:
    std::map<std::string, PoshPrimitive, std::less<>> primitives_;
};

} // namespace usar::agent
