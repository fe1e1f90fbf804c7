// An error in words for the operator, and the result type that carries it.
#pragma once

#include <string>

#include <tl/expected.hpp>

namespace usar {

/// What failed, on what (file, line, host, parameter), and what the person can do about it.
/// Each part is a phrase without a final stop; `mend` may be empty where nothing can be done.
struct Error {
    std::string what;
    std::string where;
    std::string mend;

    /// One sentence or two: "where: what. Mend."
    std::string text() const;
    bool operator==(const Error&) const = default;
};

/// Expected trouble (input, files, network, plugins) is a value that must be looked at; our own bugs are assertions.
template <class T, class E = Error>
using Result = tl::expected<T, E>;

tl::unexpected<Error> failure(std::string what, std::string where, std::string mend = {});

} // namespace usar
