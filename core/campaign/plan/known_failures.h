// A file of runs that once showed a defect, so that they are flown again from then on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <QString>

#include "core/base/result.h"

namespace usar::campaign {

/// One line of the file, a JSON object with these keys.
struct KnownFailure {
    std::string mission; ///< its name, which is that of its file without the suffix
    std::string variant; ///< its name
    std::uint64_t seed = 1;
    std::vector<std::string> faults;
    std::vector<std::string> values; ///< KEY=VALUE, without those of the variant
    std::string broke;               ///< what was wrong, in words for people
    bool operator==(const KnownFailure&) const = default;
};

/// Reads the file; one that does not exist has no lines. The error names the line that is no known failure.
Result<std::vector<KnownFailure>> readKnownFailures(const QString& path);

/// Appends those that are not in the file yet, which is created even for none. Fails if it cannot be read or written.
Result<void> addKnownFailures(const QString& path, const std::vector<KnownFailure>& failures);

} // namespace usar::campaign
