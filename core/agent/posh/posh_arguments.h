// The arguments of the calls of senses and acts in a plan, checked and converted once when the plan is loaded.
#pragma once

#include <string>
#include <vector>

#include "core/agent/posh/posh_primitive.h"
#include "core/base/result.h"
#include "core/posh/run/program.h"

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
    double real(std::string_view name) const;
    std::int64_t whole(std::string_view name) const;
    bool flag(std::string_view name) const;
    /// The value of a parameter that is a text or a symbol.
    const std::string& text(std::string_view name) const;

private:
    const posh::Value& find(std::string_view name) const;

    std::vector<std::pair<std::string, posh::Value>> values_;
};

} // namespace usar::agent
