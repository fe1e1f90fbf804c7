// An error message for the operator, and the result type that carries it.
#pragma once

#include <string>

#include <tl/expected.hpp>

namespace usar {

/// A failure in three parts: `what` failed, `where` (file, line, host or parameter), and in `mend` what the user can do
/// about it. Each part is a phrase without a final period. `where` and `mend` may be empty.
struct Error {
    std::string what;
    std::string where;
    std::string mend;

    /// One or two sentences: "where: what. Mend."
    std::string text() const;
    bool operator==(const Error&) const = default;
};

/// A value or an error. Expected failures (input, files, network, plugins) are returned as errors; bugs in our own code
/// are caught by assertions.
template <class T, class E = Error>
using Result = tl::expected<T, E>;

/// Makes an error that a function returning Result can return directly.
tl::unexpected<Error> failure(std::string what, std::string where, std::string mend = {});

} // namespace usar
