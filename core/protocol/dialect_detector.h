// Tells UT2004 and UDK servers apart by what they say; never needed to read it.
#pragma once

#include <optional>
#include <string_view>

#include "core/protocol/command.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// Listens to one connection, by the end of usarsim-protocol 7. The first telling line decides; from then on a line
/// that tells the other way only weakens the belief, and it takes several more of them than there were for it (no more
/// than a few count) to change it. A proxy that is restarted with another server behind it is noticed; a single odd
/// line changes nothing.
class DialectDetector {
public:
    /// Every info line of the connection, as it came.
    void take(std::string_view line);
    /// Every command that went out: an answer about cameras tells something only where nobody asked.
    void sent(const Command& command);

    std::optional<Dialect> dialect() const { return dialect_; }

private:
    void vote(Dialect dialect);

    std::optional<Dialect> dialect_;
    int belief_ = 0; ///< in `dialect_`, by the lines that told
    bool asked_for_cameras_ = false;
};

} // namespace usar::protocol
