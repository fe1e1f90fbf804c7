// Buffer that keeps the newest line of every stream until it is fetched.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info_message.h"

namespace usar::widgets {

/// Key that distinguishes the streams of one connection: "SEN Sonar F1", "STA", "GEO RangeScanner".
std::string streamOf(const protocol::InfoMessage& message);

/// The newest line of a stream, and how many lines of the stream came since the last fetch, this one included.
struct CountedLine {
    protocol::InfoLine line;
    /// Clock at arrival, as passed to take().
    Seconds now{0.0};
    int count = 0;
};

/// Bounds the work of a slow or hidden view: a thousand lines of one stream cost as much as one. A line that is the
/// only one of its stream is never lost. A value with one owner.
class NewestLines {
public:
    /// Stores a line; it replaces the previous line of the same stream.
    void take(const protocol::InfoLine& line, Seconds now);
    /// Removes and returns all lines, in the order in which their streams first appeared since the last call.
    std::vector<CountedLine> takeAll();

private:
    std::map<std::string, std::size_t> places_;
    std::vector<CountedLine> lines_;
};

} // namespace usar::widgets
