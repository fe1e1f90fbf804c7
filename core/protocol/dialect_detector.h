// Tells UT2004 and UDK servers apart by the lines they send. Reading those lines does not depend on the answer.
#pragma once

#include <optional>
#include <string_view>

#include "core/protocol/command.h"
#include "core/protocol/dialect.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// Watches one connection and applies the rules of udk.md, "Telling the servers apart". The first characteristic line
/// decides. After that, each line for the same dialect strengthens the belief, up to a small limit, and each line for
/// the other one weakens it; the answer changes when the contrary lines outnumber the others by several. In this way a
/// proxy that is restarted with a different server is noticed, but a single odd line changes nothing.
class DialectDetector {
public:
    /// Call it with every info line of the connection, as received.
    void take(std::string_view line);
    /// Call it with every command that is sent: a configuration of cameras is characteristic only if nobody asked for
    /// it.
    void sent(const Command& command);

    /// The dialect as far as known; nullopt before the first characteristic line.
    std::optional<Dialect> dialect() const { return dialect_; }

private:
    void vote(Dialect dialect);

    std::optional<Dialect> dialect_;
    int belief_ = 0; ///< in `dialect_`: lines for it minus lines against it
    bool asked_for_cameras_ = false;
    Segments segments_; ///< of the newest line; kept for its memory, like `ignored_`
    Diagnostics ignored_;
};

} // namespace usar::protocol
