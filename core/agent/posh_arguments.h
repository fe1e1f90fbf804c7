// What a sense or act of a plan is called with, checked and converted once when the plan is put in.
#pragma once

#include <string>
#include <vector>

#include "core/agent/posh_primitive.h"
#include "core/base/result.h"
#include "core/posh/program.h"

namespace usar::agent {

/// `value` as a value of that parameter: whole numbers are taken for reals, the last part of an enumeration constant
/// for a symbol, a text for a symbol. The error is a phrase: "takes $x as …, not …".
Result<posh::Value, std::string> convertArgument(const PoshParameter& parameter, const posh::Value& value);

/// The parameter that the `position`-th argument of a call gives a value to; null where there is none.
const PoshParameter* parameterFor(const PrimitiveDescription& primitive, std::size_t position, const std::string& name);

/// A value for each parameter.
class PoshArguments {
public:
    static Result<PoshArguments, std::string> make(const PrimitiveDescription& primitive,
                                                   const std::vector<posh::CallArgument>& arguments);

    /// Asking for a parameter that is not declared, or for another type, is a bug (assertion).
    double real(std::string_view name) const;
    std::int64_t whole(std::string_view name) const;
    bool flag(std::string_view name) const;
    /// Of a text or a symbol.
    const std::string& text(std::string_view name) const;

private:
    const posh::Value& find(std::string_view name) const;

    std::vector<std::pair<std::string, posh::Value>> values_;
};

} // namespace usar::agent
